#pragma once
/// \file
/// What the bar does from any state: damping, excitation, and an exact simulation event by event.
///
/// Units L = c = g = 1; forces in EA g/L. A massless dashpot holds the tip with the force -eta v.
/// A force F(t) pulls at the tip towards the wall, or the base moves with velocity V(t) while the
/// wall stands still. With p the wave that arrives at the tip and q the one that leaves it,
///
///     flight    q = rho p + F/(1 + eta),   v = (2p + F)/(1 + eta),   rho = (1 - eta)/(1 + eta)
///     contact   q = -p,   v = 0,   and the wall pushes with R = F + 2p >= 0
///     base      p(t) = V(t - 1) - q(t - 2).
///
/// The state is a list of pieces (duration, value); nothing stands on a grid, and no step of time
/// is chosen. docs/theory.md, section 16.
///
/// A bar of several segments (bar.hpp) has two such lists for each of them, and at a joint every
/// piece makes two. Z being the impedance of the last segment, eta stays the dashpot in units of
/// EA/c of the first: rho = (Z - eta)/(Z + eta), 1/(Z + eta) in place of 1/(1 + eta), and R =
/// F + 2 Z p. docs/theory.md, section 19.

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/control.hpp"
#include "signorini/motion.hpp"

namespace signorini {

/// A dashpot at the tip; every linear mode of the free bar decays at the same rate.
struct Damping {
    double ratio = 0.0;  ///< [-], zeta of the first linear mode, 0..maxDampingRatio; 0: none

    /// rho = exp(-pi zeta), what an echo in flight leaves of a wave.
    [[nodiscard]] double rho() const;
    /// eta = tanh(pi zeta/2), the dashpot in units of EA/c.
    [[nodiscard]] double eta() const;

    friend bool operator==(const Damping&, const Damping&) = default;
};

/// Beyond it hardly a wave comes back: rho = 2e-27.
inline constexpr double maxDampingRatio = 20.0;

/// \throws std::invalid_argument unless 0 <= ratio <= maxDampingRatio.
void validate(const Damping& damping);

/// The damping with the given rho. \throws std::invalid_argument unless rho is in ]0, 1] and the
/// ratio in its range.
[[nodiscard]] Damping dampingOfRho(double rho);

/// eta EA/c [N s/m] for a bar.
[[nodiscard]] double dashpot(const Damping& damping, const Bar& bar);

/// What is moved from outside.
enum class Excited {
    tip,   ///< a force on the tip
    base,  ///< the base moves
};

/// "tip", "base".
[[nodiscard]] std::string_view name(Excited place);

/// A periodic excitation, constant in each step, but for a base, which moves straight from one
/// place to the next.
struct Excitation {
    Excited place = Excited::tip;
    /// One period. tip: the force F of each step [EA g/L]. base: its displacement at the beginning
    /// of each step [g]. Empty: no excitation.
    std::vector<double> values = {};
    double stepsPerCrossing = 1.0;  ///< [-], steps in L/c; N where steps are those of a grid

