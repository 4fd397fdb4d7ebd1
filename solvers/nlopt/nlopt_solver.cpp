#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/meaning.hpp"
#include "nlopt/nlopt.hpp"
#include "nlopt/search.hpp"
#include "stopwatch.hpp"

namespace signorini::nlopt {

namespace {

/// A method of NLopt and how it is used.
struct Method {
    nlopt_algorithm algorithm;
    std::int64_t maxEvaluations;  ///< where no iteration limit is given: it always ends
    bool hasInner = false;        ///< CCSAQ for its subproblems: L-BFGS gives up too often
};

/// Objective and point have settled when a step changes them by less. Both are near what doubles
/// can show, because NLopt stops at the first step that is small, not at the minimum.
constexpr double objectiveTolerance = 1e-14;
constexpr double pointTolerance = 1e-10;
/// Rows are asked to hold to this share of the tolerance: they are summed in another order later.
constexpr double violationShare = 0.1;

struct DeleteOptimizer {
    void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};
using Optimizer = std::unique_ptr<nlopt_opt_s, DeleteOptimizer>;

/// NLopt answers a refused setting with a negative code, and goes on.
void require(nlopt_result code)
{
    if (code < 0) {
        throw std::logic_error(
            fmt::format("NLopt does not accept a setting: {}", nlopt_result_to_string(code)));
    }
}

/// Every result of nlopt_optimize, by name: positive codes are not all successes.
constexpr auto results = std::to_array<Meaning>({
    {NLOPT_SUCCESS, SolverStatus::optimal, "NLOPT_SUCCESS"},
    {NLOPT_FTOL_REACHED, SolverStatus::optimal, "NLOPT_FTOL_REACHED"},
    {NLOPT_XTOL_REACHED, SolverStatus::optimal, "NLOPT_XTOL_REACHED"},
    {NLOPT_STOPVAL_REACHED, SolverStatus::unbounded,
     "NLOPT_STOPVAL_REACHED: the objective falls for ever"},
    {NLOPT_MAXEVAL_REACHED, SolverStatus::limit, "NLOPT_MAXEVAL_REACHED"},
    {NLOPT_MAXTIME_REACHED, SolverStatus::limit, "NLOPT_MAXTIME_REACHED"},
    {NLOPT_FORCED_STOP, SolverStatus::cancelled, "NLOPT_FORCED_STOP: cancelled"},
    {NLOPT_FAILURE, SolverStatus::failed, "NLOPT_FAILURE"},
    {NLOPT_INVALID_ARGS, SolverStatus::failed, "NLOPT_INVALID_ARGS"},
    {NLOPT_OUT_OF_MEMORY, SolverStatus::failed, "NLOPT_OUT_OF_MEMORY"},
    {NLOPT_ROUNDOFF_LIMITED, SolverStatus::failed,
     "NLOPT_ROUNDOFF_LIMITED: short of the tolerance"},
});

void setStops(nlopt_opt optimizer, const Method& method, const SolverOptions& options,
              double secondsSpent)
{
    require(nlopt_set_ftol_rel(optimizer, objectiveTolerance));
    require(nlopt_set_xtol_rel(optimizer, pointTolerance));
    require(nlopt_set_xtol_abs1(optimizer, pointTolerance));
    const std::int64_t most =
        options.iterationLimit > 0 ? options.iterationLimit : method.maxEvaluations;
    require(nlopt_set_maxeval(optimizer, static_cast<int>(std::min<std::int64_t>(
                                             most, std::numeric_limits<int>::max()))));
    if (std::isfinite(options.timeLimit)) {
        require(nlopt_set_maxtime(optimizer, std::max(1e-9, options.timeLimit - secondsSpent)));
    }
}

class NloptSolver final : public Solver {
public:
    NloptSolver(const Backend& row, const Method& method) : Solver(row), method_(method) {}

private:
    [[nodiscard]] SolverResult run(const Program& program,
                                   const SolverOptions& options) const override
    {
        Stopwatch watch;
        const FreeProgram freed = withoutEqualities(program, options.tolerance, row().mostUnknowns);
        if (freed.decided) {
            return *freed.decided;
        }
        Eigen::VectorXd u = startOf(freed, options);
        if (!hasObjective(program)) {
            const Eigen::VectorXd x = freed.point(u);
            if (violation(program, x) <= violationShare * options.tolerance) {
                return atStart(x);
            }
        }
        const Optimizer optimizer(
            nlopt_create(method_.algorithm, static_cast<unsigned>(freed.size())));
        if (!optimizer) {
            throw std::bad_alloc();
        }
        Search search(freed, u, options, optimizer.get());
        pose(freed, options, optimizer.get(), search);
        setStops(optimizer.get(), method_, options, watch.seconds());

        SolverResult result;
        result.setupSeconds = watch.restart();
        double value = 0.0;
        const nlopt_result code = nlopt_optimize(optimizer.get(), u.data(), &value);
        search.rethrow();
        result.solveSeconds = watch.seconds();
        meaningOf(code, results, "unknown result of NLopt").enter(result);
        result.iterations = search.evaluations();
        result.x = freed.point(u);
        return result;
    }

