#pragma once
/// \file
/// Nonsmooth modes: the continuous families of periodic motions with one contact phase.
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
/// All numbers are integers, nothing is fitted.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
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
    std::int64_t mu = 0;                            ///< [-], kappa T - mu > 0 in the interval

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

/// The motion of a mode at one period, without a grid: with F the integral of p from 0,
///
///     u(x, t) = F(t + 1 - x) - F(t + 1 + x)
///     v(x, t) = p(t + 1 - x) - p(t + 1 + x),   s(x, t) = -p(t + 1 - x) - p(t + 1 + x).
///
/// Units L = c = g = 1; t = 0 is the start of contact. At jumps velocity and strain take the value
/// right after them in p. Each sample costs O(log a).
class ModeMotion {
public:
    /// O(a). \throws std::invalid_argument unless lowest < T < highest.
    ModeMotion(const Mode& mode, double period);

    /// T [L/c].
    [[nodiscard]] double period() const { return period_; }
    /// t_c [L/c].
    [[nodiscard]] double contactTime() const { return times_.front(); }
    /// h = |p| > 0 [g/L]; E/E_1 = 4 h^2.
    [[nodiscard]] double amplitude() const { return amplitude_; }
    /// Where p changes its sign, ascending in ]0, T[ [L/c]: the first is t_c, from + to -.
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
    /// g - u(L, t) [g].
    [[nodiscard]] double tipGap(double t) const { return 1.0 - displacement(1.0, t); }
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
    double amplitude_ = 0.0;
    std::vector<double> times_;
    std::vector<double> integrals_;  ///< of p/h up to each jump
};

/// The state at t = 0 on N cells: the mean of each wave over each cell, so that u is exact at the
/// ends of cells. Where T N is whole it is the state of the mode's motion of least energy on that
/// grid, but for rounding. O(N log a). \throws std::invalid_argument unless 1 <= N <= maxCells.
[[nodiscard]] State cellMeans(const ModeMotion& motion, std::int64_t cells);

}  // namespace signorini