    /// n, steps of one period.
    [[nodiscard]] std::int64_t steps() const { return static_cast<std::int64_t>(values.size()); }
    /// F in step m >= 0 [EA g/L]; 0 for a base.
    [[nodiscard]] double force(std::int64_t m) const;
    /// V in step m >= 0 [c g/L]; 0 for a force.
    [[nodiscard]] double baseVelocity(std::int64_t m) const;
    /// y at the beginning of step m >= 0 [g]; 0 for a force.
    [[nodiscard]] double baseDisplacement(std::int64_t m) const;
};

/// Most steps of an excitation.
inline constexpr std::int64_t maxExcitationSteps = 100'000'000;

/// \throws std::invalid_argument on values that are not finite, too many, or a stepsPerCrossing
/// that is not finite and positive.
void validate(const Excitation& excitation);

/// The same excitation in `factor` >= 1 times as many steps. O(factor n).
[[nodiscard]] Excitation refined(const Excitation& excitation, std::int64_t factor);

/// K cycles in n steps: tip F cos(2 pi K (m + 1/2)/n - phase), base Y cos(2 pi K m/n - phase).
struct Harmonic {
    Excited place = Excited::tip;
    double amplitude = 1.0;         ///< F [EA g/L] or Y [g]
    double phase = 0.0;             ///< [rad]
    std::int64_t cycles = 1;        ///< [-], K
    std::int64_t steps = 0;         ///< [-], n
    double stepsPerCrossing = 1.0;  ///< [-]
};

/// Its values. O(n). \throws std::invalid_argument unless 1 <= n <= maxExcitationSteps,
/// 1 <= 2K <= n, and the other numbers are finite, stepsPerCrossing > 0.
[[nodiscard]] Excitation excitationOf(const Harmonic& harmonic);

/// One cycle of frequency omega/omega_1 = W, a period of 4/W L/c: in as many whole steps as come
/// nearest to `stepsPerCrossing` in L/c, which then is what makes the period exact. `steps` and
/// `cycles` are not read. \throws as above, and std::invalid_argument naming `field` where that
/// would be fewer than 3 or more than maxExcitationSteps.
[[nodiscard]] Excitation excitationAt(Harmonic harmonic, double frequencyRatio,
                                      std::string_view field = "frequency");

/// A stretch of a wave with one value.
struct Piece {
    double duration =
        0.0;             ///< > 0, in units of which a crossing of the bar takes `Waves::crossing`
    double value = 0.0;  ///< [g/L]

    friend bool operator==(const Piece&, const Piece&) = default;
};

/// A state of the bar off any grid. The durations of each wave add up to `crossing`.
struct Waves {
    double crossing = 1.0;  ///< units of time in L/c; N for a state on a grid
    std::vector<Piece> a;   ///< right-going wave, in the order in which it reaches the tip
    std::vector<Piece> b;   ///< left-going wave, in the order in which it reaches the base
    /// Where the base stands [g]; unset: where the excitation has it. From elsewhere it is led to
    /// its place within a period of the excitation, evenly, so that nothing jumps.
    std::optional<double> base = std::nullopt;
};

/// A state on a grid; its unit of time is the step. O(N).
[[nodiscard]] Waves wavesOf(const State& state);

/// A bar at rest whose base stands at `base` [g], for an excitation with so many steps in L/c:
/// without waves, or pressed on a stop where its tip, not strained, would stand beyond it. With a
/// negative gap a = 1/2, b = -1/2 throughout.
[[nodiscard]] Waves wavesAtRest(double stepsPerCrossing = 1.0, const Stops& stops = {},
                                double base = 0.0);

/// A bar of several segments at rest, a step for each cell: without waves, or pressed by one force
/// throughout. \throws std::invalid_argument on segments that are none.
[[nodiscard]] Waves wavesAtRest(std::span<const Segment> segments, const Stops& stops,
                                double base = 0.0);

/// u(x_i) - u(0), x_i = i/cells, i = 0..cells [g]. O(pieces + cells).
[[nodiscard]] Eigen::VectorXd stretching(const Waves& waves, std::int64_t cells);

/// E/E_1 = 2 int (a^2 + b^2) dx of a uniform bar. O(pieces).
[[nodiscard]] double energyRatio(const Waves& waves);

/// One contact with a stop, or several that follow each other closer than the resolution.
struct ContactEvent {
    double start = 0.0;      ///< [L/c]
    double end = 0.0;        ///< [L/c]
    double impulse = 0.0;    ///< int R dt [EA g/c]
    double peakForce = 0.0;  ///< [EA g/L], of a wave front, however short
    /// [EA g/L], largest mean over the stretches of the resolution that follow each other from its
    /// start; the peak where the resolution is 0.
    double meanForce = 0.0;
    double speed = 0.0;  ///< [c g/L], of the tip when it came to the stop; 0: it started there
    /// [E_1], turned over: of the waves that the stop sends back, int 2 Z p^2 dt.
    double energy = 0.0;
    Stop stop = Stop::right;

