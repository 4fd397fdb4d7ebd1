#include "solving.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "clp.hpp"
#include "echo.hpp"
#include "formulation.hpp"
#include "infeasibility.hpp"
#include "judge.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "stopwatch.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

Record identify(const CaseName& name, const Problem& problem, std::string_view backEnd,
                std::string_view form, double tolerance)
{
    Record record = identified(name.suite, problem.name, std::string(backEnd), std::string(form),
                               fmt::format("{} {:g}", name.setting, tolerance));
    record.figures["cells"] = static_cast<double>(problem.schedule.cells);
    record.figures["tolerance"] = tolerance;
    return record;
}

Case caseOf(const CaseName& name, Record record, std::function<void(Record&)> body)
{
    std::string series;
    if (!name.series.empty()) {
        series =
            fmt::format("{}/{}/{}/{}", name.suite, name.series, record.backEnd, record.formulation);
    }
    return {std::move(record), std::move(series), std::move(body)};
}

/// The library found out that the claim does not hold (solver.cpp).
bool wasWithdrawn(const SolverResult& result)
{
    return result.status == SolverStatus::failed &&
           result.detail.find("but the point violates") != std::string::npos;
}

void judgeClaim(const Problem& problem, const Formulated& formulated, const SolverResult& result,
                double tolerance, Record& record)
{
    record.detail = result.detail;
    if (result.status == SolverStatus::optimal) {
        judgeFound(problem, stateOf(formulated, result.x), tolerance, record);
    } else if (result.status == SolverStatus::infeasible) {
        judgeNone(problem, record);
    } else {
        record.claim = wasWithdrawn(result) ? "withdrawn" : name(result.status);
        record.outcome = wasWithdrawn(result) ? "withdrawn" : "undecided";
    }
}

void solveProgram(const Problem& problem, std::string_view backEnd, std::string_view form,
                  double tolerance, const Kept& kept, Record& record)
{
    const auto solver = makeRival(backEnd);
    Formulated formulated;
    record.figures["pose_seconds"] =
        timeOf([&] {
            formulated = poseForm(problem.schedule, problem.demands, form, kept);
        }).median;
    recordSize(formulated.program, record);
    const SolverOptions options{.tolerance = tolerance};
    SolverResult result;
    Stopwatch watch;
    std::vector<double> inside;
    std::vector<double> outside;
    const Timing timing = timeOf([&] {
        watch.restart();
        result = solver->solve(formulated.program, options);
        inside.push_back(result.solveSeconds);
        outside.push_back(watch.seconds() - result.solveSeconds);
    });
    bench::record(timing, record);
    record.figures["solve_seconds"] = medianOf(inside);
    record.figures["setup_seconds"] = medianOf(outside);
    record.figures["iterations"] = static_cast<double>(result.iterations);
    judgeClaim(problem, formulated, result, tolerance, record);
}

FindOptions optionsFor(const Problem& problem, double tolerance)
{
    return {.scene = problem.scene,
            .objective = problem.demands.objective,
            .strainLimit = problem.demands.strainLimit,
            .energyRatio = problem.demands.energyRatio,
            .tolerance = tolerance};
}

void judgeResult(const Problem& problem, const PeriodicResult& result, double tolerance,
                 Record& record)
{
    record.detail = result.how.route + (result.detail.empty() ? "" : ": " + result.detail);
    if (result.motion) {
        judgeFound(problem, result.motion->state, tolerance, record);
    } else if (result.absence) {
        judgeNone(problem, record);
        // Proofs are checked again here, except an energy outside a range that no other code knows.
        if (!isProof(result) && !std::holds_alternative<EnergyExclusion>(result.absence->proof)) {
            record.outcome = "wrong";
            record.detail += ": the proof does not hold";
        }
    } else {
        record.claim = name(result.status);
        record.outcome = "undecided";
    }
}

}  // namespace

std::vector<std::string_view> linearBackEnds()
{
    return {"glpk-simplex", "glpk-interior", "glpk-exact",  "clp-simplex",
            "clp-barrier",  "ipopt",         "nlopt-slsqp", "nlopt-cobyla"};
}

std::vector<std::string_view> quadraticBackEnds()
{
    return {"ipopt", "nlopt-slsqp", "nlopt-auglag", "clp-barrier", "clp-primal"};
}

std::vector<std::string_view> energyBackEnds()
{
    return {"ipopt", "nlopt-auglag"};
}

bool hasTolerance(std::string_view backEnd)
{
    return backEnd != "glpk-interior" && backEnd != "glpk-exact";
}

std::unique_ptr<Solver> makeRival(std::string_view backEnd)
{
    const auto& ours = clpMethods();
    return std::find(ours.begin(), ours.end(), backEnd) != ours.end() ? makeClp(backEnd)
                                                                      : makeSolver(backEnd);
}

void recordSize(const Program& program, Record& record)
{
    record.figures["variables"] = static_cast<double>(program.variables());
    record.figures["rows"] =
        static_cast<double>(program.equalities.rows() + program.inequalities.rows());
    record.figures["entries"] =
        static_cast<double>(program.equalities.nonZeros() + program.inequalities.nonZeros());
}

Case programCase(const CaseName& name, const Problem& problem, std::string_view backEnd,
                 std::string_view form, double tolerance, const Kept& kept)
{
    return caseOf(
        name, identify(name, problem, backEnd, form, tolerance),
        [problem, solver = std::string(backEnd), shape = std::string(form), tolerance,
         kept](Record& record) { solveProgram(problem, solver, shape, tolerance, kept, record); });
}

Case libraryCase(const CaseName& name, const Problem& problem, double tolerance)
{
    return caseOf(
        name, identify(name, problem, "signorini", "auto", tolerance),
        [problem, tolerance](Record& record) {
            const FindOptions options = optionsFor(problem, tolerance);
            PeriodicResult result;
            bench::record(timeOf([&] { result = findPeriodic(problem.schedule, options); }),
                          record);
            record.figures["solve_seconds"] = result.how.solver.seconds;
            record.figures["iterations"] = static_cast<double>(result.how.solver.iterations);
            judgeResult(problem, result, tolerance, record);
        });
}

Case closedFormCase(const CaseName& name, const Problem& problem, double tolerance)
{
    return caseOf(
        name, identify(name, problem, "closed-form", "-", tolerance),
        [problem, tolerance](Record& record) {
            OnePhaseSet whole;
            State state;
            bench::record(
                timeOf([&] {
                    onePhaseSet(problem.schedule, whole);
                    if (!whole.reason && problem.demands.energyRatio) {
                        state = motionOf(
                            whole, amplitudesWithSquares(
                                       whole.set, squaresOf(*problem.demands.energyRatio,
                                                            whole.schedule.cells, whole.window)));
                    } else if (!whole.reason) {
                        state = leastEnergyMotion(whole);
                    }
                }),
                record);
            if (whole.reason) {
                judgeNone(problem, record);
            } else {
                judgeFound(problem, state, tolerance, record);
            }
        });
}

}  // namespace signorini::bench
