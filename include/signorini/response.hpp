#pragma once
/// \file
/// Forced, damped motions, exactly: those of one schedule, those of all schedules with one contact
/// phase at one amplitude (the response), and whether the bar stays near them.
///
/// Units L = c = g = 1, forces in EA g/L; Damping and Excitation in simulation.hpp. A schedule
/// (n_c, n_f) is one period of n = n_c + n_f steps in which a harmonic excitation goes through K
/// cycles, m = 0 being the start of contact,
///
///     C cos(2 pi K (m + 1/2)/n) + S sin(2 pi K (m + 1/2)/n)      force on the tip,
///     Y cos(2 pi K m/n - phase)                                  displacement of the base.
///
/// With damping the waves that arrive at the tip are C p^0 + S p^1, u(L, 0) = g is a line in the
/// plane (C, S), and the conditions R >= 0 and u(L) <= g cut it: the motions of a schedule are a
/// segment, a ray, a point or nothing, and an amplitude hypot(C, S) is met by at most two. Each
/// further contact phase closes one more flight: with two what is left is a point or nothing.
/// Waves that nothing damps (without a dashpot, or always in contact) have amplitudes of their own:
/// a linear program in them and (C, S). docs/theory.md, section 15.
///
/// The stops are those of the schedule; a gap of any sign and a second stop only change right sides
/// and signs, two phases that mirror each other leave a segment like one. Where the bar at rest is
/// a motion (no gap, only the wall touched) it is not counted: the motions have amplitudes > 0, as
/// small as one likes. Units are then L in place of g. docs/theory.md, section 17.

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/certificate.hpp"
#include "signorini/control.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// An excitation up to its size.
struct Forcing {
    Excited place = Excited::tip;
    std::int64_t cycles = 1;  ///< [-], K, of a harmonic of any amplitude and phase
    /// Other than a harmonic: one period of its values (simulation.hpp), from the start of
    /// contact, times an amplitude of any sign. Its length divides n.
    std::vector<double> shape = {};
};

/// Whether the bar stays near a motion.
enum class Stability {
    attracts,  ///< every disturbance that was tried died out
    repels,    ///< one grew
    unclear,   ///< neither in the time given, or by 2e7 events
};

/// "attracts", "repels", "unclear".
[[nodiscard]] std::string_view name(Stability stability);

/// Largest residual of a reported motion.
inline constexpr double forcedTolerance = 1e-9;

/// One motion.
struct ForcedMotion {
    Schedule schedule;
    Damping damping;
    Excitation excitation;   ///< n steps from the start of contact
    double amplitude = 0.0;  ///< [EA g/L] (tip) or [g] (base)
    double phase = 0.0;      ///< [rad], of the harmonic; 0 for a shape
    State state;             ///< at the start of contact
    Extremes extremes;       ///< of one period; strains those of the bar, base and tip included
    double residual = 0.0;   ///< the worst of both independent checks,
                             ///< the balance of work included; relative
    std::optional<Stability> stability = {};  ///< for those who ask stabilityOf, to be kept here
};

/// What the motions of a schedule look like.
enum class ForcedKind {
    empty,     ///< none
    point,     ///< one motion
    segment,   ///< amplitudes in a closed interval
    ray,       ///< no largest amplitude
    polytope,  ///< with amplitudes of waves that nothing damps
};

/// "empty", "point", "segment", "ray", "polytope".
[[nodiscard]] std::string_view name(ForcedKind kind);

/// What is demanded of a motion besides.
struct ForcedLimits {
    /// [g/L], S > 0: s >= -S for all x and t, -min s being 2 max p; beside a moving base, whose
    /// velocity adds to it, what waves of a network make (`ForcedSet::isOfNetwork`).
    double strain = std::numeric_limits<double>::infinity();
};

/// A corner of what the motions of a schedule leave of the plane (C, S), with one motion there.
struct ForcedCorner {
    std::array<double, 2> place = {};  ///< (C, S)
    std::vector<double> free = {};     ///< [g/L], amplitudes of the waves that nothing damps
};

class NetworkForced;

