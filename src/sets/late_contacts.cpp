#include "late_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "infinity.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

constexpr int grownPeriods = 3000;  // in which growth is looked at, and as many before
constexpr double together = 1e-9;   // a front and a pair of growths that are all there is

/// a(n + 1) = p a(n) + q a(n - 1) at the end, or else the mean growth of two long stretches.
std::optional<double> pairOf(const std::vector<double>& late, const std::vector<double>& scale,
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
        return std::abs(one);
    }
    const double area = xx * yy - xy * xy;
    const double p = (xz * yy - yz * xy) / area;
    const double q = (yz * xx - xz * xy) / area;
    if (std::isfinite(p) && std::isfinite(q) && std::abs(zz - p * xz - q * yz) < together * zz) {
        const double square = 0.25 * p * p + q;
        return square < 0.0 ? std::sqrt(-q) : 0.5 * std::abs(p) + std::sqrt(square);
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
    return std::isfinite(last) && std::abs(early - last) <= sameGrowth * last ? std::optional(last)
                                                                              : std::nullopt;
}

}  // namespace

std::optional<double> growthOfLate(const std::vector<double>& weights, std::size_t terms,
                                   std::size_t count)
{
    const std::size_t all = 2 * static_cast<std::size_t>(grownPeriods);
    std::vector<double> late(count * all, 0.0);
    std::vector<double> scale(all, 0.0);  // log of what late is divided by
    for (std::size_t n = 0; n < all; ++n) {
        double* now = &late[n * count];
        for (std::size_t k = 0; k < count; ++k) {
            double sum = n == 0 ? -1.0 / static_cast<double>(k + 1) : 0.0;
            for (std::size_t s = 0; s < std::min(terms, n + 1); ++s) {
                const double* row = &weights[(s * count + k) * count];
                const double* then = &late[(n - s) * count];
                for (std::size_t j = 0; j < (s == 0 ? k : count); ++j) {
                    sum += row[j] * then[j];
                }
            }
            now[k] = -sum;
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
                for (std::size_t k = 0; k < count; ++k) {
                    late[i * count + k] /= most;
                }
                scale[i] = common;
            }
        }
    }
    return pairOf(late, scale, count);
}

std::optional<double> growthOfOrders(
    bool arePinned, const std::function<std::optional<double>(const FrontOrders&)>& growth)
{
    double least = infinity;
    double most = 0.0;
    for (const bool isLateAtRelease : {false, true}) {
        for (const bool isLateAtContact : {false, true}) {
            if (isLateAtRelease && !arePinned) {
                continue;
            }
            const std::optional<double> one = growth({isLateAtRelease, isLateAtContact});
            if (!one) {
                return std::nullopt;
            }
            least = std::min(least, *one);
            most = std::max(most, *one);
            if (most - least > sameGrowth * most) {
                return std::nullopt;
            }
        }
    }
    return most;
}

}  // namespace signorini
