#include "signorini/lumped_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "double_description.hpp"
#include "exact_projection.hpp"
#include "faults.hpp"
#include "signorini/amplitude_set.hpp"

namespace signorini {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t maxRays = 512;
constexpr std::size_t maxTypesForVertices = 12;

/// ExactRow::tag: closures carry the number of their phase.
constexpr std::int64_t gapTag = -1;
constexpr std::int64_t signTag = -2;
constexpr std::int64_t prefixTag = -3;

/// For each type its place among the live ones, or -1.
std::vector<std::ptrdiff_t> placesOf(const ClassTypes& classes)
{
    std::vector<std::ptrdiff_t> places;
    std::ptrdiff_t next = 0;
    for (const ClassType& type : classes.types) {
        places.push_back(type.isLive() ? next++ : -1);
    }
    return places;
}

/// Calls action(block, place, sign) for every live block in flight, and atEnd(phase) after the
/// last block of each flight.
template <typename Action, typename AtEnd>
void walkFlights(const ClassTypes& classes, Action action, AtEnd atEnd)
{
    const std::vector<std::ptrdiff_t> places = placesOf(classes);
    forEachBlock(classes, [&](const Block& block) {
        const std::ptrdiff_t place = places[block.type];
        if (!block.isContact && place >= 0) {
            const auto& signs = classes.types[block.type].signs;
            action(block, static_cast<std::size_t>(place),
                   std::int64_t{signs[static_cast<std::size_t>(block.alpha)]});
        }
        if (block.endsPhase) {
            atEnd(block.phase);
        }
    });
}

std::vector<std::size_t> liveTypes(const ClassTypes& classes)
{
    std::vector<std::size_t> live;
    for (std::size_t t = 0; t < classes.types.size(); ++t) {
        if (classes.types[t].isLive()) {
            live.push_back(t);
        }
    }
    return live;
}

/// The rows in the sums S.
class LumpedRows : public RowSource {
public:
    LumpedRows(const ClassTypes& classes, const std::vector<std::size_t>& live)
        : classes_(classes), live_(live)
    {
    }

    [[nodiscard]] std::size_t unknowns() const override { return live_.size(); }

    [[nodiscard]] std::optional<ExactRow> violatedRow(const Homogeneous& point) const override
    {
        // Every sum below stays within the largest number times this.
        const Integer terms =
            Integer(blockCount(classes_.schedule)) +
            2 * classes_.schedule.cells * (static_cast<std::int64_t>(unknowns()) + 1);
        Integer largest = point.denominator;
        for (const Integer& value : point.numerators) {
            largest = std::max<Integer>(largest, abs(value));
        }
        if (largest * terms <= std::numeric_limits<std::int64_t>::max()) {
            std::vector<std::int64_t> small;
            for (const Integer& value : point.numerators) {
                small.push_back(static_cast<std::int64_t>(value));
            }
            return violatedRow(small, static_cast<std::int64_t>(point.denominator));
        }
        return violatedRow(point.numerators, point.denominator);
    }

private:
    /// The gap row if it is broken, else the worst closure, else the worst inequality.
    template <typename Number>
    [[nodiscard]] std::optional<ExactRow> violatedRow(const std::vector<Number>& sums,
                                                      const Number& denominator) const
    {
        Number gap = denominator * classes_.schedule.cells;
        for (std::size_t i = 0; i < live_.size(); ++i) {
            gap += sums[i] * classes_.types[live_[i]].windowSum;
        }
        if (gap != 0) {
            return gapRow();
        }
        const std::size_t lastPhase = classes_.schedule.phases.size() - 1;
        Number worst = 0;
        std::optional<std::size_t> negative;  // live type
        for (std::size_t i = 0; i < live_.size(); ++i) {
            if (classes_.types[live_[i]].kind == TypeKind::pressing && -sums[i] > worst) {
                worst = -sums[i];
                negative = i;
            }
        }
        Number prefix = 0;
        Number worstClosure = 0;
        std::int64_t block = 0;
        std::int64_t worstBlock = -1;
        std::optional<std::size_t> openPhase;
        walkFlights(
            classes_,
            [&](const Block&, std::size_t place, std::int64_t sign) {
                if (sign > 0) {
                    prefix += sums[place];
                } else {
                    prefix -= sums[place];
                }
                if (prefix > worst) {
                    worst = prefix;
                    worstBlock = block;
                }
                ++block;
            },
            [&](std::size_t phase) {
                const Number size = prefix < 0 ? Number(-prefix) : prefix;
                if (phase < lastPhase && size > worstClosure) {
                    worstClosure = size;
                    openPhase = phase;
                }
                prefix = 0;
            });
        if (openPhase) {
            return closure(*openPhase);
        }
        if (worstBlock >= 0) {
            return prefixRow(worstBlock);
        }
        if (negative) {
            ExactRow row{std::vector<std::int64_t>(live_.size()), 0, false, signTag};
            row.coefficients[*negative] = 1;
            return row;
        }
        return std::nullopt;
    }

