#include "clp.hpp"

#if SIGNORINI_HAS_CLP
#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>
#include <algorithm>
#include <string>

#include "clp_model.hpp"
#include "stopwatch.hpp"
#endif

namespace signorini::bench {

const std::vector<std::string_view>& clpMethods()
{
    static const std::vector<std::string_view> methods{"clp-simplex", "clp-barrier", "clp-primal"};
    return methods;
}

#if SIGNORINI_HAS_CLP

namespace {

/// CLP's own tolerance; looser asks for nothing.
constexpr double defaultTolerance = 1e-7;
/// As for the library's own back ends: rows are summed in another order later.
constexpr double toleranceShare = 0.1;

class Clp final : public Solver {
public:
    Clp(std::string_view method, ClpSolve::SolveType type)
        : Solver({.name = method,
                  .can = {.quadraticObjective = type != ClpSolve::automatic,
                          .detectsInfeasibility = true}}),
          type_(type)
    {
    }

private:
    [[nodiscard]] SolverResult run(const Program& program,
                                   const SolverOptions& options) const override
    {
        SolverResult result;
        Stopwatch watch;
        ClpSimplex model;
        loadClp(program, model);
        const double tolerance = std::min(defaultTolerance, toleranceShare * options.tolerance);
        model.setPrimalTolerance(tolerance);
        model.setDualTolerance(tolerance);
        result.setupSeconds = watch.restart();
        ClpSolve how;
        how.setSolveType(type_);
        model.initialSolve(how);
        result.solveSeconds = watch.seconds();
        result.iterations = model.numberIterations();
        result.status = statusOfClp(model.status());
        result.detail = "CLP status " + std::to_string(model.status());
        result.x = Eigen::Map<const Eigen::VectorXd>(model.getColSolution(), program.variables());
        return result;
    }

    ClpSolve::SolveType type_;
};

}  // namespace

void loadClp(const Program& program, ClpSimplex& model)
{
    model.setLogLevel(0);
    std::vector<int> starts{0};
    std::vector<int> columns;
    std::vector<double> values;
    std::vector<double> low;
    std::vector<double> high;
    const auto add = [&](const auto& rows, const Eigen::VectorXd& rhs, bool isEquality) {
        for (int row = 0; row < rows.rows(); ++row) {
            for (typename std::decay_t<decltype(rows)>::InnerIterator entry(rows, row); entry;
                 ++entry) {
                columns.push_back(static_cast<int>(entry.col()));
                values.push_back(entry.value());
            }
            starts.push_back(static_cast<int>(columns.size()));
            low.push_back(isEquality ? rhs[row] : -COIN_DBL_MAX);
            high.push_back(rhs[row]);
        }
    };
    add(program.equalities, program.equalityRhs, true);
    add(program.inequalities, program.inequalityRhs, false);
    const auto variables = static_cast<int>(program.variables());
    const CoinPackedMatrix matrix(false, variables, static_cast<int>(low.size()),
                                  static_cast<int>(values.size()), values.data(), columns.data(),
                                  starts.data(), nullptr);
    model.loadProblem(matrix, program.lower.data(), program.upper.data(), program.linear.data(),
                      low.data(), high.data());
    if (program.quadratic.size() > 0) {
        std::vector<int> diagonal(static_cast<std::size_t>(variables) + 1);
        for (int i = 0; i <= variables; ++i) {
            diagonal[static_cast<std::size_t>(i)] = i;
        }
        model.loadQuadraticObjective(variables, diagonal.data(), diagonal.data(),
                                     program.quadratic.data());
    }
}

SolverStatus statusOfClp(int status)
{
    switch (status) {
        case 0:
            return SolverStatus::optimal;
        case 1:
            return SolverStatus::infeasible;
        case 2:
            return SolverStatus::unbounded;
        case 3:
            return SolverStatus::limit;
        default:
            return SolverStatus::failed;
    }
}

std::string_view clpVersion()
{
    return CLP_VERSION;
}

std::unique_ptr<Solver> makeClp(std::string_view method)
{
    if (method == "clp-simplex") {
        return std::make_unique<Clp>(clpMethods()[0], ClpSolve::automatic);
    }
    if (method == "clp-barrier") {
        return std::make_unique<Clp>(clpMethods()[1], ClpSolve::useBarrierNoCross);
    }
    if (method == "clp-primal") {
        return std::make_unique<Clp>(clpMethods()[2], ClpSolve::usePrimal);
    }
    throw std::invalid_argument("CLP has no method of that name");
}

#else

std::string_view clpVersion()
{
    return "absent";
}

std::unique_ptr<Solver> makeClp(std::string_view)
{
    throw BackendUnavailable("this build has no CLP: install coinor-libclp-dev");
}

#endif

}  // namespace signorini::bench
