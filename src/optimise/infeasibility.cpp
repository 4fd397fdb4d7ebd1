#include "infeasibility.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "integers.hpp"
#include "rational.hpp"

namespace signorini {

namespace {

constexpr std::int64_t maxDenominator = 1'000'000;
constexpr double roundingTolerance = 1e-9;

struct Fraction {
    std::int64_t numerator;
    std::int64_t denominator;
};

/// The simplest fraction within the rounding tolerance, by continued fractions.
std::optional<Fraction> simplestFraction(double value)
{
    if (!(std::abs(value) < 1e9)) {
        return std::nullopt;
    }
    std::int64_t p0 = 1;
    std::int64_t q0 = 0;
    auto p1 = static_cast<std::int64_t>(std::floor(value));
    std::int64_t q1 = 1;
    double rest = value - std::floor(value);
    const double allowed = roundingTolerance * std::max(1.0, std::abs(value));
    while (std::abs(value - static_cast<double>(p1) / static_cast<double>(q1)) > allowed) {
        const double inverse = 1.0 / rest;
        const double whole = std::floor(inverse);
        if (!(whole <= static_cast<double>(maxDenominator))) {
            return std::nullopt;
        }
        const auto term = static_cast<std::int64_t>(whole);
        p0 = std::exchange(p1, term * p1 + p0);
        q0 = std::exchange(q1, term * q1 + q0);
        if (q1 > maxDenominator) {
            return std::nullopt;
        }
        rest = inverse - whole;
    }
    return Fraction{p1, q1};
}

/// Duals as fractions over one denominator, or nothing if that is out of reach.
std::optional<InfeasibilityProof> clearDenominators(const Eigen::VectorXd& y,
                                                    const Eigen::VectorXd& mu)
{
    std::int64_t common = 1;
    std::vector<Fraction> fractions;
    for (const Eigen::VectorXd* values : {&y, &mu}) {
        for (const double value : *values) {
            const auto fraction = simplestFraction(value);
            if (!fraction) {
                return std::nullopt;
            }
            fractions.push_back(*fraction);
            common = checkedMultiply(common / std::gcd(common, fraction->denominator),
                                     fraction->denominator);
        }
    }
    InfeasibilityProof proof;
    for (std::size_t k = 0; k < fractions.size(); ++k) {
        const std::int64_t value =
            checkedMultiply(fractions[k].numerator, common / fractions[k].denominator);
        if (value == 0) {
            continue;
        }
        const auto row = static_cast<std::int64_t>(k);
        if (row < y.size()) {
            proof.equalities.push_back({row, value});
        } else {
            proof.inequalities.push_back({row - y.size(), value});
        }
    }
    return proof;
}

/// minimise the sum of row violations: one elastic unknown per inequality, two per equality.
Program elastic(const Program& program)
{
    const Eigen::Index n = program.variables();
    const Eigen::Index p = program.equalities.rows();
    const Eigen::Index q = program.inequalities.rows();
    Program result = emptyProgram(n + 2 * p + q);
    result.lower << program.lower, Eigen::VectorXd::Zero(2 * p + q);
    result.upper.head(n) = program.upper;
    result.linear.tail(2 * p + q).setOnes();
    const auto extend = [n](const SparseRows& from, Eigen::Index columns, Eigen::Index first,
                            bool bothWays) {
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index row = 0; row < from.rows(); ++row) {
            const auto k = static_cast<int>(row);
            for (SparseRows::InnerIterator entry(from, row); entry; ++entry) {
                entries.emplace_back(k, static_cast<int>(entry.col()), entry.value());
            }
            const auto slack = static_cast<int>(n + first + (bothWays ? 2 * row : row));
            entries.emplace_back(k, slack, -1.0);
            if (bothWays) {
                entries.emplace_back(k, slack + 1, 1.0);
            }
        }
        SparseRows to(from.rows(), columns);
        to.setFromTriplets(entries.begin(), entries.end());
        return to;
    };
    result.equalities = extend(program.equalities, result.variables(), 0, true);
    result.equalityRhs = program.equalityRhs;
    result.inequalities = extend(program.inequalities, result.variables(), 2 * p, false);
    result.inequalityRhs = program.inequalityRhs;
    return result;
}

/// Do the bounds seem to keep sign * row above its right side? In doubles: a filter before the
/// exact check.
bool excludes(const Program& program, const SparseRows& rows, Eigen::Index row, double sign,
              double rhs)
{
    double least = 0.0;
    for (SparseRows::InnerIterator entry(rows, row); entry; ++entry) {
        const double c = sign * entry.value();
        if (c != 0.0) {
            least += c * (c > 0.0 ? program.lower : program.upper)[entry.col()];
        }
    }
    return least > sign * rhs;
}

/// A row and what it is multiplied by.
struct Weighted {
    std::int64_t row;
    Rational value;
};

template <typename Given>
std::vector<Weighted> weighted(const std::vector<Given>& multipliers)
{
    std::vector<Weighted> rows;
    rows.reserve(multipliers.size());
    for (const Given& m : multipliers) {
        rows.push_back({m.row, Rational(m.value)});
    }
    return rows;
}

bool addRows(const std::vector<Weighted>& multipliers, const SparseRows& rows,
             const Eigen::VectorXd& rhs, bool isInequality, std::vector<Rational>& combination,
             Rational& right)
{
    for (const Weighted& m : multipliers) {
        if (m.row < 0 || m.row >= rows.rows() || (isInequality && m.value < 0)) {
            return false;
        }
        for (SparseRows::InnerIterator entry(rows, static_cast<Eigen::Index>(m.row)); entry;
             ++entry) {
            combination[static_cast<std::size_t>(entry.col())] += Rational(entry.value()) * m.value;
        }
        right += Rational(rhs[static_cast<Eigen::Index>(m.row)]) * m.value;
    }
    return true;
}

/// Is the sum of the rows broken by all within the bounds?
bool contradict(const std::vector<Weighted>& equalities, const std::vector<Weighted>& inequalities,
                const Program& program)
{
    std::vector<Rational> combination(static_cast<std::size_t>(program.variables()));
    Rational right = 0;
    if (!addRows(equalities, program.equalities, program.equalityRhs, false, combination, right) ||
        !addRows(inequalities, program.inequalities, program.inequalityRhs, true, combination,
                 right)) {
        return false;
    }
    for (Eigen::Index i = 0; i < program.variables(); ++i) {
        const Rational& c = combination[static_cast<std::size_t>(i)];
        if (c.is_zero()) {
            continue;
        }
        const double bound = c > 0 ? program.lower[i] : program.upper[i];
        if (!std::isfinite(bound)) {
            return false;
        }
        right -= c * Rational(bound);
    }
    return right < 0;
}

}  // namespace

