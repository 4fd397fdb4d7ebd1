#pragma once
/// \file
/// The state of the bar at one instant: two travelling waves, constant on each cell.
///
/// Equation (26) gives r_1, r_2 the constant values a_i, b_i on cell i. The state keeps them scaled
/// so that
///
///     v/c = a + b,   s = b - a,
///
/// that is, without the factor 1/sqrt(1 + c^2) of (14), and in units of g/L: every number of the
/// library is dimensionless, and only files, figures and `Scales` know metres and seconds.
///
/// ## Motions
///
/// The motion u(x, t), v(x, t), s(x, t) of a found state over one period.
///
/// The delay sequence p_m is the wave r_1 that arrives at the tip in step m; it holds the state,
/// a_i = p_{N-i}, b_i = -p_{N+i-1}, and goes on as p_{m+2N} = +p_m after a contact step, -p_m after
/// a free one. With P the running sum of p the field needs no stepping:
///
///     u(x_i, t_m) = -(P(m+N+i) - P(m+N-i)) / N          [g]
///     v on cell i = p_{m+N-i} - p_{m+N+i-1}             [c g/L]
///     s on cell i = -p_{m+N-i} - p_{m+N+i-1}            [g/L]
///
/// so any sample costs O(1) after O(n + N) preparation.
///
/// ## Orbits
///
/// Orbits: motions up to a shift in time.
///
/// A motion is known by the waves p_0 ... p_{n-1} that arrive at the tip in one period (theory.md,
/// section 2), its orbit by the same numbers in a ring. Periods are folded first (schedule.hpp):
/// that only leaves out what an orbit goes through twice.
///
/// ## What is measured
///
/// At the clamp the strain is -2p for a whole step, and nowhere more, in contact the wall pushes
/// with 2p, in flight the tip moves with 2p: `Extremes` are the largest and least p of a period and
/// its sums, and `Physical` the same in SI units.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// Right-going and left-going wave, N values each; cell i of the paper is entry i - 1.
struct State {
    Eigen::VectorXd a;  ///< [g/L], right-going wave r_1
    Eigen::VectorXd b;  ///< [g/L], left-going wave r_2

    /// N.
    [[nodiscard]] std::int64_t cells() const { return a.size(); }

    friend bool operator==(const State&, const State&) = default;
};

/// v on each cell, in units of c g/L. O(N).
[[nodiscard]] Eigen::VectorXd velocity(const State& state);

/// s = u_x on each cell, in units of g/L. O(N).
[[nodiscard]] Eigen::VectorXd strain(const State& state);

/// u at x_i = i dx, i = 1..N, in units of g; u(0) = 0. The last entry is the tip. O(N).
[[nodiscard]] Eigen::VectorXd displacement(const State& state);

/// E/E_1 = (2/N) sum(a_i^2 + b_i^2); conserved by contact and free steps alike. O(N).
[[nodiscard]] double energyRatio(const State& state);

/// Of a bar of several segments (bar.hpp), with Z_i and c_i their impedances and speeds: velocity
/// and displacement are as above, for all cells take equal times, but s = (b - a)/(c_i/c_1) [g/L]
/// and E/E_1 = (2/N) sum (Z_i/Z_1)(a_i^2 + b_i^2), E_1 being that of a bar of the first material
/// with the same travel time (docs/theory.md, section 19). No segments: of a uniform bar. O(N).
/// \throws std::invalid_argument unless segments and state have as many cells.
[[nodiscard]] Eigen::VectorXd strain(const State& state, std::span<const Segment> segments);
[[nodiscard]] double energyRatio(const State& state, std::span<const Segment> segments);

/// The same state on a grid with `factor` >= 1 times as many cells; a schedule with `factor` times
/// as many steps then gives the same motion, drawn finer. O(factor N).
[[nodiscard]] State refined(const State& state, std::int64_t factor);

/// max |a_i|, |b_i|: the size that residuals are relative to. O(N).
[[nodiscard]] double amplitude(const State& state);

