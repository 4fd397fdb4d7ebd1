#include "signorini/find_periodic.hpp"

#include <chrono>

#include "faults.hpp"
#include "signorini/closed_form.hpp"
#include "signorini/formulation.hpp"
#include "signorini/solver.hpp"

namespace signorini {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The solver that a request ends up with.
std::string chosenSolver(const Schedule& schedule, const FindOptions& options)
{
    if (options.solver != "auto") {
        const Backend& backend = findBackend(options.solver);
        if (!backend.available()) {
            (void)makeSolver(options.solver);  // throws, and says how to get it
        }
        return options.solver;
    }
    if (schedule.phases.size() == 1 && options.formulation != Formulation::state) {
        return "closed-form";
    }
    return "glpk-simplex";
}

void validate(const Schedule& schedule, const FindOptions& options, const std::string& solver)
{
    signorini::validate(schedule);
    signorini::validate(options.bar);
    Faults faults;
    if (!(options.tolerance >= 1e-12 && options.tolerance <= 1e-2)) {
        faults.add("tolerance", options.tolerance, "1e-12..1e-2");
    }
    if (!(options.timeLimit > 0.0)) {
        faults.add("timeLimit", options.timeLimit, "> 0 [s]");
    }
    const bool closedForm = solver == "closed-form";
    if (closedForm && schedule.phases.size() != 1) {
        faults.add("phases", schedule.phases.size(), "1 with solver closed-form");
    }
    if (closedForm && options.formulation == Formulation::state) {
        faults.add("formulation", name(options.formulation),
                   "auto|reduced with solver closed-form");
    }
    if (!closedForm && options.formulation == Formulation::reduced) {
        faults.add("formulation", name(options.formulation),
                   fmt::format("auto|state with solver {}", solver));
    }
    if (!closedForm && options.objective != Objective::automatic &&
        options.objective != Objective::any) {
        faults.add("objective", name(options.objective),
                   fmt::format("auto|any with solver {}", solver));
    }
    faults.throwIfAny();
}

/// What the exact reduction says of the schedule as a whole, whichever solver looks for a motion.
void describeSet(const Reduction& reduction, PeriodicResult& result)
{
    result.kernelDimension = reduction.kernelDimension;
    result.solutionSet = reduction.set;
    if (!reduction.reason) {
        result.energyRange = energyRange(reduction);
    }
}

void setUndecided(PeriodicResult& result, std::string why)
{
    result.status = Status::undecided;
    result.detail = std::move(why);
    result.state = {};
}

/// Accepts a state only if every residual is within the tolerance.
void acceptMotion(State state, const FindOptions& options, PeriodicResult& result)
{
    Verification verified = verify(state, result.schedule, options.tolerance);
    result.residuals = verified.residuals;
    if (!(result.residuals.worst() <= options.tolerance)) {
        setUndecided(result,
                     fmt::format("{} returned a motion with a residual of {:.3g}, more than "
                                 "the tolerance {:.3g}",
                                 result.route, result.residuals.worst(), options.tolerance));
        return;
    }
    result.status = Status::found;
    result.detail.clear();
    result.canonical = std::move(verified.canonical);
    result.contact = result.canonical.empty() ? Contact::grazing : Contact::pressing;
    result.energyRatio = energyRatio(state);
    result.energy = result.energyRatio * scales(options.bar).energy;
    result.state = std::move(state);
}

/// Accepts absence only with a certificate that holds in integers.
void acceptAbsence(const Reduction& reduction, PeriodicResult& result)
{
    FarkasCertificate certificate = proveAbsence(reduction);
    if (!isProof(certificate, result.schedule)) {
        setUndecided(result, "the certificate of absence does not hold in 64-bit integers");
        return;
    }
    result.status = Status::none;
    result.detail.clear();
    result.reason = reduction.reason;
    result.certificate = std::move(certificate);
}

void solveInClosedForm(const FindOptions& options, PeriodicResult& result)
{
    result.leftOut = {"matrices of (27)-(32): steps are signed shifts",
                      "solver libraries: the solution set is known in closed form",
                      "all but one row of (32) per sign block: prefix sums are monotone inside"};
    const auto start = Clock::now();
    const Reduction reduction = reduce(result.schedule);
    State state;
    if (!reduction.reason) {
        state = options.objective == Objective::maxEnergy
                    ? motionOf(reduction, mostAmplitudes(reduction.set))
                    : leastEnergyMotion(reduction);
    }
    result.solver.seconds = secondsSince(start);
    if (reduction.schedule != result.schedule) {
        result.leftOut.emplace_back("steps beyond 2N in contact and 4N in flight: they repeat");
    }
    describeSet(reduction, result);
    if (reduction.reason) {
        acceptAbsence(reduction, result);
    } else {
        acceptMotion(std::move(state), options, result);
    }
}

void solveInStateForm(const FindOptions& options, PeriodicResult& result)
{
    const auto start = Clock::now();
    Formulated formulated = stateProgram(result.schedule);
    const SolverResult answer = makeSolver(result.solver.name)
                                    ->solve(formulated.program, {.tolerance = options.tolerance,
                                                                 .timeLimit = options.timeLimit});
    result.solver.seconds = secondsSince(start);
    result.solver.iterations = answer.iterations;
    result.leftOut = std::move(formulated.leftOut);

    std::optional<Reduction> reduction;
    if (result.schedule.phases.size() == 1) {
        reduction = reduce(result.schedule);
        describeSet(*reduction, result);
    }
    if (answer.status == SolverStatus::optimal) {
        acceptMotion(stateOf(answer.x, result.schedule.cells), options, result);
    } else if (answer.status != SolverStatus::infeasible) {
        setUndecided(result, fmt::format("{}: {}", result.solver.name, answer.detail));
    } else if (reduction && reduction->reason) {
        acceptAbsence(*reduction, result);
    } else {
        setUndecided(result, fmt::format("{} finds no motion ({}), but there is no exact proof",
                                         result.solver.name, answer.detail));
    }
}

}  // namespace

