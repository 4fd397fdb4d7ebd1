#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "echo.hpp"
#include "energy_section.hpp"
#include "energy_segment.hpp"
#include "vertex_graph.hpp"

namespace signorini {

namespace {

class Phases final : public EnergySection {
public:
    Phases(LumpedSet set, double energyRatio)
        : set_(std::move(set)), shape_(shapeOf(set_)), energy_(energyRatio)
    {
        facts_.range = shape_.energy;
        constexpr double atEnds = 1e-14;  // as findPeriodic has it
        if (energy_ < facts_.range.least * (1.0 - atEnds) ||
            energy_ > facts_.range.most * (1.0 + atEnds)) {
            facts_.components = 0;
            return;
        }
        facts_.largestWave = std::sqrt(squares());
        findSimplex();
        if (energy_ <= facts_.range.least * (1.0 + vertexRounding)) {
            facts_.dimension = 0;
            facts_.isFinite = true;
            setComponents(1.0);
            return;
        }
        facts_.dimension = shape_.dimension - 1;
        findSegment();
        if (segment_) {
            facts_.isFinite = true;
            setComponents(static_cast<double>(segment_->places().size()));
            return;
        }
        if (!knowsVertices()) {
            if (facts_.simplex && facts_.isWhole && !facts_.isShared) {
                countInSimplex();
            }
            return;
        }
        graph_ = std::make_unique<VertexGraph>(set_, shape_.vertices, squares());
        setComponents(graph_->components());
        const bool isMost = energy_ >= facts_.range.most * (1.0 - vertexRounding);
        facts_.dimension = isMost ? 0 : facts_.dimension;
        facts_.isFinite = facts_.dimension == 0;
    }

    [[nodiscard]] std::optional<bool> joins(const State& from, const State& to) const override
    {
        if (facts_.isConnected == true) {
            return true;
        }
        if (segment_) {
            return segment_->nearest(amplitudesOf(set_.classes, from)) ==
                   segment_->nearest(amplitudesOf(set_.classes, to));
        }
        if (!graph_ && facts_.components) {
            return dominant(sharesOf(from)) == dominant(sharesOf(to));
        }
        if (!graph_) {
            return std::nullopt;
        }
        const Place start = placeOf(from);
        const Place end = placeOf(to);
        if (!graph_->isAbove(start.vertex) || !graph_->isAbove(end.vertex)) {
            return std::nullopt;
        }
        const std::size_t group = graph_->groupOf(start.vertex);
        if (group != graph_->groupOf(end.vertex)) {
            return false;
        }
        const std::vector<bool>& locks = graph_->locks(group);
        for (std::size_t t = 0; t < locks.size(); ++t) {
            if (locks[t] && start.classes[t] != end.classes[t]) {
                return false;
            }
        }
        return true;
    }

    /// On the segment, or on the straight ways from equal amplitudes to the vertices above.
    [[nodiscard]] std::vector<State> isolated(std::int64_t most) const override
    {
        std::vector<State> motions;
        if (segment_) {
            for (const double place : segment_->places()) {
                if (static_cast<std::int64_t>(motions.size()) < most) {
                    motions.push_back(signorini::motionOf(set_.classes, segment_->at(place)));
                }
            }
            return motions;
        }
        if (!graph_ && facts_.components > 1) {
            for (std::int64_t j = 0; j < std::min(most, set_.type(*spread_).count); ++j) {
                std::vector<double> shares(static_cast<std::size_t>(set_.type(*spread_).count),
                                           0.0);
                shares[static_cast<std::size_t>(j)] = 1.0;
                motions.push_back(motionOf(shares));
            }
            return motions;
        }
        if (!graph_) {
            motions.push_back(equalMotion(set_, set_.leastSums));
            return motions;
        }
        for (std::size_t i = 0; i < graph_->vertices().size(); ++i) {
            if (graph_->isAbove(i)) {
                std::vector<double> z(static_cast<std::size_t>(set_.classes.classes), 0.0);
                addSpikes(graph_->vertices()[i], 0, std::move(z), most, motions);
            }
        }
        return motions;
    }

