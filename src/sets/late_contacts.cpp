#include "late_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "harmonic_motion.hpp"
#include "infinity.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

constexpr int grownPeriods = 3000;  // in which growth is looked at, and as many before
constexpr double together = 1e-9;   // a front and a pair of growths that are all there is

/// About how much late beginnings grow, and a root that they go with.
struct Grown {
    double size;
    std::complex<double> root;
};

/// a(n + 1) = p a(n) + q a(n - 1) at the end, or else the mean growth of two long stretches.
std::optional<Grown> pairOf(const std::vector<double>& late, const std::vector<double>& scale,
                            std::size_t count)
{
    const std::size_t all = scale.size();
    const auto at = [&](std::size_t n) { return late[n * count]; };
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    double xz = 0.0;
    double yz = 0.0;
    double zz = 0.0;
    for (std::size_t n = all - 20; n + 1 < all; ++n) {
        if (scale[n - 1] != scale[all - 1]) {
            continue;
        }
        const double x = at(n);
        const double y = at(n - 1);
        const double z = at(n + 1);
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xz += x * z;
        yz += y * z;
        zz += z * z;
    }
    const double one = zz > 0.0 ? xz / xx : 0.0;
    if (zz > 0.0 && std::abs(zz - one * xz) < together * zz) {
        return Grown{std::abs(one), one};
    }
    const double area = xx * yy - xy * xy;
    const double p = (xz * yy - yz * xy) / area;
    const double q = (yz * xx - xz * xy) / area;
    const double square = 0.25 * p * p + q;
    const std::complex<double> root(0.5 * p + std::copysign(std::sqrt(std::max(square, 0.0)), p),
                                    std::sqrt(std::max(-square, 0.0)));
    if (std::isfinite(p) && std::isfinite(q) && std::abs(zz - p * xz - q * yz) < together * zz) {
        return Grown{square < 0.0 ? std::sqrt(-q) : std::abs(root.real()), root};
    }
    const auto size = [&](std::size_t n) {
        double sum = 0.0;
        for (std::size_t i = n - 200; i < n; ++i) {
            const double value = at(i);
            sum += value * value * portable::exp(2.0 * (scale[i] - scale[n - 1]));
        }
        return 0.5 * portable::log(sum) + scale[n - 1];
    };
    const std::size_t third = all / 3;
    const double early =
        portable::exp((size(2 * all / 3) - size(third)) / static_cast<double>(third));
    const double last = portable::exp((size(all) - size(2 * all / 3)) / static_cast<double>(third));
    return std::isfinite(last) && std::abs(early - last) <= sameGrowth * last
               ? std::optional(Grown{last, root})
               : std::nullopt;
}

/// det of sum over s of w_s z^-s.
std::complex<double> determinant(const std::vector<double>& weights, std::size_t count,
                                 std::complex<double> z)
{
    const std::size_t square = count * count;
    const std::complex<double> later = 1.0 / z;
    std::vector<std::complex<double>> sums(square);
    for (std::size_t s = weights.size() / square; s-- > 0;) {
        for (std::size_t i = 0; i < square; ++i) {
            sums[i] = later * sums[i] + weights[s * square + i];
        }
    }
    std::complex<double> product = 1.0;
    for (std::size_t k = 0; k < count; ++k) {
        std::size_t pivot = k;
        for (std::size_t row = k + 1; row < count; ++row) {
            pivot =
                std::norm(sums[row * count + k]) > std::norm(sums[pivot * count + k]) ? row : pivot;
        }
        if (pivot != k) {
            std::swap_ranges(&sums[k * count], &sums[k * count] + count, &sums[pivot * count]);
            product = -product;
        }
        product *= sums[k * count + k];
        for (std::size_t row = k + 1; row < count; ++row) {
            const std::complex<double> factor = sums[row * count + k] / sums[k * count + k];
            for (std::size_t column = k; column < count; ++column) {
                sums[row * count + column] -= factor * sums[k * count + column];
            }
        }
    }
    return product;
}

