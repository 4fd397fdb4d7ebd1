// What the solver libraries need for the same schedules, in each formulation, and what our
// interface adds to a bare call.

#include <benchmark/benchmark.h>

#include "formulation.hpp"
#include "signorini/config.hpp"
#include "signorini/demands.hpp"
#include "solver.hpp"

#if SIGNORINI_HAS_GLPK
#include <glpk.h>

#include <cmath>
#include <vector>
#endif

namespace {

using namespace signorini;

/// Family A: n_c = N/2, n_f = 3N (exists, E_min/E_1 = 4). Family C: n_f = 4N (none).
Schedule familyA(std::int64_t cells)
{
    return {cells, {{cells / 2, 3 * cells}}};
}

Schedule familyC(std::int64_t cells)
{
    return {cells, {{cells / 2, 4 * cells}}};
}

Program programOf(const Schedule& schedule, Formulation formulation, Objective objective)
{
    return pose(schedule, {.objective = objective}, formulation).program;
}

/// Solves one program again and again. `outside_percent` is the time our code spends around the
/// library call, relative to it: setting up, reducing redundant rows, recomputing the claim.
void solve(benchmark::State& bench, const std::string& name, const Program& program,
           SolverStatus expected)
{
    if (!findBackend(name).available()) {
        bench.SkipWithError("not in this build");
        return;
    }
    const auto solver = makeSolver(name);
    double inside = 0.0;
    double outside = 0.0;
    for (auto _ : bench) {
        const SolverResult result = solver->solve(program);
        if (result.status != expected) {
            bench.SkipWithError(result.detail.c_str());
            break;
        }
        inside += result.solveSeconds;
        outside += result.setupSeconds;
        benchmark::DoNotOptimize(result.objective);
    }
    bench.counters["setup_percent"] = 100.0 * outside / inside;
    bench.counters["unknowns"] = static_cast<double>(program.variables());
    bench.counters["entries"] =
        static_cast<double>(program.equalities.nonZeros() + program.inequalities.nonZeros());
}

#if SIGNORINI_HAS_GLPK
/// The same program handed to GLPK with nothing of ours in between.
void bareGlpk(benchmark::State& bench, const Program& program)
{
    glp_term_out(GLP_OFF);
    for (auto _ : bench) {
        glp_prob* problem = glp_create_prob();
        const auto columns = static_cast<int>(program.variables());
        glp_add_cols(problem, columns);
        for (int i = 0; i < columns; ++i) {
            const double lower = program.lower[i];
            const double upper = program.upper[i];
            const int type = lower == upper         ? GLP_FX
                             : std::isfinite(lower) ? (std::isfinite(upper) ? GLP_DB : GLP_LO)
                             : std::isfinite(upper) ? GLP_UP
                                                    : GLP_FR;
            glp_set_col_bnds(problem, i + 1, type, std::isfinite(lower) ? lower : 0.0,
                             std::isfinite(upper) ? upper : 0.0);
        }
        std::vector<int> at(1);
        std::vector<double> value(1);
        const auto add = [&](const auto& matrix, const Eigen::VectorXd& rhs, int type) {
            if (matrix.rows() == 0) {
                return;
            }
            const int first = glp_add_rows(problem, static_cast<int>(matrix.rows()));
            for (int row = 0; row < matrix.rows(); ++row) {
                at.resize(1);
                value.resize(1);
                for (typename std::decay_t<decltype(matrix)>::InnerIterator entry(matrix, row);
                     entry; ++entry) {
                    at.push_back(static_cast<int>(entry.col()) + 1);
                    value.push_back(entry.value());
                }
                glp_set_mat_row(problem, first + row, static_cast<int>(at.size()) - 1, at.data(),
                                value.data());
                glp_set_row_bnds(problem, first + row, type, rhs[row], rhs[row]);
            }
        };
        add(program.equalities, program.equalityRhs, GLP_FX);
        add(program.inequalities, program.inequalityRhs, GLP_UP);
        glp_smcp settings;
        glp_init_smcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        settings.presolve = GLP_ON;
        benchmark::DoNotOptimize(glp_simplex(problem, &settings));
        glp_delete_prob(problem);
    }
}
#endif

/// One solver, formulation and schedule.
void add(const std::string& what, const std::string& solver, Formulation formulation,
         Objective objective, const Schedule& schedule, SolverStatus expected)
{
    const std::string label = what + "/" + solver + "/" + std::string(name(formulation)) + "/" +
                              std::to_string(schedule.cells);
    const Program program = programOf(schedule, formulation, objective);
    benchmark::RegisterBenchmark(label.c_str(), [=](benchmark::State& bench) {
        solve(bench, solver, program, expected);
    })->Unit(benchmark::kMicrosecond);
#if SIGNORINI_HAS_GLPK
    if (solver == "glpk-simplex") {
        benchmark::RegisterBenchmark((what + "/bare-glpk/" + std::string(name(formulation)) + "/" +
                                      std::to_string(schedule.cells))
                                         .c_str(),
                                     [=](benchmark::State& bench) { bareGlpk(bench, program); })
            ->Unit(benchmark::kMicrosecond);
    }
#endif
}

const bool registered = [] {
    using enum Formulation;
    constexpr SolverStatus found = SolverStatus::optimal;
    for (const std::int64_t cells : {300, 3000}) {
        for (const Formulation form : {state, reduced, lumped}) {
            add("exists", "glpk-simplex", form, Objective::any, familyA(cells), found);
            add("none", "glpk-simplex", form, Objective::any, familyC(cells),
                SolverStatus::infeasible);
            add("least-energy", "ipopt", form, Objective::minEnergy, familyA(cells), found);
        }
        add("exists", "glpk-exact", state, Objective::any, familyA(cells), found);
        add("exists", "glpk-exact", reduced, Objective::any, familyA(cells), found);
        add("exists", "ipopt", state, Objective::any, familyA(cells), found);
    }
    for (const Formulation form : {state, reduced}) {
        add("exists", "glpk-interior", form, Objective::any, familyA(300), found);
        add("least-energy", "nlopt-slsqp", form, Objective::minEnergy, familyA(300), found);
    }
    return true;
}();

}  // namespace
