#include "program.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "infinity.hpp"

namespace signorini {

namespace {

/// Largest and sum of the absolute coefficients of a row.
struct RowSize {
    double largest = 0.0;
    double sum = 0.0;
};

RowSize rowSize(const SparseRows& rows, Eigen::Index row)
{
    RowSize size;
    for (SparseRows::InnerIterator entry(rows, row); entry; ++entry) {
        size.largest = std::max(size.largest, std::abs(entry.value()));
        size.sum += std::abs(entry.value());
    }
    return size;
}

/// The least max |x_i| that a row needs in order to reach its right side.
double leastSize(const SparseRows& rows, Eigen::Index row, double rhs)
{
    const double sum = rowSize(rows, row).sum;
    return sum > 0.0 ? std::abs(rhs) / sum : 0.0;
}

/// \pre excess > 0 implies bound != 0 or unit > 0, or the violation is infinite.
double relative(double excess, double bound, double unit)
{
    return excess > 0.0 ? excess / std::max(unit, std::abs(bound)) : 0.0;
}

bool hasNan(const SparseRows& matrix)
{
    return matrix.nonZeros() > 0 &&
           !Eigen::Map<const Eigen::VectorXd>(matrix.valuePtr(), matrix.nonZeros()).allFinite();
}

}  // namespace

Program emptyProgram(std::int64_t variables)
{
    Program program;
    program.equalities.resize(0, variables);
    program.inequalities.resize(0, variables);
    program.lower = Eigen::VectorXd::Constant(variables, -infinity);
    program.upper = Eigen::VectorXd::Constant(variables, infinity);
    program.linear = Eigen::VectorXd::Zero(variables);
    return program;
}

void validate(const Program& program)
{
    const Eigen::Index n = program.variables();
    Faults faults;
    const auto requireSize = [&faults](const char* field, Eigen::Index size, Eigen::Index wanted) {
        if (size != wanted) {
            faults.add(fmt::format("size of {}", field), size, fmt::format("{}", wanted));
        }
    };
    const auto requireFinite = [&faults](const char* field, const Eigen::VectorXd& values) {
        if (!values.allFinite()) {
            faults.add(field, "NaN or infinity", "finite numbers");
        }
    };
    if (n < 1) {
        faults.add("number of variables", n, ">= 1");
    }
    requireSize("columns of equalities", program.equalities.cols(), n);
    requireSize("equalityRhs", program.equalityRhs.size(), program.equalities.rows());
    requireSize("columns of inequalities", program.inequalities.cols(), n);
    requireSize("inequalityRhs", program.inequalityRhs.size(), program.inequalities.rows());
    requireSize("lower", program.lower.size(), n);
    requireSize("upper", program.upper.size(), n);
    if (program.quadratic.size() != 0) {
        requireSize("quadratic", program.quadratic.size(), n);
    }
    if (program.energy) {
        requireSize("energy weights", program.energy->weights.size(), n);
    }
    faults.throwIfAny();

    requireFinite("equalityRhs", program.equalityRhs);
    requireFinite("inequalityRhs", program.inequalityRhs);
    requireFinite("linear", program.linear);
    requireFinite("quadratic", program.quadratic);
    if (hasNan(program.equalities)) {
        faults.add("equalities", "NaN or infinity", "finite numbers");
    }
    if (hasNan(program.inequalities)) {
        faults.add("inequalities", "NaN or infinity", "finite numbers");
    }
    for (Eigen::Index i = 0; i < n; ++i) {
        const bool ordered = program.lower[i] <= program.upper[i];
        if (!ordered || program.lower[i] == infinity || program.upper[i] == -infinity) {
            faults.add(fmt::format("bounds of variable {}", i),
                       fmt::format("[{}, {}]", program.lower[i], program.upper[i]),
                       "lower <= upper, lower < inf, upper > -inf");
            break;
        }
    }
    if (program.quadratic.size() > 0 && program.quadratic.minCoeff() < 0.0) {
        faults.add("quadratic", program.quadratic.minCoeff(), ">= 0 (a convex objective)");
    }
    if (program.energy) {
        requireFinite("energy weights", program.energy->weights);
        if (program.energy->weights.minCoeff() < 0.0) {
            faults.add("energy weights", program.energy->weights.minCoeff(), ">= 0");
        }
        if (!(std::isfinite(program.energy->value) && program.energy->value > 0.0)) {
            faults.add("energy value", program.energy->value, "finite and > 0");
        }
    }
    faults.throwIfAny();
}

double objective(const Program& program, const Eigen::VectorXd& x)
{
    double value = program.linear.dot(x);
    if (program.quadratic.size() > 0) {
        value += 0.5 * program.quadratic.dot(x.cwiseAbs2());
    }
    return value;
}

double naturalSize(const Program& program)
{
    double size = 0.0;
    for (Eigen::Index i = 0; i < program.equalities.rows(); ++i) {
        size = std::max(size, leastSize(program.equalities, i, program.equalityRhs[i]));
    }
    for (Eigen::Index i = 0; i < program.inequalities.rows(); ++i) {
        const double rhs = std::min(0.0, program.inequalityRhs[i]);
        size = std::max(size, leastSize(program.inequalities, i, rhs));
    }
    for (Eigen::Index i = 0; i < program.variables(); ++i) {
        size = std::max({size, program.lower[i], -program.upper[i]});
    }
    if (program.energy && program.energy->weights.sum() > 0.0) {
        size = std::max(size, std::sqrt(program.energy->value / program.energy->weights.sum()));
    }
    return size > 0.0 ? size : 1.0;
}

double violation(const Program& program, const Eigen::VectorXd& x)
{
    if (x.size() != program.variables() || !x.allFinite()) {
        return infinity;
    }
    const double unit = naturalSize(program);
    double worst = 0.0;
    const Eigen::VectorXd equal = program.equalities * x - program.equalityRhs;
    for (Eigen::Index i = 0; i < equal.size(); ++i) {
        worst = std::max(worst, relative(std::abs(equal[i]), program.equalityRhs[i],
                                         unit * rowSize(program.equalities, i).largest));
    }
    const Eigen::VectorXd above = program.inequalities * x - program.inequalityRhs;
    for (Eigen::Index i = 0; i < above.size(); ++i) {
        worst = std::max(worst, relative(above[i], program.inequalityRhs[i],
                                         unit * rowSize(program.inequalities, i).largest));
    }
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        worst = std::max({worst, relative(program.lower[i] - x[i], program.lower[i], unit),
                          relative(x[i] - program.upper[i], program.upper[i], unit)});
    }
    if (program.energy) {
        const double excess = program.energy->weights.dot(x.cwiseAbs2()) - program.energy->value;
        worst = std::max(worst, relative(std::abs(excess), program.energy->value, 0.0));
    }
    return worst;
}

}  // namespace signorini
