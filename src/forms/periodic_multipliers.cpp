#include "periodic_multipliers.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace signorini {

namespace {

constexpr double noLength = 1e-14;          // of a vector of length 1
constexpr double solved = 1e-12;            // what is missing, of what was
constexpr std::int64_t mostKept = 1 << 24;  // numbers, of vectors that are kept orthogonal
constexpr int partBits = 46;                // of the largest multiplier

/// Of a wave that arrives.
struct Arrival {
    std::size_t channel;
    std::int64_t step;
    double value;
};

/// What is to be done in certain steps, the last ones first.
template <typename Entry>
class Falling {
public:
    explicit Falling(std::vector<Entry> entries) : entries_(std::move(entries))
    {
        std::stable_sort(entries_.begin(), entries_.end(),
                         [](const Entry& x, const Entry& y) { return x.step > y.step; });
    }
    void forEachAt(std::int64_t step, const auto& visit)
    {
        for (; next_ < entries_.size() && entries_[next_].step == step; ++next_) {
            visit(entries_[next_]);
        }
    }

private:
    std::vector<Entry> entries_;
    std::size_t next_ = 0;
};

/// W - 1 and its transpose, in the norm of the energy.
class PeriodOperator {
public:
    PeriodOperator(const Network& network, std::span<const ContactSpan> schedule)
        : network_(withoutForces(network)), bars_(driftingBars(network))
    {
        const std::vector<double> impedances = impedancesOf(network);
        scale_ = Eigen::Map<const Eigen::VectorXd>(impedances.data(),
                                                   static_cast<Eigen::Index>(impedances.size()))
                     .cwiseSqrt();
        for (const ContactSpan& span : schedule) {
            const auto& law = laws_.try_emplace(span.closed, network_, span.closed).first->second;
            spans_.push_back({&law, span.steps});
            steps_ += span.steps;
        }
    }

    [[nodiscard]] const Eigen::VectorXd& scale() const { return scale_; }

    [[nodiscard]] Eigen::VectorXd forwards(const Eigen::VectorXd& x) const
    {
        const Eigen::VectorXd start = x.cwiseQuotient(scale_);
        NetworkWaves<double> waves = wavesOf(start);
        for (const auto& [law, steps] : spans_) {
            for (std::int64_t m = 0; m < steps; ++m) {
                waves.step(*law);
            }
        }
        return (vectorOf(waves) - start).cwiseProduct(scale_);
    }

    [[nodiscard]] Eigen::VectorXd backwards(const Eigen::VectorXd& y) const
    {
        return marched(y, std::vector<double>(bars_.size(), 0.0), {});
    }

    /// What it adds up to with conditions, and with the ways of bars that drift.
    [[nodiscard]] Eigen::VectorXd marched(const Eigen::VectorXd& y, std::vector<double> drifts,
                                          const EnergyFloor& floor) const
    {
        Falling<ContactMultiplier> places(floor.places);
        Falling<ContactMultiplier> pushes(floor.pushes);
        std::vector<Arrival> made;
        made.reserve(2 * floor.strains.size());
        for (const StrainMultiplier& m : floor.strains) {
            made.push_back({2 * m.row, m.right, -m.value});
            made.push_back({2 * m.row + 1, m.left, m.value});
        }
        Falling<Arrival> arrivals(std::move(made));
        const Eigen::VectorXd end = y.cwiseProduct(scale_);
        NetworkWaves<double> waves = wavesOf(end);
        std::int64_t step = steps_;
        for (std::size_t i = spans_.size(); i-- > 0;) {
            const auto& law = *spans_[i].law;
            for (std::int64_t m = 0; m < spans_[i].steps; ++m) {
                waves.stepBack(law);
                --step;
                for (std::size_t k = 0; k < bars_.size(); ++k) {
                    add(waves, velocityOf(law, k), drifts[k]);
                }
                pushes.forEachAt(step, [&](const ContactMultiplier& push) {
                    add(waves, law.push(push.contact).terms, push.value);
                });
                arrivals.forEachAt(
                    step, [&](const Arrival& wave) { waves.add(wave.channel, wave.value); });
                places.forEachAt(step, [&](const ContactMultiplier& place) {
                    addPlace(waves, place);
                    for (const auto& [bar, sign] : driftsOf(network_, place.contact)) {
                        drifts[bar] += sign * place.value;
                    }
                });
            }
        }
        return (vectorOf(waves) - end).cwiseQuotient(scale_);
    }

private:
    struct Span {
        const NetworkLaw<double>* law;
        std::int64_t steps;
    };

    using Terms = std::vector<LinearForm<double>::Term>;

