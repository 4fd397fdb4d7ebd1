#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "faults.hpp"
#include "mode_chains.hpp"
#include "mode_line.hpp"

namespace signorini {

namespace {

/// All polytopes of one order: chains are chosen one by one, then every jump finds its flight. Each
/// choice cuts the cone of (T, s), and ends where nothing is left of it.
class Search {
public:
    Search(std::size_t phases, std::int64_t order, const Cancel& cancel,
           std::vector<ModePolytope>& found)
        : order_(order), cancel_(cancel), chains_(phases), found_(found)
    {
    }

    void run()
    {
        std::vector<std::size_t> releases(chains_.size());
        std::iota(releases.begin(), releases.end(), std::size_t{0});
        do {
            for (std::size_t i = 0; i < releases.size(); ++i) {
                chains_[i].release = releases[i];
            }
            if (hasOddCycles()) {
                chooseChain(0, order_, arrivalCone(chains_.size()));
            }
        } while (std::next_permutation(releases.begin(), releases.end()));
    }

    /// The polytopes of one type. \pre each release has one chain.
    void runWith(const std::vector<ModeChain>& chains)
    {
        chains_ = chains;
        PolyhedralCone cone = arrivalCone(chains_.size());
        for (std::size_t i = 0; i < chains_.size(); ++i) {
            if (!cutToRelease(cone, i)) {
                return;
            }
        }
        if (hasOddCycles()) {
            placeJumps(cone, 0, 1);
        }
    }

private:
    /// Only matchings with an odd number of cycles give each release its sign.
    [[nodiscard]] bool hasOddCycles() const
    {
        bool isOdd = false;
        std::vector<bool> seen(chains_.size());
        for (std::size_t i = 0; i < chains_.size(); ++i) {
            isOdd = isOdd != !seen[i];
            for (std::size_t j = i; !seen[j]; j = chains_[j].release) {
                seen[j] = true;
            }
        }
        return isOdd;
    }

    /// Chain i gets its integers; the first is the longest, `turns` are left to share.
    void chooseChain(std::size_t i, std::int64_t turns, const PolyhedralCone& cone)
    {
        if (isRequested(cancel_)) {
            return;
        }
        if (i == chains_.size()) {
            if (isListedName(chains_)) {
                placeJumps(cone, 0, 1);
            }
            return;
        }
        const bool isLast = i + 1 == chains_.size();
        ModeChain& chain = chains_[i];
        // e < T gives 2k < (turns + 1) T, and T <= 4K.
        const auto phases = static_cast<std::int64_t>(chains_.size());
        for (chain.turns = isLast ? turns : 0; chain.turns <= turns; ++chain.turns) {
            const std::int64_t most = 2 * phases * (chain.turns + 1);
            for (chain.k = 2; chain.k < (i == 0 ? most : std::min(most, chains_[0].k + 1));
                 chain.k += 2) {
                PolyhedralCone part = cone;
                if (cutToRelease(part, i)) {
                    chooseChain(i + 1, turns - chain.turns, part);
                }
            }
        }
    }

    /// s_l < e_l < s_{l+1} for the release of chain i.
    [[nodiscard]] bool cutToRelease(PolyhedralCone& cone, std::size_t i) const
    {
        const ChainForms forms(chains_);
        const std::size_t l = chains_[i].release;
        return cutStrictly(cone, forms.contact(l)) &&
               cutStrictly(cone, plus(forms.arrival(l + 1), -1, forms.release(l)));
    }

    void placeJumps(const PolyhedralCone& cone, std::size_t chain, std::int64_t k)
    {
        if (isRequested(cancel_)) {
            return;
        }
        if (k == chains_[chain].k) {
            jumps_.push_back({chain, k, chains_[chain].turns});
            if (chain + 1 < chains_.size()) {
                placeJumps(cone, chain + 1, 1);
            } else {
                finish(cone);
            }
            jumps_.pop_back();
            return;
        }
        const ChainForms forms(chains_);
        const auto [least, most] = turnsOf(cone, chain, k);
        for (std::int64_t turns = least; turns <= most; ++turns) {
            const ChainJump jump{chain, k, turns};
            const LinearForm at = forms.at(jump);
            for (std::size_t l = 0; l < chains_.size(); ++l) {
                PolyhedralCone part = cone;
                if (cutStrictly(part, plus(at, -1, forms.release(l))) &&
                    cutStrictly(part, plus(forms.arrival(l + 1), -1, at))) {
                    jumps_.push_back(jump);
                    placeJumps(part, chain, k + 1);
                    jumps_.pop_back();
                }
            }
        }
    }