    [[nodiscard]] ExactRow gapRow() const
    {
        ExactRow row{{}, -classes_.schedule.cells, true, gapTag};
        for (const std::size_t t : live_) {
            row.coefficients.push_back(classes_.types[t].windowSum);
        }
        return row;
    }

    [[nodiscard]] ExactRow closure(std::size_t wanted) const
    {
        ExactRow row{std::vector<std::int64_t>(live_.size()), 0, true,
                     static_cast<std::int64_t>(wanted)};
        walkFlights(
            classes_,
            [&](const Block& block, std::size_t place, std::int64_t sign) {
                row.coefficients[place] += block.phase == wanted ? sign : 0;
            },
            [](std::size_t) {});
        return row;
    }

    /// Minus the prefix sum at the end of the live block in flight of that number is >= 0.
    [[nodiscard]] ExactRow prefixRow(std::int64_t wanted) const
    {
        ExactRow row{std::vector<std::int64_t>(live_.size()), 0, false, prefixTag};
        std::int64_t number = 0;
        walkFlights(
            classes_,
            [&](const Block&, std::size_t place, std::int64_t sign) {
                row.coefficients[place] -= number <= wanted ? sign : 0;
                ++number;
            },
            [&](std::size_t) {
                if (number <= wanted) {
                    std::fill(row.coefficients.begin(), row.coefficients.end(), 0);
                }
            });
        return row;
    }

    const ClassTypes& classes_;
    const std::vector<std::size_t>& live_;
};

std::vector<std::int64_t> countsOf(const LumpedSet& set)
{
    std::vector<std::int64_t> counts;
    for (const std::size_t t : set.live) {
        counts.push_back(set.classes.types[t].count);
    }
    return counts;
}

std::vector<double> asDoubles(const RationalVector& x)
{
    std::vector<double> result;
    for (const Rational& value : x) {
        result.push_back(static_cast<double>(value));
    }
    return result;
}

/// 2w/N, what one unit of sum z^2 is in E/E_1.
Rational energyUnit(const ClassTypes& classes)
{
    return {2 * classes.window, classes.schedule.cells};
}

std::int64_t asInt64(const Integer& value)
{
    if (abs(value) > std::numeric_limits<std::int64_t>::max()) {
        throw std::overflow_error("a multiplier of the proof does not fit in 64 bits");
    }
    return static_cast<std::int64_t>(value);
}

/// From sum weight coefficients = 0 to integer multipliers of the rows as documented: there
/// inequalities point the other way, and rows S >= 0 are left to the reader.
LumpedAbsence absenceOf(const std::vector<WeightedRow>& rows)
{
    RationalVector weights;
    for (const WeightedRow& weighted : rows) {
        weights.push_back(weighted.weight);
    }
    const Homogeneous integers = overCommonDenominator(weights);
    LumpedAbsence absence;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const ExactRow& row = rows[k].row;
        const std::int64_t value = asInt64(integers.numerators[k]);
        if (value == 0 || row.tag == signTag) {
            continue;
        }
        if (row.tag == gapTag) {
            absence.gap = -value;
        } else if (row.tag == prefixTag) {
            PrefixMultiplier prefix{row.coefficients, value};
            for (std::int64_t& c : prefix.coefficients) {
                c = -c;
            }
            absence.prefixes.push_back(std::move(prefix));
        } else {
            absence.closures.push_back({row.tag, -value});
        }
    }
    return absence;
}

