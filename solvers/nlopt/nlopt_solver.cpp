#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

#include "common/stopwatch.hpp"
#include "nlopt/free_program.hpp"
#include "nlopt/nlopt.hpp"

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

struct Verdict {
    SolverStatus status;
    const char* detail;
};

/// Every result of nlopt_optimize, by name: positive codes are not all successes.
Verdict verdictOf(nlopt_result code)
{
    switch (code) {
        case NLOPT_SUCCESS:
            return {SolverStatus::optimal, "NLOPT_SUCCESS"};
        case NLOPT_FTOL_REACHED:
            return {SolverStatus::optimal, "NLOPT_FTOL_REACHED"};
        case NLOPT_XTOL_REACHED:
            return {SolverStatus::optimal, "NLOPT_XTOL_REACHED"};
        case NLOPT_STOPVAL_REACHED:
            return {SolverStatus::unbounded, "NLOPT_STOPVAL_REACHED: the objective falls for ever"};
        case NLOPT_MAXEVAL_REACHED:
            return {SolverStatus::limit, "NLOPT_MAXEVAL_REACHED"};
        case NLOPT_MAXTIME_REACHED:
            return {SolverStatus::limit, "NLOPT_MAXTIME_REACHED"};
        case NLOPT_FORCED_STOP:
            return {SolverStatus::cancelled, "NLOPT_FORCED_STOP: cancelled"};
        case NLOPT_FAILURE:
            return {SolverStatus::failed, "NLOPT_FAILURE"};
        case NLOPT_INVALID_ARGS:
            return {SolverStatus::failed, "NLOPT_INVALID_ARGS"};
        case NLOPT_OUT_OF_MEMORY:
            return {SolverStatus::failed, "NLOPT_OUT_OF_MEMORY"};
        case NLOPT_ROUNDOFF_LIMITED:
            return {SolverStatus::failed, "NLOPT_ROUNDOFF_LIMITED: short of the tolerance"};
        default:
            return {SolverStatus::failed, "unknown result of NLopt"};
    }
}

/// All variables of the program.
Eigen::VectorXd pointOf(const FreeProgram& freed, const Eigen::VectorXd& u)
{
    return freed.condensed.expand(freed.origin + freed.directions * u);
}

using Input = Eigen::Map<const Eigen::VectorXd>;
using Output = Eigen::Map<Eigen::VectorXd>;

/// What NLopt calls back. An exception must not cross the library, and its text would be lost:
/// it is kept here, the search is stopped, and `rethrow` throws it afterwards.
class Search {
public:
    Search(const FreeProgram& freed, Eigen::VectorXd start, const SolverOptions& options,
           nlopt_opt optimizer)
        : freed_(freed),
          program_(freed.condensed.program),
          start_(std::move(start)),
          options_(options),
          optimizer_(optimizer),
          hasObjective_(hasObjective(program_))
    {
    }

    [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

    void rethrow() const
    {
        if (exception_) {
            std::rethrow_exception(exception_);
        }
    }

    static double objective(unsigned, const double* u, double* gradient, void* self)
    {
        return static_cast<Search*>(self)->guarded(
            [&](Search& search) { return search.evaluateObjective(u, gradient); });
    }

    static void rows(unsigned, double* values, unsigned, const double* u, double* gradient,
                     void* self)
    {
        static_cast<Search*>(self)->guarded([&](Search& search) {
            search.evaluateRows(u, values, gradient);
            return 0.0;
        });
    }

    static double energy(unsigned, const double* u, double* gradient, void* self)
    {
        return static_cast<Search*>(self)->guarded(
            [&](Search& search) { return search.evaluateEnergy(u, gradient); });
    }

private:
    template <typename Evaluate>
    double guarded(Evaluate evaluate)
    {
        try {
            if (isRequested(options_.cancel)) {
                nlopt_force_stop(optimizer_);
            }
            return evaluate(*this);
        } catch (...) {
            exception_ = std::current_exception();
            nlopt_force_stop(optimizer_);
            return std::numeric_limits<double>::infinity();
        }
    }

    [[nodiscard]] Eigen::VectorXd point(const double* u) const
    {
        return freed_.origin + freed_.directions * Input(u, freed_.size());
    }

    void writeGradient(const Eigen::VectorXd& inX, double* gradient) const
    {
        if (gradient != nullptr) {
            Output(gradient, freed_.size()) = freed_.directions.transpose() * inX;
        }
    }

    double evaluateObjective(const double* u, double* gradient)
    {
        ++evaluations_;
        if (!hasObjective_) {
            const Eigen::VectorXd step = Input(u, freed_.size()) - start_;
            if (gradient != nullptr) {
                Output(gradient, freed_.size()) = step;
            }
            return 0.5 * step.squaredNorm();
        }
        const Eigen::VectorXd x = point(u);
        Eigen::VectorXd slope = program_.linear;
        if (program_.quadratic.size() > 0) {
            slope += program_.quadratic.cwiseProduct(x);
        }
        writeGradient(slope, gradient);
        return signorini::objective(program_, x);
    }

    void evaluateRows(const double* u, double* values, double* gradient) const
    {
        Output(values, freed_.rhs.size()) = freed_.rows * Input(u, freed_.size()) - freed_.rhs;
        if (gradient != nullptr) {
            using Dense = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
            Eigen::Map<Dense>(gradient, freed_.rows.rows(), freed_.rows.cols()) = freed_.rows;
        }
    }

    double evaluateEnergy(const double* u, double* gradient) const
    {
        const EnergyEquality& energy = *program_.energy;
        const Eigen::VectorXd x = point(u);
        writeGradient(2.0 / energy.value * energy.weights.cwiseProduct(x), gradient);
        return energy.weights.dot(x.cwiseAbs2()) / energy.value - 1.0;
    }

    const FreeProgram& freed_;
    const Program& program_;
    Eigen::VectorXd start_;
    const SolverOptions& options_;
    nlopt_opt optimizer_;
    bool hasObjective_;
    std::int64_t evaluations_ = 0;
    std::exception_ptr exception_;
};

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
            const Eigen::VectorXd x = pointOf(freed, u);
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
        const Verdict verdict = verdictOf(code);
        result.status = verdict.status;
        result.detail = verdict.detail;
        result.iterations = search.evaluations();
        result.x = pointOf(freed, u);
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
