#include "signorini/amplitude_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "faults.hpp"
#include "set_kind_names.hpp"

namespace signorini {

std::string_view name(SetKind kind)
{
    return nameIn(setKindNames, kind);
}

double distanceOutside(const AmplitudeSet& set, std::span<const double> z)
{
    if (static_cast<std::int64_t>(z.size()) != set.count || set.count == 0) {
        throw std::invalid_argument(
            fmt::format("amplitudes: {} values given: allowed exactly {}", z.size(), set.count));
    }
    const bool isBox = set.kind == SetKind::box;
    double worst = 0.0;
    double partial = 0.0;
    for (std::size_t j = 0; j < z.size(); ++j) {
        if (!std::isfinite(z[j])) {
            return std::numeric_limits<double>::infinity();
        }
        partial += z[j];
        if (isBox && j + 1 < z.size()) {
            worst = std::max({worst, set.lower - partial, partial - set.upper});
        }
        if (set.kind == SetKind::simplex || set.kind == SetKind::cone) {
            worst = std::max(worst, -z[j]);
        }
    }
    return std::max(worst, std::abs(partial - set.sum)) / std::abs(set.sum);
}

std::vector<double> drawAmplitudes(const AmplitudeSet& set, std::mt19937_64& generator)
{
    if (set.count == 0) {
        throw std::invalid_argument("amplitudes: the set is empty: nothing can be drawn from it");
    }
    std::vector<double> z(static_cast<std::size_t>(set.count));
    if (set.kind == SetKind::box) {
        std::uniform_real_distribution<double> partialSum(set.lower, set.upper);
        double previous = 0.0;
        for (std::size_t j = 0; j < z.size(); ++j) {
            const double next = j + 1 < z.size() ? partialSum(generator) : set.sum;
            z[j] = next - previous;
            previous = next;
        }
        return z;
    }
    // Normalised exponential variables are uniform on the simplex.
    std::exponential_distribution<double> exponential;
    double total = 0.0;
    for (double& value : z) {
        value = exponential(generator);
        total += value;
    }
    for (double& value : z) {
        value *= set.sum / total;
    }
    return z;
}

}  // namespace signorini