    friend bool operator==(const ContactEvent&, const ContactEvent&) = default;
};

/// The tip at one instant; straight between neighbours.
struct TipPoint {
    double time = 0.0;          ///< [L/c]
    double displacement = 0.0;  ///< [g]
};

/// Energy that came and went since the start, in units of E_1.
struct EnergyBalance {
    double work = 0.0;        ///< done by the excitation
    double dissipated = 0.0;  ///< in the dashpot
    double error = 0.0;       ///< energy now - at the start - work + dissipated
    double size = 0.0;        ///< what the error is to be compared with: the largest term
};

/// How to simulate.
struct SimulationOptions {
    /// [-], >= 0; neighbours that differ by no more times the largest of the waves at the start and
    /// of those that the excitation sends become one piece with their mean. Equal ones always do.
    /// Unset: 0 for a uniform bar without damping, else 1e-11.
    std::optional<double> mergeBelow = {};
    bool recordsTip = false;  ///< keep the path of the tip
    Stops stops = {};         ///< what the tip meets
    /// Of a bar that is not uniform; the start's `crossing` is the number of their cells.
    std::vector<Segment> segments = {};
    /// [L/c], >= 0: contacts with one stop no further apart are one. How often a tip that chatters
    /// leaves the wall is a matter of rounding, and its impulse is not.
    double resolution = 0.0;
};

/// Pieces of a wave in the order of arrival, in a ring.
class PieceQueue {
public:
    /// Neighbours that differ by no more become one with their mean.
    explicit PieceQueue(double mergeBelow = 0.0) : mergeBelow_(mergeBelow), ring_(64) {}

    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const Piece& front() const { return ring_[head_]; }
    [[nodiscard]] const Piece& operator[](std::size_t k) const
    {
        return ring_[(head_ + k) & (ring_.size() - 1)];
    }
    /// sum of duration times value^2. O(pieces).
    [[nodiscard]] double squares() const;
    /// sum of |jump| times duration over all that became one.
    [[nodiscard]] double merged() const { return merged_; }

    void append(double duration, double value);
    /// Takes a duration from the front. A rest that is no longer than `same` goes to what follows.
    void take(double duration, double same);

private:
    void grow();

    double mergeBelow_;
    std::vector<Piece> ring_;  ///< a power of two
    std::size_t head_ = 0;
    std::size_t count_ = 0;
    double rest_ = 0.0;  ///< of the last piece, where nothing followed
    double merged_ = 0.0;
};

class SegmentLines;

/// The bar, event by event: the end of a piece, the end of a step of the excitation, the tip at the
/// wall. A constant effort for each event. On a grid and undamped it only moves and negates
/// numbers: nothing is rounded. Instants that differ by less than 1e-12 L/c are one.
class BarSimulation {
public:
    /// \throws std::invalid_argument on values that are not finite, durations that are not positive
    /// or do not add up, a tip beyond a stop by more than 1e-9 of what the waves or the stops
    /// reach, or sizes beyond 1e100 or below 1e-100; also on segments that are none or have other
    /// cells than the start.
    BarSimulation(const Waves& start, const Damping& damping, Excitation excitation = {},
                  const SimulationOptions& options = {});
    BarSimulation(const BarSimulation&);
    BarSimulation(BarSimulation&&) noexcept;
    BarSimulation& operator=(const BarSimulation&);
    BarSimulation& operator=(BarSimulation&&) noexcept;
    ~BarSimulation();

    /// The same bar without its past: no contacts, no path, time 0. \pre a period of the
    /// excitation has just ended.
    [[nodiscard]] BarSimulation fork(bool recordsTip) const;

    /// Goes on for a time in units of the start's `Waves`: steps for a state on a grid.
    void advance(double duration);