/// All motions of one schedule. Where everything is damped (C, S) = foot + t direction, low <= t <=
/// high; else (C, S) fills a polygon, and each of its places has motions of its own.
struct ForcedSet {
    Schedule schedule;
    Damping damping;
    Forcing forcing;
    ForcedLimits limits;
    std::vector<Segment> segments = {};  ///< of the bar, clamp first; empty: a uniform bar
    Status status = Status::undecided;
    std::string detail;  ///< why not decided
    /// Why there is none: contactSign, penetration (of either stop), gap (flights do not close),
    /// constraints.
    std::optional<Reason> reason;
    /// status none: conditions that with u(L, 0) = g contradict each other, two where nothing is
    /// undamped; certain whatever was rounded (isCertain).
    std::vector<ForcedCondition> conflict;
    /// Of a network: multipliers of these conditions, for stepping backwards. They leave
    /// no excitation up to `mostCutAmplitude` whose motion has less than `hugeEnergyRatio` E_1;
    /// without a gap none of any amplitude A with less than A^2 times that.
    std::vector<EnergyFloor> cuts = {};
    ForcedKind kind = ForcedKind::empty;
    double leastAmplitude = 0.0;           ///< [EA g/L] or [g]
    double mostAmplitude = 0.0;            ///< infinite for a ray
    std::array<double, 2> foot = {};       ///< (C, S) nearest to 0 on the line
    std::array<double, 2> direction = {};  ///< of length 1, at right angles to it; 0 for a shape
    double low = 0.0;                      ///< of t
    double high = 0.0;                     ///< of t
    std::int64_t freeWaves = 0;            ///< [-], classes of steps that nothing damps
    /// kind polytope: of the polygon, counterclockwise; two of a segment, one of a point.
    std::vector<ForcedCorner> corners;
    std::shared_ptr<const NetworkForced> waves = {};  ///< where it is of a network

    /// Are its waves those of a network: do segments differ, or is strain limited beside a moving
    /// base?
    [[nodiscard]] bool isOfNetwork() const;
};

/// Largest amplitude that multipliers are asked to exclude [EA g/L or g].
inline constexpr double mostCutAmplitude = 1e9;

/// Decides a schedule. O(n) for each phase; with undamped waves a few dozen linear programs in
/// their amplitudes. Undecided: conditions that rounding could turn, undamped waves where this
/// build has no solver of linear programs.
/// \throws std::invalid_argument on an invalid schedule or damping, more than maxForcedSteps steps,
/// cycles unless 1 <= K < n/2, a shape whose length does not divide n, that is not finite, or 0
/// throughout, or a limit that is not > 0. Of a network (`ForcedSet::isOfNetwork`) one matrix of as
/// many rows as there are waves is factored: more than `maxNetworkSteps` steps are refused.
[[nodiscard]] ForcedSet forcedMotions(const Schedule& schedule, const Damping& damping,
                                      const Forcing& forcing, const ForcedLimits& limits = {},
                                      const std::vector<Segment>& segments = {});

/// Most steps of a period.
inline constexpr std::int64_t maxForcedSteps = 100'000'000;

/// The motion at (C, S) = foot + t direction, with residuals. O(n).
/// \throws std::invalid_argument unless low <= t <= high, or of a polytope.
[[nodiscard]] ForcedMotion motionAt(const ForcedSet& set, double t);

/// The motion of least amplitude; of a polytope one of them. \throws std::invalid_argument if the
/// set is empty, or there is none: without a gap, unless a phase touches the second stop.
[[nodiscard]] ForcedMotion leastAmplitudeMotion(const ForcedSet& set);

/// The motions of one amplitude > 0 by ascending impulse, at most two; of a polytope one of them,
/// on the way from the least amplitude to the largest. For a shape its amplitude is meant without
/// sign. \throws std::invalid_argument unless amplitude is finite and > 0.
[[nodiscard]] std::vector<ForcedMotion> motionsOfAmplitude(const ForcedSet& set, double amplitude);

/// Why no motion has an amplitude.
struct AmplitudeExclusion {
    double amplitude = 0.0;  ///< [EA g/L] or [g]
    /// What is broken at the two places (C, S) of that amplitude with u(L, 0) = g; none: there are
    /// no such places.
    std::vector<ForcedCondition> conflict;
    std::vector<EnergyFloor> cuts = {};  ///< as in ForcedSet; they leave none of this amplitude
    bool isCertain = false;              ///< verified independently, rounding included
};

/// \pre the set is not empty, and motionsOfAmplitude is. O(n).
[[nodiscard]] AmplitudeExclusion exclusionOf(const ForcedSet& set, double amplitude);