    [[nodiscard]] std::vector<double> sharesOf(const State& state) const override
    {
        const std::vector<double> z = amplitudesOf(set_.classes, state);
        const ClassType& type = set_.type(*spread_);
        std::vector<double> shares(z.data() + type.first, z.data() + type.first + type.count);
        for (double& value : shares) {
            value /= sums()[*spread_];
        }
        return shares;
    }

    [[nodiscard]] State motionOf(const std::vector<double>& shares) const override
    {
        return signorini::motionOf(
            set_.classes, sharedOut(set_, shares, [this](std::size_t t) { return isSpread(t); }));
    }

    [[nodiscard]] AmplitudeSet sampled() const override
    {
        return {.kind = SetKind::simplex, .count = set_.type(*spread_).count, .sum = 1.0};
    }

private:
    /// A vertex of the sums, and the class that holds the sum of each live type.
    struct Place {
        std::size_t vertex = 0;
        std::vector<std::int64_t> classes;
    };

    /// sum z^2.
    [[nodiscard]] double squares() const
    {
        return signorini::squaresOf(energy_, set_.classes.schedule.cells, set_.classes.window);
    }

    /// The sums where they are the same for all motions.
    [[nodiscard]] const std::vector<double>& sums() const { return set_.leastSums; }

    void setComponents(double components)
    {
        facts_.isConnected = components == 1.0;
        if (components < 9e15) {
            facts_.components = static_cast<std::int64_t>(components);
        }
    }

    /// Equal amplitudes of sums S.
    [[nodiscard]] std::vector<double> equalAmplitudes(const std::vector<double>& sums) const
    {
        std::vector<double> z(static_cast<std::size_t>(set_.classes.classes), 0.0);
        for (std::size_t t = 0; t < set_.live.size(); ++t) {
            for (std::int64_t j = 0; j < set_.type(t).count; ++j) {
                z[static_cast<std::size_t>(set_.type(t).first + j)] =
                    sums[t] / static_cast<double>(set_.type(t).count);
            }
        }
        return z;
    }

    /// A set of one dimension has two ends. Either the sums go from one vertex to the other, and
    /// leave no choice of amplitudes, or one pair of classes shares a sum.
    void findSegment()
    {
        if (shape_.dimension != 1) {
            return;
        }
        if (shape_.spanning.size() == 2) {
            if (shape_.isBounded && shape_.vertices.size() == 2) {
                segment_.emplace(equalAmplitudes(shape_.vertices.front()),
                                 equalAmplitudes(shape_.vertices.back()), squares());
            }
            return;
        }
        const std::vector<double>& sums = shape_.spanning.front();
        for (std::size_t t = 0; t < set_.live.size(); ++t) {
            const AmplitudeSet pair = amplitudesAt(set_, sums, t);
            const bool isBox = pair.kind == SetKind::box;
            const double low = isBox ? pair.lower : 0.0;
            const double high = isBox ? pair.upper : pair.sum;
            if (pair.count == 2 && low < high) {
                std::vector<double> from = equalAmplitudes(sums);
                std::vector<double> to = from;
                const auto first = static_cast<std::size_t>(set_.type(t).first);
                from[first] = low;
                from[first + 1] = pair.sum - low;
                to[first] = high;
                to[first + 1] = pair.sum - high;
                segment_.emplace(std::move(from), to, squares());
            }
        }
    }

    /// Boxes of several classes have vertices of their own, which nobody lists.
    [[nodiscard]] bool knowsVertices() const
    {
        for (std::size_t t = 0; t < set_.live.size(); ++t) {
            if (set_.type(t).kind == TypeKind::grazing && set_.type(t).count > 1) {
                return false;
            }
        }
        return shape_.isBounded && !shape_.vertices.empty();
    }

