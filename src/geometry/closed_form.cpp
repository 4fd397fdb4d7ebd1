#include "signorini/amplitude_set.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "faults.hpp"

namespace signorini {

namespace {

/// The farthest point of a box: Z_1 = first, then jumps across the whole box, then the step to S.
/// Sum of squares is convex, so an optimum has every inner Z_j at a bound; an inner pair of equal
/// neighbours is needed only when the parity of the jumps does not fit.
struct Zigzag {
    bool firstIsUpper;
    bool lastIsUpper;
    std::int64_t jumps;
    double squares;
};

Zigzag farthestZigzag(const AmplitudeSet& box)
{
    const std::int64_t inner = box.count - 1;  // Z_1 .. Z_{d-1}
    const double width = box.upper - box.lower;
    Zigzag best{false, false, 0, -1.0};
    for (const bool firstIsUpper : {false, true}) {
        for (const bool lastIsUpper : {false, true}) {
            const std::int64_t parity = firstIsUpper == lastIsUpper ? 0 : 1;
            if (inner - 1 < parity) {
                continue;
            }
            const std::int64_t jumps = inner - 1 - (inner - 1 - parity) % 2;
            const double first = firstIsUpper ? box.upper : box.lower;
            const double last = box.sum - (lastIsUpper ? box.upper : box.lower);
            const double squares =
                first * first + last * last + static_cast<double>(jumps) * width * width;
            if (squares > best.squares) {
                best = {firstIsUpper, lastIsUpper, jumps, squares};
            }
        }
    }
    return best;
}

bool isProperBox(const AmplitudeSet& set)
{
    return set.kind == SetKind::box && set.count > 1;
}

/// max(0, t_j - shift) with the right sum. All amplitudes are counted from the largest target:
/// those that stay positive are within S of it, so that large targets cost no digits.
std::vector<double> nearestInSimplex(const AmplitudeSet& set, std::span<const double> target)
{
    std::vector<double> descending(target.begin(), target.end());
    std::sort(descending.begin(), descending.end(), std::greater<>());
    const double largest = descending.front();
    // The k largest stay positive for the largest k at which they all exceed their shift.
    double sum = 0.0;
    double shift = 0.0;
    for (std::size_t k = 0; k < descending.size(); ++k) {
        const double below = descending[k] - largest;
        sum += below;
        const double next = (sum - set.sum) / static_cast<double>(k + 1);
        if (below <= next) {
            break;
        }
        shift = next;
    }
    std::vector<double> z(target.begin(), target.end());
    for (double& value : z) {
        value = std::max(0.0, (value - largest) - shift);
    }
    return z;
}

/// The partial sums Z less those of the target, T, are a string pulled taut through the tube
/// lower - T_j .. upper - T_j, since sum (z - t)^2 is the sum of its squared slopes. Between the
/// knots, where it touches the tube, its slope is constant.
class TautString {
public:
    TautString(const AmplitudeSet& box, std::span<const double> target)
        : box_(box), target_(target), sums_(target.size() + 1, 0.0L)
    {
        for (std::size_t j = 0; j < target.size(); ++j) {
            // Counted from the first: only differences of targets matter.
            sums_[j + 1] = sums_[j] + (static_cast<long double>(target[j]) - target[0]);
        }
    }

    [[nodiscard]] std::vector<double> pull() const
    {
        std::vector<double> z(target_.size());
        Knot from{0, 0.0};
        while (from.index < z.size()) {
            const Knot to = next(from);
            fill(z, from, to);
            from = to;
        }
        return z;
    }

private:
    /// Z_index = value.
    struct Knot {
        std::size_t index;
        double value;
    };

    /// The first place where the straight way on has to bend: the view through the tube closes.
    [[nodiscard]] Knot next(const Knot& from) const
    {
        Knot lower = from;
        Knot upper = from;
        long double leastSlope = -std::numeric_limits<long double>::infinity();
        long double mostSlope = std::numeric_limits<long double>::infinity();
        for (std::size_t j = from.index + 1; j <= target_.size(); ++j) {
            const bool isEnd = j == target_.size();
            const Knot low{j, isEnd ? box_.sum : box_.lower};
            const Knot high{j, isEnd ? box_.sum : box_.upper};
            const long double up = slope(from, low);
            const long double down = slope(from, high);
            if (up > mostSlope) {
                return upper;
            }
            if (down < leastSlope) {
                return lower;
            }
            if (up >= leastSlope) {
                leastSlope = up;
                lower = low;
            }
            if (down <= mostSlope) {
                mostSlope = down;
                upper = high;
            }
        }
        return {target_.size(), box_.sum};
    }