/// What one period of a motion reaches.
struct Extremes {
    double period = 0.0;           ///< [L/c], in which contactTime and impulse are counted
    double contactTime = 0.0;      ///< [L/c], in which the wall is pressed
    double peakForce = 0.0;        ///< [EA g/L], of the tip on the wall
    double impulse = 0.0;          ///< [EA g/c], of the wall on the tip
    double approachSpeed = 0.0;    ///< [c g/L], largest with which the tip meets the wall
    double peakCompression = 0.0;  ///< [g/L], -min s over all x and t, also inside steps
    double peakTension = 0.0;      ///< [g/L], max s over all x and t
    double lowestTip = 0.0;        ///< [g], min u(L, t)
};

/// Walks one period of the schedule, in which the motion repeats so many times; times and sums are
/// those of one repetition. A push of 1e-9 of the largest |p| is none, a tip within 1e-9 g of the
/// wall is there. O(N + min(n, 12N)), no copy of the state. \pre The state is a motion of the
/// schedule. \throws std::invalid_argument on an invalid schedule or a state with other cells.
[[nodiscard]] Extremes extremesOf(const State& state, const Schedule& schedule,
                                  std::int64_t repetitions = 1);

/// The same in SI units.
struct Physical {
    double frequency = 0.0;            ///< [Hz], of the motion's own period
    double contactTime = 0.0;          ///< [s] in one such period, in which the wall is pressed
    double peakForce = 0.0;            ///< [N], of the tip on the wall
    double impulse = 0.0;              ///< [N s] in one period
    double approachSpeed = 0.0;        ///< [m/s], of the tip just before it meets the wall
    double peakCompression = 0.0;      ///< [-], -min s over all x and t
    double peakTension = 0.0;          ///< [-], max s over all x and t
    std::optional<double> peakStress;  ///< [Pa], largest |stress|, if Young's modulus is known
    double tipLowest = 0.0;            ///< [m], min u(L, t)

    /// Is s > -1 everywhere, as the paper demands: does no part of the bar turn inside out?
    [[nodiscard]] bool isAdmissible() const { return peakCompression < 1.0; }
};

/// O(1). \throws std::invalid_argument on an invalid bar.
[[nodiscard]] Physical physicalOf(const Extremes& extremes, const Bar& bar);

struct Damping;
struct Excitation;

/// Random access to the field of one motion.
class Motion {
public:
    /// O(n + N) time and memory, n the steps of the folded schedule (schedule.hpp): after those the
    /// motion is back at its start. \throws std::invalid_argument if the cells do not match.
    Motion(const State& state, const Schedule& schedule);

    /// The same of a bar of several segments (bar.hpp), which has no delay sequence: it is marched
    /// along the schedule, and all of it kept. Its extremes are not looked for. O(n N) time and
    /// memory. \throws std::invalid_argument if the cells do not match, or for more than
    /// maxKeptValues of them.
    Motion(const State& state, const Schedule& schedule, std::span<const Segment> segments);

    /// The same of a bar that is damped and forced (simulation.hpp): u(0, t) is what its base does.
    /// An excitation without values is none.
    Motion(const State& state, const Schedule& schedule, std::span<const Segment> segments,
           const Damping& damping, const Excitation& excitation);

    /// Most cells times instants of a motion that is kept.
    static constexpr std::int64_t maxKeptValues = 20'000'000;

    /// N.
    [[nodiscard]] std::int64_t cells() const { return cells_; }
    /// n of the folded schedule: steps after which the motion is back at its start.
    [[nodiscard]] std::int64_t steps() const { return steps_; }

    /// u(x_i, t_m) in units of g; node i in 0..N, instant m in 0..n.
    [[nodiscard]] double displacement(std::int64_t node, std::int64_t instant) const;
    /// v on cell i in 1..N right after t_m, in units of c g/L.
    [[nodiscard]] double velocity(std::int64_t cell, std::int64_t instant) const;
    /// s on cell i in 1..N right after t_m, in units of g/L.
    [[nodiscard]] double strain(std::int64_t cell, std::int64_t instant) const;
    /// The state right after t_m, m in 0..n. O(N). \throws std::invalid_argument on another
    /// instant.
    [[nodiscard]] State stateAt(std::int64_t instant) const;
    /// Force on the wall in step m in 0..n-1, 2 p_m + F in contact and 0 in flight [EA g/L];
    /// negative at the second stop. What rounding leaves of a zero, 1e-9 of the largest |p|, is no
    /// force.
    [[nodiscard]] double wallForce(std::int64_t step) const;