/// Verifies the proof of a set with status none independently of what found it, in numbers
/// enclosed by doubles on both sides. O(n).
[[nodiscard]] bool isCertain(const ForcedSet& set);

/// Which motions to list.
struct ResponseRange {
    std::int64_t cells = 300;      ///< [-], N
    Damping damping = {0.02};      ///< ratio > 0
    Excited place = Excited::tip;  ///< what is excited
    double amplitude = 1.0;        ///< [EA g/L] or [g], > 0
    /// [-], 1 or 2: the amplitude is that of the base's velocity [c g/L] or acceleration [c^2
    /// g/L^2].
    int derivative = 0;
    std::int64_t cycles = 1;           ///< [-], K; above 1: subharmonic motions
    double leastFrequencyRatio = 0.5;  ///< of the excitation, omega/omega_1 = 4 N K/n; > 0
    double mostFrequencyRatio = 2.0;   ///< >= least
    /// Most contacts in a period, 1 or 2. Two leave isolated motions, each with an amplitude of its
    /// own: listed are those whose amplitude is within `band` of the amplitude, relative.
    std::int64_t contacts = 1;
    double band = 0.05;  ///< [-], 0 < band < 1
    Stops stops = {};    ///< where the tip is held
    /// Of the bar, clamp first, N cells in all; empty: a uniform bar. Of segments that differ
    /// motions whose contact does not open are apart, and mirrored ones are among those with two
    /// contacts. The frequency is in omega_1 of the first material.
    std::vector<Segment> segments = {};
};

/// Most schedules with two contacts that a range may hold, of all its n: about n^3/12 of each,
/// n^3/3 with a second stop; of segments that differ 2e7.
inline constexpr double maxTwoContactSchedules = 1e9;

/// Motions of one n_c, one for each amplitude of an interval.
struct AmplitudeBranch {
    std::int64_t contact = 0;  ///< n_c
    double least = 0.0;        ///< [EA g/L] or [g]
    double most = 0.0;         ///< infinite: without end

    friend bool operator==(const AmplitudeBranch&, const AmplitudeBranch&) = default;
};

/// The motions of a schedule with two contacts: as a rule one, least and most being the same.
struct TwoContactBranch {
    std::array<Phase, 2> phases = {};  ///< the longer contact first
    double least = 0.0;                ///< amplitude [EA g/L] or [g]
    double most = 0.0;                 ///< more than the least where a class is always in contact

    friend bool operator==(const TwoContactBranch&, const TwoContactBranch&) = default;
};

/// The tip that never leaves the wall, where the bar presses on it at rest. Waves that run between
/// base and wall are damped by nothing and may be added; here there are none, so the push is the
/// static one and a harmonic.
struct PermanentContact {
    double leastForce = 0.0;  ///< [EA g/L], of the tip on the wall, whatever the phase; >= 0
    Extremes extremes;        ///< of one period, at phase 0
    double residual = 0.0;    ///< as that of a motion
};

/// All motions at one frequency with as many contacts as were asked for, on either stop, and, where
/// stops are at equal distances and K is odd, those with two of which the second is the first,
/// mirrored.
struct FrequencyResponse {
    std::int64_t steps = 0;       ///< n, of the period of the motions
    double frequencyRatio = 0.0;  ///< omega/omega_1 of the excitation
    double linearPeak = 0.0;      ///< max u(L) of the bar without stops [g]
    bool touches = false;         ///< would that motion meet a stop?
    double openUpTo = 0.0;        ///< [EA g/L] or [g], the amplitude at which it begins to
    std::int64_t undecided = 0;   ///< schedules that were not decided
    std::string detail;           ///< why the first of them was not
    /// It holds at any frequency but those of the bar between base and wall, for amplitudes up to
    /// that at which the push would vanish.
    std::optional<PermanentContact> permanent;
    double permanentUpTo = 0.0;  ///< [EA g/L] or [g], the amplitude at which it would; 0: none
    std::vector<ForcedMotion> motions;  ///< by contacts, stop, ascending n_c, then impulse
    /// One contact, of all amplitudes, in this order, at most two for each schedule: an amplitude
    /// is met by as many motions as there are branches that hold it.
    std::vector<AmplitudeBranch> branches;
    std::vector<TwoContactBranch> twoContacts;  ///< of all amplitudes
};

