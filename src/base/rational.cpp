#include "rational.hpp"

#include <utility>

namespace signorini {

std::vector<std::size_t> reduceRows(std::vector<RationalVector>& rows, std::size_t columns)
{
    // Without fractions (Bareiss 1968): entries are minors of the rows over common denominators, so
    // that each division is exact and no gcd is asked for on the way.
    std::vector<IntegerVector> whole;
    whole.reserve(rows.size());
    for (const RationalVector& row : rows) {
        whole.push_back(overCommonDenominator(row).numerators);
    }
    std::vector<std::size_t> pivots;
    Integer last = 1;  // what stands in the pivots of all rows so far
    for (std::size_t column = 0; column < columns && pivots.size() < whole.size(); ++column) {
        const std::size_t top = pivots.size();
        std::size_t found = top;
        while (found < whole.size() && whole[found][column].is_zero()) {
            ++found;
        }
        if (found == whole.size()) {
            continue;
        }
        std::swap(whole[top], whole[found]);
        const Integer pivot = whole[top][column];
        for (std::size_t k = 0; k < whole.size(); ++k) {
            if (k == top) {
                continue;
            }
            const Integer factor = whole[k][column];
            for (std::size_t i = 0; i < whole[k].size(); ++i) {
                Integer& entry = whole[k][i];
                if (!entry.is_zero() || !factor.is_zero()) {
                    entry = (pivot * entry - factor * whole[top][i]) / last;
                }
            }
        }
        last = pivot;
        pivots.push_back(column);
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (std::size_t i = 0; i < rows[k].size(); ++i) {
            rows[k][i] = k < pivots.size() ? Rational(whole[k][i]) / last : Rational(whole[k][i]);
        }
    }
    return pivots;
}

Homogeneous overCommonDenominator(const RationalVector& x)
{
    Homogeneous point;
    for (const Rational& value : x) {
        point.denominator = lcm(point.denominator, denominator(value));
    }
    for (const Rational& value : x) {
        point.numerators.emplace_back(numerator(value) * (point.denominator / denominator(value)));
    }
    return point;
}

RationalVector asRationals(const Homogeneous& point)
{
    RationalVector x;
    x.reserve(point.numerators.size());
    for (const Integer& value : point.numerators) {
        x.emplace_back(value, point.denominator);
    }
    return x;
}

RationalVector solveRegular(std::vector<RationalVector> rows, RationalVector rhs)
{
    const std::size_t n = rows.size();
    for (std::size_t k = 0; k < n; ++k) {
        rows[k].push_back(std::move(rhs[k]));
    }
    reduceRows(rows, n);
    for (std::size_t k = 0; k < n; ++k) {
        rhs[k] = std::move(rows[k][n]);
    }
    return rhs;
}

std::optional<RationalVector> solveSome(std::vector<RationalVector> rows, RationalVector rhs,
                                        std::size_t size)
{
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].push_back(std::move(rhs[k]));
    }
    const std::vector<std::size_t> pivots = reduceRows(rows, size);
    for (std::size_t k = pivots.size(); k < rows.size(); ++k) {
        if (!rows[k][size].is_zero()) {
            return std::nullopt;
        }
    }
    RationalVector x(size);
    for (std::size_t k = 0; k < pivots.size(); ++k) {
        x[pivots[k]] = std::move(rows[k][size]);
    }
    return x;
}

std::optional<IntegerVector> nullVector(std::vector<RationalVector> rows, std::size_t size)
{
    const std::vector<std::size_t> pivots = reduceRows(rows, size);
    if (pivots.size() == size) {
        return std::nullopt;
    }
    std::size_t open = 0;  // the first column without a pivot
    while (open < pivots.size() && pivots[open] == open) {
        ++open;
    }
    RationalVector c(size);
    c[open] = 1;
    for (std::size_t k = 0; k < pivots.size(); ++k) {
        c[pivots[k]] = -rows[k][open];
    }
    return overCommonDenominator(c).numerators;
}

}  // namespace signorini
