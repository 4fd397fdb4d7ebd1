#include "rational.hpp"

#include <utility>

namespace signorini {

namespace {

/// Gauss-Jordan: afterwards row k has a 1 in column pivots[k], and that column is 0 elsewhere.
/// Only the first `columns` columns are searched for pivots. Zero rows end up last.
std::vector<std::size_t> reduceRows(std::vector<RationalVector>& rows, std::size_t columns)
{
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < columns && pivots.size() < rows.size(); ++column) {
        const std::size_t top = pivots.size();
        std::size_t found = top;
        while (found < rows.size() && rows[found][column].is_zero()) {
            ++found;
        }
        if (found == rows.size()) {
            continue;
        }
        std::swap(rows[top], rows[found]);
        const Rational scale = 1 / rows[top][column];
        for (Rational& value : rows[top]) {
            value *= scale;
        }
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (k == top || rows[k][column].is_zero()) {
                continue;
            }
            const Rational factor = rows[k][column];
            for (std::size_t i = column; i < rows[k].size(); ++i) {
                rows[k][i] -= factor * rows[top][i];
            }
        }
        pivots.push_back(column);
    }
    return pivots;
}

}  // namespace

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
