#pragma once
/// \file
/// A schedule: how many steps the tip of the bar touches the wall, how many it flies free, in turn.
///
/// The bar is cut into N equal cells, dx = L/N, and time into steps dt = dx/c, equation (26) and
/// what follows it. One period is a list of phases, each n_c contact steps followed by n_f free
/// steps; the paper has one phase. Period T = n dt with n the sum of all steps.
///
/// Below: the words in which answers about a schedule are given.

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/bar.hpp"

namespace signorini {

/// Which of the stops the tip touches. Of bars in a row their contact number k + 1 has the value k.
enum class Stop {
    right,  ///< the wall, at u(L) = g; it pushes the tip to the left
    left,   ///< the second stop, at u(L) = -h; it pushes the tip to the right
};

/// "right", "left".
[[nodiscard]] std::string_view name(Stop stop);

/// One contact phase and the free flight after it.
struct Phase {
    std::int64_t contact = 0;  ///< [steps], n_c >= 1
    std::int64_t free = 0;     ///< [steps], n_f >= 1
    Stop stop = Stop::right;   ///< that is touched

    /// By contact, then free, then the stop.
    friend auto operator<=>(const Phase&, const Phase&) = default;
};

/// A rational number in lowest terms, denominator > 0.
struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;

    /// Rounded once.
    [[nodiscard]] double value() const
    {
        return static_cast<double>(numerator) / static_cast<double>(denominator);
    }

    friend bool operator==(const Fraction&, const Fraction&) = default;
};

/// A rational period [L/c].
using ExactPeriod = Fraction;

/// numerator/denominator in lowest terms. \pre both > 0.
[[nodiscard]] ExactPeriod exactPeriod(std::int64_t numerator, std::int64_t denominator);

/// The simplest fraction that rounds to this double. \pre it is finite and > 0, and neither the
/// fraction nor its inverse exceeds 2^53.
[[nodiscard]] Fraction simplestFraction(double value);

/// Where the tip stops, in units of displacement (bar.hpp). All that a scene's gap and stops mean
/// to the equations is here; every unit in metres is gone.
struct Stops {
    int right = 1;  ///< u(L) at the wall: the sign of the gap, 1, 0 or -1
    /// h in the same units: the second stop stands at u(L) = -left.
    std::optional<Fraction> left = std::nullopt;

    friend bool operator==(const Stops&, const Stops&) = default;
};

/// The stops of a scene; h/|g| is taken for the simplest fraction that rounds to it, so that proofs
/// are exact. \throws std::invalid_argument on an invalid scene.
[[nodiscard]] Stops stopsOf(const Scene& scene);

/// The grid, the phases of one period, and the stops they touch.
struct Schedule {
    std::int64_t cells = 300;   ///< [-], N, number of equal cells of the bar
    std::vector<Phase> phases;  ///< at least one; the period starts with the first contact
    Stops stops = {};           ///< where the tip is held

    friend bool operator==(const Schedule&, const Schedule&) = default;
};

/// Largest number of cells: one state then fills 1.6 GB, and every product formed inside the
/// library fits in 64 bits.
inline constexpr std::int64_t maxCells = 100'000'000;

/// Largest number of steps in one period.
inline constexpr std::int64_t maxSteps = std::int64_t{1} << 62;

/// Checks 1 <= N <= maxCells, at least one phase, every phase >= 1 step of each kind, and a sum of
/// all steps <= maxSteps, and stops that stand apart, a left one if a phase touches it; reports all
/// faults in one message.
/// \throws std::invalid_argument with field, value and allowed range.
void validate(const Schedule& schedule);

/// n, all steps of one period of a valid schedule. O(K).
[[nodiscard]] std::int64_t steps(const Schedule& schedule);

/// T c/L = n/N, the period in units of the time a wave needs to cross the bar.
[[nodiscard]] double period(const Schedule& schedule);

/// omega/omega_1 = 4N/n, the abscissa of the frequency-energy plot.
[[nodiscard]] double frequencyRatio(const Schedule& schedule);

/// Replaces a schedule by one with the same equations and fewer steps.
///
/// In contact the state repeats after 2N steps, in free flight after 4N (equations (21)-(25)), and
/// so do the inequalities. Hence n_c >= 2N may be replaced by 2N + (n_c mod 2N) and n_f >= 4N by
/// 4N + (n_f mod 4N): W of (30) is the same matrix, and the rows of (32) that fall away repeat rows
/// that stay. Afterwards n < 12N per phase, so the cost of a verdict never grows with the period.
void fold(Schedule& schedule);

/// The same for one phase on N cells.
void fold(std::int64_t cells, Phase& phase);

/// "(150, 900)", "(1, 5) L:(1, 5)", for people; more than eight phases are abridged.
[[nodiscard]] std::string describe(const std::vector<Phase>& phases);

/// "N = 300, (150, 900)", "N = 4, (1, 5) L:(1, 5)", for people.
[[nodiscard]] std::string describe(const Schedule& schedule);

/// What the mathematics answers.
enum class Status {
    found,      ///< a motion, verified
    none,       ///< no motion, proved
    undecided,  ///< neither; `PeriodicResult::detail` says why
};

/// "found", "none", "undecided".
[[nodiscard]] std::string_view name(Status status);

/// Why no motion exists; the first that applies, in this order.
enum class Reason {
    noLiveClass,  ///< ker(W - 1) = 0: only the bar at rest repeats
    contactSign,  ///< the same amplitude would have to push and to pull on the wall
    penetration,  ///< a prefix sum of (12) is positive whatever the amplitudes
    gap,          ///< the tip cannot be at the wall at t = 0: row (31) has no sign that fits
    constraints,  ///< motions exist, but none meets the further demands
};

/// "no-live-class", "contact-sign", "penetration", "gap", "constraints".
[[nodiscard]] std::string_view name(Reason reason);

/// Does the wall feel the motion?
enum class Contact {
    pressing,  ///< positive force at some contact step
    grazing,   ///< the tip touches, the force is zero throughout: a linear motion
};

/// "pressing" or "grazing".
[[nodiscard]] std::string_view name(Contact contact);

/// Both ends of the energies E/E_1 that the motions of a set have.
struct EnergyRange {
    double least = 0.0;  ///< [E_1]
    double most = 0.0;   ///< [E_1]
};

}  // namespace signorini
