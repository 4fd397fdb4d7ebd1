#pragma once
/// \file
/// `findPeriodic`: a verified periodic motion of a schedule, or a proof that there is none.
///
/// The cheapest route that is exact for the request is taken, its answer is checked by code that
/// did not produce it, and a claim that does not hold is downgraded to undecided.

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/certificate.hpp"
#include "signorini/reduction.hpp"
#include "signorini/schedule.hpp"
#include "signorini/state.hpp"
#include "signorini/verification.hpp"

namespace signorini {

/// What the mathematics answers.
enum class Status {
    found,      ///< a motion, verified
    none,       ///< no motion, proved
    undecided,  ///< neither; `PeriodicResult::detail` says why
};

/// "found", "none", "undecided".
[[nodiscard]] std::string_view name(Status status);

/// Which motion of the solution set to return.
enum class Objective {
    automatic,  ///< least energy where that costs nothing (closed form), otherwise any
    any,        ///< whichever the route finds first
    minEnergy,  ///< least E
    maxEnergy,  ///< most E
};

/// "auto", "any", "min-energy", "max-energy".
[[nodiscard]] std::string_view name(Objective objective);

/// Which unknowns the problem is posed in.
enum class Formulation {
    automatic,  ///< whatever the route needs least of
    state,      ///< the paper's a and b, equations (30)-(32) as they stand
    reduced,    ///< class amplitudes
};

/// "auto", "state", "reduced".
[[nodiscard]] std::string_view name(Formulation formulation);

/// A request names only what it wants.
struct FindOptions {
    Bar bar = {};                 ///< turns numbers into metres, seconds and joules
    std::string solver = "auto";  ///< a name from `backends()`, or "auto"
    Formulation formulation = Formulation::automatic;
    Objective objective = Objective::automatic;
    /// Largest relative residual a found motion may have; also the solver's tolerance. Looser
    /// values do not make the closed form faster.
    double tolerance = 1e-7;
    double timeLimit = std::numeric_limits<double>::infinity();  ///< [s], for the solver
};

/// Who did the work, and how long it took.
struct SolverReport {
    std::string name = "not run";
    std::int64_t iterations = 0;
    double seconds = 0.0;  ///< [s], formulation and solution, without verification
};

/// The answer. Invariants: found <=> `state` has N cells and `residuals` are within the tolerance;
/// none <=> `reason` and a verified `certificate` are present; undecided <=> `detail` is not empty.
struct PeriodicResult {
    Status status = Status::undecided;
    std::string detail = "findPeriodic has not been called";  ///< why undecided, else empty
    Schedule schedule;                                        ///< as asked for
    Bar bar;
    double period = 0.0;          ///< [s], T = n dt
    double frequencyRatio = 0.0;  ///< omega/omega_1

    std::optional<std::int64_t> kernelDimension;  ///< dim ker(W - 1), if the route knows it
    std::optional<AmplitudeSet> solutionSet;      ///< the set of all motions, if the route knows it

    State state;  ///< at t = 0, start of the first contact phase
    Contact contact = Contact::pressing;
    std::vector<Phase> canonical;  ///< phases in which the wall is pressed; empty if grazing
    double energy = 0.0;           ///< [J]
    double energyRatio = 0.0;      ///< E/E_1
    std::optional<EnergyRange> energyRange;  ///< over the whole set, if the route knows it
    Residuals residuals;                     ///< recomputed, relative

    std::optional<Reason> reason;                  ///< why none exists
    std::optional<FarkasCertificate> certificate;  ///< checked in integers

    std::string route;                 ///< e.g. "closed-form"
    std::vector<std::string> leftOut;  ///< what the request did not need
    SolverReport solver;
};

/// Decides a schedule, and returns a motion of it or the proof that there is none.
///
/// Routes: one contact phase and `auto` or `closed-form` -> closed form, O(N); a linear-programming
/// back end -> the paper's equations in a, b (its answer is a witness, any motion of the set).
/// Several phases: a back end finds motions; their absence is left undecided.
///
/// \throws std::invalid_argument on an invalid schedule, bar or option, BackendUnavailable if the
/// solver asked for is not in this build, std::bad_alloc if 2N numbers do not fit.
[[nodiscard]] PeriodicResult findPeriodic(const Schedule& schedule,
                                          const FindOptions& options = {});

/// One contact phase of n_c steps and n_f free steps on N cells.
[[nodiscard]] PeriodicResult findPeriodic(std::int64_t contactSteps, std::int64_t freeSteps,
                                          std::int64_t cells = 300,
                                          const FindOptions& options = {});

/// Steps are whole numbers: anything else does not compile.
template <typename Contact, typename Free>
requires(std::floating_point<Contact> || std::floating_point<Free>) PeriodicResult
    findPeriodic(Contact, Free, std::int64_t = 300, const FindOptions& = {})
= delete;

}  // namespace signorini
