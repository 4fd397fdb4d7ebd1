#include "solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "faults.hpp"
#include "names.hpp"
#include "scaling.hpp"
#include "signorini/config.hpp"

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

/// What can be needed, in the words of a refusal.
struct Word {
    bool Capabilities::*capability;
    std::string_view text;
};
constexpr std::array words{
    Word{&Capabilities::quadraticObjective, "a quadratic objective"},
    Word{&Capabilities::energyEquality, "an energy equality"},
    Word{&Capabilities::detectsInfeasibility, "the answer infeasible"},
    Word{&Capabilities::duals, "duals"},
    Word{&Capabilities::iterationLimit, "iterationLimit"},
    Word{&Capabilities::timeLimit, "timeLimit"},
    Word{&Capabilities::start, "start"},
    Word{&Capabilities::cancel, "cancel"},
};
static_assert(words.size() * sizeof(bool) == sizeof(Capabilities), "a word for each");

void refuseUnsupported(const Solver& solver, const Program& program, const SolverOptions& options)
{
    Capabilities needs = needsOf(program);
    needs.iterationLimit = options.iterationLimit > 0;
    needs.timeLimit = std::isfinite(options.timeLimit);
    needs.start = options.start.has_value();
    needs.cancel = static_cast<bool>(options.cancel);
    Faults faults;
    for (const auto& [need, what] : words) {
        if (needs.*need && !(solver.capabilities().*need)) {
            faults.add("solver", solver.name(), fmt::format("one that supports {}", what));
        }
    }
    faults.throwIfAny();
}

bool isChosenFor(const Backend& backend, const Capabilities& needs)
{
    const Choice& choice = backend.chosenFor;
    return needs.energyEquality       ? choice.heldEnergy
           : needs.quadraticObjective ? choice.quadratic
                                      : choice.linear;
}

constexpr auto statusNames = std::to_array<Named<SolverStatus>>({
    {SolverStatus::notRun, "not run"},
    {SolverStatus::optimal, "optimal"},
    {SolverStatus::infeasible, "infeasible"},
    {SolverStatus::unbounded, "unbounded"},
    {SolverStatus::limit, "limit"},
    {SolverStatus::cancelled, "cancelled"},
    {SolverStatus::failed, "failed"},
});

}  // namespace

std::string_view name(SolverStatus status)
{
    return nameIn(statusNames, status);
}

Capabilities needsOf(const Program& program)
{
    return {.quadraticObjective = program.quadratic.size() > 0 && !program.quadratic.isZero(0.0),
            .energyEquality = program.energy.has_value()};
}

bool covers(const Capabilities& can, const Capabilities& needs)
{
    return std::all_of(words.begin(), words.end(), [&](const Word& word) {
        return can.*word.capability || !(needs.*word.capability);
    });
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

std::string versionText()
{
    std::string text = fmt::format("signorini {}\nback ends:\n", SIGNORINI_VERSION);
    for (const Backend& backend : backends()) {
        const std::string library =
            backend.library.empty() ? ""
            : backend.available()   ? fmt::format(" ({} {})", backend.library, backend.version())
                                    : fmt::format(" ({}, not in this build)", backend.library);
        text += fmt::format("  {:<14} {}{}\n", backend.name, backend.purpose, library);
    }
    return text;
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
    throwFault("solver", name, "auto|" + known);
}

std::vector<const Backend*> candidates(const Capabilities& needs)
{
    std::vector<const Backend*> rows;
    for (const Backend& backend : backends()) {
        if (isChosenFor(backend, needs) && covers(backend.can, needs)) {
            rows.push_back(&backend);
        }
    }
    return rows;
}

const Backend* preferred(const Capabilities& needs)
{
    const auto rows = candidates(needs);
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [](const Backend* each) { return each->available(); });
    return row == rows.end() ? nullptr : *row;
}

const Backend& choose(const Capabilities& needs)
{
    if (const Backend* backend = preferred(needs)) {
        return *backend;
    }
    std::vector<std::string_view> names;
    for (const Backend* backend : candidates(needs)) {
        names.push_back(backend->name);
    }
    throw BackendUnavailable(
        names.empty()
            ? "no solver can do all that this request needs"
            : fmt::format("this request needs one of the solvers {}: none is in this build",
                          fmt::join(names, ", ")));
}

std::unique_ptr<Solver> makeSolver(const Backend& backend)
{
    if (!backend.available()) {
        throw BackendUnavailable(
            fmt::format("solver {} is not in this build: configure with -D{}=ON (needs {})",
                        backend.name, backend.option, backend.library));
    }
    if (backend.make == nullptr) {
        throw std::invalid_argument(
            fmt::format("solver {} solves schedules, not programs", backend.name));
    }
    return backend.make(backend);
}

std::unique_ptr<Solver> makeSolver(std::string_view name)
{
    return makeSolver(findBackend(name));
}

}  // namespace signorini
