#pragma once
/// \file
/// The rows of a mode with several contacts, as they stand in docs/theory.md, section 18.
///
/// Unknowns are the period T and the arrivals s_1, ..., s_{K-1}, counted from s_0 = 0. Every
/// position is a linear form in them with whole coefficients.

#include <cstddef>
#include <optional>
#include <vector>

#include "double_description.hpp"
#include "signorini/modes.hpp"

namespace signorini {

/// coefficients . (T, s_1, ..., s_{K-1}) - rhs.
using LinearForm = ExactRow;

/// left + factor right.
[[nodiscard]] LinearForm plus(LinearForm left, std::int64_t factor, const LinearForm& right);

/// Positions of arrivals, releases and jumps.
class ChainForms {
public:
    explicit ChainForms(const std::vector<ModeChain>& chains);

    /// s_i; s_K is T.
    [[nodiscard]] LinearForm arrival(std::size_t i) const;
    /// e_l. \pre some chain ends there.
    [[nodiscard]] const LinearForm& release(std::size_t l) const { return releases_[l]; }
    /// s_chain + 2k - turns T.
    [[nodiscard]] LinearForm at(const ChainJump& jump) const;
    /// e_l - s_l.
    [[nodiscard]] LinearForm contact(std::size_t l) const;

private:
    std::size_t count_;
    std::vector<LinearForm> releases_;
};

/// What a motion with these jumps, in this order, asks of (T, s).
struct ModeRows {
    std::vector<LinearForm> gaps;      ///< > 0: contacts, and flights between jumps
    std::vector<LinearForm> closures;  ///< = 0: each flight, without those that always are
    std::vector<LinearForm> prefixes;  ///< >= 0: g - u(L) where the tip turns
    LinearForm window;                 ///< > 0: -win, the sum of -epsilon over 2L/c
};

/// LinearForm::tag of a contact among `ModeRows::gaps`.
inline constexpr std::int64_t contactTag = 1;

/// The rows; none if some contact would have to pull. `jumps` ascend and begin with the release of
/// contact 0. O(K jumps).
[[nodiscard]] std::optional<ModeRows> rowsOf(const std::vector<ModeChain>& chains,
                                             const std::vector<ChainJump>& jumps);

/// 0 <= s_1 <= ... <= s_{K-1} <= T and s_{i+1} - s_i <= 4: what holds of all motions.
[[nodiscard]] PolyhedralCone arrivalCone(std::size_t phases);

/// Keeps form >= 0. \returns false if form > 0 nowhere in the cone.
[[nodiscard]] bool cutStrictly(PolyhedralCone& cone, const LinearForm& form);

/// The sum of all rays, a point of the relative interior. \pre the cone is pointed and not empty.
[[nodiscard]] IntegerVector middleOf(const PolyhedralCone& cone);

/// The polytope of these jumps, if there are motions: the cone, which lies where they are in this
/// order, cut by the rows.
[[nodiscard]] std::optional<ModePolytope> polytopeIn(PolyhedralCone cone,
                                                     const std::vector<ModeChain>& chains,
                                                     std::vector<ChainJump> jumps);

/// What a type is called: k, turns and release of all chains, as they are if arrival `first` is
/// number 0. Of the names that a type has the largest is the one it is listed under.
[[nodiscard]] std::vector<std::int64_t> nameFrom(const std::vector<ModeChain>& chains,
                                                 std::size_t first);

/// Is that the largest name?
[[nodiscard]] bool isListedName(const std::vector<ModeChain>& chains);

}  // namespace signorini
