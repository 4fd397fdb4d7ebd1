#include "solver.hpp"

#include <cmath>

#include "faults.hpp"
#include "scaling.hpp"

namespace signorini {

namespace {

void validate(const SolverOptions& options, const Program& program)
{
    Faults faults;
    if (!(options.tolerance >= 1e-12 && options.tolerance <= 1e-2)) {
        faults.add("tolerance", options.tolerance, "1e-12..1e-2");
    }
    if (options.iterationLimit < 0) {
        faults.add("iterationLimit", options.iterationLimit, ">= 0 (0: no limit)");
    }
    if (!(options.timeLimit > 0.0)) {
        faults.add("timeLimit", options.timeLimit, "> 0 [s]");
    }
    if (options.start && options.start->size() != program.variables()) {
        faults.add("size of start", options.start->size(), fmt::format("{}", program.variables()));
    } else if (options.start && !options.start->allFinite()) {
        faults.add("start", "NaN or infinity", "finite numbers");
    }
    faults.throwIfAny();
}

void refuseUnsupported(const Solver& solver, const Program& program, const SolverOptions& options)
{
    const Capabilities can = solver.capabilities();
    Faults faults;
    const auto need = [&](bool wanted, bool supported, std::string_view what) {
        if (wanted && !supported) {
            faults.add("solver", solver.name(), fmt::format("one that supports {}", what));
        }
    };
    const bool isQuadratic = program.quadratic.size() > 0 && !program.quadratic.isZero(0.0);
    need(isQuadratic, can.quadraticObjective, "a quadratic objective");
    need(program.energy.has_value(), can.energyEquality, "an energy equality");
    need(options.iterationLimit > 0, can.iterationLimit, "iterationLimit");
    need(std::isfinite(options.timeLimit), can.timeLimit, "timeLimit");
    need(options.start.has_value(), can.start, "start");
    need(static_cast<bool>(options.cancel), can.cancel, "cancel");
    faults.throwIfAny();
}

}  // namespace

std::string_view name(SolverStatus status)
{
    switch (status) {
        case SolverStatus::notRun:
            return "not run";
        case SolverStatus::optimal:
            return "optimal";
        case SolverStatus::infeasible:
            return "infeasible";
        case SolverStatus::unbounded:
            return "unbounded";
        case SolverStatus::limit:
            return "limit";
        case SolverStatus::cancelled:
            return "cancelled";
        case SolverStatus::failed:
            return "failed";
    }
    throw std::logic_error("unnamed SolverStatus");
}

SolverResult Solver::solve(const Program& program, const SolverOptions& options) const
{
    signorini::validate(program);
    validate(options, program);
    refuseUnsupported(*this, program, options);
    if (isRequested(options.cancel)) {
        SolverResult result;
        result.status = SolverStatus::cancelled;
        result.detail = "cancelled before the start";
        return result;
    }
    SolverResult result;
    if (const std::optional<Scaling> scaling = scalingOf(program)) {
        SolverOptions scaledOptions = options;
        if (scaledOptions.start) {
            *scaledOptions.start /= scaling->unit;
        }
        result = run(scaled(program, *scaling), scaledOptions);
        unscale(*scaling, result);
    } else {
        result = run(program, options);
    }
    if (result.x.size() == program.variables()) {
        result.objective = objective(program, result.x);
        result.violation = violation(program, result.x);
    }
    if (result.status == SolverStatus::optimal &&
        !(result.x.size() == program.variables() && result.violation <= options.tolerance)) {
        result.status = SolverStatus::failed;
        result.detail +=
            fmt::format("; but the point violates the rows by {:.3g}, more than {:.3g}",
                        result.violation, options.tolerance);
    }
    return result;
}

const Backend& findBackend(std::string_view name)
{
    std::string known;
    for (const Backend& backend : backends()) {
        if (backend.name == name) {
            return backend;
        }
        known += known.empty() ? "" : "|";
        known += backend.name;
    }
    throw std::invalid_argument(
        fmt::format("solver = {} is out of range: allowed auto|{}", shortened(name), known));
}

std::unique_ptr<Solver> makeSolver(std::string_view name)
{
    const Backend& backend = findBackend(name);
    if (!backend.available()) {
        throw BackendUnavailable(
            fmt::format("solver {} is not in this build: configure with -D{}=ON (needs {})", name,
                        backend.option, backend.library));
    }
    if (backend.make == nullptr) {
        throw std::invalid_argument(fmt::format("solver {} solves schedules, not programs", name));
    }
    return backend.make();
}

}  // namespace signorini
