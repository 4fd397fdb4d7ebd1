#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "common/condensed.hpp"
#include "glpk/glpk.hpp"
#include "glpk/glpk_problem.hpp"
#include "stopwatch.hpp"

namespace signorini::glpk {

namespace {

// Tolerances: none to set. glp_interior stops at 1e-8 relative, in its own scaling; what that
// means for a row is decided afterwards, by `violation`. Where a program has no interior it gets
// near, then stops with GLP_EINSTAB: its best point is accepted if the multipliers show it to be
// optimal within the tolerance. Equalities that it leaves open by 1e-7 are closed by a projection.

/// Every return code of glp_interior but 0, and of glp_ipt_status after that.
constexpr auto interiorCodes = std::to_array<Meaning>({
    {GLP_EFAIL, SolverStatus::failed, "GLP_EFAIL: problem without rows or columns"},
    {GLP_ENOCVG, SolverStatus::failed, "GLP_ENOCVG: very slow convergence or divergence"},
    {GLP_EITLIM, SolverStatus::limit, "GLP_EITLIM: built-in iteration limit"},
    {GLP_EINSTAB, SolverStatus::failed, "GLP_EINSTAB: numerical instability in a Newton system"},
});
constexpr auto interiorStatuses = std::to_array<Meaning>({
    {GLP_OPT, SolverStatus::optimal, "GLP_OPT: optimal"},
    {GLP_NOFEAS, SolverStatus::failed, "GLP_NOFEAS: infeasible or unbounded, not known which"},
    {GLP_INFEAS, SolverStatus::failed, "GLP_INFEAS: infeasible point, nothing proved"},
    {GLP_UNDEF, SolverStatus::failed, "GLP_UNDEF: undefined solution"},
});

/// How far the objective can be from its minimum, by weak duality, relative to max(1, |objective|).
/// A reduced cost that no bound answers is charged with the size of x. 0 without an objective.
double dualityGap(const Program& program, const SolverResult& result)
{
    if (program.linear.isZero(0.0)) {
        return 0.0;
    }
    const Eigen::VectorXd& x = result.x;
    const Eigen::VectorXd reducedCosts = program.linear -
                                         program.equalities.transpose() * result.equalityDuals -
                                         program.inequalities.transpose() * result.inequalityDuals;
    const double size = std::max(1.0, x.lpNorm<Eigen::Infinity>());
    double gap = 0.0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double bound = reducedCosts[i] > 0.0 ? program.lower[i] : program.upper[i];
        gap += std::abs(reducedCosts[i]) * (std::isfinite(bound) ? std::abs(x[i] - bound) : size);
    }
    const Eigen::VectorXd slack = program.inequalityRhs - program.inequalities * x;
    gap += result.inequalityDuals.cwiseMin(0.0).cwiseProduct(slack).lpNorm<1>();
    gap += size * result.inequalityDuals.cwiseMax(0.0).lpNorm<1>();
    return gap / std::max(1.0, std::abs(program.linear.dot(x)));
}

/// If x misses the tolerance: moves it to the nearest point that meets the equalities, which are
/// independent. The bounds, which the method keeps, may lose what it moves by.
void closeEqualities(const Program& program, double tolerance, Eigen::VectorXd& x)
{
    if (!x.allFinite() || violation(program, x) <= tolerance || program.equalities.rows() == 0) {
        return;
    }
    const Eigen::SparseMatrix<double> normal = program.equalities * program.equalities.transpose();
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(normal);
    const Eigen::VectorXd residual = program.equalities * x - program.equalityRhs;
    x -= program.equalities.transpose() * factors.solve(residual);
}

class Interior final : public Solver {
public:
    using Solver::Solver;

private:
    [[nodiscard]] SolverResult run(const Program& program,
                                   const SolverOptions& options) const override
    {
        SolverResult result;
        Stopwatch watch;
        const Condensed condensed = condense(program, options.tolerance);
        if (condensed.decided) {
            return *condensed.decided;
        }
        Problem problem(options.cancel);
        fill(problem, condensed.program);
        glp_iptcp settings;
        glp_init_iptcp(&settings);
        settings.msg_lev = options.cancel ? GLP_MSG_ALL : GLP_MSG_OFF;
        result.setupSeconds = watch.restart();

        int code = 0;
        const auto solve = [&](glp_prob* p) { code = glp_interior(p, &settings); };
        if (!finishes(problem, solve, watch, result)) {
            return result;
        }

        Meaning meaning =
            code != 0 ? meaningOf(code, interiorCodes, "unknown return code of glp_interior")
                      : meaningOf(glp_ipt_status(problem.get()), interiorStatuses,
                                  "unknown status of glp_ipt_status");
        if (meaning.status == SolverStatus::optimal || code == GLP_EINSTAB) {
            readPoint(problem.get(), condensed.program, glp_ipt_col_prim, glp_ipt_row_dual, result);
            closeEqualities(condensed.program, options.tolerance, result.x);
        }
        if (code == GLP_EINSTAB && result.x.allFinite() &&
            violation(condensed.program, result.x) <= options.tolerance &&
            dualityGap(condensed.program, result) <= options.tolerance) {
            meaning = {code, SolverStatus::optimal,
                       "GLP_EINSTAB, but optimal within the tolerance"};
        }
        meaning.enter(result);
        expand(condensed, program.equalities.rows(), result);
        return result;
    }

    static void expand(const Condensed& condensed, Eigen::Index equalities, SolverResult& result)
    {
        if (result.status != SolverStatus::optimal) {
            result.equalityDuals.resize(0);
            result.inequalityDuals.resize(0);
        }
        if (result.x.size() > 0) {
            result.x = condensed.expand(result.x);
        }
        if (result.status == SolverStatus::optimal) {  // rows left out need no multiplier
            const Eigen::VectorXd duals = result.equalityDuals;
            result.equalityDuals = Eigen::VectorXd::Zero(equalities);
            result.equalityDuals(condensed.rows) = duals;
        }
    }
};

}  // namespace

std::unique_ptr<Solver> makeInterior(const Backend& row)
{
    return std::make_unique<Interior>(row);
}

}  // namespace signorini::glpk
