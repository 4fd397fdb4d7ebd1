#pragma once
/// \file
/// Periodic motions on no grid: nonsmooth modes, the families on them, and the polytopes of several
/// contacts.
///
/// Lengths in L, displacements in g, times in L/c. Between the grid points of a schedule lie
/// motions of any period T. For irrational T the delay sequence has one size, p(t) = h epsilon(t)
/// with epsilon = +-1, and it exists only for contact times
///
///     t_c = 4a + b T,   a >= 1 whole, b < 0 odd,   lowest < T < highest,
///
/// with energy 1/sqrt(E/E_1) = kappa T - mu. docs/theory.md, section 12, derives that the 2a jumps
/// stand at 2i mod T, i = 1..2a, that each coprime pair (2a, |b|) has at most one interval, and
/// that
///
/// - at highest = 4a/|b| contact vanishes: the mode leaves the linear motion of the frequency
///   |b| omega_1 that touches the wall, a of whose periods are T; there E = b^2 E_1;
/// - lowest is where the energy becomes infinite, or where neighbouring jumps meet and the mode
///   branches off one of smaller |b|;
/// - a <= |b|, so every mode has omega > omega_1, T < 4.
///
/// Where the gap is negative the same pattern presses for kappa T < mu: such modes live on the
/// other side of the period of infinite energy, 1/sqrt(E/E_1) = mu - kappa T, between jumps that
/// meet and that period. Without a gap there are no modes, as they have a single period mu/kappa.
/// docs/theory.md, section 17.
///
/// All numbers are integers, nothing is fitted.
///
/// ## Families
///
/// All motions with one contact phase that press the wall, each once, on no grid.
///
/// A schedule's class pattern (one_phase_set.hpp) depends on three integers alone: w = 2N/G blocks
/// in a window of 2L/c, nu = n/G blocks in a period, k blocks of contact; w and nu have no common
/// factor. A triple whose pattern is that of motions is a *family*:
///
///     T = 2 nu/w,   least E/E_1 = (w/win)^2,   longest contact 2k/w,   win = windowSum < 0.
///
/// With a negative gap win > 0 instead, and there is one more for each w, (w, 1, 1), whose tip
/// never leaves the wall; without a gap win = 0.
///
/// On every grid with w | 2N it is one simplex of G = 2N/w amplitudes, the set of the schedule
/// n_c = kG, n = nu G, with energies up to G times the least. The schedules with |n_c - kG| < G
/// and the same n, its *tent*, are the faces of that simplex with d = G - |n_c - kG| amplitudes.
/// No other schedule of one phase presses, no orbit belongs to two families, T < 4 for all.
///
/// Families are the rational points of modes: T lies inside the interval of exactly one mode
/// (a, b), with k = 2aw + b nu and the least energy on its curve. One run of Euclid's algorithm
/// lists the families of (w, nu) and decides a mode. docs/theory.md, section 14, proves all this.
///
/// ## Several contacts
///
/// With K contacts [s_i, e_i) the jumps form K chains, from each arrival to some release: e = s_i +
/// 2k - m T. Beside T up to K - 1 times are free: polytopes with rational corners, on each of which
/// the energy depends on T alone. docs/theory.md, section 18.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "signorini/control.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// Why a mode goes no further.
enum class ModeEnd {
    contactVanishes,  ///< t_c -> 0: a linear motion that touches the wall (always the highest T)
    energyInfinite,   ///< u(L) no longer reaches g: kappa T = mu; jumps may meet there as well
    jumpsMeet,  ///< neighbouring jumps cancel, at finite energy; beyond, one of them would fall
                ///< into the contact phase
};

/// "contact-vanishes", "energy-infinite", "jumps-meet".
[[nodiscard]] std::string_view name(ModeEnd end);