    /// The same at any place and time, exactly, as waves are constant on each cell and step: x in
    /// cells, 0..N, t in steps, any. Where a wave jumps v and s are those right after it; instants
    /// and places within 1e-9 of a whole number count as that. O(1).
    /// \throws std::invalid_argument unless 0 <= x <= N and t is finite.
    [[nodiscard]] double displacementAt(double x, double t) const;
    [[nodiscard]] double velocityAt(double x, double t) const;
    [[nodiscard]] double strainAt(double x, double t) const;
    [[nodiscard]] double wallForceAt(double t) const;
    /// p_0 ... p_{n-1} [g/L]; empty for a bar of several segments.
    [[nodiscard]] std::span<const double> arriving() const
    {
        return {p_.data(), p_.empty() ? 0 : static_cast<std::size_t>(steps_)};
    }

private:
    /// A place within a cell and an instant within a step.
    struct Place {
        std::int64_t cell = 1;     ///< 1..N
        double offset = 0.0;       ///< [cells], 0..1
        std::int64_t instant = 0;  ///< 0..n-1
        double since = 0.0;        ///< [steps], 0..1
    };
    [[nodiscard]] Place placeOf(double x, double t) const;
    /// a and b on cell i in 1..N right after t_m.
    [[nodiscard]] double rightGoing(std::int64_t cell, std::int64_t instant) const;
    [[nodiscard]] double leftGoing(std::int64_t cell, std::int64_t instant) const;
    /// The same at a place.
    [[nodiscard]] double rightGoing(const Place& at) const;
    [[nodiscard]] double leftGoing(const Place& at) const;
    /// s [g/L] of two waves on a cell.
    [[nodiscard]] double strainOf(std::int64_t cell, double right, double left) const;

    std::int64_t cells_;
    std::int64_t steps_;
    double least_;             ///< force that is more than rounding
    std::vector<double> p_;    ///< p_0 .. p_{n+2N-1}
    std::vector<double> sum_;  ///< P(0) .. P(n+2N)
    /// Of a bar of several segments: u at N + 1 nodes, a and b in N cells, for every instant, and
    /// the force of every step.
    std::vector<double> u_;
    std::vector<double> a_;
    std::vector<double> b_;
    std::vector<double> speed_;  ///< of each cell
    std::vector<double> force_;
};

/// 0, k, 2k, ... up to `last`, which is always included, with the least stride k that gives at most
/// `most` >= 2 values: how files and figures thin out long motions.
[[nodiscard]] std::vector<std::int64_t> thinned(std::int64_t last, std::int64_t most);

/// p_0 ... p_{n-1} [g/L] of a motion that follows the schedule, n counted after folding. O(n).
/// \throws std::invalid_argument on an invalid schedule or a state with other cells.
[[nodiscard]] std::vector<double> arrivals(const State& state, const Schedule& schedule);

/// The same state for all motions of an orbit, equal to the last bit: the orbit as force on the
/// wall begins. Of several such instants it is the first in a lexicographic order that puts steps
/// where force begins before others and larger p before smaller; a grazing motion is taken where
/// that order says. O(n).
/// \pre The state is a motion of the schedule.
/// \throws std::invalid_argument on an invalid schedule or a state with other cells.
[[nodiscard]] State orbitRepresentative(const State& state, const Schedule& schedule);

/// Are two motions of one schedule the same but for a shift in time, each p within `tolerance`
/// times the largest |p|? O(n) for tolerance 0, which suits motions that the library wrote, as
/// propagation does not round. Otherwise O(n) for each shift that brings the largest |p| into
/// place, mostly given up early. \pre Both states are motions of the schedule.
/// \throws std::invalid_argument on an invalid schedule, states with other cells, or a tolerance
/// that is not a number >= 0.
[[nodiscard]] bool isSameOrbit(const State& first, const State& second, const Schedule& schedule,
                               double tolerance = 0.0);

}  // namespace signorini