    /// Of what a bar that drifts is counted from.
    [[nodiscard]] const Terms& velocityOf(const NetworkLaw<double>& law, std::size_t drifting) const
    {
        return law.velocity(network_.bars[bars_[drifting]].firstNode).terms;
    }
    static void add(NetworkWaves<double>& waves, const Terms& terms, double factor)
    {
        for (const auto& term : terms) {
            waves.add(term.channel, factor * term.coefficient);
        }
    }
    [[nodiscard]] NetworkWaves<double> wavesOf(const Eigen::VectorXd& x) const
    {
        return {network_, {x.begin(), x.end()}};
    }
    [[nodiscard]] static Eigen::VectorXd vectorOf(const NetworkWaves<double>& waves)
    {
        const std::vector<double> all = waves.waves();
        return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
    }

    void addPlace(NetworkWaves<double>& waves, const ContactMultiplier& m) const
    {
        std::vector<double> all = waves.waves();
        addDistance(all, network_, m.contact, m.value);
        waves = NetworkWaves<double>(network_, std::move(all));
    }

    Network network_;
    std::vector<std::size_t> bars_;  ///< that drift
    Eigen::VectorXd scale_;
    std::map<ContactSet, NetworkLaw<double>> laws_;
    std::vector<Span> spans_;
    std::int64_t steps_ = 0;
};

/// Vectors at right angles, as many as memory is meant for.
class Basis {
public:
    /// Takes away what earlier vectors make, and gives it length 1. Returns the length it had.
    double enter(Eigen::VectorXd& vector)
    {
        for (int twice = 0; twice < 2 && count_ > 0; ++twice) {
            const auto used = columns_.leftCols(count_);
            const Eigen::VectorXd parts = used.transpose() * vector;
            vector -= used * parts;
        }
        const double length = vector.norm();
        if (length > 0.0) {
            vector /= length;
        }
        if ((count_ + 1) * vector.size() <= mostKept) {
            if (count_ == columns_.cols()) {
                columns_.conservativeResize(vector.size(), 2 * count_ + 8);
            }
            columns_.col(count_++) = vector;
        }
        return length;
    }

private:
    Eigen::MatrixXd columns_;
    Eigen::Index count_ = 0;
};

/// x that makes |A x - b| least, A the backwards operator.
Eigen::VectorXd leastSquares(const PeriodOperator& period, Eigen::VectorXd u, const Cancel& cancel)
{
    Eigen::VectorXd x = Eigen::VectorXd::Zero(u.size());
    Basis left;
    Basis right;
    const double size = left.enter(u);
    Eigen::VectorXd v = period.forwards(u);
    double alpha = right.enter(v);
    Eigen::VectorXd way = v;
    double rest = size;
    double rho = alpha;
    for (Eigen::Index step = 0; step < 2 * u.size() + 10 && alpha > noLength; ++step) {
        if (isRequested(cancel)) {
            break;
        }
        u = period.backwards(v) - alpha * u;
        const double beta = left.enter(u);
        const double length = std::hypot(rho, beta);
        const double cosine = rho / length;
        const double sine = beta / length;
        x += (cosine * rest / length) * way;
        rest *= sine;
        if (beta <= noLength || rest <= 0.1 * noLength * size) {
            break;
        }
        v = period.forwards(u) - beta * v;
        alpha = right.enter(v);
        if (std::abs(cosine) * alpha <= noLength) {
            break;  // what is left is at right angles to all that A makes
        }
        way = v - (sine * alpha / length) * way;
        rho = -cosine * alpha;
    }
    return x;
}

/// A multiplier and the bars that drift, or the ground, between which its distance is.
struct Edge {
    ContactMultiplier* multiplier;
    std::array<std::size_t, 2> bars;
    std::array<int, 2> signs;
};

/// Of the largest multipliers as many as tie the bars together without a circle.
std::vector<Edge> forestOf(const std::vector<Edge>& edges, std::size_t bars)
{
    std::vector<std::size_t> tree(bars + 1);
    std::iota(tree.begin(), tree.end(), std::size_t{0});
    std::vector<Edge> forest;
    for (const Edge& edge : edges) {
        const std::size_t one = tree[edge.bars[0]];
        const std::size_t other = tree[edge.bars[1]];
        if (one != other) {
            forest.push_back(edge);
            std::replace(tree.begin(), tree.end(), other, one);
        }
    }
    return forest;
}

/// From the ends of the forest inwards, the ground last.
void balance(std::vector<Edge> forest, std::vector<std::int64_t>& sums, double part)
{
    const std::size_t ground = sums.size() - 1;
    for (std::size_t turn = 0; turn < ground; ++turn) {
        for (std::size_t bar = 0; bar < ground; ++bar) {
            const auto touches = [bar](const Edge& edge) {
                return edge.bars[0] == bar || edge.bars[1] == bar;
            };
            if (std::count_if(forest.begin(), forest.end(), touches) != 1) {
                continue;
            }
            const auto edge = std::find_if(forest.begin(), forest.end(), touches);
            const int sign = edge->signs[edge->bars[0] == bar ? 0 : 1];
            const std::int64_t change = -sign * sums[bar];
            edge->multiplier->value += part * static_cast<double>(change);
            for (const std::size_t k : {0U, 1U}) {
                sums[edge->bars[k]] += edge->signs[k] * change;
            }
            forest.erase(edge);
        }
    }
}

/// Rounds multipliers to whole parts of the largest, and changes those of equalities, one for each
/// bar that drifts, so that its displacement is left out to the last bit.
void balance(std::vector<ContactMultiplier>& places, const Network& network)
{
    const std::size_t bars = driftingBars(network).size();
    double most = 0.0;
    for (const ContactMultiplier& m : places) {
        most = std::max(most, std::abs(m.value));
    }
    if (bars == 0 || most == 0.0) {
        return;
    }
    const double part = std::ldexp(1.0, std::ilogb(most) - partBits);
    std::vector<std::int64_t> sums(bars + 1, 0);  // the last: of the ground
    std::vector<Edge> edges;
    for (ContactMultiplier& m : places) {
        m.value = part * std::round(m.value / part);
        edges.push_back({&m, {bars, bars}, {0, 0}});
        std::size_t k = 0;
        for (const auto& [bar, sign] : driftsOf(network, m.contact)) {
            sums[bar] += sign * std::llround(m.value / part);
            edges.back().bars[k] = bar;
            edges.back().signs[k++] = sign;
        }
    }
    std::stable_sort(edges.begin(), edges.end(), [](const Edge& one, const Edge& other) {
        return std::abs(one.multiplier->value) > std::abs(other.multiplier->value);
    });
    balance(forestOf(edges, bars), sums, part);
}

/// `solve`: what makes a vector of A, if that is known.
void complete(EnergyFloor& floor, const Network& network, std::span<const ContactSpan> schedule,
              const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve,
              const Cancel& cancel, std::span<const double> wanted)
{
    const PeriodOperator period(network, schedule);
    balance(floor.places, network);
    const Eigen::VectorXd& scale = period.scale();
    const auto waves = static_cast<std::ptrdiff_t>(scale.size());
    floor.periodicity.resize(network.waves() + driftingBars(network).size(), 0.0);
    const std::vector<double> ways(floor.periodicity.begin() + waves, floor.periodicity.end());
    Eigen::VectorXd y =
        Eigen::Map<const Eigen::VectorXd>(floor.periodicity.data(), waves).cwiseQuotient(scale);
    const auto missed = [&] {
        Eigen::VectorXd missing = -period.marched(y, ways, floor);
        if (!wanted.empty()) {
            missing += Eigen::Map<const Eigen::VectorXd>(wanted.data(), waves).cwiseProduct(scale);
        }
        return missing;
    };
    Eigen::VectorXd missing = missed();
    const double size = missing.norm();
    for (int twice = 0; twice < 2 && solve; ++twice) {
        y -= solve(missing.cwiseProduct(scale)).cwiseQuotient(scale);
        missing = missed();
    }
    if (!solve || missing.norm() > solved * size) {
        y += leastSquares(period, std::move(missing), cancel);
    }
    y = y.cwiseProduct(scale).eval();
    std::copy(y.begin(), y.end(), floor.periodicity.begin());
}

}  // namespace

void completeFloor(EnergyFloor& floor, const Network& network,
                   std::span<const ContactSpan> schedule, const Cancel& cancel,
                   std::span<const double> wanted)
{
    complete(floor, network, schedule, {}, cancel, wanted);
}

void completeFloor(EnergyFloor& floor, const NetworkBlocks& blocks,
                   const NetworkKernel<double>& kernel)
{
    const std::int64_t steps = stepsOf(blocks.schedule());
    const std::vector<CellRow>& rows = blocks.network().rows;
    const bool isKnown =
        kernel.isWhole() && std::all_of(rows.begin(), rows.end(),
                                        [&](const CellRow& row) { return row.cells <= steps; });
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> solve;
    if (isKnown) {
        solve = [&](const Eigen::VectorXd& given) {
            return periodicBackwards(blocks, kernel, given);
        };
    }
    complete(floor, blocks.network(), blocks.schedule(), solve, {}, {});
}

}  // namespace signorini
