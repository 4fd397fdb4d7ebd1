#pragma once
/// \file
/// Families: all motions with one contact phase that press the wall, each once, on no grid.
///
/// A schedule's class pattern (one_phase_set.hpp) depends on three integers alone: w = 2N/G blocks
/// in a window of 2L/c, nu = n/G blocks in a period, k blocks of contact; w and nu have no common
/// factor. A triple whose pattern is that of motions is a *family*:
///
///     T = 2 nu/w,   least E/E_1 = (w/win)^2,   longest contact 2k/w,   win = windowSum < 0.
///
/// On every grid with w | 2N it is one simplex of G = 2N/w amplitudes, the set of the schedule
/// n_c = kG, n = nu G, with energies up to G times the least. The schedules with |n_c - kG| < G
/// and the same n, its *tent*, are the faces of that simplex with d = G - |n_c - kG| amplitudes.
/// No other schedule of one phase presses, no orbit belongs to two families, T < 4 for all.
///
/// Families are the rational points of modes: T lies inside the interval of exactly one mode
/// (a, b), with k = 2aw + b nu and the least energy on its curve. One run of Euclid's algorithm
/// lists the families of (w, nu) and decides a mode. docs/theory.md, section 14, proves all this.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "signorini/control.hpp"
#include "signorini/modes.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// The motions of one period and one contact pattern.
struct Family {
    std::int64_t order = 0;          ///< [-], w, blocks in 2L/c
    std::int64_t blocks = 0;         ///< [-], nu, blocks in a period; coprime to w
    std::int64_t contactBlocks = 0;  ///< [-], k, of them in contact
    std::int64_t windowSum = 0;      ///< [-], win < 0, sum of epsilon over w blocks

    friend bool operator==(const Family&, const Family&) = default;
};

/// An energy in lowest terms, denominator > 0.
struct ExactEnergy {
    std::int64_t numerator = 0;    ///< [E_1]
    std::int64_t denominator = 1;  ///< [-]

    /// The quotient of both, each a double.
    [[nodiscard]] double value() const
    {
        return static_cast<double>(numerator) / static_cast<double>(denominator);
    }

    friend bool operator==(const ExactEnergy&, const ExactEnergy&) = default;
};

/// Largest order of a family: that of the finest grid.
inline constexpr std::int64_t maxFamilyOrder = 2 * maxCells;

/// Which families to list.
struct FamilyBounds {
    double maxPeriod = 4.0;  ///< [L/c], > 0; from 4 on it selects nothing
    /// [E_1], > 0, of the least energy; compared exactly.
    double maxEnergyRatio = std::numeric_limits<double>::infinity();
    Cancel cancel = {};  ///< ends the search as a visitor does
};

/// Asked for each family; false ends the search.
using FamilyVisitor = std::function<bool(const Family&)>;

/// T = 2 nu/w.
[[nodiscard]] ExactPeriod exactPeriod(const Family& family);

/// 2k/w [L/c], the contact of the motions with no amplitude 0; shorter ones are in the tent.
[[nodiscard]] ExactPeriod longestContact(const Family& family);

/// (w/win)^2, met on every grid of the family by equal amplitudes.
[[nodiscard]] ExactEnergy leastEnergy(const Family& family);

/// The family with these numbers, if there is one. O(log nu).
/// \throws std::invalid_argument unless 1 <= w <= maxFamilyOrder, 1 <= nu, 1 <= k.
[[nodiscard]] std::optional<Family> findFamily(std::int64_t order, std::int64_t blocks,
                                               std::int64_t contactBlocks);

/// Visits the families with w <= maxOrder by ascending w, nu, k. O(log w) for each pair
/// (w, nu), no memory; there are 33 families with w <= 12, 1651 with w <= 60, 326,073 with w <=
/// 600. \returns false if it was ended early. \throws std::invalid_argument naming each bound that
/// is out of range.
bool forEachFamily(std::int64_t maxOrder, const FamilyBounds& bounds, const FamilyVisitor& visitor);

/// The same as a list.
[[nodiscard]] std::vector<Family> findFamilies(std::int64_t maxOrder,
                                               const FamilyBounds& bounds = {});

/// The families of T = 2 nu/w by ascending k: all that one contact in a period can press. O(log nu)
/// and their number; none from T = 4 on.
/// \throws std::invalid_argument unless 1 <= w <= maxFamilyOrder, 1 <= nu, without common factor.
[[nodiscard]] std::vector<Family> familiesAt(std::int64_t order, std::int64_t blocks);

/// Visits the families of a grid, those with w | 2N, by ascending w, nu, k. O(N log N) steps and
/// no memory. \returns false if it was ended early.
/// \throws std::invalid_argument naming each argument that is out of range.
bool forEachFamilyOnGrid(std::int64_t cells, const FamilyBounds& bounds,
                         const FamilyVisitor& visitor);

/// The schedule whose set is the family's whole simplex: n_c = kG, n = nu G, G = 2N/w.
/// \throws std::invalid_argument unless w divides 2N.
[[nodiscard]] Schedule scheduleOf(const Family& family, std::int64_t cells);

/// Where a schedule lies in the tent of its family.
struct TentPlace {
    Family family;
    std::int64_t classes = 0;     ///< [-], G, amplitudes of the whole simplex
    std::int64_t amplitudes = 0;  ///< [-], d = G - |offset|, those of this face
    std::int64_t offset = 0;      ///< [steps], n_c - kG; > 0: the first `offset` amplitudes are 0

    friend bool operator==(const TentPlace&, const TentPlace&) = default;
};

/// The family of a schedule that has pressing motions; none if it has no motion, or grazes. O(log
/// n). \throws std::invalid_argument on an invalid schedule or more than one phase.
[[nodiscard]] std::optional<TentPlace> familyOf(const Schedule& schedule);

/// The mode with t_c = 4a + bT, if there is one, by continued fraction. O(log a).
/// \throws std::invalid_argument unless 1 <= a, -b <= maxFamilyOrder.
[[nodiscard]] std::optional<Mode> findMode(std::int64_t a, std::int64_t b);

/// The one mode whose curve the family stands on: lowest < T < highest, k = 2aw + b nu. O(log nu).
/// \throws std::invalid_argument if there is no such family.
[[nodiscard]] Mode modeThrough(const Family& family);

/// The families that stand on a mode, w <= maxOrder, by ascending w and nu: its rational points.
/// \throws std::invalid_argument if there is no such mode or maxOrder is out of range.
[[nodiscard]] std::vector<Family> familiesOf(const Mode& mode, std::int64_t maxOrder);

}  // namespace signorini
