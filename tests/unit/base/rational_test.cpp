// Exact linear algebra against its own equations, which is all there is to it.

#include "rational.hpp"

#include <algorithm>
#include <random>

#include "catch.hpp"

using namespace signorini;

namespace {

Rational dot(const RationalVector& row, const RationalVector& x)
{
    Rational sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sum += row[k] * x[k];
    }
    return sum;
}

/// Fractions of small integers, many of them 0.
RationalVector drawRow(std::mt19937_64& generator, std::size_t size)
{
    std::uniform_int_distribution<int> numerator(-3, 3);
    std::uniform_int_distribution<int> denominator(1, 4);
    RationalVector row;
    for (std::size_t k = 0; k < size; ++k) {
        row.emplace_back(numerator(generator));
        row.back() /= denominator(generator);
    }
    return row;
}

std::vector<RationalVector> drawRows(std::mt19937_64& generator, std::size_t count,
                                     std::size_t size)
{
    std::vector<RationalVector> rows;
    for (std::size_t k = 0; k < count; ++k) {
        rows.push_back(drawRow(generator, size));
    }
    return rows;
}

}  // namespace

TEST_CASE("rational: the solution of regular equations solves them without a remainder")
{
    std::mt19937_64 generator(1);
    for (int trial = 0; trial < 200; ++trial) {
        const auto size = static_cast<std::size_t>(1 + trial % 6);
        const auto rows = drawRows(generator, size, size);
        if (nullVector(rows, size)) {
            continue;
        }
        const RationalVector rhs = drawRow(generator, size);
        const RationalVector x = solveRegular(rows, rhs);
        for (std::size_t k = 0; k < size; ++k) {
            REQUIRE(dot(rows[k], x) == rhs[k]);
        }
    }
}

TEST_CASE("rational: equations that hang together a little have a solution, or none")
{
    std::mt19937_64 generator(3);
    for (int trial = 0; trial < 500; ++trial) {
        const auto size = static_cast<std::size_t>(1 + trial % 14);
        const std::size_t count = trial % 2 == 0 ? size : 1 + generator() % 14;
        std::vector<RationalVector> rows = drawRows(generator, count, size);
        const std::uint64_t zeros = trial % 4 < 2 ? 2 : 0;  // of three entries
        for (RationalVector& row : rows) {
            for (Rational& entry : row) {
                if (generator() % 3 < zeros) {
                    entry = Rational();
                }
            }
        }
        const RationalVector known = drawRow(generator, size);
        RationalVector rhs;
        for (const RationalVector& row : rows) {
            rhs.push_back(dot(row, known));
        }
        const auto x = solveSome(rows, rhs, size);
        REQUIRE(x);
        for (std::size_t k = 0; k < count; ++k) {
            REQUIRE(dot(rows[k], *x) == rhs[k]);
        }
        // A row again, with another right side.
        rows.push_back(rows[generator() % count]);
        rhs.push_back(dot(rows.back(), known));
        rhs.back() += 1;
        REQUIRE_FALSE(solveSome(rows, rhs, size));
    }
}

TEST_CASE("rational: a null vector exists exactly when a column is spanned by the others")
{
    std::mt19937_64 generator(2);
    int dependent = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const auto size = static_cast<std::size_t>(2 + trial % 4);
        auto rows = drawRows(generator, size + 1, size);
        const bool isSpanned = trial % 2 == 0;
        if (isSpanned) {  // the last column a combination of the first two
            const RationalVector factors = drawRow(generator, 2);
            for (RationalVector& row : rows) {
                row.back() = factors[0] * row[0] + (size > 2 ? factors[1] * row[1] : Rational(0));
            }
        }
        const auto null = nullVector(rows, size);
        if (isSpanned) {
            REQUIRE(null);
        }
        if (!null) {
            continue;
        }
        ++dependent;
        const RationalVector x(null->begin(), null->end());
        REQUIRE(std::any_of(x.begin(), x.end(), [](const Rational& value) { return value != 0; }));
        for (const RationalVector& row : rows) {
            REQUIRE(dot(row, x) == 0);
        }
    }
    CHECK(dependent < 400);
    CHECK_FALSE(nullVector({{1, 0}, {0, 1}}, 2));
    CHECK(nullVector({}, 1));
}

TEST_CASE("rational: one common denominator, the least")
{
    std::mt19937_64 generator(3);
    for (int trial = 0; trial < 100; ++trial) {
        const RationalVector x = drawRow(generator, 5);
        const Homogeneous point = overCommonDenominator(x);
        REQUIRE(point.denominator > 0);
        Integer common = point.denominator;
        for (std::size_t k = 0; k < x.size(); ++k) {
            REQUIRE(Rational(point.numerators[k], point.denominator) == x[k]);
            common = gcd(common, point.numerators[k]);
        }
        REQUIRE(common == 1);
    }
}