/// What a call may do beside its work.
struct ResponseControl {
    Cancel cancel = {};
    std::function<void(double done, double total)> progress = {};
};

/// The n of a range, ascending: 4NK/most <= n <= 4NK/least, n > 2K.
/// \throws std::invalid_argument naming each field that is out of range, if there is no such n, or
/// if they have more than maxTwoContactSchedules.
[[nodiscard]] std::vector<std::int64_t> stepsOf(const ResponseRange& range);

/// One n of a range, every 1 <= n_c < n, and every schedule with two contacts if they are asked
/// for; each motion verified. A period of two contacts that is a shorter one gone through twice is
/// left out. A range is shared among threads by giving them different n. O(n^2) at most, with two
/// contacts O(n^4); none if it was cancelled. Of segments that differ all n_c share one sequence of
/// Toeplitz systems; schedules whose waves the steps in flight fix no better than rounding are
/// counted as undecided.
/// \throws as stepsOf, but for the number of schedules.
[[nodiscard]] std::optional<FrequencyResponse> responseAt(const ResponseRange& range,
                                                          std::int64_t steps,
                                                          const Cancel& cancel = {});

/// All n of a range; those that were done when it was cancelled.
/// \throws as stepsOf.
[[nodiscard]] std::vector<FrequencyResponse> frequencyResponse(const ResponseRange& range,
                                                               const ResponseControl& control = {});

/// A free, undamped motion of a mode, at the frequency of an excitation.
struct BackbonePoint {
    double frequencyRatio = 0.0;  ///< omega/omega_1 of the excitation, 4K L/(cT)
    double energyRatio = 0.0;     ///< E/E_1
    Extremes extremes;
};

/// What forced motions with little damping follow.
struct Backbone {
    Mode mode;
    std::vector<BackbonePoint> points;  ///< by descending frequency, the ends of the mode left out
};

/// Most |b| of the modes of a backbone.
inline constexpr std::int64_t maxBackboneOrder = 15;

/// The modes up to maxBackboneOrder with motions in a range of frequencies, K cycles of the
/// excitation in a period of theirs; so many points of each, but for those that a second stop is in
/// the way of. Without a gap a mode has one period only, and there are none. Milliseconds.
/// \throws std::invalid_argument unless 0 < least <= most, cycles >= 1 and points >= 1.
[[nodiscard]] std::vector<Backbone> backbonesOf(double leastFrequencyRatio,
                                                double mostFrequencyRatio, std::int64_t cycles = 1,
                                                const Stops& stops = {}, int points = 160);

/// What to try. Each arriving wave is multiplied by 1 + a random number of at most `size`.
struct StabilityOptions {
    std::int64_t periods = 300;                ///< to wait for
    std::vector<double> sizes = {1e-3, 1e-4};  ///< > 0, < 1
    std::int64_t draws = 2;                    ///< disturbances of each size
    std::uint64_t seed = 1;                    ///< of the first
    double mergeBelow = 1e-10;                 ///< SimulationOptions::mergeBelow
    std::vector<Segment> segments = {};        ///< SimulationOptions::segments
    Cancel cancel = {};
};

/// One disturbance: largest |u - u of the motion| along the bar [g].
struct StabilityTrial {
    double size = 0.0;
    double start = 0.0;
    double end = 0.0;
};

/// The outcome, with what was tried.
struct StabilityResult {
    Stability stability = Stability::unclear;
    std::vector<StabilityTrial> trials;
    double drift = 0.0;         ///< [g], of the undisturbed motion from where it began: 0 but for
                                ///< rounding, unless it is damped and not forced
    std::int64_t contacts = 0;  ///< of the undisturbed motion, in the time waited
};

/// Perturbs the motion and compares displacements after whole periods. It attracts if all end
/// below a tenth of their start, it repels if one ends above ten times its start.
/// \throws std::invalid_argument on options out of range.
[[nodiscard]] StabilityResult stabilityOf(const ForcedMotion& motion,
                                          const StabilityOptions& options = {});

/// The same of a free motion of a schedule, in its periods. With damping it has no period and fades
/// itself: disturbances are compared with what it does undisturbed.
/// \throws std::invalid_argument also on a state with other cells than the schedule.
[[nodiscard]] StabilityResult stabilityOf(const State& state, const Schedule& schedule,
                                          const Damping& damping = {},
                                          const StabilityOptions& options = {});

}  // namespace signorini
