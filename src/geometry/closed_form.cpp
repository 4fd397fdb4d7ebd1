#include "signorini/closed_form.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

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
    if (isProperBox(set) || static_cast<std::int64_t>(target.size()) != set.count ||
        set.count == 0) {
        throw std::invalid_argument("amplitudes: allowed as many as the set has, and no box");
    }
    if (set.count == 1) {
        return {set.sum};
    }
    // Adding a number to all targets changes nothing: measured from the largest, no target is too
    // far away for the sum to be seen beside it.
    const double largest = *std::max_element(target.begin(), target.end());
    std::vector<double> z(target.begin(), target.end());
    for (double& value : z) {
        value -= largest;
    }
    std::vector<double> descending = z;
    std::sort(descending.begin(), descending.end(), std::greater<>());
    // The k largest stay positive for the largest k at which they all exceed their shift.
    double sum = 0.0;
    double shift = 0.0;
    for (std::size_t k = 0; k < descending.size(); ++k) {
        sum += descending[k];
        const double next = (sum - set.sum) / static_cast<double>(k + 1);
        if (descending[k] <= next) {
            break;
        }
        shift = next;
    }
    for (double& value : z) {
        value = std::max(0.0, value - shift);
    }
    return z;
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