void requireMotion(const LumpedSet& set)
{
    if (set.absence) {
        throw std::invalid_argument("set: the schedule has no motion");
    }
}

void requireSums(const LumpedSet& set, std::span<const double> sums)
{
    requireMotion(set);
    if (sums.size() != set.live.size()) {
        throw std::invalid_argument(
            fmt::format("sums: {} values given: allowed exactly {}", sums.size(), set.live.size()));
    }
}

/// Bounds on the partial sums Z of one grazing type: P + epsilon Z <= 0 for each of its blocks, P
/// being the prefix sum before it. Both signs occur among its blocks.
template <typename Number>
std::pair<Number, Number> boundsOf(const ClassTypes& classes, const std::vector<Number>& sums,
                                   std::size_t wanted)
{
    Number prefix = 0;
    std::optional<Number> lower;
    std::optional<Number> upper;
    walkFlights(
        classes,
        [&](const Block&, std::size_t place, std::int64_t sign) {
            if (place == wanted && sign > 0) {
                upper = upper ? std::min<Number>(*upper, -prefix) : Number(-prefix);
            } else if (place == wanted) {
                lower = lower ? std::max<Number>(*lower, prefix) : prefix;
            }
            if (sign > 0) {
                prefix += sums[place];
            } else {
                prefix -= sums[place];
            }
        },
        [&prefix](std::size_t) { prefix = 0; });
    return {*lower, *upper};
}

/// Finds the affine hull of the polyhedron of the sums by projecting points beside it.
class AffineHull {
public:
    AffineHull(const LumpedSet& set, const LumpedRows& rows) : rows_(rows), counts_(countsOf(set))
    {
        const std::size_t size = set.live.size();
        Projection nearest = project(rows, RationalVector(size), counts_);
        points_.push_back(std::move(nearest.point));
        for (const WeightedRow& active : nearest.rows) {
            if (active.row.isEquality) {
                addKnown({active.row.coefficients.begin(), active.row.coefficients.end()});
            }
        }
        while (const auto c = nullVector(known_, size)) {
            if (!stretch(*c, 1) && !stretch(*c, -1)) {
                addKnown({c->begin(), c->end()});
            }
        }
    }

    /// Points that span the polyhedron, one more than it has dimensions.
    [[nodiscard]] const std::vector<RationalVector>& points() const { return points_; }

    /// Their mean, a point in the relative interior.
    [[nodiscard]] RationalVector centre() const
    {
        RationalVector mean(points_.front().size());
        for (const RationalVector& point : points_) {
            for (std::size_t i = 0; i < mean.size(); ++i) {
                mean[i] += point[i] / points_.size();
            }
        }
        return mean;
    }

private:
    /// A functional that is constant on the polyhedron, or a direction inside it: either way one
    /// that need not be tried again.
    void addKnown(RationalVector row) { known_.push_back(std::move(row)); }

    /// Does c . x rise anywhere above its value at the first point? That point is its own
    /// projection from c beyond it exactly if not.
    bool stretch(const IntegerVector& c, int sign)
    {
        RationalVector beside = points_.front();
        for (std::size_t i = 0; i < beside.size(); ++i) {
            beside[i] += c[i] * counts_[i] * sign;
        }
        RationalVector reached = project(rows_, beside, counts_).point;
        if (reached == points_.front()) {
            return false;
        }
        RationalVector direction = reached;
        for (std::size_t i = 0; i < direction.size(); ++i) {
            direction[i] -= points_.front()[i];
        }
        addKnown(std::move(direction));
        points_.push_back(std::move(reached));
        return true;
    }

    const LumpedRows& rows_;
    std::vector<std::int64_t> counts_;
    std::vector<RationalVector> known_;
    std::vector<RationalVector> points_;
};

/// Everything that decides kind and most energy, once the affine hull is known.
class Shape {
public:
    explicit Shape(const LumpedSet& set) : set_(set), rows_(set.classes, set.live) {}