    /// [L/c] since the start.
    [[nodiscard]] double time() const;
    /// u(L) [g].
    [[nodiscard]] double tip() const;
    /// Displacement of the base [g].
    [[nodiscard]] double base() const;
    /// Is the tip held by a stop?
    [[nodiscard]] bool isHeld() const { return isHeld_; }
    /// The stop that holds the tip, or held it last.
    [[nodiscard]] Stop stop() const { return stop_; }
    /// What it is made of; empty: a uniform bar.
    [[nodiscard]] const std::vector<Segment>& segments() const { return parts_; }
    /// The stops there are.
    [[nodiscard]] const Stops& stops() const { return stops_; }
    /// The state. O(pieces).
    [[nodiscard]] Waves waves() const;
    /// Pieces under way.
    [[nodiscard]] std::int64_t pieces() const;
    /// E/E_1 of the state. O(pieces).
    [[nodiscard]] double energyRatio() const;
    /// Contacts that are over, and pressed.
    [[nodiscard]] const std::vector<ContactEvent>& contacts() const { return contacts_; }
    /// All impulse so far, that of a contact that lasts included, each counted > 0 [EA g/c].
    [[nodiscard]] double impulse() const { return impulse_; }
    /// The path of the tip, if it is recorded.
    [[nodiscard]] const std::vector<TipPoint>& tipPath() const { return path_; }
    /// Events so far.
    [[nodiscard]] std::int64_t events() const { return events_; }
    /// How far all merging together can have moved any cross-section: sum of |jump| times
    /// duration [g].
    [[nodiscard]] double merged() const;
    /// O(pieces).
    [[nodiscard]] EnergyBalance balance() const;

private:
    /// A periodic list of values, each of which lasts as long.
    struct Clock {
        std::vector<double> values;
        std::size_t first = 0;  ///< of those that are repeated
        double step = 0.0;
        std::size_t next = 0;  ///< the value after the present one
        double value = 0.0;
        double left = 0.0;

        void pass(double duration, double same);
    };
    struct Sum {
        double value = 0.0;
        double lost = 0.0;
        void add(double term);
        [[nodiscard]] double total() const { return value + lost; }
    };

    void setClocks();
    void place(const Waves& start);
    void step(double most);
    void send(double q, double lasts);
    void press(double push, double p, double lasts);
    void closeContact();
    void hold(Stop stop, double speed);
    void recordTip();
    [[nodiscard]] double storedSquares() const;
    [[nodiscard]] Waves wavesOfEcho() const;

    double crossing_;
    double same_;  ///< instants that differ by less are one
    double rho_;
    double eta_;
    double impedance_ = 1.0;  ///< Z, of the last segment
    double admittance_;       ///< 1/(Z + eta)
    bool recordsTip_;
    Stops stops_;
    double way_;  ///< from the wall to the second stop, like opening_; infinite: none
    Excitation excitation_;
    Clock force_;
    double lead_ = 0.0;  ///< [g], of the base from its place at the start
    Clock base_;         ///< V one crossing ago, as it arrives at the tip; with segments V now
    PieceQueue echo_;    ///< of a uniform bar: q, in the order in which it arrives
    /// Of a bar of several segments: its waves, one entry; else empty.
    std::vector<SegmentLines> segments_;
    std::vector<Segment> parts_;
    bool isHeld_ = false;
    double speed_ = 0.0;  ///< with which the stop that holds was met
    Stop stop_ = Stop::right;
    Sum opening_;        ///< place of the wall - u(L), in g times units of time per crossing
    Sum time_;           ///< units
    double owed_ = 0.0;  ///< units that were asked for and not yet simulated
    std::int64_t events_ = 0;
    double start_ = 0.0;  ///< sum of squares at the start
    Sum work_;
    Sum dissipated_;
    double mergedBefore_ = 0.0;  ///< in the echo, by the start
    double impulse_ = 0.0;
    double resolution_;            ///< [L/c]
    double stretchEnd_ = 0.0;      ///< [L/c], of the stretch over which force is averaged
    double stretchImpulse_ = 0.0;  ///< in it so far
    ContactEvent contact_;         ///< the one that lasts
    std::vector<ContactEvent> contacts_;
    std::vector<TipPoint> path_;
};

}  // namespace signorini
