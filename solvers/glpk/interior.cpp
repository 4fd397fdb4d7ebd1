#include "common/stopwatch.hpp"
#include "glpk/glpk.hpp"
#include "glpk/glpk_problem.hpp"

namespace signorini::glpk {

namespace {

// Tolerances: none to set. glp_interior stops at 1e-8 relative, in its own scaling; what that
// means for a row is decided afterwards, by `violation`.

/// Every return code of glp_interior, and of glp_ipt_status after a 0.
Verdict interiorVerdict(int code, glp_prob* problem)
{
    switch (code) {
        case 0:
            break;
        case GLP_EFAIL:
            return {SolverStatus::failed, "GLP_EFAIL: problem without rows or columns"};
        case GLP_ENOCVG:
            return {SolverStatus::failed, "GLP_ENOCVG: very slow convergence or divergence"};
        case GLP_EITLIM:
            return {SolverStatus::limit, "GLP_EITLIM: built-in iteration limit"};
        case GLP_EINSTAB:
            return {SolverStatus::failed, "GLP_EINSTAB: numerical instability in a Newton system"};
        default:
            return {SolverStatus::failed, "unknown return code of glp_interior"};
    }
    switch (glp_ipt_status(problem)) {
        case GLP_OPT:
            return {SolverStatus::optimal, "GLP_OPT: optimal"};
        case GLP_NOFEAS:
            return {SolverStatus::failed, "GLP_NOFEAS: infeasible or unbounded, not known which"};
        case GLP_INFEAS:
            return {SolverStatus::failed, "GLP_INFEAS: infeasible point, nothing proved"};
        case GLP_UNDEF:
            return {SolverStatus::failed, "GLP_UNDEF: undefined solution"};
        default:
            return {SolverStatus::failed, "unknown status of glp_ipt_status"};
    }
}

class Interior final : public Solver {
public:
    [[nodiscard]] std::string_view name() const override { return "glpk-interior"; }

    [[nodiscard]] Capabilities capabilities() const override { return {.duals = true}; }

private:
    [[nodiscard]] SolverResult run(const Program& program, const SolverOptions&) const override
    {
        SolverResult result;
        Stopwatch watch;
        const Problem problem = build(program);
        glp_iptcp settings;
        glp_init_iptcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        result.setupSeconds = watch.restart();

        const int code = glp_interior(problem.get(), &settings);
        result.solveSeconds = watch.seconds();

        const Verdict verdict = interiorVerdict(code, problem.get());
        result.status = verdict.status;
        result.detail = verdict.detail;
        if (result.status == SolverStatus::optimal) {
            readPoint(problem.get(), program, glp_ipt_col_prim, glp_ipt_row_dual, result);
        }
        return result;
    }
};

}  // namespace

std::unique_ptr<Solver> makeInterior()
{
    return std::make_unique<Interior>();
}

}  // namespace signorini::glpk
