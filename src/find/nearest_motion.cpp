#include "nearest_motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "formulation.hpp"
#include "program_rows.hpp"
#include "rational.hpp"
#include "signorini/amplitude_set.hpp"

namespace signorini {

namespace {

constexpr int maxProjections = 200;
constexpr double residualAllowed = 1e-9;

/// The distance of one type as a function of its sum S: on piece k, from starts[k - 1] to
/// starts[k], it is (S - sums[k - 1])^2 / k and a constant.
class TypeDistance {
public:
    TypeDistance(std::span<const double> target, TypeKind kind)
    {
        std::vector<double> descending(target.begin(), target.end());
        std::sort(descending.begin(), descending.end(), std::greater<>());
        Rational sum = 0;
        for (const double value : descending) {
            sum += Rational(value);
            sums_.push_back(sum);
            starts_.push_back(sum - Rational(value) * sums_.size());
        }
        if (kind == TypeKind::grazing) {  // free in sign: all of them, whatever S is
            sums_ = {sum};
            starts_ = {Rational(0)};
            only_ = static_cast<std::int64_t>(descending.size());
        }
    }

    /// The piece that holds S.
    [[nodiscard]] std::size_t pieceAt(const Rational& s) const
    {
        if (only_ > 0) {
            return 0;
        }
        const auto after = std::upper_bound(starts_.begin(), starts_.end(), s);
        return after == starts_.begin() ? 0 : static_cast<std::size_t>(after - starts_.begin()) - 1;
    }

    /// Is S on the piece, ends included?
    [[nodiscard]] bool holds(std::size_t piece, const Rational& s) const
    {
        return only_ > 0 || ((piece == 0 || s >= starts_[piece]) &&
                             (piece + 1 == starts_.size() || s <= starts_[piece + 1]));
    }

    [[nodiscard]] const Rational& centre(std::size_t piece) const { return sums_[piece]; }

    /// k.
    [[nodiscard]] std::int64_t weight(std::size_t piece) const
    {
        return only_ > 0 ? only_ : static_cast<std::int64_t>(piece) + 1;
    }

    /// Half the derivative.
    [[nodiscard]] Rational slope(const Rational& s) const
    {
        const std::size_t piece = pieceAt(s);
        return (s - centre(piece)) / weight(piece);
    }

private:
    std::vector<Rational> sums_;
    std::vector<Rational> starts_;
    std::int64_t only_ = 0;
};

/// How far to go from one point towards another, 0..1, until the distance rises: by halving.
double lengthOf(const std::vector<TypeDistance>& types, const RationalVector& from,
                const RationalVector& to)
{
    const auto rises = [&](double length) {
        Rational slope = 0;
        for (std::size_t i = 0; i < types.size(); ++i) {
            const Rational way = to[i] - from[i];
            slope += way * types[i].slope(from[i] + way * Rational(length));
        }
        return slope > 0;
    };
    double low = 0.0;
    double high = 1.0;
    if (!rises(high)) {
        return high;
    }
    for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        (rises(middle) ? high : low) = middle;
    }
    return low;
}

/// The sums of the nearest motion, boxes of grazing types aside.
std::optional<RationalVector> nearestSums(const ProgramRows& rows,
                                          const std::vector<TypeDistance>& types)
{
    std::optional<RationalVector> at;
    for (int k = 0; k < maxProjections; ++k) {
        RationalVector centre;
        std::vector<std::int64_t> weights;
        std::vector<std::size_t> pieces;
        for (std::size_t i = 0; i < types.size(); ++i) {
            pieces.push_back(at ? types[i].pieceAt((*at)[i]) : 0);
            centre.push_back(types[i].centre(pieces.back()));
            weights.push_back(types[i].weight(pieces.back()));
        }
        const Projection next = project(rows, centre, weights);
        if (!next.isFeasible) {
            return std::nullopt;
        }
        bool isReached = true;
        for (std::size_t i = 0; i < types.size(); ++i) {
            isReached = isReached && types[i].holds(pieces[i], next.point[i]);
        }
        if (isReached) {
            return next.point;
        }
        if (!at) {
            at = next.point;
            continue;
        }
        const double length = lengthOf(types, *at, next.point);
        for (std::size_t i = 0; i < types.size(); ++i) {
            // Rounded: the point only says which pieces to try, and its digits must not grow.
            const Rational reached = (*at)[i] + ((next.point[i] - (*at)[i]) * Rational(length));
            (*at)[i] = Rational(static_cast<double>(reached));
        }
    }
    return std::nullopt;
}

/// All equal steps from the target that reach the sum: the nearest amplitudes where no bound holds.
std::vector<double> shifted(std::span<const double> target, double sum)
{
    const double origin = target.front();
    double total = 0.0;
    for (const double value : target) {
        total += value - origin;
    }
    const double step = (sum - total) / static_cast<double>(target.size());
    std::vector<double> z;
    for (const double value : target) {
        z.push_back(value - origin + step);
    }
    return z;
}

std::span<const double> partOf(const std::vector<double>& values, const ClassType& type)
{
    return std::span(values).subspan(static_cast<std::size_t>(type.first),
                                     static_cast<std::size_t>(type.count));
}

}  // namespace