    LumpedShape build()
    {
        const AffineHull hull(set_, rows_);
        const RationalVector centre = hull.centre();
        sumDimension_ = static_cast<std::int64_t>(hull.points().size()) - 1;
        result_.dimension = sumDimension_;
        for (std::size_t i = 0; i < set_.live.size(); ++i) {
            const ClassType& type = typeOf(i);
            if (type.count > 1 && hasInterior(centre, i)) {
                result_.dimension += type.count - 1;
                (type.kind == TypeKind::pressing ? spreadsPressing_ : spreadsGrazing_) = true;
            }
        }
        for (const RationalVector& point : hull.points()) {
            result_.spanning.push_back(asDoubles(point));
        }
        findVertices();
        result_.energy = {set_.leastEnergy, mostEnergy()};
        result_.kind = kind();
        return std::move(result_);
    }

private:
    [[nodiscard]] const ClassType& typeOf(std::size_t i) const
    {
        return set_.classes.types[set_.live[i]];
    }

    /// Can the amplitudes of the type differ from each other at a point inside the polyhedron? The
    /// width of a box is concave in S, so if it is 0 there it is 0 everywhere.
    [[nodiscard]] bool hasInterior(const RationalVector& centre, std::size_t i) const
    {
        if (typeOf(i).kind == TypeKind::pressing) {
            return !centre[i].is_zero();
        }
        const auto [lower, upper] =
            boundsOf(set_.classes, overCommonDenominator(centre).numerators, i);
        return lower < upper;
    }

    void findVertices()
    {
        if (set_.live.size() > maxTypesForVertices) {
            return;
        }
        const auto generators = generatorsOf(rows_, maxRays);
        if (!generators) {
            return;
        }
        result_.isBounded = generators->directions.empty();
        for (const Homogeneous& vertex : generators->vertices) {
            RationalVector point;
            for (const Integer& value : vertex.numerators) {
                point.emplace_back(value, vertex.denominator);
            }
            vertices_.push_back(std::move(point));
        }
        for (const RationalVector& vertex : vertices_) {
            result_.vertices.push_back(asDoubles(vertex));
        }
    }

    /// A convex function is largest at a vertex of the whole set: a vertex S, with all of a
    /// pressing sum in one class. Grazing boxes add vertices of their own unless S is fixed.
    [[nodiscard]] double mostEnergy() const
    {
        if (!result_.isBounded) {
            return infinity;
        }
        if (vertices_.empty() || (spreadsGrazing_ && sumDimension_ > 0)) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        if (spreadsGrazing_) {
            return mostEnergyOfBoxes();
        }
        Rational most = 0;
        for (const RationalVector& vertex : vertices_) {
            Rational squares = 0;
            for (const Rational& sum : vertex) {
                squares += sum * sum;
            }
            most = std::max(most, squares);
        }
        return static_cast<double>(Rational(most * energyUnit(set_.classes)));
    }

    /// S is one point.
    [[nodiscard]] double mostEnergyOfBoxes() const
    {
        const std::vector<double>& sums = result_.spanning.front();
        double squares = 0.0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            squares += mostSquares(amplitudesAt(set_, sums, i));
        }
        return squares * static_cast<double>(energyUnit(set_.classes));
    }

    [[nodiscard]] SetKind kind() const
    {
        if (result_.dimension == 0) {
            return SetKind::point;
        }
        if (sumDimension_ == 0 && !spreadsPressing_) {
            return SetKind::box;
        }
        const bool isSimplex = !spreadsGrazing_ && result_.isBounded &&
                               vertexCount() == static_cast<double>(result_.dimension) + 1.0;
        return isSimplex ? SetKind::simplex : SetKind::polytope;
    }

    /// Vertices of the set in amplitudes: each positive pressing sum may sit in any of its classes.
    [[nodiscard]] double vertexCount() const
    {
        double count = 0.0;
        for (const RationalVector& vertex : vertices_) {
            double lifts = 1.0;
            for (std::size_t i = 0; i < vertex.size(); ++i) {
                lifts *= vertex[i].is_zero() || typeOf(i).kind == TypeKind::grazing
                             ? 1.0
                             : static_cast<double>(typeOf(i).count);
            }
            count += lifts;
        }
        return count;
    }

    const LumpedSet& set_;
    LumpedRows rows_;
    std::int64_t sumDimension_ = 0;
    bool spreadsPressing_ = false;
    bool spreadsGrazing_ = false;
    std::vector<RationalVector> vertices_;
    LumpedShape result_;
};

