#pragma once
/// \file
/// The families of one pair (w, nu), read off Euclid's algorithm.

#include <array>
#include <cstdint>
#include <span>

#include "signorini/modes.hpp"

namespace signorini {

/// Families of one (w, nu) that differ in k only: k = least, least + step, ... (count of them).
/// They stand on modes with one right neighbour P/Q, see docs/theory.md, section 14.
struct FamilyChain {
    std::int64_t least = 0;   ///< [-], smallest k
    std::int64_t count = 0;   ///< [-]
    std::int64_t narrow = 0;  ///< [-], A, blocks in a narrow gap between jumps; step = 2A
    std::int64_t turns = 0;   ///< [-], c: win = c k - A

    [[nodiscard]] std::int64_t step() const { return 2 * narrow; }

    [[nodiscard]] Family family(std::int64_t order, std::int64_t blocks, std::int64_t place) const
    {
        const std::int64_t k = least + place * step();
        return {order, blocks, k, turns * k - narrow};
    }
};

/// All chains of (w, nu), by ascending k. With M = ceil(w/nu) Euclid's algorithm on (nu, M nu - w)
/// yields d_0, d_1, ... and remainders; after an even number of steps the last two, R > A, give the
/// chain k = R - d A > 0, d = 2, 4, ..., with c = M - (d_1 + d_3 + ...). It ends with the first odd
/// d_0, d_2, ....
class FamilyChains {
public:
    /// Keeps the families with -win >= leastWindow; with a negative gap win >= leastWindow, without
    /// one win = 0. O(log nu), no heap. \pre gcd(w, nu) = 1, leastWindow >= 1.
    FamilyChains(std::int64_t order, std::int64_t blocks, std::int64_t leastWindow, int gapSign);

    [[nodiscard]] std::span<const FamilyChain> chains() const
    {
        return {chains_.data() + begin_, chains_.size() - begin_};
    }

private:
    // Remainders fall by a factor of 3 from chain to chain: nu < 2 maxFamilyOrder < 3^19.
    std::array<FamilyChain, 20> chains_;
    std::size_t begin_ = chains_.size();
};

/// The smallest s >= 1 with (w/s)^2 <= maxEnergyRatio, exactly; at most w, which no -win reaches.
[[nodiscard]] std::int64_t leastWindowSum(std::int64_t order, double maxEnergyRatio);

/// Is it one whose tip never leaves the wall, (w, 1, 1), pressed at rest?
[[nodiscard]] inline bool isHeld(const Family& family)
{
    return family.contactBlocks == family.blocks;
}

/// Visits the families of (w, nu) by ascending k, without (w, 1, 1). \returns false if `visit` did.
template <typename Visit>
bool forEachContact(std::int64_t order, std::int64_t blocks, std::int64_t leastWindow, int gapSign,
                    Visit visit)
{
    const FamilyChains all(order, blocks, leastWindow, gapSign);
    for (const FamilyChain& chain : all.chains()) {
        for (std::int64_t place = 0; place < chain.count; ++place) {
            if (!visit(chain.family(order, blocks, place))) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace signorini
