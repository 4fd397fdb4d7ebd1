#include "lifting.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>

namespace signorini {

namespace {

constexpr std::uint64_t prime = 2147483647;  // 2^31 - 1

using Remainders = std::vector<std::vector<std::uint64_t>>;

std::uint64_t remainder(const Integer& number)
{
    const auto part = static_cast<std::int64_t>(number % prime);
    return static_cast<std::uint64_t>(part < 0 ? part + static_cast<std::int64_t>(prime) : part);
}

Remainders remaindersOf(const std::vector<IntegerVector>& rows)
{
    Remainders result(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        std::transform(rows[k].begin(), rows[k].end(), std::back_inserter(result[k]), remainder);
    }
    return result;
}

/// By Fermat.
std::uint64_t reciprocal(std::uint64_t number)
{
    std::uint64_t power = 1;
    for (std::uint64_t e = prime - 2; e > 0; e /= 2) {
        power = e % 2 == 1 ? power * number % prime : power;
        number = number * number % prime;
    }
    return power;
}

/// Rows and columns, as many of both.
struct Core {
    std::vector<std::size_t> rows;
    std::vector<std::size_t> columns;
};

/// Gauss-Jordan in the first `columns` columns: afterwards row k has a 1 in column columns[k] of
/// the answer, where all others have a 0, and was row rows[k].
Core reduce(Remainders& m, std::size_t columns)
{
    std::vector<std::size_t> order(m.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Core core;
    for (std::size_t column = 0; column < columns; ++column) {
        const std::size_t top = core.columns.size();
        std::size_t found = top;
        while (found < m.size() && m[found][column] == 0) {
            ++found;
        }
        if (found == m.size()) {
            continue;
        }
        std::swap(m[top], m[found]);
        std::swap(order[top], order[found]);
        const std::uint64_t scale = reciprocal(m[top][column]);
        for (std::uint64_t& entry : m[top]) {
            entry = entry * scale % prime;
        }
        for (std::size_t k = 0; k < m.size(); ++k) {
            const std::uint64_t factor = prime - m[k][column];
            for (std::size_t i = column; i < m[k].size() && k != top && factor != prime; ++i) {
                m[k][i] = (m[k][i] + factor * m[top][i]) % prime;
            }
        }
        core.columns.push_back(column);
    }
    order.resize(core.columns.size());
    core.rows = std::move(order);
    return core;
}

bool isSolution(const std::vector<IntegerVector>& rows, const IntegerVector& rhs,
                const Homogeneous& x)
{
    for (std::size_t k = 0; k < rows.size(); ++k) {
        Integer sum = -rhs[k] * x.denominator;
        for (std::size_t i = 0; i < rows[k].size(); ++i) {
            sum += rows[k][i] * x.numerators[i];
        }
        if (!sum.is_zero()) {
            return false;
        }
    }
    return true;
}

/// \pre the matrix is square and regular in remainders of p.
class Lifting {
public:
    Lifting(std::vector<IntegerVector> rows, IntegerVector rhs)
        : size_(rows.size()), rows_(std::move(rows)), rhs_(std::move(rhs))
    {
    }

    [[nodiscard]] Homogeneous solve() const
    {
        const Remainders inverse = inverted();
        Remainders digits;
        IntegerVector rest = rhs_;
        for (std::size_t enough = 32;; enough *= 2) {
            while (digits.size() < enough) {
                digits.push_back(nextDigits(inverse, rest));
            }
            if (auto x = fractions(digits); x && isSolution(rows_, rhs_, *x)) {
                return *std::move(x);
            }
        }
    }

private:
    /// Beside the identity.
    [[nodiscard]] Remainders inverted() const
    {
        Remainders m = remaindersOf(rows_);
        for (std::size_t k = 0; k < size_; ++k) {
            m[k].resize(2 * size_, 0);
            m[k][size_ + k] = 1;
        }
        reduce(m, size_);
        for (auto& row : m) {
            row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(size_));
        }
        return m;
    }

    /// The lowest digits of what M sends to `rest`, which goes on without them.
    [[nodiscard]] std::vector<std::uint64_t> nextDigits(const Remainders& inverse,
                                                        IntegerVector& rest) const
    {
        std::vector<std::uint64_t> low(size_);
        std::transform(rest.begin(), rest.end(), low.begin(), remainder);
        std::vector<std::uint64_t> x(size_, 0);
        for (std::size_t k = 0; k < size_; ++k) {
            for (std::size_t i = 0; i < size_; ++i) {
                x[k] = (x[k] + inverse[k][i] * low[i]) % prime;
            }
        }
        for (std::size_t k = 0; k < size_; ++k) {
            for (std::size_t i = 0; i < size_; ++i) {
                rest[k] -= rows_[k][i] * x[i];
            }
            rest[k] /= prime;
        }
        return x;
    }

    /// The fractions of least size with these digits, over one denominator; empty if some of them
    /// need more digits.
    [[nodiscard]] std::optional<Homogeneous> fractions(const Remainders& digits) const
    {
        const Integer modulus = pow(Integer(prime), static_cast<unsigned>(digits.size()));
        const Integer most = Integer(1) << (msb(modulus) / 2 - 1);
        Homogeneous x;
        for (std::size_t k = 0; k < size_; ++k) {
            Integer value = 0;
            for (std::size_t i = digits.size(); i-- > 0;) {
                value = value * prime + digits[i][k];
            }
            value = value * x.denominator % modulus;
            // Euclid, up to the first remainder that is small enough.
            Integer last = modulus;
            Integer lastFactor = 0;
            Integer factor = 1;
            while (value > most && modulus - value > most) {
                const Integer quotient = last / value;
                last -= quotient * value;
                lastFactor -= quotient * factor;
                swap(last, value);
                swap(lastFactor, factor);
            }
            if (value > most) {
                value -= modulus;
            }
            if (factor < 0) {
                factor = -factor;
                value = -value;
            }
            x.denominator *= factor;
            if (x.denominator > most) {
                return std::nullopt;
            }
            for (Integer& before : x.numerators) {
                before *= factor;
            }
            x.numerators.push_back(std::move(value));
        }
        return x;
    }

    std::size_t size_;
    std::vector<IntegerVector> rows_;
    IntegerVector rhs_;
};

}  // namespace

std::optional<RationalVector> liftedSolution(const std::vector<IntegerVector>& rows,
                                             const IntegerVector& rhs)
{
    const std::size_t size = rows.front().size();
    Remainders remainders = remaindersOf(rows);
    const Core core = reduce(remainders, size);
    std::vector<IntegerVector> square;
    IntegerVector right;
    for (const std::size_t k : core.rows) {
        IntegerVector& row = square.emplace_back();
        for (const std::size_t i : core.columns) {
            row.push_back(rows[k][i]);
        }
        right.push_back(rhs[k]);
    }
    Homogeneous solved = Lifting(std::move(square), std::move(right)).solve();
    Homogeneous x{IntegerVector(size), std::move(solved.denominator)};
    for (std::size_t i = 0; i < core.columns.size(); ++i) {
        x.numerators[core.columns[i]] = std::move(solved.numerators[i]);
    }
    return isSolution(rows, rhs, x) ? std::optional(asRationals(x)) : std::nullopt;
}

}  // namespace signorini