/// Writes a (reversed: a_i = p_{N-i}) and b (b_i = -p_{N+i-1}) in runs of neighbouring classes:
/// fill(run, sign, type, j) for the classes j, j + 1, ... of a live type.
template <typename Fill>
State writeState(const ClassTypes& classes, Fill fill)
{
    const std::int64_t cells = classes.schedule.cells;
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    auto forward = state.a.reverse();
    for (std::int64_t block = 0; block < classes.window; ++block) {
        for (const ClassType& type : classes.types) {
            const bool live = type.isLive();
            const double sign =
                live ? type.signs[static_cast<std::size_t>(block % classes.members)] : 0.0;
            const std::int64_t begin = block * classes.classes + type.first;
            const std::int64_t end = begin + type.count;
            const std::int64_t split = std::clamp(cells, begin, end);
            const auto write = [&](auto run, double signOfRun, std::int64_t j) {
                if (live) {
                    fill(run, signOfRun, type, j);
                } else {
                    run.setZero();
                }
            };
            if (begin < split) {
                write(forward.segment(begin, split - begin), sign, type.first);
            }
            if (split < end) {
                write(state.b.segment(split - cells, end - split), -sign,
                      type.first + split - begin);
            }
        }
    }
    return state;
}

/// One z per class: choose(the amplitudes of a type at given sums) for each live type, 0 elsewhere.
template <typename Choose>
std::vector<double> amplitudesOf(const LumpedSet& set, const std::vector<double>& sums,
                                 Choose choose)
{
    std::vector<double> z(static_cast<std::size_t>(set.classes.classes), 0.0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const std::vector<double> chosen = choose(amplitudesAt(set, sums, i));
        std::copy(chosen.begin(), chosen.end(), z.data() + set.classes.types[set.live[i]].first);
    }
    return z;
}

}  // namespace

std::int64_t blockCount(const Schedule& schedule)
{
    validate(schedule);
    Schedule folded = schedule;
    fold(folded);
    const std::int64_t n = steps(folded);
    const std::int64_t classes = std::gcd(2 * folded.cells, n);
    const auto boundaries = 2 * static_cast<std::int64_t>(folded.phases.size());
    return n / classes * std::min(boundaries, classes);
}

std::size_t liveTypeCount(const ClassTypes& classes)
{
    return liveTypes(classes).size();
}

LumpedSet lumpedSet(const Schedule& schedule)
{
    const std::int64_t blocks = blockCount(schedule);
    if (blocks > maxBlocks) {
        throw std::invalid_argument(
            fmt::format("schedule: {} blocks in a period: allowed at most {}", blocks, maxBlocks));
    }
    return lumpedSetOf(classTypes(schedule));
}

LumpedSet lumpedSetOf(ClassTypes classes)
{
    LumpedSet set;
    set.live = liveTypes(classes);
    set.classes = std::move(classes);
    if (set.live.size() > maxLiveTypes) {
        throw std::invalid_argument(fmt::format("schedule: {} live types: allowed at most {}",
                                                set.live.size(), maxLiveTypes));
    }
    const LumpedRows rows(set.classes, set.live);
    const std::vector<std::int64_t> counts = countsOf(set);
    const Projection nearest = project(rows, RationalVector(set.live.size()), counts);
    if (!nearest.isFeasible) {
        set.absence = absenceOf(nearest.rows);
        return set;
    }
    Rational squares = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        squares += nearest.point[i] * nearest.point[i] / counts[i];
    }
    set.leastSums = asDoubles(nearest.point);
    set.leastEnergy = static_cast<double>(Rational(squares * energyUnit(set.classes)));
    return set;
}

