#include <algorithm>

#include "glpk/glpk.hpp"
#include "glpk/glpk_problem.hpp"
#include "stopwatch.hpp"

namespace signorini::glpk {

namespace {

/// GLPK's own value of tol_bnd and tol_dj: looser asks for nothing, tighter costs pivots.
constexpr double defaultTolerance = 1e-7;
/// GLPK measures on rows it has scaled itself, so it is asked for a tenth of what rows must hold.
constexpr double toleranceShare = 0.1;

/// With few rows the simplex method is done before the presolver has looked at them: a bounded
/// unknown that stands in one row only costs the presolver that row's length, all of them its
/// square.
constexpr int fewRows = 64;

/// Pivots between two looks at `cancel`.
constexpr int pivotsOfALook = 50;

/// Pivots after which it goes in circles, if nobody said how many are allowed: it takes about as
/// many as there are rows and columns, but where coefficients differ by 10^6 rounding can lead it
/// back.
int mostPivots(glp_prob* problem)
{
    const double size = glp_get_num_rows(problem) + static_cast<double>(glp_get_num_cols(problem));
    return static_cast<int>(std::min(1e4 + 100.0 * size, 2e9));
}

class Simplex final : public Solver {
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
        settings.out_frq = pivotsOfALook;
        settings.presolve = glp_get_num_rows(problem.get()) > fewRows ? GLP_ON : GLP_OFF;
        settings.tol_bnd = std::min(defaultTolerance, toleranceShare * options.tolerance);
        settings.tol_dj = settings.tol_bnd;
        if (options.iterationLimit == 0) {
            settings.it_lim = mostPivots(problem.get());
        }
        result.setupSeconds = watch.restart();

        int code = 0;
        const auto solve = [&code, &settings](glp_prob* p) { code = glp_simplex(p, &settings); };
        if (finishes(problem, solve, watch, result)) {
            readSimplex(code, problem.get(), program, result);
        }
        return result;
    }
};

}  // namespace

std::unique_ptr<Solver> makeSimplex(const Backend& row)
{
    return std::make_unique<Simplex>(row);
}

}  // namespace signorini::glpk