/// One continuous family: a motion for every T in the open interval ]lowest, highest[.
struct Mode {
    std::int64_t a = 0;                             ///< [-], t_c = 4a + b T; a >= 1
    std::int64_t b = 0;                             ///< [-], odd, < 0
    ExactPeriod lowest;                             ///< [L/c], not itself a member
    ExactPeriod highest;                            ///< [L/c], 4a/|b|, not itself a member
    ModeEnd lowestEnd = ModeEnd::energyInfinite;    ///< why the mode ends at `lowest`
    ModeEnd highestEnd = ModeEnd::contactVanishes;  ///< why it ends at `highest`
    std::int64_t kappa = 0;                         ///< [-], E/E_1 = 1/(kappa T - mu)^2,
    std::int64_t mu = 0;                            ///< [-], kappa T - mu > 0 in the interval,
                                                    ///< < 0 where the gap is
    int gapSign = 1;                                ///< [-], of the gap: 1 or -1

    friend bool operator==(const Mode&, const Mode&) = default;
};

/// Largest |b| that can be asked for.
inline constexpr std::int64_t maxModeOrder = 10'001;

/// Which modes to list: those with |b| <= maxOrder that have a motion with T <= maxPeriod and
/// E/E_1 <= maxEnergyRatio. The bounds select modes and never shorten their intervals.
struct ModeBounds {
    std::int64_t maxOrder = 25;    ///< [-], 1..maxModeOrder
    double maxPeriod = 8.0;        ///< [L/c], > 0; from 4 on it selects nothing
    double maxEnergyRatio = 50.0;  ///< [E_1], > 0
    int gapSign = 1;               ///< [-], of the gap: 1 or -1
    Cancel cancel = {};            ///< ends the search: what was found so far is returned
    std::function<void(double done, double total)> progress = {};  ///< called for each |b|
};

/// All modes within the bounds, by ascending |b|, then a. Integer work O(log a) for each pair with
/// a <= |b| <= maxOrder: about 0.2 ms for order 25, 2 ms for 101, 0.2 s for 1001, 10 s for 10,001.
/// \throws std::invalid_argument naming each bound that is out of range.
[[nodiscard]] std::vector<Mode> findModes(const ModeBounds& bounds = {});

/// The families with a closed formula: "main" (t_c = 4 - T), "subharmonic p" (4p - (2p-1)T),
/// "higher m" (4 - (2m+1)T), "twin k" (4+12k - (1+4k)T: energies of the main mode); "" for others.
[[nodiscard]] std::string familyName(const Mode& mode);

/// Position 2k - turns T, in [0, T) for every T of the mode.
struct ModeJump {
    std::int64_t k = 0;      ///< [-], 1..2a
    std::int64_t turns = 0;  ///< [-]

    friend bool operator==(const ModeJump&, const ModeJump&) = default;
};

/// Where epsilon changes its sign, ascending: the first is t_c, from + to -. O(a).
[[nodiscard]] std::vector<ModeJump> jumps(const Mode& mode);

/// t_c = 4a + b T. \throws std::invalid_argument unless lowest < T < highest.
[[nodiscard]] double contactTime(const Mode& mode, double period);

/// E/E_1 = 1/(kappa T - mu)^2. \throws std::invalid_argument unless lowest < T < highest.
[[nodiscard]] double energyRatio(const Mode& mode, double period);

/// The limits of E/E_1 at both ends of the interval, neither reached; most may be infinite.
[[nodiscard]] EnergyRange energyRange(const Mode& mode);

/// The schedule of the mode's motion with T = steps/cells: n_c = 4a N + b n. With G = gcd(2N, n)
/// its set is a simplex of dimension G - 1 whose motion of least energy is the mode's.
/// \throws std::invalid_argument unless lowest < steps/cells < highest, or on too many cells.
[[nodiscard]] Schedule scheduleOf(const Mode& mode, std::int64_t cells, std::int64_t steps);

struct ModePolytope;
struct ModePoint;

