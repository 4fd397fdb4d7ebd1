#include "lifting.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

namespace signorini {

namespace {

class Lifting {
public:
    Lifting(std::vector<IntegerVector> rows, IntegerVector rhs)
        : size_(rows.size()), rows_(std::move(rows)), rhs_(std::move(rhs))
    {
    }

    static RegularCore coreOf(const std::vector<IntegerVector>& rows)
    {
        Remainders m(rows.size());
        std::vector<std::size_t> order(rows.size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            std::transform(rows[k].begin(), rows[k].end(), std::back_inserter(m[k]), remainder);
            order[k] = k;
        }
        RegularCore core;
        for (std::size_t column = 0; column < m.front().size(); ++column) {
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
            clear(m, top, column, top + 1);
            core.columns.push_back(column);
        }
        core.rows.assign(order.begin(),
                         order.begin() + static_cast<std::ptrdiff_t>(core.columns.size()));
        return core;
    }

    [[nodiscard]] RationalVector solve() const
    {
        const Remainders inverse = inverted();
        std::vector<std::vector<std::uint64_t>> digits;
        IntegerVector rest = rhs_;
        for (std::size_t enough = 32;; enough *= 2) {
            while (digits.size() < enough) {
                digits.push_back(nextDigits(inverse, rest));
            }
            if (auto x = fractions(digits); x && isSolution(*x)) {
                return asRationals(*x);
            }
        }
    }

private:
    static constexpr std::uint64_t prime = 2147483647;  // 2^31 - 1

    static std::uint64_t remainder(const Integer& number)
    {
        const auto part = static_cast<std::int64_t>(number % prime);
        return static_cast<std::uint64_t>(part < 0 ? part + static_cast<std::int64_t>(prime)
                                                   : part);
    }

    /// By Fermat.
    static std::uint64_t reciprocal(std::uint64_t number)
    {
        std::uint64_t power = 1;
        for (std::uint64_t e = prime - 2; e > 0; e /= 2) {
            power = e % 2 == 1 ? power * number % prime : power;
            number = number * number % prime;
        }
        return power;
    }

    using Remainders = std::vector<std::vector<std::uint64_t>>;

    /// Makes row `top` begin with 1 and takes it from rows `from` ... so that the column is 0
    /// there.
    static void clear(Remainders& m, std::size_t top, std::size_t column, std::size_t from)
    {
        const std::uint64_t scale = reciprocal(m[top][column]);
        for (std::uint64_t& entry : m[top]) {
            entry = entry * scale % prime;
        }
        for (std::size_t k = from; k < m.size(); ++k) {
            const std::uint64_t factor = prime - m[k][column];
            for (std::size_t i = column; i < m[k].size() && k != top; ++i) {
                m[k][i] = (m[k][i] + factor * m[top][i]) % prime;
            }
        }
    }

    /// Gauss-Jordan beside the identity.
    [[nodiscard]] Remainders inverted() const
    {
        Remainders m(size_, std::vector<std::uint64_t>(2 * size_, 0));
        for (std::size_t k = 0; k < size_; ++k) {
            std::transform(rows_[k].begin(), rows_[k].end(), m[k].begin(), remainder);
            m[k][size_ + k] = 1;
        }
        for (std::size_t column = 0; column < size_; ++column) {
            std::size_t found = column;
            while (m[found][column] == 0) {
                ++found;
            }
            std::swap(m[column], m[found]);
            clear(m, column, column, 0);
        }
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

    [[nodiscard]] bool isSolution(const Homogeneous& x) const
    {
        for (std::size_t k = 0; k < size_; ++k) {
            Integer sum = -rhs_[k] * x.denominator;
            for (std::size_t i = 0; i < size_; ++i) {
                sum += rows_[k][i] * x.numerators[i];
            }
            if (!sum.is_zero()) {
                return false;
            }
        }
        return true;
    }

    std::size_t size_;
    std::vector<IntegerVector> rows_;
    IntegerVector rhs_;
};

}  // namespace

RegularCore regularCore(const std::vector<IntegerVector>& rows)
{
    return Lifting::coreOf(rows);
}

RationalVector liftedSolution(std::vector<IntegerVector> rows, IntegerVector rhs)
{
    return Lifting(std::move(rows), std::move(rhs)).solve();
}

}  // namespace signorini