    [[nodiscard]] long double slope(const Knot& from, const Knot& to) const
    {
        const long double rise = static_cast<long double>(to.value) - from.value;
        return (rise - (sums_[to.index] - sums_[from.index])) /
               static_cast<long double>(to.index - from.index);
    }

    void fill(std::vector<double>& z, const Knot& from, const Knot& to) const
    {
        const std::size_t length = to.index - from.index;
        if (length == 1) {
            z[from.index] = to.value - from.value;  // whatever the target
            return;
        }
        const double origin = target_[from.index];
        long double total = 0.0L;
        for (std::size_t j = from.index; j < to.index; ++j) {
            total += static_cast<long double>(target_[j]) - origin;
        }
        const long double constant = (static_cast<long double>(to.value) - from.value - total) /
                                     static_cast<long double>(length);
        for (std::size_t j = from.index; j < to.index; ++j) {
            z[j] = static_cast<double>(static_cast<long double>(target_[j]) - origin + constant);
        }
    }

    const AmplitudeSet& box_;
    std::span<const double> target_;
    std::vector<long double> sums_;
};

std::vector<double> nearestInBox(const AmplitudeSet& box, std::span<const double> target)
{
    return TautString(box, target).pull();
}

}  // namespace

double leastSquares(const AmplitudeSet& set)
{
    return set.count == 0 ? 0.0 : set.sum * set.sum / static_cast<double>(set.count);
}

double mostSquares(const AmplitudeSet& set)
{
    return isProperBox(set) ? farthestZigzag(set).squares : set.sum * set.sum;
}

std::vector<double> leastAmplitudes(const AmplitudeSet& set)
{
    const auto count = static_cast<std::size_t>(set.count);
    std::vector<double> z(count, set.sum / static_cast<double>(set.count));
    return z;
}

std::vector<double> mostAmplitudes(const AmplitudeSet& set)
{
    std::vector<double> z(static_cast<std::size_t>(set.count), 0.0);
    if (!isProperBox(set)) {
        if (!z.empty()) {
            z.front() = set.sum;
        }
        return z;
    }
    const Zigzag path = farthestZigzag(set);
    bool atUpper = path.firstIsUpper;
    const auto position = [&set](bool upper) { return upper ? set.upper : set.lower; };
    z.front() = position(atUpper);
    for (std::size_t j = 1; j <= static_cast<std::size_t>(path.jumps); ++j) {
        z[j] = position(!atUpper) - position(atUpper);
        atUpper = !atUpper;
    }
    z.back() = set.sum - position(atUpper);
    return z;
}

std::vector<double> nearestAmplitudes(const AmplitudeSet& set, std::span<const double> target)
{
    if (static_cast<std::int64_t>(target.size()) != set.count || set.count == 0) {
        throw std::invalid_argument(
            fmt::format("target: {} amplitudes given: allowed exactly {}, and at least 1",
                        target.size(), set.count));
    }
    if (set.count == 1) {
        return {set.sum};
    }
    return isProperBox(set) ? nearestInBox(set, target) : nearestInSimplex(set, target);
}

std::vector<double> amplitudesWithSquares(const AmplitudeSet& set, double squares)
{
    const double least = leastSquares(set);
    const double most = mostSquares(set);
    const double rounding = 1e-14 * most;
    if (!(squares >= least - rounding && squares <= most + rounding)) {
        throw std::invalid_argument("sum of squares: outside the range of the set");
    }
    std::vector<double> z = leastAmplitudes(set);
    if (most <= least) {
        return z;
    }
    const double share = std::sqrt(std::clamp((squares - least) / (most - least), 0.0, 1.0));
    const std::vector<double> far = mostAmplitudes(set);
    for (std::size_t j = 0; j < z.size(); ++j) {
        z[j] += share * (far[j] - z[j]);
    }
    return z;
}

}  // namespace signorini
