#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "absence_claims.hpp"
#include "backend_choice.hpp"
#include "formulation.hpp"
#include "infinity.hpp"
#include "known_motions.hpp"
#include "routes.hpp"
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

/// Where to start for a held energy: equal amplitudes, where a solver would otherwise start, are a
/// stationary point of the energy on the set. This takes them apart, the same way in every run.
Eigen::VectorXd startWithEnergy(const Program& program)
{
    const EnergyEquality& energy = *program.energy;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(program.variables());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double wave = 1.0 + 0.5 * std::cos(2.4 * static_cast<double>(i));
        x[i] = energy.weights[i] > 0.0 ? wave : 0.0;
    }
    x *= std::sqrt(energy.value / energy.weights.dot(x.cwiseAbs2()));
    return x.cwiseMax(program.lower).cwiseMin(program.upper);
}

/// Most energy is a convex maximum: from several directions, follow its linearisation from vertex
/// to vertex while the energy grows. The best vertex found is no proof of the most.
SolverResult climb(Formulated& formulated, const Solver& solver, const SolverOptions& settings)
{
    constexpr int directions = 8;
    const Eigen::VectorXd weights = energyWeights(formulated);
    const auto energy = [&weights](const Eigen::VectorXd& x) { return weights.dot(x.cwiseAbs2()); };
    SolverResult best;
    for (int k = 0; k < directions; ++k) {
        // Directions spread over the unknowns, the same in every run.
        Eigen::VectorXd& cost = formulated.program.linear;
        for (Eigen::Index i = 0; i < cost.size(); ++i) {
            cost[i] = std::cos(static_cast<double>((i + 1) * (k + 1)));
        }
        double reached = -1.0;
        while (true) {
            SolverResult next = solver.solve(formulated.program, settings);
            if (next.status != SolverStatus::optimal) {
                return best.status == SolverStatus::optimal ? best : next;
            }
            const double found = energy(next.x);
            if (!(found > reached * (1.0 + 1e-9))) {
                break;
            }
            reached = found;
            cost = -2.0 * weights.cwiseProduct(next.x);
            if (best.status != SolverStatus::optimal || found > energy(best.x)) {
                best = std::move(next);
            }
        }
    }
    return best;
}

/// Solves; most energy by climbing, held energies from a start that takes amplitudes apart. Leaves
/// the direction of the last climb in the program.
SolverResult solve(Formulated& formulated, Objective objective, const Solver& solver,
                   const SolverOptions& settings)
{
    if (objective == Objective::maxEnergy) {
        return climb(formulated, solver, settings);
    }
    SolverOptions started = settings;
    if (formulated.program.energy && solver.capabilities().start) {
        started.start = startWithEnergy(formulated.program);
    }
    return solver.solve(formulated.program, started);
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

/// A bound on the distance of x from the minimiser x*, in the metric of the objective and relative
/// to the size of x: with g the gradient at x, convexity gives
///
///     sum q_i (x_i - x*_i)^2  <=  g . x - min over the rows of g . y,
///
/// a linear program, whose solver did not find x. Empty if that does not solve it.
std::optional<double> minimumError(const Program& program, const Eigen::VectorXd& x,
                                   const Solver& linear, const SolverOptions& options)
{
    Program tangent = program;
    tangent.linear = program.linear + program.quadratic.cwiseProduct(x);
    tangent.quadratic.resize(0);
    const SolverResult lowest = linear.solve(tangent, options);
    if (lowest.status == SolverStatus::unbounded) {
        return infinity;
    }
    if (lowest.status != SolverStatus::optimal) {
        return std::nullopt;
    }
    // Rows met within a tolerance only can turn the sign: its size is the error all the same.
    const double rounding = 1e-15 * tangent.linear.cwiseAbs().dot(x.cwiseAbs());
    const double gap = std::abs(tangent.linear.dot(x - lowest.x)) + rounding;
    return std::sqrt(gap / program.quadratic.dot(x.cwiseAbs2()));
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