double nearestResidual(const AmplitudeSet& set, std::span<const double> z,
                       std::span<const double> target)
{
    const double bound = std::max({std::abs(set.sum), std::abs(set.lower), std::abs(set.upper)});
    const double size = bound > 0.0 ? bound : 1.0;  // all amplitudes 0
    double worst = 0.0;
    if (set.kind == SetKind::box && set.count > 1) {
        double partial = 0.0;
        for (std::size_t j = 0; j + 1 < z.size(); ++j) {
            partial += z[j];
            const double gradient = (z[j] - z[j + 1]) - (target[j] - target[j + 1]);
            const double moved = std::clamp(partial - gradient, set.lower, set.upper);
            worst = std::max(worst, std::abs(partial - moved));
        }
        worst = std::max(worst, std::abs(partial + z.back() - set.sum));
        return worst / size;
    }
    // The largest amplitude is positive and tells the shift.
    const auto top = static_cast<std::size_t>(std::max_element(z.begin(), z.end()) - z.begin());
    double sum = 0.0;
    for (std::size_t j = 0; j < z.size(); ++j) {
        const double wanted = std::max(0.0, (target[j] - target[top]) + z[top]);
        worst = std::max(worst, set.count == 1 ? 0.0 : std::abs(z[j] - wanted));
        sum += z[j];
    }
    return std::max(worst, std::abs(sum - set.sum)) / size;
}

std::optional<State> nearestMotion(const OnePhaseSet& whole, const State& target)
{
    const std::vector<double> wanted = amplitudesOf(whole, target);
    const std::vector<double> z = nearestAmplitudes(whole.set, wanted);
    if (!(nearestResidual(whole.set, z, wanted) <= residualAllowed)) {
        return std::nullopt;
    }
    return motionOf(whole, z);
}

std::optional<State> nearestMotion(const LumpedSet& set, const LumpedShape& shape,
                                   const State& target)
{
    const std::vector<double> wanted = amplitudesOf(set.classes, target);
    const bool isFixed = shape.spanning.size() == 1;
    std::vector<double> sums = isFixed ? shape.spanning.front() : std::vector<double>();
    if (!isFixed) {
        const auto rows =
            ProgramRows::of(formulate(set.classes.schedule, Formulation::lumped).program);
        std::vector<TypeDistance> types;
        for (const std::size_t t : set.live) {
            const ClassType& type = set.classes.types[t];
            types.emplace_back(partOf(wanted, type), type.kind);
        }
        const auto found = rows ? nearestSums(*rows, types) : std::nullopt;
        if (!found) {
            return std::nullopt;
        }
        for (const Rational& sum : *found) {
            sums.push_back(static_cast<double>(sum));
        }
    }
    std::vector<double> z(wanted.size(), 0.0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const ClassType& type = set.type(i);
        const auto part = partOf(wanted, type);
        const AmplitudeSet amplitudes = amplitudesAt(set, sums, i);
        const bool isMovingBox = amplitudes.kind == SetKind::box && !isFixed;
        const std::vector<double> chosen =
            isMovingBox ? shifted(part, sums[i]) : nearestAmplitudes(amplitudes, part);
        if (!(nearestResidual(amplitudes, chosen, part) <= residualAllowed)) {
            return std::nullopt;
        }
        std::copy(chosen.begin(), chosen.end(), z.data() + type.first);
    }
    return motionOf(set.classes, z);
}

}  // namespace signorini
