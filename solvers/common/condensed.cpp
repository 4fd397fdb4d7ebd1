#include "common/condensed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>

#include "common/independent_rows.hpp"

namespace signorini {

namespace {

using Index = Eigen::Index;
using Triplet = Eigen::Triplet<double>;

/// A basis whose own residual is larger than this share of the tolerance decides nothing.
constexpr double residualShare = 0.1;

SparseRows select(const SparseRows& matrix, const std::vector<Index>& rows,
                  const std::vector<Index>& columns)
{
    std::vector<int> place(static_cast<std::size_t>(matrix.cols()), -1);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        place[static_cast<std::size_t>(columns[k])] = static_cast<int>(k);
    }
    std::vector<Triplet> entries;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (SparseRows::InnerIterator entry(matrix, rows[k]); entry; ++entry) {
            const int column = place[static_cast<std::size_t>(entry.col())];
            if (column >= 0 && entry.value() != 0.0) {
                entries.emplace_back(static_cast<int>(k), column, entry.value());
            }
        }
    }
    SparseRows selected(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
    selected.setFromTriplets(entries.begin(), entries.end());
    return selected;
}

std::vector<Index> all(Index count)
{
    std::vector<Index> indices(static_cast<std::size_t>(count));
    for (Index i = 0; i < count; ++i) {
        indices[static_cast<std::size_t>(i)] = i;
    }
    return indices;
}

/// Splits off the variables with lower = upper.
void removeFixed(const Program& program, Condensed& result)
{
    result.fixed = Eigen::VectorXd::Zero(program.variables());
    for (Index i = 0; i < program.variables(); ++i) {
        if (program.lower[i] == program.upper[i]) {
            result.fixed[i] = program.lower[i];
        } else {
            result.variables.push_back(i);
        }
    }
    const std::vector<Index>& left = result.variables;
    Program& condensed = result.program;
    condensed.equalities = select(program.equalities, all(program.equalities.rows()), left);
    condensed.equalityRhs = program.equalityRhs - program.equalities * result.fixed;
    condensed.inequalities = select(program.inequalities, all(program.inequalities.rows()), left);
    condensed.inequalityRhs = program.inequalityRhs - program.inequalities * result.fixed;
    condensed.lower = program.lower(left);
    condensed.upper = program.upper(left);
    condensed.linear = program.linear(left);
    if (program.quadratic.size() > 0) {
        condensed.quadratic = program.quadratic(left);
    }
    if (program.energy) {
        const Eigen::VectorXd& weights = program.energy->weights;
        condensed.energy = EnergyEquality{
            weights(left), program.energy->value - weights.dot(result.fixed.cwiseAbs2())};
    }
}

SolverResult answer(SolverStatus status, std::string detail, Eigen::VectorXd x = {})
{
    SolverResult result;
    result.status = status;
    result.detail = std::move(detail);
    result.x = std::move(x);
    return result;
}

/// The row that misses its right side most, relative to max(1, |right side|).
std::pair<Index, double> worstRow(const Program& program, const Eigen::VectorXd& x)
{
    std::pair<Index, double> worst{0, 0.0};
    const Eigen::VectorXd residual = program.equalities * x - program.equalityRhs;
    for (Index row = 0; row < residual.size(); ++row) {
        const double relative =
            std::abs(residual[row]) / std::max(1.0, std::abs(program.equalityRhs[row]));
        if (!(relative <= worst.second)) {
            worst = {row, relative};
        }
    }
    return worst;
}

/// The energy that is left to variables that are not fixed.
void decideEnergy(double tolerance, Condensed& result)
{
    const EnergyEquality& energy = *result.program.energy;
    const bool hasWeight = energy.weights.size() > 0 && energy.weights.maxCoeff() > 0.0;
    if (hasWeight ? energy.value < -tolerance : std::abs(energy.value) > tolerance) {
        result.decided =
            answer(SolverStatus::infeasible,
                   fmt::format("fixed variables leave an energy of {:.3g}", energy.value));
    } else if (!hasWeight) {
        result.program.energy.reset();
    }
}

/// Where linear x + quadratic/2 x^2 is least between two bounds; infinite if nowhere.
double leastPoint(double linear, double quadratic, double lower, double upper)
{
    if (quadratic > 0.0) {
        return std::clamp(-linear / quadratic, lower, upper);
    }
    return linear > 0.0 ? lower : linear < 0.0 ? upper : std::clamp(0.0, lower, upper);
}

/// Without rows each variable is on its own.
void decideWithoutRows(Condensed& result)
{
    const Program& left = result.program;
    Eigen::VectorXd x(left.variables());
    for (Index i = 0; i < x.size(); ++i) {
        const double quadratic = left.quadratic.size() > 0 ? left.quadratic[i] : 0.0;
        x[i] = leastPoint(left.linear[i], quadratic, left.lower[i], left.upper[i]);
    }
    result.decided = x.allFinite()
                         ? answer(SolverStatus::optimal, "there are no rows", result.expand(x))
                         : answer(SolverStatus::unbounded, "there are no rows");
}

/// What one solution of the independent rows says about the others, and about itself if it is the
/// only one.
void decide(const Program& program, double tolerance, const Program& independent, Condensed& result)
{
    const Basis basis(independent.equalities, result.pivots);
    const Eigen::VectorXd x = basis.solve(independent.equalityRhs);
    if (!(worstRow(independent, x).second <= residualShare * tolerance)) {
        return;
    }
    const Eigen::VectorXd point = result.expand(x);
    const auto [row, residual] = worstRow(program, point);
    if (residual > tolerance) {
        result.decided = answer(
            SolverStatus::infeasible,
            fmt::format("equality {} contradicts the others: it misses by {:.3g}", row, residual));
    } else if (independent.equalities.rows() == independent.variables()) {
        const double worst = violation(program, point);
        result.decided =
            worst <= tolerance
                ? answer(SolverStatus::optimal, "the equalities have one solution", point)
                : answer(SolverStatus::infeasible,
                         fmt::format("the only solution of the equalities violates a bound or "
                                     "inequality by {:.3g}",
                                     worst));
    }
}

/// Eigen's SparseLU frees a block twice when memory runs out on the way, so there must be enough:
/// it begins with 20 entries for each of the matrix, of 20 bytes in all, and may grow to twice
/// that. \throws std::bad_alloc.
void requireMemoryForLu(const Eigen::SparseMatrix<double>& matrix)
{
    const auto entries = static_cast<std::size_t>(matrix.nonZeros() + matrix.cols());
    void* volatile room =
        std::malloc(std::size_t{2} * 20 * 20 * entries);  // volatile: not optimised away
    if (room == nullptr) {
        throw std::bad_alloc();
    }
    std::free(room);
}

}  // namespace