std::string_view name(Status status)
{
    switch (status) {
        case Status::found:
            return "found";
        case Status::none:
            return "none";
        case Status::undecided:
            return "undecided";
    }
    throw std::logic_error("unnamed Status");
}

std::string_view name(Objective objective)
{
    switch (objective) {
        case Objective::automatic:
            return "auto";
        case Objective::any:
            return "any";
        case Objective::minEnergy:
            return "min-energy";
        case Objective::maxEnergy:
            return "max-energy";
    }
    throw std::logic_error("unnamed Objective");
}

std::string_view name(Formulation formulation)
{
    switch (formulation) {
        case Formulation::automatic:
            return "auto";
        case Formulation::state:
            return "state";
        case Formulation::reduced:
            return "reduced";
    }
    throw std::logic_error("unnamed Formulation");
}

PeriodicResult findPeriodic(const Schedule& schedule, const FindOptions& options)
{
    const std::string solver = chosenSolver(schedule, options);
    validate(schedule, options, solver);
    PeriodicResult result;
    result.schedule = schedule;
    result.bar = options.bar;
    result.period = period(schedule) * scales(options.bar).time;
    result.frequencyRatio = frequencyRatio(schedule);
    result.solver.name = solver;
    result.route = solver == "closed-form" ? solver : solver + " on the state formulation";
    if (solver == "closed-form") {
        solveInClosedForm(options, result);
    } else {
        solveInStateForm(options, result);
    }
    return result;
}

PeriodicResult findPeriodic(std::int64_t contactSteps, std::int64_t freeSteps, std::int64_t cells,
                            const FindOptions& options)
{
    return findPeriodic(Schedule{cells, {{contactSteps, freeSteps}}}, options);
}

}  // namespace signorini