/// The motion of a mode at one period, without a grid: with F the integral of p from 0,
///
///     u(x, t) = F(t + 1 - x) - F(t + 1 + x)
///     v(x, t) = p(t + 1 - x) - p(t + 1 + x),   s(x, t) = -p(t + 1 - x) - p(t + 1 + x).
///
/// Units L = c = g = 1; t = 0 is the start of contact. At jumps velocity and strain take the value
/// right after them in p. Each sample costs O(log a). Under weight g is the gap at rest, and the
/// shape at rest is added: sag (2 - x) x to u, 2 sag (1 - x) to s.
class ModeMotion {
public:
    /// O(a). `sag` [g]: of the tip at rest (`tipSag`).
    /// \throws std::invalid_argument unless lowest < T < highest.
    ModeMotion(const Mode& mode, double period, double sag = 0.0);
    /// A motion with several contacts, t = 0 at s_0. O(K jumps). \throws std::invalid_argument
    /// unless the point is in the polytope, its closures within 1e-9.
    ModeMotion(const ModePolytope& polytope, const ModePoint& point);

    /// T [L/c].
    [[nodiscard]] double period() const { return period_; }
    /// t_c, of all contacts together [L/c].
    [[nodiscard]] double contactTime() const { return contactTime_; }
    /// [s_l, e_l[, the first from 0 [L/c].
    [[nodiscard]] const std::vector<std::pair<double, double>>& contacts() const
    {
        return contacts_;
    }
    /// h = |p| > 0 [g/L]; E/E_1 = 4 h^2.
    [[nodiscard]] double amplitude() const { return amplitude_; }
    /// Where p changes its sign, ascending in ]0, T[ [L/c]: the first is e_0, from + to -.
    [[nodiscard]] const std::vector<double>& jumpTimes() const { return times_; }

    /// p(t), +h or -h: the wave arriving at the tip [g/L].
    [[nodiscard]] double incoming(double t) const;
    /// The mean of p over [from, to] [g/L], from < to. O(log a).
    [[nodiscard]] double meanIncoming(double from, double to) const;
    /// u(x, t) [g], 0 <= x <= 1.
    [[nodiscard]] double displacement(double x, double t) const;
    /// v(x, t) [c g/L].
    [[nodiscard]] double velocity(double x, double t) const;
    /// s(x, t) [g/L].
    [[nodiscard]] double strain(double x, double t) const;
    /// The way from the tip to the wall [g].
    [[nodiscard]] double tipGap(double t) const { return gapSign_ + sag_ - displacement(1.0, t); }
    /// Force on the wall, 2h in contact and 0 in flight [EA g/L].
    [[nodiscard]] double wallForce(double t) const;
    /// What one period reaches. O(a).
    [[nodiscard]] Extremes extremes() const;

private:
    struct Place {
        double turns;       ///< whole periods before t
        double time;        ///< the rest, in [0, T)
        std::size_t jumps;  ///< jumps at or before it
    };
    [[nodiscard]] Place locate(double t) const;
    [[nodiscard]] double integral(double t) const;  ///< of p/h from 0 to t

    double period_;
    int gapSign_ = 1;
    double sag_ = 0.0;
    double amplitude_ = 0.0;
    double contactTime_ = 0.0;
    std::vector<std::pair<double, double>> contacts_;
    std::vector<double> times_;
    std::vector<double> integrals_;  ///< of p/h up to each jump
};

/// The state at t = 0 on N cells: the mean of each wave over each cell, so that u is exact at the
/// ends of cells. Where T N is whole it is the state of the mode's motion of least energy on that
/// grid, but for rounding. O(N log a). \throws std::invalid_argument unless 1 <= N <= maxCells.
[[nodiscard]] State cellMeans(const ModeMotion& motion, std::int64_t cells);

/// The motions of one period and one contact pattern.
struct Family {
    std::int64_t order = 0;          ///< [-], w, blocks in 2L/c
    std::int64_t blocks = 0;         ///< [-], nu, blocks in a period; coprime to w
    std::int64_t contactBlocks = 0;  ///< [-], k, of them in contact
    std::int64_t windowSum = 0;      ///< [-], win, sum of epsilon over w blocks; < 0 with a gap

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
    int gapSign = 1;     ///< [-], of the gap: 1, 0, -1; without one energies select nothing
    Cancel cancel = {};  ///< ends the search as a visitor does
};

/// Asked for each family; false ends the search.
using FamilyVisitor = std::function<bool(const Family&)>;

