// Why programs have a unit of their own: what a bare call of a library makes of SI units.

#include "catch.hpp"
#include "formulation.hpp"
#include "signorini/config.hpp"
#include "signorini/one_phase_set.hpp"
#include "solver.hpp"
#include "support.hpp"

#if SIGNORINI_HAS_GLPK

#include <glpk.h>

#include <vector>

using namespace signorini;

namespace {

using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

void addRows(glp_prob* problem, const Rows& rows, const Eigen::VectorXd& rhs, int type)
{
    const int first = glp_add_rows(problem, static_cast<int>(rows.rows()));
    for (int row = 0; row < rows.rows(); ++row) {
        std::vector<int> columns(1);
        std::vector<double> values(1);
        for (Rows::InnerIterator entry(rows, row); entry; ++entry) {
            columns.push_back(static_cast<int>(entry.col()) + 1);
            values.push_back(entry.value());
        }
        glp_set_mat_row(problem, first + row, static_cast<int>(columns.size()) - 1, columns.data(),
                        values.data());
        glp_set_row_bnds(problem, first + row, type, rhs[row], rhs[row]);
    }
}

/// The program as it stands, GLPK with its own settings and presolve.
bool bareGlpkSaysOptimal(const Program& program)
{
    glp_prob* problem = glp_create_prob();
    glp_add_cols(problem, static_cast<int>(program.variables()));
    for (int i = 0; i < program.variables(); ++i) {
        const bool isPrefixSum = program.upper[i] == 0.0;
        glp_set_col_bnds(problem, i + 1, isPrefixSum ? GLP_UP : GLP_FR, 0.0, 0.0);
    }
    addRows(problem, program.equalities, program.equalityRhs, GLP_FX);
    addRows(problem, program.inequalities, program.inequalityRhs, GLP_UP);
    glp_smcp settings;
    glp_init_smcp(&settings);
    settings.msg_lev = GLP_MSG_OFF;
    settings.presolve = GLP_ON;
    const int code = glp_simplex(problem, &settings);
    const bool isOptimal = code == 0 && glp_get_status(problem) == GLP_OPT;
    glp_delete_prob(problem);
    return isOptimal;
}

}  // namespace

TEST_CASE("bad scaling: in SI units a bare call of GLPK finds motions that do not exist, ours none")
{
    constexpr double gapRow = 1e-10;  // [m s], c = 5188 m/s and g = 1e-6 m
    int falselyFound = 0;
    test::forAllSchedules(3, 2, [&](const Schedule& schedule) {
        Program program = formulate(schedule, Formulation::state).program;
        program.equalityRhs *= gapRow;
        const bool exists = !onePhaseSet(schedule).reason;
        falselyFound += !exists && bareGlpkSaysOptimal(program) ? 1 : 0;
        INFO(describe(schedule));
        const SolverResult result = makeSolver("glpk-simplex")->solve(program);
        CHECK((result.status == SolverStatus::optimal) == exists);
    });
    CHECK(falselyFound > 0);
}

#endif