/// The root itself, by secants; what is known about it where they lead elsewhere.
double refined(const Grown& grown, const std::vector<double>& weights, std::size_t count)
{
    constexpr int mostSecants = 40;
    constexpr double apart = 1e-4;
    constexpr double noMove = 1e-13;
    std::complex<double> last = grown.root * (1.0 + apart);
    std::complex<double> now = grown.root;
    std::complex<double> lastValue = determinant(weights, count, last);
    for (int k = 0; k < mostSecants; ++k) {
        const std::complex<double> value = determinant(weights, count, now);
        const std::complex<double> move =
            value == 0.0 ? 0.0 : value * (now - last) / (lastValue - value);
        last = now;
        lastValue = value;
        now += move;
        if (lengthOf(move) <= noMove * lengthOf(now)) {
            const double size = lengthOf(now);
            return std::abs(size - grown.size) <= sameGrowth * grown.size ? size : grown.size;
        }
    }
    return grown.size;
}

/// In four sums that do not wait for each other, the same on every machine.
double sumOfProducts(const double* x, const double* y, std::size_t count)
{
    std::array<double, 4> sums = {};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        for (std::size_t k = 0; k < 4; ++k) {
            sums[k] += x[i + k] * y[i + k];
        }
    }
    for (; i < count; ++i) {
        sums[0] += x[i] * y[i];
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

std::optional<double> growthOfLate(const std::vector<double>& weights, std::size_t terms,
                                   std::size_t count)
{
    const std::size_t all = 2 * static_cast<std::size_t>(grownPeriods);
    const std::size_t width = terms * count;
    // By k, the oldest first, as in `late`: each sum is one of two lists in their order.
    std::vector<double> rows(count * width);
    for (std::size_t s = 0; s < terms; ++s) {
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t j = 0; j < count; ++j) {
                rows[k * width + (terms - 1 - s) * count + j] =
                    weights[(s * count + k) * count + j];
            }
        }
    }
    // Before the first period nothing is late.
    std::vector<double> late(width + count * (all - 1), 0.0);
    std::vector<double> scale(all, 0.0);  // log of what late is divided by
    for (std::size_t n = 0; n < all; ++n) {
        double* first = &late[n * count];
        double* now = first + width - count;
        for (std::size_t k = 0; k < count; ++k) {
            const double begin = n == 0 ? -1.0 / static_cast<double>(k + 1) : 0.0;
            // What is not known yet is 0.
            now[k] = -begin - sumOfProducts(&rows[k * width], first, width);
        }
        scale[n] = n > 0 ? scale[n - 1] : 0.0;
        double most = 0.0;
        for (std::size_t k = 0; k < count; ++k) {
            most = std::max(most, std::abs(now[k]));
        }
        if (most > 1e100 || (most < 1e-100 && most > 0.0)) {
            // Only what is still seen is kept on one scale.
            const double common = scale[n] + portable::log(most);
            for (std::size_t i = n - std::min(n, terms); i <= n; ++i) {
                scale[i] = common;
            }
            std::for_each(first - (n >= terms ? count : 0), now + count,
                          [most](double& one) { one /= most; });
        }
    }
    late.erase(late.begin(), late.begin() + static_cast<std::ptrdiff_t>(width - count));
    const std::optional<Grown> grown = pairOf(late, scale, count);
    return grown ? std::optional(refined(*grown, weights, count)) : std::nullopt;
}

void takeOffPlace(std::vector<double>& weights, std::span<const double> by)
{
    const std::size_t count = by.size();
    const std::size_t square = count * count;
    const auto first = static_cast<std::size_t>(
        std::find_if(by.begin(), by.end(), [](double one) { return one != 0.0; }) - by.begin());
    for (std::size_t s = weights.size() / square; s-- > 0 && first < count;) {
        double* now = &weights[s * square];
        for (std::size_t j = 0; j < count; ++j) {
            const std::size_t row = first * count + j;
            for (std::size_t k = first + 1; k < count; ++k) {
                now[k * count + j] -= by[k] / by[first] * now[row];
            }
            now[row] -= s > 0 ? weights[(s - 1) * square + row] : 0.0;
        }
    }
}

std::optional<double> growthOfOrders(bool arePinned,
                                     const std::function<OrderedGrowth(const FrontOrders&)>& growth)
{
    double least = infinity;
    double most = 0.0;
    for (int order = 0; order < (arePinned ? 4 : 2); ++order) {
        const FrontOrders orders{order >= 2, order % 2 == 1};
        const OrderedGrowth one = growth(orders);
        if (!one.growth) {
            return std::nullopt;
        }
        least = std::min(least, *one.growth);
        most = std::max(most, *one.growth);
        if (most - least > sameGrowth * most) {
            return std::nullopt;
        }
        // Else the next, which differs in that alone, has the same.
        order += !orders.isLateAtContact && !one.dependsOnContact ? 1 : 0;
    }
    return most;
}

}  // namespace signorini
