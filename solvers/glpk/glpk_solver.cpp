#include "glpk/glpk_solver.hpp"

#include <glpk.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

namespace signorini::glpk {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct DeleteProblem {
    void operator()(glp_prob* problem) const { glp_delete_prob(problem); }
};
using Problem = std::unique_ptr<glp_prob, DeleteProblem>;

void setBounds(glp_prob* problem, int column, double lower, double upper)
{
    const bool hasLower = std::isfinite(lower);
    const bool hasUpper = std::isfinite(upper);
    const int type = hasLower && hasUpper ? (lower == upper ? GLP_FX : GLP_DB)
                     : hasLower           ? GLP_LO
                     : hasUpper           ? GLP_UP
                                          : GLP_FR;
    glp_set_col_bnds(problem, column, type, hasLower ? lower : 0.0, hasUpper ? upper : 0.0);
}

/// GLPK's sparse rows count from 1; entry 0 of the arrays is unused.
void addRows(glp_prob* problem, const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows,
             const Eigen::VectorXd& rhs, int type)
{
    if (rows.rows() == 0) {
        return;
    }
    const int first = glp_add_rows(problem, static_cast<int>(rows.rows()));
    std::vector<int> columns(1);
    std::vector<double> values(1);
    for (int row = 0; row < static_cast<int>(rows.rows()); ++row) {
        columns.resize(1);
        values.resize(1);
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(rows, row); entry;
             ++entry) {
            if (entry.value() != 0.0) {
                columns.push_back(static_cast<int>(entry.col()) + 1);
                values.push_back(entry.value());
            }
        }
        glp_set_mat_row(problem, first + row, static_cast<int>(columns.size()) - 1, columns.data(),
                        values.data());
        glp_set_row_bnds(problem, first + row, type, rhs[row], rhs[row]);
    }
}

Problem build(const Program& program)
{
    Problem problem(glp_create_prob());
    glp_set_obj_dir(problem.get(), GLP_MIN);
    const int variables = static_cast<int>(program.variables());
    glp_add_cols(problem.get(), variables);
    for (int i = 0; i < variables; ++i) {
        setBounds(problem.get(), i + 1, program.lower[i], program.upper[i]);
        glp_set_obj_coef(problem.get(), i + 1, program.linear[i]);
    }
    addRows(problem.get(), program.equalities, program.equalityRhs, GLP_FX);
    addRows(problem.get(), program.inequalities, program.inequalityRhs, GLP_UP);
    return problem;
}

struct Verdict {
    SolverStatus status;
    const char* detail;
};

/// Every return code of glp_simplex, and of glp_get_status after a return of 0.
Verdict verdictOf(int code, glp_prob* problem)
{
    switch (code) {
        case 0:
            break;
        case GLP_ENOPFS:
            return {SolverStatus::infeasible,
                    "GLP_ENOPFS: presolver found no primal feasible point"};
        case GLP_ENODFS:
            return {SolverStatus::unbounded, "GLP_ENODFS: presolver found no dual feasible point"};
        case GLP_EITLIM:
            return {SolverStatus::limit, "GLP_EITLIM: iteration limit"};
        case GLP_ETMLIM:
            return {SolverStatus::limit, "GLP_ETMLIM: time limit"};
        case GLP_EOBJLL:
        case GLP_EOBJUL:
            return {SolverStatus::limit, "GLP_EOBJLL/UL: objective limit"};
        case GLP_EBADB:
            return {SolverStatus::failed, "GLP_EBADB: invalid initial basis"};
        case GLP_ESING:
            return {SolverStatus::failed, "GLP_ESING: singular basis"};
        case GLP_ECOND:
            return {SolverStatus::failed, "GLP_ECOND: ill-conditioned basis"};
        case GLP_EBOUND:
            return {SolverStatus::failed, "GLP_EBOUND: incorrect bounds"};
        case GLP_EFAIL:
            return {SolverStatus::failed, "GLP_EFAIL: solver failure"};
        default:
            return {SolverStatus::failed, "unknown return code of glp_simplex"};
    }
    switch (glp_get_status(problem)) {
        case GLP_OPT:
            return {SolverStatus::optimal, "GLP_OPT: optimal"};
        case GLP_NOFEAS:
            return {SolverStatus::infeasible, "GLP_NOFEAS: no feasible point"};
        case GLP_UNBND:
            return {SolverStatus::unbounded, "GLP_UNBND: unbounded"};
        case GLP_FEAS:
            return {SolverStatus::failed, "GLP_FEAS: feasible, not proved optimal"};
        case GLP_INFEAS:
            return {SolverStatus::failed, "GLP_INFEAS: infeasible point, nothing proved"};
        case GLP_UNDEF:
            return {SolverStatus::failed, "GLP_UNDEF: undefined solution"};
        default:
            return {SolverStatus::failed, "unknown status of glp_get_status"};
    }
}

int clampToInt(double value)
{
    return static_cast<int>(std::min(value, static_cast<double>(std::numeric_limits<int>::max())));
}

class Simplex final : public Solver {
public:
    [[nodiscard]] std::string_view name() const override { return "glpk-simplex"; }

    [[nodiscard]] Capabilities capabilities() const override
    {
        return {.detectsInfeasibility = true, .iterationLimit = true, .timeLimit = true};
    }

private:
    [[nodiscard]] SolverResult run(const Program& program,
                                   const SolverOptions& options) const override
    {
        SolverResult result;
        glp_term_out(GLP_OFF);  // per thread: GLPK keeps an environment in each
        const auto start = Clock::now();
        const Problem problem = build(program);

        glp_smcp settings;
        glp_init_smcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        settings.presolve = GLP_ON;
        // GLPK's own default is 1e-7; it stops when rows hold to a tenth of what is asked.
        settings.tol_bnd = std::min(1e-7, 0.1 * options.tolerance);
        settings.tol_dj = settings.tol_bnd;
        if (options.iterationLimit > 0) {
            settings.it_lim = clampToInt(static_cast<double>(options.iterationLimit));
        }
        if (std::isfinite(options.timeLimit)) {
            settings.tm_lim = clampToInt(std::ceil(1e3 * options.timeLimit));
        }
        result.setupSeconds = secondsSince(start);

        const auto solving = Clock::now();
        const int code = glp_simplex(problem.get(), &settings);
        result.solveSeconds = secondsSince(solving);

        const Verdict verdict = verdictOf(code, problem.get());
        result.status = verdict.status;
        result.detail = verdict.detail;
        result.iterations = glp_get_it_cnt(problem.get());
        if (result.status == SolverStatus::optimal) {
            result.x.resize(program.variables());
            for (int i = 0; i < static_cast<int>(program.variables()); ++i) {
                result.x[i] = glp_get_col_prim(problem.get(), i + 1);
            }
        }
        return result;
    }
};

}  // namespace

std::string version()
{
    return glp_version();
}

std::unique_ptr<Solver> makeSimplex()
{
    return std::make_unique<Simplex>();
}

}  // namespace signorini::glpk
