#pragma once
/// \file
/// What the tests of modes share.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "catch.hpp"
#include "signorini/modes.hpp"
#include "signorini/simulation.hpp"

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

/// The waves of a mode at t = 0, which leave the clamp and the tip where p jumps.
inline Waves wavesOf(const ModeMotion& motion)
{
    Waves waves;
    std::vector<double> ends;
    for (double turn = 0.0; turn < 2.0; turn += motion.period()) {
        for (const double jump : motion.jumpTimes()) {
            ends.push_back(turn + jump);
        }
        ends.push_back(turn + motion.period());
    }
    ends.push_back(1.0);
    ends.push_back(2.0);
    std::sort(ends.begin(), ends.end());
    double before = 0.0;
    for (const double end : ends) {
        if (end > before && end <= 2.0) {
            // a arrives as p, b as -p a crossing later.
            const double p = motion.incoming(0.5 * (before + end));
            (end <= 1.0 ? waves.a : waves.b).push_back({end - before, end <= 1.0 ? p : -p});
            before = end;
        }
    }
    return waves;
}

/// Every type of the given order, whatever its energy and period.
inline ModeBounds anyEnergy(std::int64_t order)
{
    ModeBounds bounds = upTo(order);
    bounds.maxPeriod = 1e9;
    return bounds;
}

inline std::int64_t sumOfK(const ModePolytope& polytope)
{
    return std::accumulate(polytope.chains.begin(), polytope.chains.end(), std::int64_t{0},
                           [](std::int64_t sum, const ModeChain& chain) { return sum + chain.k; });
}

/// Cycles of the map i -> next(i).
template <typename Next>
int cycles(std::size_t count, Next next)
{
    std::vector<bool> seen(count);
    int result = 0;
    for (std::size_t i = 0; i < count; ++i) {
        result += seen[i] ? 0 : 1;
        for (std::size_t j = i; !seen[j]; j = next(j)) {
            seen[j] = true;
        }
    }
    return result;
}

/// The chain that ends where flight l begins.
inline std::size_t chainTo(const ModePolytope& polytope, std::size_t l)
{
    std::size_t i = 0;
    while (polytope.chains[i].release != l) {
        ++i;
    }
    return i;
}

/// What docs/theory.md proves of every type.
inline void requireTheorems(const ModePolytope& polytope)
{
    const std::size_t count = polytope.chains.size();
    for (const ModeChain& chain : polytope.chains) {
        REQUIRE(chain.k >= 2);
        REQUIRE(chain.k % 2 == 0);
    }
    REQUIRE(polytope.order % 2 == 1);
    REQUIRE(polytope.jumps.size() == static_cast<std::size_t>(sumOfK(polytope)));
    REQUIRE(cycles(count, [&](std::size_t i) { return polytope.chains[i].release; }) % 2 == 1);
    const int free =
        cycles(count, [&](std::size_t i) { return chainTo(polytope, (i + count - 1) % count); });
    REQUIRE(polytope.dimension < free);
    REQUIRE(polytope.highest.value() <= 4.0 * static_cast<double>(count));
    if (polytope.dimension + 1 == static_cast<std::int64_t>(count)) {
        REQUIRE(polytope.divisor == 1);
    }
}

}  // namespace signorini::test
