#include "rational.hpp"

#include <algorithm>
#include <utility>

#include "lifting.hpp"

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

namespace {

/// M x = rhs, solved part by part: rows that share no unknowns know nothing of each other, and an
/// unknown that stands alone in a row is a number everywhere else.
class Parts {
public:
    Parts(std::vector<RationalVector> rows, RationalVector rhs, std::size_t size)
        : rows_(std::move(rows)), rhs_(std::move(rhs)), x_(size)
    {
    }

    std::optional<RationalVector> solve()
    {
        substitute();
        const std::size_t none = rows_.size();
        std::vector<std::size_t> parts(none, none);  // of each row; 0 stands in rows without one
        for (std::size_t first = 0; first < rows_.size(); ++first) {
            if (parts[first] != none) {
                continue;
            }
            gather(first, parts);
            if (!solvePart(first, parts)) {
                return std::nullopt;
            }
        }
        return std::move(x_);
    }

private:
    void substitute()
    {
        for (bool isChanged = true; isChanged;) {
            isChanged = false;
            for (std::size_t k = 0; k < rows_.size(); ++k) {
                const auto isThere = [](const Rational& entry) { return !entry.is_zero(); };
                const auto entry = std::find_if(rows_[k].begin(), rows_[k].end(), isThere);
                if (entry != rows_[k].end() && std::none_of(entry + 1, rows_[k].end(), isThere)) {
                    const Rational value = rhs_[k] / *entry;
                    fix(static_cast<std::size_t>(entry - rows_[k].begin()), value);
                    isChanged = true;
                }
            }
        }
    }

    void fix(std::size_t unknown, const Rational& value)
    {
        x_[unknown] = value;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            Rational& entry = rows_[k][unknown];
            rhs_[k] -= entry * value;
            entry = Rational();
        }
    }

    /// The rows that share unknowns with the first, directly or by others.
    void gather(std::size_t first, std::vector<std::size_t>& parts) const
    {
        std::vector<std::size_t> next{first};
        parts[first] = first;
        while (!next.empty()) {
            const RationalVector& row = rows_[next.back()];
            next.pop_back();
            for (std::size_t i = 0; i < row.size(); ++i) {
                for (std::size_t k = 0; k < rows_.size() && !row[i].is_zero(); ++k) {
                    if (parts[k] == rows_.size() && !rows_[k][i].is_zero()) {
                        parts[k] = first;
                        next.push_back(k);
                    }
                }
            }
        }
    }

    bool solvePart(std::size_t part, const std::vector<std::size_t>& parts)
    {
        std::vector<std::size_t> unknowns;
        std::vector<RationalVector> rows;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            for (std::size_t k = 0; k < rows_.size(); ++k) {
                if (parts[k] == part && !rows_[k][i].is_zero()) {
                    unknowns.push_back(i);
                    break;
                }
            }
        }
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            if (parts[k] == part) {
                RationalVector& row = rows.emplace_back();
                for (const std::size_t i : unknowns) {
                    row.push_back(std::move(rows_[k][i]));
                }
                row.push_back(std::move(rhs_[k]));
            }
        }
        if (const auto values = lifted(rows)) {
            for (std::size_t i = 0; i < unknowns.size(); ++i) {
                x_[unknowns[i]] = (*values)[i];
            }
            return true;
        }
        const std::vector<std::size_t> pivots = reduceRows(rows, unknowns.size());
        for (std::size_t k = pivots.size(); k < rows.size(); ++k) {
            if (!rows[k].back().is_zero()) {
                return false;
            }
        }
        for (std::size_t k = 0; k < pivots.size(); ++k) {
            x_[unknowns[pivots[k]]] = std::move(rows[k].back());
        }
        return true;
    }

    static constexpr std::size_t leastToLift = 6;  // elimination is quicker below

    /// By lifting, for rows that end with their right sides. Empty for few, and as liftedSolution.
    static std::optional<RationalVector> lifted(const std::vector<RationalVector>& rows)
    {
        const std::size_t size = rows.front().size() - 1;
        if (std::min(rows.size(), size) < leastToLift) {
            return std::nullopt;
        }
        std::vector<IntegerVector> matrix;
        IntegerVector rhs;
        for (const RationalVector& row : rows) {
            matrix.push_back(overCommonDenominator(row).numerators);
            rhs.push_back(std::move(matrix.back().back()));
            matrix.back().pop_back();
        }
        return liftedSolution(matrix, rhs);
    }

    std::vector<RationalVector> rows_;
    RationalVector rhs_;
    RationalVector x_;
};

}  // namespace

std::optional<RationalVector> solveSome(std::vector<RationalVector> rows, RationalVector rhs,
                                        std::size_t size)
{
    return Parts(std::move(rows), std::move(rhs), size).solve();
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
