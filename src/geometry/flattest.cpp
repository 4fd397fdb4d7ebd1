#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "faults.hpp"
#include "signorini/amplitude_set.hpp"

namespace signorini {

namespace {

/// Roundings of 1/rho that count as the whole number next to it.
constexpr double roundingOfSquares = 1e-12;

double checkedRatio(const AmplitudeSet& set, double squares)
{
    const double least = leastSquares(set);
    const double most = mostSquares(set);
    if (set.count == 0 || !(squares >= least * (1.0 - roundingOfSquares) &&
                            squares <= most * (1.0 + roundingOfSquares))) {
        throwFault("sum of squares", squares, fmt::format("{}..{}", least, most));
    }
    return std::clamp(squares, least, most) / (set.sum * set.sum);
}

/// Shares of a simplex: m equal ones, the rest of the sum, zeros.
void fillSimplex(std::vector<double>& shares, double ratio)
{
    const auto count = static_cast<double>(shares.size());
    const double inverse = std::min(1.0 / ratio, count);
    const double whole = std::round(inverse);
    const bool isWhole = std::abs(inverse - whole) <= roundingOfSquares * inverse;
    const double m = isWhole ? whole : std::floor(inverse);
    const double most =
        isWhole ? 1.0 / m
                : (1.0 + std::sqrt(std::max(0.0, ((m + 1.0) * ratio - 1.0) / m))) / (m + 1.0);
    const auto equal = static_cast<std::ptrdiff_t>(m);
    std::fill(shares.begin(), shares.end(), 0.0);
    std::fill(shares.begin(), shares.begin() + equal, most);
    if (!isWhole) {
        shares[static_cast<std::size_t>(equal)] = std::max(0.0, 1.0 - m * most);
    }
}

/// Steps of one size up and down, in full strokes between 0 and `top` of them, the last ones
/// shorter; so many of them down, and ending at the top.
std::vector<double> strokes(std::int64_t down, std::int64_t top, double size)
{
    std::vector<double> steps;
    std::int64_t stroke = top;
    for (double direction = 1.0; stroke > 0; direction = -direction) {
        steps.insert(steps.end(), static_cast<std::size_t>(stroke), direction * size);
        if (direction > 0.0) {
            stroke = std::min(top, down);
            down -= stroke;
        }
    }
    return steps;
}

/// Shares of a box, the steps of a walk from 0 to 1 that stays between: all of one size but one.
std::vector<double> flattestSteps(std::int64_t count, double ratio)
{
    const auto d = static_cast<double>(count);
    // Steps up less steps down, of d - 1: the whole number next to 1/size that has their parity.
    const std::int64_t least = count % 2 == 0 ? 1 : 2;
    const double pairs = (std::sqrt(d / ratio) - static_cast<double>(least)) / 2.0;
    const std::int64_t net = std::min(
        count - 1, least + 2 * std::max<std::int64_t>(0, std::llround(pairs + roundingOfSquares)));
    const auto j = static_cast<double>(net);
    const double square = d - 1.0 + j * j;
    const double size =
        std::min(1.0, (j + std::sqrt(std::max(0.0, j * j - square * (1.0 - ratio)))) / square);
    const double rest = 1.0 - j * size;
    if (rest >= 0.0) {
        std::vector<double> steps = strokes((count - 1 - net) / 2, net, size);
        steps.push_back(rest);
        return steps;
    }
    // A step down: it makes the last of them longer, if that is no full stroke.
    const std::int64_t top = net - 1;
    const std::int64_t down = (count - 2 - top) / 2;
    std::vector<double> steps = strokes(down, top, size);
    steps.insert(steps.end() - static_cast<std::ptrdiff_t>(down % top), rest);
    steps.push_back(size);
    return steps;
}

void requireWholeBox(const AmplitudeSet& set)
{
    if (set.kind == SetKind::box &&
        !(set.lower == std::min(0.0, set.sum) && set.upper == std::max(0.0, set.sum))) {
        throw std::invalid_argument(
            fmt::format("box: partial sums {}..{}: allowed those between 0 and S = {}", set.lower,
                        set.upper, set.sum));
    }
}

void scale(std::vector<double>& values, double factor)
{
    for (double& value : values) {
        value *= factor;
    }
}

/// How many of the largest targets stay positive: sum (t - t_next)^2 / (sum (t - t_next))^2, that
/// of a point with one amplitude about to leave 0, falls with their number; the first not above
/// rho.
std::size_t positiveCount(const std::vector<double>& below, double ratio)
{
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t k = 1; k < below.size(); ++k) {
        const auto count = static_cast<double>(k);
        const double gap = below[k - 1] - below[k];
        squares += gap * (2.0 * sum + count * gap);
        sum += count * gap;
        if (sum > 0.0 && squares <= ratio * sum * sum) {
            return k;
        }
    }
    return below.size();
}

}  // namespace

std::vector<double> flattestAmplitudes(const AmplitudeSet& set, double squares)
{
    const double ratio = checkedRatio(set, squares);
    requireWholeBox(set);
    std::vector<double> z;
    if (set.kind == SetKind::box && set.count > 1) {
        z = flattestSteps(set.count, ratio);
    } else {
        z.resize(static_cast<std::size_t>(set.count));
        fillSimplex(z, ratio);
    }
    scale(z, set.sum);
    return z;
}

std::vector<double> nearestWithSquares(const AmplitudeSet& set, std::span<const double> target,
                                       double squares)
{
    const double ratio = checkedRatio(set, squares);
    const auto count = static_cast<std::size_t>(set.count);
    if (target.size() != count || (set.kind == SetKind::box && count > 1)) {
        throw std::invalid_argument(
            fmt::format("target: {} amplitudes given, of a {}: allowed exactly {}, of a simplex",
                        target.size(), name(set.kind), count));
    }
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&target](std::size_t i, std::size_t k) { return target[i] > target[k]; });
    // Counted from the largest target, and in units of the spread: only directions matter.
    const double largest = target[order.front()];
    const double spread =
        std::max(largest - target[order.back()], std::numeric_limits<double>::min());
    std::vector<double> below(count);
    for (std::size_t k = 0; k < count; ++k) {
        below[k] = (target[order[k]] - largest) / spread;
    }
    const std::size_t positive = positiveCount(below, ratio);
    std::vector<double> shares(below.begin(),
                               below.begin() + static_cast<std::ptrdiff_t>(positive));
    const auto k = static_cast<double>(positive);
    const double mean = std::accumulate(shares.begin(), shares.end(), 0.0) / k;
    double variance = 0.0;
    for (double& share : shares) {
        share -= mean;
        variance += share * share;
    }
    if (variance > 0.0) {
        scale(shares, std::sqrt(std::max(0.0, ratio - 1.0 / k) / variance));
        for (double& share : shares) {
            share = std::max(0.0, share + 1.0 / k);
        }
    } else {
        fillSimplex(shares, std::max(ratio, 1.0 / k));  // equal targets: all are equally near
    }
    std::vector<double> z(count, 0.0);
    for (std::size_t i = 0; i < positive; ++i) {
        z[order[i]] = set.sum * shares[i];
    }
    return z;
}

}  // namespace signorini
