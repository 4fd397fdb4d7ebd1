#include "family_chains.hpp"

#include <algorithm>
#include <cmath>

#include "rational.hpp"

namespace signorini {

namespace {

/// Cuts a chain down to k >= contact.
FamilyChain beginningAt(FamilyChain chain, std::int64_t contact)
{
    const std::int64_t missing = std::max<std::int64_t>(0, contact - chain.least);
    const std::int64_t skipped = std::min(chain.count, (missing + chain.step() - 1) / chain.step());
    chain.least += skipped * chain.step();
    chain.count -= skipped;
    return chain;
}

/// Cuts a chain down to win = c k - A >= leastWindow.
FamilyChain restrictedAbove(FamilyChain chain, std::int64_t leastWindow)
{
    if (chain.turns <= 0) {
        chain.count = 0;
        return chain;
    }
    return beginningAt(chain, (chain.narrow + leastWindow - 1) / chain.turns + 1);
}

/// Cuts a chain down to win = c k - A = 0: k <= A, so it is the first or none.
FamilyChain restrictedToZero(FamilyChain chain)
{
    chain.count = chain.turns * chain.least == chain.narrow ? 1 : 0;
    return chain;
}

/// Cuts a chain down to win = c k - A <= -leastWindow.
FamilyChain restrictedBelow(FamilyChain chain, std::int64_t leastWindow)
{
    const std::int64_t room = chain.narrow - leastWindow;  // c k <= room
    if (chain.turns > 0) {
        // k < A: of a progression in steps of 2A at most the first.
        chain.count = chain.turns * chain.least <= room ? 1 : 0;
    } else if (chain.turns == 0) {
        chain.count = room >= 0 ? chain.count : 0;
    } else if (room < 0) {
        chain = beginningAt(chain, (-room - chain.turns - 1) / -chain.turns);  // rounded up
    }
    return chain;
}

}  // namespace

FamilyChains::FamilyChains(std::int64_t order, std::int64_t blocks, std::int64_t leastWindow,
                           int gapSign)
{
    const auto restricted = [&](const FamilyChain& chain) {
        return gapSign > 0    ? restrictedBelow(chain, leastWindow)
               : gapSign == 0 ? restrictedToZero(chain)
                              : restrictedAbove(chain, leastWindow);
    };
    std::int64_t turns = (order - 1) / blocks + 1;  // M, the least integer >= w/nu
    std::int64_t before = blocks;
    std::int64_t narrow = turns * blocks - order;
    while (narrow > 0) {
        const std::int64_t quotient = before / narrow;
        const std::int64_t rest = before % narrow;
        // The last d, even, that leaves k > 0.
        const std::int64_t last = (rest > 0 ? quotient : quotient - 1) / 2 * 2;
        const FamilyChain chain = restricted({before - last * narrow, last / 2, narrow, turns});
        if (chain.count > 0) {
            chains_.at(--begin_) = chain;
        }
        if (quotient % 2 != 0 || rest == 0) {
            return;
        }
        turns -= narrow / rest;
        before = rest;
        narrow %= rest;
    }
}

std::int64_t leastWindowSum(std::int64_t order, double maxEnergyRatio)
{
    // -win < w, so w itself is a bound that nothing meets.
    const double guess = std::ceil(static_cast<double>(order) / std::sqrt(maxEnergyRatio));
    if (!(guess < static_cast<double>(order))) {
        return order;
    }
    auto sum = std::max<std::int64_t>(1, static_cast<std::int64_t>(guess));
    if (std::isinf(maxEnergyRatio)) {
        return 1;
    }
    const Rational ratio(maxEnergyRatio);
    const auto isEnough = [&](std::int64_t value) {
        const Rational root = Rational(order) / value;
        return root * root <= ratio;
    };
    while (!isEnough(sum)) {
        ++sum;
    }
    while (sum > 1 && isEnough(sum - 1)) {
        --sum;
    }
    return sum;
}

}  // namespace signorini
