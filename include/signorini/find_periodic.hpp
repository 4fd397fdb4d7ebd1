#pragma once
/// \file
/// `findPeriodic`: a verified periodic motion of a schedule, or a proof that there is none.
///
/// The cheapest route that is exact for the request is taken, its answer is checked by code that
/// did not produce it, and a claim that does not hold is downgraded to undecided.
///
/// **Tolerance.** One rule on all routes: a demand that a motion breaks by at most the tolerance,
/// relative (`violation` of demands.hpp), is met; absence is claimed only if the demands, relaxed
/// by the tolerance, are proved impossible.
///
/// **Extremes.** What a solver calls the least, the most or the nearest is withdrawn if a motion is
/// known that meets the same demands and is better.

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "signorini/amplitude_set.hpp"
#include "signorini/bar.hpp"
#include "signorini/certificate.hpp"
#include "signorini/control.hpp"
#include "signorini/demands.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"
#include "signorini/verification.hpp"

namespace signorini {

/// A request names only what it wants. Lengths, strains and energies are in the scaled units of
/// motion.hpp, as in `Demands`; divide metres by `scales(bar).displacement`, strains by
/// `scales(bar).strain`.
struct FindOptions {
    /// Bar, gap and stops. Beside the sign of the gap and the place of a second stop it decides
    /// nothing, but gives the answer in seconds and joules.
    Scene scene = {};
    std::string solver = "auto";                       ///< a name from `backends()`, or "auto"
    Formulation formulation = Formulation::automatic;  ///< unknowns handed to a solver
    Objective objective = Objective::automatic;        ///< which motion of the set
    std::optional<State> target = std::nullopt;        ///< [g/L], for Objective::nearest
    /// [g/L], S > 0: strain s >= -S for all x and t; the paper's admissibility is S = L/g.
    double strainLimit = std::numeric_limits<double>::infinity();
    /// [g], lowest displacement of the tip allowed, < 1.
    double tipFloor = -std::numeric_limits<double>::infinity();
    std::vector<FixedValue> fixed = {};  ///< [g/L], prescribed parts of the initial state
    /// [E_1], energy to hold; without a gap [EA L/2], and it has to be given.
    std::optional<double> energyRatio = std::nullopt;
    /// Largest relative residual a found motion may have; also the solver's tolerance. Looser
    /// values do not make the closed form faster.
    double tolerance = 1e-7;
    double timeLimit = std::numeric_limits<double>::infinity();  ///< [s], for the solver
    std::int64_t iterationLimit = 0;                             ///< [-], for the solver; 0: none
    Cancel cancel = {};  ///< stops a solver that can be stopped
};

/// The motions that have the energy to hold.
struct HeldEnergy {
    std::int64_t dimension = 0;              ///< [-]
    bool isConnected = true;                 ///< can all of them be joined?
    std::optional<std::int64_t> components;  ///< in so many parts; empty beyond 64 bits
};

/// The set of all motions of a schedule, as far as the route knows it; `onePhaseSet` and
/// `lumpedSet` describe it in full.
struct MotionSet {
    std::optional<std::int64_t> kernelDimension = {};  ///< dim ker(W - 1)
    std::optional<SetKind> kind = {};                  ///< its shape
    std::int64_t dimension = -1;                       ///< [-], known if the kind is; -1: empty
    std::optional<AmplitudeSet> amplitudes = {};       ///< the same in amplitudes, one phase only
    /// From least to most; `most` may be infinite, or NaN if not known.
    std::optional<EnergyRange> energy = {};
    std::optional<TentPlace> family =
        {};  ///< of one phase that presses: the set is that family's face
    std::optional<HeldEnergy> held = {};  ///< of one phase, where an energy to hold was found
};

/// A motion whose residuals are within the tolerance.
struct FoundMotion {
    State state;                          ///< at t = 0, start of the first contact phase
    Contact contact = Contact::pressing;  ///< does the wall feel it?
    std::vector<Phase> canonical;         ///< phases in which the wall is pressed; empty if grazing
    std::int64_t repetitions = 1;  ///< how often the motion repeats within the schedule's period
    std::vector<bool> pressing;    ///< for each phase of the schedule: is the wall pressed at all?
    bool isSymmetric = false;      ///< is its second half the first, mirrored from stop to stop?
    double energy = 0.0;           ///< [J]
    double energyRatio = 0.0;      ///< E/E_1
    Physical physical;             ///< in SI units, over the motion's own period
    Residuals residuals;           ///< recomputed, relative
};

/// Multipliers over the rows of the program `pose(schedule, demands, rows)` that exclude every
/// motion which meets the demands, even relaxed by the tolerance.
struct ProgramProof {
    InfeasibilityProof multipliers = {};        ///< checked in rationals
    Formulation rows = Formulation::automatic;  ///< what the multipliers refer to
    Demands demands = {};                       ///< limits and fixed values; other demands left out
    double tolerance = 0.0;                     ///< relative, as in `violation`
};

/// Every energy of the set misses the one to hold by more than the tolerance.
struct EnergyExclusion {
    double energyRatio = 0.0;  ///< E/E_1 to hold
    EnergyRange range = {};    ///< of the set, by the route
    double tolerance = 0.0;    ///< relative
    /// [g/L], if it narrows the range: that of the motions whose strain stays within it.
    double strainLimit = std::numeric_limits<double>::infinity();
    /// Is the range verified independently, in rationals? (Not where several phases limit it from
    /// above.)
    bool isVerified = false;
};

/// "E/E_1 = 3 is outside the range [4, 600] of the schedule", or of its motions within the limit.
[[nodiscard]] std::string describe(const EnergyExclusion& exclusion);

/// Rational multipliers over the rows of the joints form of a bar of several segments (theory.md,
/// section 19), in blocks, that exclude every motion, even if the tip floor is relaxed by the
/// tolerance.
struct SteppedProof {
    RationalProof multipliers = {};                              ///< checked in rationals
    double tipFloor = -std::numeric_limits<double>::infinity();  ///< [g], as asked for
    double tolerance = 0.0;                                      ///< relative
};

/// Multipliers by which every motion of a bar of several segments, even if its tip floor is relaxed
/// by the tolerance, has at least an energy: more than the one to hold, or, where none is held,
/// more than any bar bears (theory.md, section 19).
struct EnergyFloorProof {
    EnergyFloor multipliers = {};  ///< checked by a march backwards, its rounding bounded
    double energyRatio = 0.0;      ///< E/E_1: no motion has less
    double tipFloor = -std::numeric_limits<double>::infinity();    ///< [g], as asked for
    double tolerance = 0.0;                                        ///< relative
    std::optional<double> held = std::nullopt;                     ///< E/E_1 to hold
    double strainLimit = std::numeric_limits<double>::infinity();  ///< [g/L], as asked for
};

/// What no bar bears, E/E_1: below it at least absence is proved where no energy is held.
inline constexpr double hugeEnergyRatio = 1e9;

/// Why there is no motion.
struct Absence {
    Reason reason = Reason::constraints;  ///< in a word
    /// Over the paper's rows, checked in integers; over the rows of a program; or by the energies.
    std::variant<FarkasCertificate, ProgramProof, EnergyExclusion, SteppedProof, EnergyFloorProof>
        proof = {};
};

/// Who did the work, and how long it took.
struct SolverReport {
    std::string name = "not run";  ///< as in --solver
    std::int64_t iterations = 0;   ///< [-], as the solver counts them
    double seconds = 0.0;          ///< [s], formulation and solution, without verification
};

/// How an answer was got.
struct Provenance {
    std::string route = {};                 ///< e.g. "closed-form"
    std::string reason = {};                ///< why that route
    std::vector<std::string> leftOut = {};  ///< what the request did not need
    Objective objective = Objective::any;   ///< which motion of the set the answer is
    SolverReport solver = {};               ///< who did it
};

/// The answer. Invariants: found <=> `motion` is present; none <=> `absence` is present;
/// undecided <=> neither, and `detail` says why.
struct PeriodicResult {
    Status status = Status::undecided;                        ///< the verdict
    std::string detail = "findPeriodic has not been called";  ///< why undecided, else empty
    Schedule schedule;                                        ///< as asked for
    Scene scene;                                              ///< as asked for
    double period = 0.0;                                      ///< [s], T = n dt
    double frequencyRatio = 0.0;                              ///< omega/omega_1
    MotionSet set;                                            ///< all motions
    std::optional<FoundMotion> motion;                        ///< the one asked for
    std::optional<Absence> absence;                           ///< why there is none
    Provenance how;                                           ///< route and solver
};

/// Checks a proof of absence once more, against rows and bounds made anew from the schedule. False
/// for anything that is no proof, also for a range of energies that no other code confirms.
/// O(rows of the program).
[[nodiscard]] bool isProof(const PeriodicResult& result);

/// Decides a schedule, and returns a motion of it or the proof that there is none.
///
/// Routes, the cheapest that is exact for the request:
/// - one contact phase: the closed form, O(N); limits on strain and tip are met by the motion of
///   least energy or by none, an energy to hold by the motion of least peak compression (objective
///   automatic or minPeakStrain), or where the wall is pressed by the nearest to a target
/// - several contact phases, or two stops: the exact verdict of lumped_set.hpp, O(N + blocks);
///   demands as above
/// - no gap: the same sets are cones, and the motion is the one of most impulse for its energy
/// - demands that neither can answer, or phases beyond its limits: a linear, quadratic or nonlinear
///   program in as few unknowns as they allow (`cheapestFormulation`), by GLPK, Ipopt or NLopt
/// - a bar of several segments: coordinates of ker(W - 1) (`Formulation::kernel`; `joints` asks for
///   the same), in which an active set method finds the motion of least energy, the nearest to a
///   target in the norm of the energy, or multipliers of a conflict, and programs find those of
///   most impulse or of a given energy. Independent time stepping confirms a motion; rationals that
///   there is none, or, where these would be too many, steps backwards in time: none below
///   `hugeEnergyRatio`. Equal segments without dashpots are one bar
/// - the paper's equations in a, b (`Formulation::state`) when asked for, as a witness
/// Where a program has no solution, absence is claimed only with an exact proof.
///
/// The stops of the schedule are those of `FindOptions::scene`, whatever it says itself.
///
/// \throws std::invalid_argument on an invalid schedule, scene or option, BackendUnavailable if no
/// solver in this build can do what is asked, std::bad_alloc if 2N numbers do not fit.
[[nodiscard]] PeriodicResult findPeriodic(const Schedule& schedule,
                                          const FindOptions& options = {});

/// One contact phase of n_c steps and n_f free steps on N cells.
[[nodiscard]] PeriodicResult findPeriodic(std::int64_t contactSteps, std::int64_t freeSteps,
                                          std::int64_t cells = 300,
                                          const FindOptions& options = {});

/// For each set of motions with one contact in a period of n steps the schedule that has all of it:
/// the families, by ascending k, then, where nu = 2, the linear motions that touch the wall without
/// force; `gapSign` is that of the gap. O(log n) and their number.
/// \throws std::invalid_argument unless 1 <= N <= maxCells, 1 <= n <= maxSteps.
[[nodiscard]] std::vector<Schedule> schedulesOfPeriod(std::int64_t cells, std::int64_t steps,
                                                      int gapSign = 1);

/// Steps are whole numbers: anything else does not compile.
template <typename Contact, typename Free>
requires(std::floating_point<Contact> || std::floating_point<Free>) PeriodicResult
    findPeriodic(Contact, Free, std::int64_t = 300, const FindOptions& = {})
= delete;

}  // namespace signorini