    /// The least and the most whole periods before a jump. \pre T > 0 on the cone.
    [[nodiscard]] static std::pair<std::int64_t, std::int64_t> turnsOf(const PolyhedralCone& cone,
                                                                       std::size_t chain,
                                                                       std::int64_t k)
    {
        std::int64_t least = std::numeric_limits<std::int64_t>::max();
        std::int64_t most = 0;
        for (const PolyhedralCone::Ray& ray : cone.rays()) {
            const Integer at = (chain > 0 ? ray.at[chain] : Integer(0)) + 2 * k * ray.at.back();
            const auto turns = static_cast<std::int64_t>(Integer(at / ray.at.front()));
            least = std::min(least, turns);
            most = std::max(most, turns);
        }
        return {least, most};
    }

    void finish(const PolyhedralCone& cone)
    {
        const ChainForms forms(chains_);
        const IntegerVector middle = middleOf(cone);
        std::vector<ChainJump> jumps = jumps_;
        std::sort(jumps.begin(), jumps.end(), [&](const ChainJump& l, const ChainJump& r) {
            return valueAt(forms.at(l), middle) < valueAt(forms.at(r), middle);
        });
        if (auto polytope = polytopeIn(cone, chains_, std::move(jumps))) {
            found_.push_back(std::move(*polytope));
        }
    }

    std::int64_t order_;
    const Cancel& cancel_;
    std::vector<ModeChain> chains_;
    std::vector<ChainJump> jumps_;
    std::vector<ModePolytope>& found_;
};

}  // namespace

std::vector<ModePolytope> findPolytopes(std::int64_t phases, const ModeBounds& bounds)
{
    Faults faults;
    faults.requireWhole("phases", phases, maxPolytopePhases);
    faults.requireWhole("maxOrder", bounds.maxOrder, maxPolytopeOrder);
    faults.requirePositive("maxPeriod", bounds.maxPeriod, "L/c");
    faults.requirePositive("maxEnergyRatio", bounds.maxEnergyRatio, "E_1");
    if (bounds.gapSign != 1) {
        faults.add("gapSign", bounds.gapSign, "1: several contacts are known for a gap > 0");
    }
    faults.throwIfAny();
    const auto power = static_cast<double>(phases + 2);
    std::vector<ModePolytope> all;
    for (std::int64_t order = 1; order <= bounds.maxOrder; order += 2) {
        if (isRequested(bounds.cancel)) {
            break;
        }
        if (bounds.progress) {
            bounds.progress(std::pow(order, power), std::pow(bounds.maxOrder, power));
        }
        std::vector<ModePolytope> found;
        Search(static_cast<std::size_t>(phases), order, bounds.cancel, found).run();
        std::copy_if(found.begin(), found.end(), std::back_inserter(all),
                     [&bounds](const ModePolytope& polytope) {
                         return isWithin({polytope.lowest, polytope.highest, polytope.kappa,
                                          polytope.mu, polytope.divisor},
                                         bounds);
                     });
    }
    return all;
}

std::vector<ModePolytope> polytopesOf(const std::vector<ModeChain>& chains)
{
    constexpr std::int64_t most = 10'000;
    const auto count = static_cast<std::int64_t>(chains.size());
    Faults faults;
    faults.requireWhole("phases", count, maxPolytopePhases);
    std::vector<std::size_t> releases;
    std::int64_t order = 0;
    for (const ModeChain& chain : chains) {
        releases.push_back(chain.release);
        order += chain.turns;
        if (chain.k < 2 || chain.k > most || chain.k % 2 != 0) {
            faults.add("k", chain.k, fmt::format("even numbers 2..{}", most));
        }
        if (chain.turns < 0 || chain.turns > most) {
            faults.add("turns", chain.turns, fmt::format("0..{}", most));
        }
    }
    std::sort(releases.begin(), releases.end());
    for (std::size_t l = 0; l < releases.size(); ++l) {
        if (releases[l] != l) {
            faults.add("release", releases[l], "each contact once");
            break;
        }
    }
    faults.throwIfAny();
    std::vector<ModePolytope> found;
    if (order % 2 == 1) {
        Search(chains.size(), order, {}, found).runWith(chains);
    }
    return found;
}

}  // namespace signorini
