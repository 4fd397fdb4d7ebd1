#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "absence_claims.hpp"
#include "accept.hpp"
#include "backend_choice.hpp"
#include "known_motions.hpp"
#include "minimum_error.hpp"
#include "program_solution.hpp"
#include "tolerated.hpp"

namespace signorini {

namespace {

/// The demands that a program gets: several phases answer with least energy if they can.
Demands posedDemands(const Request& request)
{
    Demands posed = request.demands;
    if (request.isOfAnySize()) {
        // Looked for at one impulse, and brought to the energy afterwards: least for its impulse is
        // most impulse for its energy.
        posed.energyRatio.reset();
        posed.objective =
            posed.objective == Objective::maxImpulse ? Objective::minEnergy : posed.objective;
    }
    if (posed.objective == Objective::automatic && request.options.solver == automaticChoice &&
        !posed.energyRatio && preferred({.quadraticObjective = true}) != nullptr) {
        posed.objective = Objective::minEnergy;
    }
    return posed;
}

/// Why this solver, and why not the closed form.
std::string reasonFor(const Program& program, const Request& request)
{
    const FindOptions& options = request.options;
    const char* cause = options.solver != automaticChoice           ? "as asked for"
                        : request.schedule.stops.left               ? "two stops"
                        : !request.known.onePhase                   ? "several contact phases"
                        : options.formulation == Formulation::state ? "state asked for"
                                                                    : "demands beyond the closed "
                                                                      "form";
    if (request.demands.objective == Objective::maxEnergy) {
        return fmt::format(
            "{}: a convex maximum, climbed from vertex to vertex: the most found, not proved the "
            "most",
            cause);
    }
    const char* kind = program.energy ? "a nonlinear program (held energy: the flattest motion is "
                                        "known to the closed form only)"
                       : program.quadratic.size() > 0 ? "a quadratic program"
                                                      : "a linear program";
    return fmt::format("{}: {}", cause, kind);
}

/// A request as a program, and what a back end said of it.
struct Solved {
    Demands posed;
    Formulation formulation;
    Formulated formulated;
    SolverResult answer;
    Provenance how;
};

/// Says that there is no solution, or cannot find one.
bool isWithout(const SolverResult& answer)
{
    return answer.status == SolverStatus::infeasible || answer.status == SolverStatus::failed;
}

Solved solved(const Request& request)
{
    const Stopwatch watch;
    const FindOptions& options = request.options;
    const Demands posed = posedDemands(request);
    const Formulation formulation = options.formulation == Formulation::automatic
                                        ? cheapestFormulation(posed)
                                        : options.formulation;
    Solved s{posed, formulation, pose(request.schedule, posed, formulation), {}, {}};
    s.how.solver.name = backendFor(s.formulated.program, options.solver);
    s.how.route = fmt::format("{} on the {} formulation", s.how.solver.name, name(formulation));
    s.how.reason = reasonFor(s.formulated.program, request);
    if (posed.objective != Objective::automatic) {
        s.how.objective = posed.objective;
    }

    const auto solver = makeSolver(s.how.solver.name);
    const SolverOptions settings{
        .tolerance = options.tolerance,
        .iterationLimit = options.iterationLimit,
        .timeLimit = options.timeLimit,
        .cancel = solver->capabilities().cancel ? options.cancel : Cancel()};
    s.answer = solve(s.formulated, posed.objective, *solver, settings);
    if (isWithout(s.answer) &&
        (std::isfinite(posed.strainLimit) || std::isfinite(posed.tipFloor))) {
        // A limit that a motion misses by no more than the tolerance is met (tolerated.hpp); a
        // tenth of it is left to the solver.
        s.formulated = pose(request.schedule, relaxed(posed, 0.9 * options.tolerance), formulation);
        s.answer = solve(s.formulated, posed.objective, *solver, settings);
    }
    s.how.leftOut = s.formulated.leftOut;
    s.how.solver.iterations = s.answer.iterations;
    s.how.solver.seconds = watch.seconds();
    return s;
}

/// Local methods stop at motions that are not extreme and call them so: what is known of the set
/// is held against them. Says what is wrong; empty if nothing is.
std::string doubtOfExtreme(const Request& request, const Solved& s, const State& state)
{
    const auto& range = request.known.set.energy;
    if (s.posed.objective == Objective::maxEnergy && !s.posed.areLimits() && range &&
        std::isinf(range->most)) {
        return "the energies of the schedule have no bound: no motion has the most";
    }
    const auto why = refutation(s.posed, request.schedule, state, knownMotions(request),
                                request.options.tolerance);
    return why ? fmt::format("{} returned a motion {}", s.how.route, *why) : std::string();
}

/// Where no known motion judges the nearest, its distance from the true one is bounded by linear
/// programming. Says what is wrong, or notes the bound.
std::string doubtOfNearest(const Request& request, Solved& s)
{
    const auto linear = simplexWithDuals();
    if (request.demands.objective != Objective::nearest || !linear) {
        return {};
    }
    const double tolerance = request.options.tolerance;
    const auto error =
        minimumError(s.formulated.program, s.answer.x, *linear,
                     {.tolerance = tolerance, .timeLimit = request.options.timeLimit});
    if (error && *error <= std::sqrt(tolerance)) {
        s.how.reason +=
            fmt::format("; amplitudes off by at most {:.2g} of their root mean square", *error);
        return {};
    }
    return fmt::format("{} returned a motion that is not shown to be the nearest: {}", s.how.route,
                       error ? fmt::format("it may be off by {:.3g} of its size", *error)
                             : std::string("its error could not be bounded"));
}

Claim claimOfMotion(const Request& request, Solved& s)
{
    State state = stateOf(s.formulated, s.answer.x);
    std::string doubt = doubtOfExtreme(request, s, state);
    if (doubt.empty()) {
        doubt = doubtOfNearest(request, s);
    }
    if (!doubt.empty()) {
        return {std::move(s.how), std::move(doubt)};
    }
    return {std::move(s.how), request.sized(std::move(state))};
}

/// No motion came of it: claims absence if that is proved.
Claim claimWithoutMotion(const Request& request, Solved& s)
{
    const std::vector<State> known = knownMotions(request);
    const bool isKnown = std::any_of(known.begin(), known.end(), [&](const State& state) {
        return request.isMetBy(request.sized(state));
    });
    if (isWithout(s.answer)) {
        auto absence = absenceOfAll(request);
        if (!absence) {
            absence = absenceByEnergy(request);
        }
        if (!absence && !isKnown) {
            absence = absenceByProgram(request, s.formulation);
        }
        if (absence) {
            return {std::move(s.how), std::move(*absence)};
        }
    }
    std::string why = fmt::format(
        "{}: {}; no exact proof of absence was found either{}", s.how.solver.name, s.answer.detail,
        isKnown ? ", and there is none: solver auto knows a motion that meets the demands" : "");
    return {std::move(s.how), std::move(why)};
}

}  // namespace

std::optional<Claim> programRoute(const Request& request)
{
    if (preferred({.energyEquality = true}) == nullptr && holdsEnergyInSums(request)) {
        return std::nullopt;
    }
    Solved s = solved(request);
    Claim claim = s.answer.status == SolverStatus::optimal ? claimOfMotion(request, s)
                                                           : claimWithoutMotion(request, s);
    if (request.demands.energyRatio && holdsEnergyInSums(request) &&
        accept(request, claim).status == Status::undecided) {
        return std::nullopt;
    }
    return claim;
}

}  // namespace signorini