bool hasObjective(const Program& program)
{
    return !program.linear.isZero(0.0) || !program.quadratic.isZero(0.0);
}

Basis::Basis(const SparseRows& rows, std::vector<Index> columns)
    : variables_(rows.cols()),
      columns_(std::move(columns)),
      matrix_(select(rows, all(rows.rows()), columns_)),
      factors_(std::make_unique<Eigen::SparseLU<Eigen::SparseMatrix<double>>>())
{
    if (!columns_.empty()) {
        requireMemoryForLu(matrix_);
        factors_->compute(matrix_);
    }
}

Eigen::VectorXd Basis::solve(const Eigen::VectorXd& rhs) const
{
    Eigen::VectorXd x = Eigen::VectorXd::Zero(variables_);
    if (columns_.empty()) {
        return x;
    }
    if (factors_->info() != Eigen::Success) {
        x.setConstant(std::nan(""));
        return x;
    }
    Eigen::VectorXd inBasis = factors_->solve(rhs);
    inBasis += factors_->solve(rhs - matrix_ * inBasis);
    x(columns_) = inBasis;
    return x;
}

Eigen::VectorXd Condensed::expand(const Eigen::VectorXd& x) const
{
    Eigen::VectorXd result = fixed;
    result(variables) = x;
    return result;
}

Eigen::VectorXd Condensed::restrict(const Eigen::VectorXd& x) const
{
    return x(variables);
}

Condensed condense(const Program& program, double tolerance)
{
    Condensed result;
    removeFixed(program, result);
    if (program.energy) {
        decideEnergy(tolerance * std::max(1.0, program.energy->value), result);
    }
    if (result.decided) {
        return result;
    }
    Program& left = result.program;
    if (program.equalities.rows() + left.inequalities.rows() == 0 && !left.energy) {
        decideWithoutRows(result);
        return result;
    }
    IndependentRows independent = independentRows(left.equalities);
    result.rows = std::move(independent.rows);
    result.pivots = std::move(independent.pivots);
    std::vector<Index>& rows = result.rows;
    std::sort(rows.begin(), rows.end());
    const bool isRedundant = static_cast<Index>(rows.size()) < left.equalities.rows();
    if (isRedundant) {
        left.equalities = select(left.equalities, rows, all(left.variables()));
        left.equalityRhs = Eigen::VectorXd(left.equalityRhs(rows));
    }
    if (isRedundant || left.equalities.rows() == left.variables()) {
        decide(program, tolerance, left, result);
    }
    return result;
}

}  // namespace signorini