/// T = 2 nu/w.
[[nodiscard]] ExactPeriod exactPeriod(const Family& family);

/// 2k/w [L/c], the contact of the motions with no amplitude 0; shorter ones are in the tent.
[[nodiscard]] ExactPeriod longestContact(const Family& family);

/// (w/win)^2, met on every grid of the family by equal amplitudes; 0 without a gap, the infimum of
/// all sizes.
[[nodiscard]] ExactEnergy leastEnergy(const Family& family);

/// The lowest place of the tip in all its motions [|g|], exactly: sgn g - 2 max |Lambda|/|win| over
/// prefix sums Lambda of signs in flight, which no amplitude changes. A second stop at or below it
/// leaves the family as it is, one above it leaves nothing. O(nu).
/// \throws std::invalid_argument without a gap, where motions have any size.
[[nodiscard]] Fraction lowestTip(const Family& family, int gapSign = 1);

/// Does a second stop, if there is one, leave the motions of a family of the wall? Without a gap it
/// leaves those that are small enough. O(nu).
[[nodiscard]] bool staysClear(const Family& family, const Stops& stops);

/// The family with these numbers, if there is one. O(log nu).
/// \throws std::invalid_argument unless 1 <= w <= maxFamilyOrder, 1 <= nu, 1 <= k.
[[nodiscard]] std::optional<Family> findFamily(std::int64_t order, std::int64_t blocks,
                                               std::int64_t contactBlocks, int gapSign = 1);

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
[[nodiscard]] std::vector<Family> familiesAt(std::int64_t order, std::int64_t blocks,
                                             int gapSign = 1);

/// The schedule whose set is the family's whole simplex: n_c = kG, n = nu G, G = 2N/w; of (w, 1, 1)
/// the first face, n_c = G - 1. \throws std::invalid_argument unless w divides 2N (and w < 2N
/// there).
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
[[nodiscard]] std::optional<Mode> findMode(std::int64_t a, std::int64_t b, int gapSign = 1);

/// The one mode whose curve the family stands on: lowest < T < highest, k = 2aw + b nu. O(log nu).
/// \throws std::invalid_argument if there is no such family, or it stands on no mode: win = 0, and
/// (w, 1, 1).
[[nodiscard]] Mode modeThrough(const Family& family);

/// Does a family stand on a mode, inside its interval? Not those at the end of one, of no gap, nor
/// those whose tip never leaves the wall.
[[nodiscard]] inline bool standsOnMode(const Family& family)
{
    return family.windowSum != 0 && family.contactBlocks < family.blocks;
}

/// The families that stand on a mode, w <= maxOrder, by ascending w and nu: its rational points.
/// \throws std::invalid_argument if there is no such mode or maxOrder is out of range.
[[nodiscard]] std::vector<Family> familiesOf(const Mode& mode, std::int64_t maxOrder);

/// Jumps of a motion with K contacts [s_i, e_i), from an arrival to a release: they stand at s_i +
/// 2j mod T, j = 1..k, the last at e_release = s_i + 2k - turns T. 0 = s_0 < e_0 < s_1 < ... < T.
struct ModeChain {
    std::size_t release = 0;  ///< number of the contact that ends there
    std::int64_t k = 0;       ///< [-], jumps; even, >= 2
    std::int64_t turns = 0;   ///< [-], >= 0

    friend bool operator==(const ModeChain&, const ModeChain&) = default;
};

/// Position s_chain + 2k - turns T, in ]0, T[.
struct ChainJump {
    std::size_t chain = 0;   ///< [-]
    std::int64_t k = 0;      ///< [-], 1..k of the chain
    std::int64_t turns = 0;  ///< [-]

    friend bool operator==(const ChainJump&, const ChainJump&) = default;
};