Reason absenceReason(const ClassTypes& classes)
{
    const auto any = [&classes](auto condition) {
        return std::any_of(classes.types.begin(), classes.types.end(), condition);
    };
    if (classes.kernelDimension == 0) {
        return Reason::noLiveClass;
    }
    if (!any([](const ClassType& type) { return type.isLive(); })) {
        return Reason::contactSign;
    }
    if (!any([](const ClassType& type) {
            return (type.kind == TypeKind::pressing && type.windowSum < 0) ||
                   (type.kind == TypeKind::grazing && type.windowSum != 0);
        })) {
        return Reason::gap;
    }
    return Reason::penetration;
}

LumpedShape shapeOf(const LumpedSet& set)
{
    return set.absence ? LumpedShape{} : Shape(set).build();
}

AmplitudeSet amplitudesAt(const LumpedSet& set, std::span<const double> sums, std::size_t index)
{
    requireSums(set, sums);
    if (index >= set.live.size()) {
        throw std::invalid_argument(
            fmt::format("index = {}: allowed 0..{}", index, set.live.size() - 1));
    }
    const ClassType& type = set.classes.types[set.live[index]];
    AmplitudeSet result{.kind = SetKind::point, .count = type.count, .sum = sums[index]};
    if (type.count == 1) {
        return result;
    }
    result.kind = SetKind::simplex;
    if (type.kind == TypeKind::grazing) {
        result.kind = SetKind::box;
        const auto [lower, upper] =
            boundsOf(set.classes, std::vector<double>(sums.begin(), sums.end()), index);
        result.lower = lower;
        result.upper = std::max(lower, upper);
    }
    return result;
}

State motionOf(const ClassTypes& classes, std::span<const double> z)
{
    if (static_cast<std::int64_t>(z.size()) != classes.classes) {
        throw std::invalid_argument(
            fmt::format("z: {} values given: allowed exactly {}", z.size(), classes.classes));
    }
    const Eigen::Map<const Eigen::VectorXd> values(z.data(), static_cast<Eigen::Index>(z.size()));
    return writeState(classes, [&values](auto& run, double sign, const ClassType&, std::int64_t j) {
        run = sign * values.segment(j, run.size());
    });
}

State equalMotion(const LumpedSet& set, std::span<const double> sums)
{
    requireSums(set, sums);
    std::vector<double> z(set.classes.types.size(), 0.0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        z[set.live[i]] = sums[i] / static_cast<double>(set.classes.types[set.live[i]].count);
    }
    const ClassType* first = set.classes.types.data();
    return writeState(set.classes,
                      [&](auto& run, double sign, const ClassType& type, std::int64_t) {
                          run.setConstant(sign * z[static_cast<std::size_t>(&type - first)]);
                      });
}

State mostEnergyMotion(const LumpedSet& set, const LumpedShape& shape)
{
    requireMotion(set);
    if (!std::isfinite(shape.energy.most)) {
        throw std::invalid_argument("shape: its most energy is infinite or not known");
    }
    const auto squaresOf = [&set](const std::vector<double>& sums) {
        double squares = 0.0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            squares += mostSquares(amplitudesAt(set, sums, i));
        }
        return squares;
    };
    const auto& best = *std::max_element(
        shape.vertices.begin(), shape.vertices.end(),
        [&](const auto& left, const auto& right) { return squaresOf(left) < squaresOf(right); });
    return motionOf(set.classes, amplitudesOf(set, best, mostAmplitudes));
}

State drawMotion(const LumpedSet& set, const LumpedShape& shape, std::mt19937_64& generator)
{
    requireMotion(set);
    std::vector<double> sums(set.live.size(), 0.0);
    const AmplitudeSet mixture{.kind = SetKind::simplex,
                               .count = static_cast<std::int64_t>(shape.spanning.size()),
                               .sum = 1.0};
    const std::vector<double> weights = drawAmplitudes(mixture, generator);
    for (std::size_t k = 0; k < weights.size(); ++k) {
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += weights[k] * shape.spanning[k][i];
        }
    }
    return motionOf(set.classes, amplitudesOf(set, sums, [&generator](const AmplitudeSet& type) {
                        return drawAmplitudes(type, generator);
                    }));
}

}  // namespace signorini