bool isProof(const InfeasibilityProof& proof, const Program& program)
{
    return contradict(weighted(proof.equalities), weighted(proof.inequalities), program);
}

bool isProof(const RationalProof& proof, const Program& program)
{
    try {
        return contradict(weighted(proof.equalities), weighted(proof.inequalities), program);
    } catch (const std::runtime_error&) {
        return false;  // what Boost says of a number it cannot read
    } catch (const std::logic_error&) {
        return false;  // and of one over 0
    }
}

std::optional<InfeasibilityProof> proveByOneRow(const Program& program)
{
    for (Eigen::Index row = 0; row < program.equalities.rows(); ++row) {
        for (const std::int64_t sign : {1, -1}) {
            InfeasibilityProof proof{{{row, sign}}, {}};
            if (excludes(program, program.equalities, row, static_cast<double>(sign),
                         program.equalityRhs[row]) &&
                isProof(proof, program)) {
                return proof;
            }
        }
    }
    for (Eigen::Index row = 0; row < program.inequalities.rows(); ++row) {
        InfeasibilityProof proof{{}, {{row, 1}}};
        if (excludes(program, program.inequalities, row, 1.0, program.inequalityRhs[row]) &&
            isProof(proof, program)) {
            return proof;
        }
    }
    return std::nullopt;
}

std::optional<InfeasibilityProof> proveInfeasible(const Program& program, const Solver& solver,
                                                  const SolverOptions& options)
{
    if (!solver.capabilities().duals) {
        throw std::invalid_argument(std::string("solver = ") + std::string(solver.name()) +
                                    ": allowed one that returns duals");
    }
    const SolverResult answer = solver.solve(elastic(program), options);
    if (answer.status != SolverStatus::optimal || !(answer.objective > 0.0)) {
        return std::nullopt;
    }
    try {
        // The duals of a least-sum problem have the opposite sign of Farkas multipliers.
        auto proof = clearDenominators(-answer.equalityDuals, -answer.inequalityDuals);
        if (proof && isProof(*proof, program)) {
            return proof;
        }
    } catch (const std::overflow_error&) {
        return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace signorini