    /// One type alone differs between the motions if it accounts for the whole dimension.
    void findSimplex()
    {
        if (shape_.spanning.size() != 1 || shape_.dimension < 1) {
            return;
        }
        for (std::size_t t = 0; t < set_.live.size(); ++t) {
            const ClassType& type = set_.type(t);
            if (type.kind == TypeKind::pressing && type.count == shape_.dimension + 1 &&
                sums()[t] > 0.0) {
                spread_ = t;
            }
        }
        if (!spread_) {
            findSharedPulses();
            return;
        }
        double others = 0.0;
        double largest = 0.0;
        for (std::size_t t = 0; t < set_.live.size(); ++t) {
            const auto count = static_cast<double>(set_.type(t).count);
            others += t == *spread_ ? 0.0 : sums()[t] * sums()[t] / count;
            largest = std::max(largest, std::abs(sums()[t]) / (t == *spread_ ? 1.0 : count));
        }
        const double sum = sums()[*spread_];
        double ratio = (squares() - others) / (sum * sum);
        if (std::abs(ratio - 0.5) <= vertexRounding) {
            ratio = 0.5;
        }
        facts_.simplex = SphereSection{set_.type(*spread_).count, ratio};
        facts_.unit =
            sum * std::sqrt(energyOf(1.0, set_.classes.schedule.cells, set_.classes.window));
        facts_.largestWave = std::min(facts_.largestWave, largest);
    }

    /// Motions differ in one simplex only: those of one contact phase, whatever boxes without room
    /// stand beside it.
    void countInSimplex()
    {
        const auto& [count, ratio] = *facts_.simplex;
        setComponents(ratio <= 0.5 ? 1.0 : static_cast<double>(count));
        if (energy_ >= facts_.range.most * (1.0 - vertexRounding)) {
            facts_.dimension = 0;
            facts_.isFinite = true;
        }
    }

    /// Types of equal width with sums that are the same for all motions can carry the same pulse,
    /// at two stops the mirrored one: sum z^2 = rho sum S^2 + sum S^2/d of the others.
    void findSharedPulses()
    {
        double shared = 0.0;
        double others = 0.0;
        std::int64_t count = 0;
        for (std::size_t t = 0; t < set_.live.size(); ++t) {
            const ClassType& type = set_.type(t);
            if (type.kind == TypeKind::pressing && type.count > 2 && sums()[t] > 0.0) {
                if (count != 0 && type.count != count) {
                    return;
                }
                count = type.count;
                shared += sums()[t] * sums()[t];
                spread_ = spread_.value_or(t);
            } else {
                others += sums()[t] * sums()[t] / static_cast<double>(type.count);
            }
        }
        const double ratio = (squares() - others) / shared;
        if (spread_ && ratio <= 0.5 && ratio * static_cast<double>(count) >= 1.0) {
            facts_.simplex = SphereSection{count, ratio};
            facts_.isWhole = false;
            facts_.isShared = true;
        }
    }

    /// Does a type carry what the shares say?
    [[nodiscard]] bool isSpread(std::size_t live) const
    {
        return live == *spread_ ||
               (facts_.isShared && set_.type(live).kind == TypeKind::pressing &&
                set_.type(live).count == set_.type(*spread_).count && sums()[live] > 0.0);
    }

    /// Where an ascent leads: each sum into its largest class, then straight to the vertex to which
    /// Q rises most. Q is convex and does not fall at the start of either way.
    [[nodiscard]] Place placeOf(const State& state) const
    {
        const std::vector<double> z = amplitudesOf(set_.classes, state);
        Place place;
        std::vector<double> sums;
        for (std::size_t t = 0; t < set_.live.size(); ++t) {
            const auto* const first = z.data() + set_.type(t).first;
            const auto* const last = first + set_.type(t).count;
            sums.push_back(std::accumulate(first, last, 0.0));
            place.classes.push_back(std::max_element(first, last) - first);
        }
        double highest = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < graph_->vertices().size(); ++i) {
            const std::vector<double>& vertex = graph_->vertices()[i];
            const double rise = std::inner_product(sums.begin(), sums.end(), vertex.begin(), 0.0);
            if (rise > highest) {
                highest = rise;
                place.vertex = i;
            }
        }
        return place;
    }

