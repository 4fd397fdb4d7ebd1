#include "scaling.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

namespace {

constexpr double wellScaled = 1024.0;

/// 1 over the power of two next below a size; 1 for size 0.
double inversePower(double size)
{
    return size > 0.0 ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
}

Eigen::VectorXd rowFactors(const SparseRows& rows, double unit)
{
    Eigen::VectorXd factors(rows.rows());
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
        double largest = 0.0;
        for (SparseRows::InnerIterator entry(rows, row); entry; ++entry) {
            largest = std::max(largest, std::abs(entry.value()));
        }
        factors[row] = inversePower(unit * largest);
    }
    return factors;
}

double largestCost(const Program& program, double unit)
{
    const double linear = unit * program.linear.lpNorm<Eigen::Infinity>();
    const double quadratic =
        program.quadratic.size() > 0 ? unit * unit * program.quadratic.maxCoeff() : 0.0;
    return std::max(linear, quadratic);
}

bool isModest(double factor)
{
    return factor >= 1.0 / wellScaled && factor <= wellScaled;
}

bool isModest(const Eigen::VectorXd& factors)
{
    return factors.size() == 0 || (isModest(factors.minCoeff()) && isModest(factors.maxCoeff()));
}

}  // namespace

std::optional<Scaling> scalingOf(const Program& program)
{
    Scaling scaling;
    scaling.unit = 1.0 / inversePower(naturalSize(program));
    if (isModest(scaling.unit)) {
        scaling.unit = 1.0;
    }
    scaling.equalities = rowFactors(program.equalities, scaling.unit);
    scaling.inequalities = rowFactors(program.inequalities, scaling.unit);
    scaling.objective = inversePower(largestCost(program, scaling.unit));
    if (scaling.unit == 1.0 && isModest(scaling.objective) && isModest(scaling.equalities) &&
        isModest(scaling.inequalities)) {
        return std::nullopt;
    }
    return scaling;
}

Program scaled(const Program& program, const Scaling& scaling)
{
    const double unit = scaling.unit;
    Program result = program;
    result.equalities = scaling.equalities.asDiagonal() * program.equalities * unit;
    result.equalityRhs = scaling.equalities.cwiseProduct(program.equalityRhs);
    result.inequalities = scaling.inequalities.asDiagonal() * program.inequalities * unit;
    result.inequalityRhs = scaling.inequalities.cwiseProduct(program.inequalityRhs);
    result.lower /= unit;
    result.upper /= unit;
    result.linear *= scaling.objective * unit;
    result.quadratic *= scaling.objective * unit * unit;
    if (result.energy) {
        const double factor = inversePower(result.energy->value);
        result.energy->value *= factor;
        result.energy->weights *= factor * unit * unit;
    }
    return result;
}

void unscale(const Scaling& scaling, SolverResult& result)
{
    result.x *= scaling.unit;
    if (result.equalityDuals.size() > 0) {
        result.equalityDuals.array() *= scaling.equalities.array() / scaling.objective;
    }
    if (result.inequalityDuals.size() > 0) {
        result.inequalityDuals.array() *= scaling.inequalities.array() / scaling.objective;
    }
}

}  // namespace signorini