/// Motions with K contacts, one for each (T, s_1, ..., s_{K-1}) in the relative interior of a
/// polytope of dimension 1 + `dimension`. All contact together lasts 2 sum k - order T. Of several
/// names that differ by where time begins the type is listed under the one with the largest k, then
/// turns, then release.
struct ModePolytope {
    std::vector<ModeChain> chains;  ///< K of them
    std::vector<ChainJump> jumps;   ///< ascending in time; the first is the release of contact 0
    std::int64_t order = 0;         ///< [-], sum of all turns, odd
    std::int64_t dimension = 0;     ///< [-], times that are free at one T, 0..K-1
    ExactPeriod lowest;             ///< [L/c], not itself met
    ExactPeriod highest;            ///< [L/c], not itself met
    ModeEnd lowestEnd = ModeEnd::energyInfinite;    ///< why it ends at `lowest`
    ModeEnd highestEnd = ModeEnd::contactVanishes;  ///< why it ends at `highest`
    std::int64_t kappa = 0;                         ///< [-], E/E_1 = (divisor/(kappa T - mu))^2,
    std::int64_t mu = 0;                            ///< [-], kappa T - mu > 0
    std::int64_t divisor = 1;                       ///< [-], > 0; 1 if dimension = K - 1
    /// (T, s_1, ..., s_{K-1}) in lexicographic order [L/c]
    std::vector<std::vector<ExactPeriod>> vertices;

    friend bool operator==(const ModePolytope&, const ModePolytope&) = default;
};

/// Bounds of `findPolytopes`; its cost grows like order^(K + 2).
inline constexpr std::int64_t maxPolytopePhases = 5;
inline constexpr std::int64_t maxPolytopeOrder = 101;

/// All types with K contacts and order <= maxOrder that have a motion within the bounds, by order.
/// Exact, and complete: no grid is asked. Motions that repeat one with fewer contacts are listed
/// there only where they are part of a continuum here. With one contact these are the modes.
/// \throws std::invalid_argument naming each bound that is out of range.
[[nodiscard]] std::vector<ModePolytope> findPolytopes(std::int64_t phases,
                                                      const ModeBounds& bounds = {});

/// The polytopes of one type, seldom more than one; none if it has no motions or repeats fewer
/// contacts. \throws std::invalid_argument unless every contact is the release of one chain, k is
/// even and >= 2, and no number is negative or above 10,000.
[[nodiscard]] std::vector<ModePolytope> polytopesOf(const std::vector<ModeChain>& chains);

/// The polytope that holds the motion of a schedule with gcd(2N, n) = 1; none if the schedule has
/// no motion, or one that touches without force, or repeats itself. O(n^2).
/// \throws std::invalid_argument on an invalid schedule or another gcd.
[[nodiscard]] std::optional<ModePolytope> polytopeOf(const Schedule& schedule);

/// A point of a polytope.
struct ModePoint {
    double period = 0.0;           ///< T [L/c]
    std::vector<double> arrivals;  ///< s_1, ..., s_{K-1} [L/c]
};

/// Points that span all motions of one period: the motions are their means, ends excluded.
/// \throws std::invalid_argument unless lowest < T < highest.
[[nodiscard]] std::vector<ModePoint> slice(const ModePolytope& polytope, double period);
/// Their mean. \throws as slice.
[[nodiscard]] ModePoint middle(const ModePolytope& polytope, double period);

/// Contact and flight in turn, 2K lengths [L/c].
/// \throws std::invalid_argument unless the point has K - 1 arrivals.
[[nodiscard]] std::vector<double> stretches(const ModePolytope& polytope, const ModePoint& point);

/// E/E_1. \throws std::invalid_argument unless lowest < T < highest.
[[nodiscard]] double energyRatio(const ModePolytope& polytope, double period);

/// The limits of E/E_1 at both ends of its periods, neither reached; most may be infinite.
[[nodiscard]] EnergyRange energyRange(const ModePolytope& polytope);

/// The schedules on N cells in n steps whose motion is in the polytope: the grid points with T =
/// n/N, one for each orbit. If gcd(2N, n) = 1 that is the only motion of the schedule.
/// \throws std::invalid_argument unless 1 <= N <= maxCells, 1 <= n.
[[nodiscard]] std::vector<Schedule> schedulesOf(const ModePolytope& polytope, std::int64_t cells,
                                                std::int64_t steps);

}  // namespace signorini