    /// The vertices over one S, type by type from number `live` on, each brought to the energy.
    void addSpikes(const std::vector<double>& sums, std::size_t live, std::vector<double> z,
                   std::int64_t most, std::vector<State>& motions) const
    {
        if (static_cast<std::int64_t>(motions.size()) >= most) {
            return;
        }
        if (live == set_.live.size()) {
            motions.push_back(signorini::motionOf(set_.classes, lowered(std::move(z))));
            return;
        }
        const std::int64_t choices = sums[live] == 0.0 ? 1 : set_.type(live).count;
        for (std::int64_t j = 0; j < choices; ++j) {
            const auto place = static_cast<std::size_t>(set_.type(live).first + j);
            z[place] = sums[live];
            addSpikes(sums, live + 1, z, most, motions);
            z[place] = 0.0;
        }
    }

    /// The point of this energy on the way from the least motion c to a vertex. Q is least at c, so
    /// it grows along the way: |c|^2 + 2 t c.(v - c) + t^2 |v - c|^2 = q.
    [[nodiscard]] std::vector<double> lowered(std::vector<double> z) const
    {
        const std::vector<double> least =
            amplitudesOf(set_.classes, equalMotion(set_, set_.leastSums));
        double along = 0.0;
        double length = 0.0;
        for (std::size_t j = 0; j < z.size(); ++j) {
            along += least[j] * (z[j] - least[j]);
            length += (z[j] - least[j]) * (z[j] - least[j]);
        }
        const double rest = std::max(0.0, squares() - squaresOf(least));
        const double t = std::min(1.0, rest / (along + std::sqrt(along * along + length * rest)));
        for (std::size_t j = 0; j < z.size(); ++j) {
            z[j] = least[j] + t * (z[j] - least[j]);
        }
        return z;
    }

    LumpedSet set_;
    LumpedShape shape_;
    double energy_;
    std::optional<std::size_t> spread_;  ///< the live type in which alone motions differ
    std::optional<EnergySegment> segment_;
    std::unique_ptr<VertexGraph> graph_;
};

}  // namespace

std::vector<double> sharedOut(const LumpedSet& set, const std::vector<double>& shares,
                              const std::function<bool(std::size_t live)>& carries)
{
    std::vector<double> z(static_cast<std::size_t>(set.classes.classes), 0.0);
    for (std::size_t t = 0; t < set.live.size(); ++t) {
        const ClassType& type = set.type(t);
        const bool isGiven = carries(t);
        for (std::int64_t j = 0; j < type.count; ++j) {
            const double share = isGiven ? shares[static_cast<std::size_t>(j)]
                                         : 1.0 / static_cast<double>(type.count);
            z[static_cast<std::size_t>(type.first + j)] = share * set.leastSums[t];
        }
    }
    return z;
}

std::optional<LumpedSet> reachableSet(const Schedule& schedule)
{
    if (blockCount(schedule) > maxBlocks) {
        return std::nullopt;
    }
    ClassTypes classes = classTypes(schedule);
    if (liveTypeCount(classes) > maxLiveTypes) {
        return std::nullopt;
    }
    try {
        LumpedSet set = lumpedSetOf(std::move(classes));
        return set.absence ? std::nullopt : std::optional(std::move(set));
    } catch (const std::overflow_error&) {
        return std::nullopt;  // a proof of absence beyond 64 bits
    }
}

std::unique_ptr<EnergySection> sectionOfPhases(const Schedule& schedule, double energyRatio)
{
    auto set = reachableSet(schedule);
    return set ? std::make_unique<Phases>(std::move(*set), energyRatio) : nullptr;
}

}  // namespace signorini
