#include <algorithm>

#include "glpk/glpk.hpp"
#include "glpk/glpk_problem.hpp"
#include "stopwatch.hpp"

namespace signorini::glpk {

namespace {

// No tolerances: what decides is compared between rationals. GLPK replaces a coefficient that is
// not a whole number by a simple fraction within 1e-9 of it; the point is rounded to doubles at the
// end.

/// A basis for the rational method to start from, found in doubles; without it rational pivots are
/// spent on the way (factor 20 to 1000). Whether the basis is right does not matter.
int findBasis(glp_prob* problem, const glp_smcp& settings)
{
    glp_adv_basis(problem, 0);
    const int code = glp_simplex(problem, &settings);
    if (code != 0) {
        glp_std_basis(problem);
    }
    return code;
}

/// Both methods; the second gets what the first has left of the limits.
int solveExactly(glp_prob* problem, glp_smcp settings, const Stopwatch& watch)
{
    const int code = findBasis(problem, settings);
    const int milliseconds = static_cast<int>(1e3 * std::min(watch.seconds(), 1e6));
    settings.tm_lim = std::max(0, settings.tm_lim - milliseconds);
    settings.it_lim = std::max(0, settings.it_lim - glp_get_it_cnt(problem));
    return code == GLP_EITLIM || code == GLP_ETMLIM ? code : glp_exact(problem, &settings);
}

class Exact final : public Solver {
public:
    using Solver::Solver;

private:
    [[nodiscard]] SolverResult run(const Program& program,
                                   const SolverOptions& options) const override
    {
        SolverResult result;
        Stopwatch watch;
        Problem problem(options.cancel);
        fill(problem, program);
        glp_smcp settings = quietSettings(options);
        result.setupSeconds = watch.restart();

        int code = 0;
        const auto solve = [&](glp_prob* p) { code = solveExactly(p, settings, watch); };
        if (finishes(problem, solve, watch, result)) {
            readSimplex(code, problem.get(), program, result);
        }
        return result;
    }
};

}  // namespace

std::unique_ptr<Solver> makeExact(const Backend& row)
{
    return std::make_unique<Exact>(row);
}

}  // namespace signorini::glpk
