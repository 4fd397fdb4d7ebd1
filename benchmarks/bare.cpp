#include "bare.hpp"

#include <cmath>
#include <string>

#include "signorini/config.hpp"

#if SIGNORINI_HAS_GLPK
#include "glpk/glpk_problem.hpp"
#endif
#if SIGNORINI_HAS_IPOPT
#include <IpIpoptApplication.hpp>

#include "ipopt/program_nlp.hpp"
#endif
#if SIGNORINI_HAS_CLP
#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>

#include "clp_model.hpp"
#endif

namespace signorini::bench {

namespace {

#if SIGNORINI_HAS_GLPK
BareAnswer solveByGlpk(const Program& program)
{
    glpk::Problem problem;
    glpk::fill(problem, program);
    glp_smcp settings;
    glp_init_smcp(&settings);
    settings.msg_lev = GLP_MSG_OFF;
    settings.presolve = GLP_ON;
    const int code = glp_simplex(problem.get(), &settings);
    BareAnswer answer{glpk::simplexMeaning(code, problem.get()).status,
                      Eigen::VectorXd(program.variables())};
    for (Eigen::Index i = 0; i < answer.x.size(); ++i) {
        answer.x[i] = glp_get_col_prim(problem.get(), static_cast<int>(i) + 1);
    }
    return answer;
}
#endif

#if SIGNORINI_HAS_CLP
BareAnswer solveByClp(const Program& program, ClpSolve::SolveType type)
{
    ClpSimplex model;
    loadClp(program, model);
    ClpSolve how;
    how.setSolveType(type);
    model.initialSolve(how);
    return {statusOfClp(model.status()),
            Eigen::Map<const Eigen::VectorXd>(model.getColSolution(), program.variables())};
}
#endif

#if SIGNORINI_HAS_IPOPT
BareAnswer solveByIpopt(const Program& program)
{
    const Ipopt::SmartPtr<ipopt::ProgramNlp> nlp = new ipopt::ProgramNlp(
        program, Eigen::VectorXd::Zero(program.variables()), [] { return true; });
    const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
    application->Options()->SetIntegerValue("print_level", 0);
    application->Options()->SetStringValue("sb", "yes");
    application->Options()->SetIntegerValue("max_iter", 200);  // it needs 10 to 30, or no end
    // Redundant rows stop Ipopt at once otherwise: too few degrees of freedom.
    application->Options()->SetStringValue("fixed_variable_treatment", "make_parameter");
    application->Options()->SetStringValue("dependency_detector", "mumps");
    const auto opening = application->Initialize(std::string());
    const auto verdict = opening == Ipopt::Solve_Succeeded
                             ? application->OptimizeTNLP(Ipopt::GetRawPtr(nlp))
                             : opening;
    BareAnswer answer;
    answer.x = nlp->point();
    answer.status =
        verdict == Ipopt::Solve_Succeeded || verdict == Ipopt::Solved_To_Acceptable_Level
            ? SolverStatus::optimal
        : verdict == Ipopt::Infeasible_Problem_Detected ? SolverStatus::infeasible
                                                        : SolverStatus::failed;
    return answer;
}
#endif

}  // namespace

const std::vector<std::string_view>& bareLibraries()
{
    static const std::vector<std::string_view> names{"glpk-simplex", "clp-simplex", "clp-barrier",
                                                     "ipopt"};
    return names;
}

BareAnswer solveBare([[maybe_unused]] std::string_view library,
                     [[maybe_unused]] const Program& program)
{
#if SIGNORINI_HAS_GLPK
    if (library == "glpk-simplex") {
        return solveByGlpk(program);
    }
#endif
#if SIGNORINI_HAS_CLP
    if (library == "clp-simplex") {
        return solveByClp(program, ClpSolve::automatic);
    }
    if (library == "clp-barrier") {
        return solveByClp(program, ClpSolve::useBarrierNoCross);
    }
#endif
#if SIGNORINI_HAS_IPOPT
    if (library == "ipopt") {
        return solveByIpopt(program);
    }
#endif
    throw BackendUnavailable("this build does not contain " + std::string(library));
}

}  // namespace signorini::bench
