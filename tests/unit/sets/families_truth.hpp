#pragma once
/// \file
/// Families by their definition, modes by a walk over their jumps.

#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "signorini/modes.hpp"

namespace signorini::test {

/// The definition: follows epsilon around Z/nu and asks for the three conditions, block by block.
inline std::optional<Family> byDefinition(std::int64_t w, std::int64_t nu, std::int64_t k,
                                          int gapSign = 1)
{
    std::vector<int> epsilon(static_cast<std::size_t>(nu), 0);
    const auto at = [&](std::int64_t block) -> int& {
        return epsilon[static_cast<std::size_t>(block % nu)];
    };
    int sign = 1;
    for (std::int64_t i = 0; i < nu; ++i) {
        at(i * w) = sign;
        sign *= i * w % nu < k ? 1 : -1;
    }
    if (sign != 1) {
        return std::nullopt;  // the class is dead
    }
    int prefix = 0;
    for (std::int64_t block = 0; block < nu; ++block) {
        prefix += block < k ? 0 : at(block);
        if (prefix > 0 || (block < k && at(block) < 0)) {
            return std::nullopt;
        }
    }
    std::int64_t sum = 0;
    for (std::int64_t block = 0; block < w; ++block) {
        sum += at(block);
    }
    const int side = (sum < 0 ? 1 : 0) - (sum > 0 ? 1 : 0);
    return side == gapSign ? std::optional(Family{w, nu, k, sum}) : std::nullopt;
}

/// All triples of the definition with w <= maxOrder, and beyond T = 4 to see that none is there.
inline std::vector<Family> allByDefinition(std::int64_t maxOrder)
{
    std::vector<Family> families;
    for (std::int64_t w = 1; w <= maxOrder; ++w) {
        for (std::int64_t nu = 1; nu <= 2 * w + 3; ++nu) {
            for (std::int64_t k = 1; k < nu && std::gcd(w, nu) == 1; ++k) {
                if (const auto family = byDefinition(w, nu, k)) {
                    families.push_back(*family);
                }
            }
        }
    }
    return families;
}

/// The records of i w mod nu over 0 < i < nu with even i: lower semiconvergents of w/nu.
inline std::vector<std::int64_t> evenRecords(std::int64_t w, std::int64_t nu)
{
    std::vector<std::int64_t> records;
    std::int64_t least = nu;
    for (std::int64_t i = 1; i < nu; ++i) {
        if (i * w % nu < least) {
            least = i * w % nu;
            if (i % 2 == 0) {
                records.push_back(least);
            }
        }
    }
    return records;
}

inline ModeBounds everyMode(std::int64_t order)
{
    ModeBounds bounds;
    bounds.maxOrder = order;
    bounds.maxEnergyRatio = 1e300;
    return bounds;
}

inline bool isOn(const Family& family, const Mode& mode)
{
    const auto isBelow = [](const ExactPeriod& x, const ExactPeriod& y) {
        return x.numerator * y.denominator < y.numerator * x.denominator;
    };
    const ExactPeriod T = exactPeriod(family);
    return isBelow(mode.lowest, T) && isBelow(T, mode.highest) &&
           family.contactBlocks == 2 * mode.a * family.order + mode.b * family.blocks;
}

/// The mode with t_c = 4a - order T, from a walk over its 2a jumps: jump i stands at 2i mod T, and
/// the gap behind it is wide where the next index falls below 0.
inline std::optional<Mode> walkedMode(std::int64_t a, std::int64_t order)
{
    const std::int64_t count = 2 * a;
    if (std::gcd(count, order) != 1) {
        return std::nullopt;
    }
    std::int64_t q = 1;
    while ((1 + q * order) % count != 0) {
        ++q;
    }
    const std::int64_t p = (1 + q * order) / count;
    std::int64_t index = count;
    // At the end of a positive gap the integral of epsilon over the flight is -surplus t_c.
    std::int64_t surplus = 0;       // wide negative gaps less wide positive ones
    std::int64_t surplusAtTwo = 0;  // those before the jump 2 - T floor(2/T)
    for (std::int64_t r = 0; r < count; ++r) {
        surplusAtTwo = index == 1 ? surplus : surplusAtTwo;
        index -= q;
        if (index < 0) {
            index += count;
            surplus += r % 2 == 0 ? 1 : -1;
        }
        if (surplus < 0) {
            return std::nullopt;
        }
    }
    // The integral of epsilon from 0 to 2, the window of (31), is c t_c - alpha.
    const std::int64_t c = order / count + 1 - surplusAtTwo;
    Mode mode;
    mode.a = a;
    mode.b = -order;
    mode.kappa = (p + c * order) / 2;
    mode.mu = q + c * count;
    mode.lowest = c > 0 ? exactPeriod(mode.mu, mode.kappa) : exactPeriod(2 * q, p);
    mode.lowestEnd = c < 0 ? ModeEnd::jumpsMeet : ModeEnd::energyInfinite;
    mode.highest = {2 * count, order};
    return mode;
}

}  // namespace signorini::test
