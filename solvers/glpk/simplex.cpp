#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dual.hpp"
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

int clampToInt(double value)
{
    return static_cast<int>(std::min(value, static_cast<double>(std::numeric_limits<int>::max())));
}

/// Every return code of glp_simplex and glp_exact but 0, and of glp_get_status after that.
constexpr auto simplexCodes = std::to_array<Meaning>({
    {GLP_ENOPFS, SolverStatus::infeasible, "GLP_ENOPFS: presolver found no primal feasible point"},
    {GLP_ENODFS, SolverStatus::unbounded, "GLP_ENODFS: presolver found no dual feasible point"},
    {GLP_EITLIM, SolverStatus::limit, "GLP_EITLIM: iteration limit"},
    {GLP_ETMLIM, SolverStatus::limit, "GLP_ETMLIM: time limit"},
    {GLP_EOBJLL, SolverStatus::limit, "GLP_EOBJLL/UL: objective limit"},
    {GLP_EOBJUL, SolverStatus::limit, "GLP_EOBJLL/UL: objective limit"},
    {GLP_EBADB, SolverStatus::failed, "GLP_EBADB: invalid initial basis"},
    {GLP_ESING, SolverStatus::failed, "GLP_ESING: singular basis"},
    {GLP_ECOND, SolverStatus::failed, "GLP_ECOND: ill-conditioned basis"},
    {GLP_EBOUND, SolverStatus::failed, "GLP_EBOUND: incorrect bounds"},
    {GLP_EFAIL, SolverStatus::failed, "GLP_EFAIL: solver failure"},
});
constexpr auto simplexStatuses = std::to_array<Meaning>({
    {GLP_OPT, SolverStatus::optimal, "GLP_OPT: optimal"},
    {GLP_NOFEAS, SolverStatus::infeasible, "GLP_NOFEAS: no feasible point"},
    {GLP_UNBND, SolverStatus::unbounded, "GLP_UNBND: unbounded"},
    {GLP_FEAS, SolverStatus::failed, "GLP_FEAS: feasible, not proved optimal"},
    {GLP_INFEAS, SolverStatus::failed, "GLP_INFEAS: infeasible point, nothing proved"},
    {GLP_UNDEF, SolverStatus::failed, "GLP_UNDEF: undefined solution"},
});

/// Within the limits, and silent unless somebody may cancel.
glp_smcp quietSettings(const SolverOptions& options)
{
    glp_smcp settings;
    glp_init_smcp(&settings);
    settings.msg_lev = options.cancel ? GLP_MSG_ON : GLP_MSG_OFF;
    if (options.iterationLimit > 0) {
        settings.it_lim = clampToInt(static_cast<double>(options.iterationLimit));
    }
    if (std::isfinite(options.timeLimit)) {
        settings.tm_lim = clampToInt(std::ceil(1e3 * options.timeLimit));
    }
    return settings;
}

/// Meaning, iterations and, if optimal, point and multipliers.
void readSimplex(int code, glp_prob* problem, const Program& program, SolverResult& result)
{
    simplexMeaning(code, problem).enter(result);
    result.iterations = glp_get_it_cnt(problem);
    if (result.status == SolverStatus::optimal) {
        readPoint(problem, program, glp_get_col_prim, glp_get_row_dual, result);
    }
}

/// Fills a problem, lets `solve(problem, settings, watch)` work on it, and reads its answer.
template <typename Set, typename Solve>
SolverResult solved(const Program& program, const SolverOptions& options, Set set, Solve solve)
{
    SolverResult result;
    Stopwatch watch;
    Problem problem(options.cancel);
    fill(problem, program);
    glp_smcp settings = quietSettings(options);
    set(settings, problem.get());
    result.setupSeconds = watch.restart();

    int code = 0;
    const auto run = [&](glp_prob* p) { code = solve(p, settings, watch); };
    if (finishes(problem, run, watch, result)) {
        readSimplex(code, problem.get(), program, result);
    }
    return result;
}

/// GLPK's basis has a row for each row of a program: one with many more rows than unknowns is
/// solved as its dual, in a tenth of the time.
bool isTall(const Program& program)
{
    const Eigen::Index rows = program.equalities.rows() + program.inequalities.rows();
    return rows > std::max<Eigen::Index>(fewRows, 4 * program.variables());
}

class Simplex final : public Solver {
public:
    using Solver::Solver;

private:
    [[nodiscard]] SolverResult run(const Program& program,
                                   const SolverOptions& options) const override
    {
        if (isTall(program)) {
            SolverResult turned = ofProgram(program, solve(dualOf(program), options));
            if (turned.status != SolverStatus::failed) {
                return turned;
            }
        }
        return solve(program, options);
    }

    [[nodiscard]] static SolverResult solve(const Program& program, const SolverOptions& options)
    {
        const auto set = [&options](glp_smcp& settings, glp_prob* problem) {
            settings.out_frq = pivotsOfALook;
            settings.presolve = glp_get_num_rows(problem) > fewRows ? GLP_ON : GLP_OFF;
            settings.tol_bnd = std::min(defaultTolerance, toleranceShare * options.tolerance);
            settings.tol_dj = settings.tol_bnd;
            if (options.iterationLimit == 0) {
                settings.it_lim = mostPivots(problem);
            }
        };
        return solved(program, options, set,
                      [](glp_prob* problem, const glp_smcp& settings, const Stopwatch&) {
                          return glp_simplex(problem, &settings);
                      });
    }
};

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
        return solved(
            program, options, [](glp_smcp&, glp_prob*) {}, solveExactly);
    }
};

}  // namespace

Meaning simplexMeaning(int code, glp_prob* problem)
{
    return code != 0 ? meaningOf(code, simplexCodes, "unknown return code of the simplex method")
                     : meaningOf(glp_get_status(problem), simplexStatuses,
                                 "unknown status of glp_get_status");
}

std::unique_ptr<Solver> makeSimplex(const Backend& row)
{
    return std::make_unique<Simplex>(row);
}

std::unique_ptr<Solver> makeExact(const Backend& row)
{
    return std::make_unique<Exact>(row);
}

}  // namespace signorini::glpk
