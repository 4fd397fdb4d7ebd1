#pragma once
/// \file
/// What the tests of modes share.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "signorini/modes.hpp"

namespace signorini::test {

/// Every mode of the given order, whatever its energy.
inline ModeBounds upTo(std::int64_t order)
{
    ModeBounds bounds;
    bounds.maxOrder = order;
    bounds.maxEnergyRatio = 1e300;
    return bounds;
}

inline const Mode& find(const std::vector<Mode>& modes, std::int64_t a, std::int64_t b)
{
    const auto at = std::find_if(modes.begin(), modes.end(),
                                 [a, b](const Mode& mode) { return mode.a == a && mode.b == b; });
    if (at == modes.end()) {
        throw std::runtime_error("no such mode");
    }
    return *at;
}

/// The numbers n with lowest < n/cells < highest and gcd(2N, n) = 1.
inline std::vector<std::int64_t> coprimeSteps(const Mode& mode, std::int64_t cells)
{
    std::vector<std::int64_t> result;
    for (std::int64_t n = mode.lowest.numerator * cells / mode.lowest.denominator + 1;
         n * mode.highest.denominator < mode.highest.numerator * cells; ++n) {
        if (std::gcd(2 * cells, n) == 1) {
            result.push_back(n);
        }
    }
    return result;
}

/// A period in the interval that no short fraction comes near: lowest + (highest - lowest) times
/// a number in ]0, 1[.
inline double periodAt(const Mode& mode, double part)
{
    return mode.lowest.value() + part * (mode.highest.value() - mode.lowest.value());
}

}  // namespace signorini::test
