// The nearest point of a polyhedron, by the conditions that make it one: no row is broken, and the
// way from the centre is a sum of the rows that hold it.

#include "exact_projection.hpp"

#include <random>

#include "catch.hpp"
#include "listed_rows.hpp"

using namespace signorini;
using test::ListedRows;

namespace {

Rational valueAt(const ExactRow& row, const RationalVector& x)
{
    Rational sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sum += row.coefficients[k] * x[k];
    }
    return sum;
}

std::vector<ExactRow> drawRows(std::mt19937_64& generator, std::size_t unknowns)
{
    std::uniform_int_distribution<std::int64_t> coefficient(-3, 3);
    std::uniform_int_distribution<std::int64_t> count(0, 8);
    std::vector<ExactRow> rows;
    for (std::int64_t left = count(generator); left > 0; --left) {
        ExactRow row{.coefficients = {}, .rhs = coefficient(generator)};
        for (std::size_t k = 0; k < unknowns; ++k) {
            row.coefficients.push_back(coefficient(generator));
        }
        row.isEquality = count(generator) == 0;
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

TEST_CASE("exact projection: nearest by the conditions of a convex program, or rows that say 0 > 0")
{
    std::mt19937_64 generator(1);
    std::uniform_int_distribution<std::int64_t> small(-6, 6);
    int feasible = 0;
    int infeasible = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const auto unknowns = static_cast<std::size_t>(1 + trial % 5);
        const std::vector<ExactRow> rows = drawRows(generator, unknowns);
        RationalVector centre;
        std::vector<std::int64_t> d;
        for (std::size_t k = 0; k < unknowns; ++k) {
            centre.emplace_back(small(generator), 2);
            d.push_back(1 + static_cast<std::int64_t>(k) % 3);
        }
        const Projection result = project(ListedRows(unknowns, rows), centre, d);

        RationalVector sum(unknowns, Rational(0));
        Rational right = 0;
        for (const WeightedRow& held : result.rows) {
            REQUIRE((held.row.isEquality || held.weight >= 0));
            right += held.weight * held.row.rhs;
            for (std::size_t k = 0; k < unknowns; ++k) {
                sum[k] += held.weight * held.row.coefficients[k];
            }
        }
        if (!result.isFeasible) {
            ++infeasible;
            REQUIRE(right > 0);
            REQUIRE(sum == RationalVector(unknowns, Rational(0)));
            continue;
        }
        ++feasible;
        for (const ExactRow& row : rows) {
            const Rational value = valueAt(row, result.point);
            REQUIRE((row.isEquality ? value == row.rhs : value >= row.rhs));
        }
        for (const WeightedRow& held : result.rows) {
            REQUIRE((held.weight == 0 || valueAt(held.row, result.point) == held.row.rhs));
        }
        for (std::size_t k = 0; k < unknowns; ++k) {
            REQUIRE(result.point[k] - centre[k] == d[k] * sum[k]);
        }
    }
    CHECK(feasible > 200);
    CHECK(infeasible > 200);
}