    static Eigen::VectorXd startOf(const FreeProgram& freed, const SolverOptions& options)
    {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(freed.size());
        if (options.start) {
            u = freed.condensed.restrict(*options.start)(freed.outside);
        }
        return u.cwiseMax(freed.lower).cwiseMin(freed.upper);
    }

    static SolverResult atStart(Eigen::VectorXd x)
    {
        SolverResult result;
        result.status = SolverStatus::optimal;
        result.detail = "the start meets all rows";
        result.x = std::move(x);
        return result;
    }

    void pose(const FreeProgram& freed, const SolverOptions& options, nlopt_opt optimizer,
              Search& search) const
    {
        require(nlopt_set_lower_bounds(optimizer, freed.lower.data()));
        require(nlopt_set_upper_bounds(optimizer, freed.upper.data()));
        require(nlopt_set_min_objective(optimizer, Search::objective, &search));
        const double allowed = violationShare * options.tolerance;
        if (freed.rhs.size() > 0) {
            const Eigen::VectorXd each = Eigen::VectorXd::Constant(freed.rhs.size(), allowed);
            require(nlopt_add_inequality_mconstraint(optimizer, static_cast<unsigned>(each.size()),
                                                     Search::rows, &search, each.data()));
        }
        if (freed.condensed.program.energy) {
            require(nlopt_add_equality_constraint(optimizer, Search::energy, &search, allowed));
        }
        if (method_.hasInner) {
            const Optimizer inner(
                nlopt_create(NLOPT_LD_CCSAQ, static_cast<unsigned>(freed.size())));
            require(nlopt_set_ftol_rel(inner.get(), objectiveTolerance));
            require(nlopt_set_xtol_rel(inner.get(), pointTolerance));
            require(nlopt_set_local_optimizer(optimizer, inner.get()));
        }
    }

    Method method_;
};

}  // namespace

std::string version()
{
    int major = 0;
    int minor = 0;
    int bugfix = 0;
    nlopt_version(&major, &minor, &bugfix);
    return fmt::format("{}.{}.{}", major, minor, bugfix);
}

std::unique_ptr<Solver> makeSlsqp(const Backend& row)
{
    return std::make_unique<NloptSolver>(row, Method{NLOPT_LD_SLSQP, 2'000});
}

std::unique_ptr<Solver> makeAuglag(const Backend& row)
{
    return std::make_unique<NloptSolver>(row, Method{NLOPT_AUGLAG, 20'000, true});
}

std::unique_ptr<Solver> makeCobyla(const Backend& row)
{
    return std::make_unique<NloptSolver>(row, Method{NLOPT_LN_COBYLA, 200'000});
}

}  // namespace signorini::nlopt
