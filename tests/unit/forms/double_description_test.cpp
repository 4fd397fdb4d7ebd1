// Our vertices and directions of polyhedra against those of cddlib, exactly.

#include "double_description.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "catch.hpp"
#include "cddlib.hpp"
#include "formulation.hpp"
#include "listed_rows.hpp"
#include "program_rows.hpp"
#include "signorini/schedule.hpp"

using namespace signorini;
using test::ListedRows;

namespace {

/// Coordinates in lowest terms: of a vertex behind "1", of a direction, up to a factor > 0, "0".
using Generator = std::vector<std::string>;
using GeneratorSet = std::set<Generator>;

Generator generatorOf(const std::vector<Rational>& at, bool isVertex)
{
    Generator words{isVertex ? "1" : "0"};
    const auto first = std::find_if(at.begin(), at.end(), [](const auto& x) { return x != 0; });
    const Rational scale = isVertex || first == at.end() ? Rational(1) : Rational(abs(*first));
    for (const Rational& value : at) {
        words.push_back(Rational(value / scale).str());
    }
    return words;
}

GeneratorSet asSet(const Generators& generators)
{
    GeneratorSet all;
    for (const auto* list : {&generators.vertices, &generators.directions}) {
        for (const Homogeneous& point : *list) {
            const bool isVertex = !point.denominator.is_zero();
            std::vector<Rational> at;
            for (const Integer& value : point.numerators) {
                at.emplace_back(value, isVertex ? point.denominator : Integer(1));
            }
            CHECK(all.insert(generatorOf(at, isVertex)).second);  // none comes twice
        }
    }
    return all;
}

/// What cddlib says. Empty if the polyhedron contains lines: then generators are not unique.
std::optional<GeneratorSet> oracle(const std::vector<ExactRow>& rows, std::size_t unknowns)
{
    const auto columns = static_cast<dd_colrange>(unknowns) + 1;
    const test::CddMatrix input = test::cddRows(rows.size(), unknowns);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        mpq_set_si(input->matrix[k][0], -rows[k].rhs, 1);
        for (std::size_t i = 0; i < unknowns; ++i) {
            mpq_set_si(input->matrix[k][i + 1], rows[k].coefficients[i], 1);
        }
        if (rows[k].isEquality) {
            set_addelem(input->linset, static_cast<long>(k) + 1);
        }
    }
    const test::CddMatrix output = test::cddGenerators(input);
    if (set_card(output->linset) > 0) {
        return std::nullopt;
    }
    GeneratorSet all;
    for (dd_rowrange k = 0; k < output->rowsize; ++k) {
        std::vector<Rational> at;
        for (dd_colrange i = 1; i < columns; ++i) {
            char* text = mpq_get_str(nullptr, 10, output->matrix[k][i]);
            at.emplace_back(text);
            std::free(text);
        }
        all.insert(generatorOf(at, mpq_sgn(output->matrix[k][0]) != 0));
    }
    if (std::all_of(rows.begin(), rows.end(), [](const ExactRow& row) { return row.rhs == 0; })) {
        // A cone: cddlib leaves its tip out.
        all.insert(generatorOf(std::vector<Rational>(unknowns), true));
    }
    return all;
}

bool hasVertex(const GeneratorSet& generators)
{
    return !generators.empty() && generators.rbegin()->front() == "1";
}

/// Small coefficients, so that rows are often parallel, redundant, or meet in one point.
std::vector<ExactRow> randomRows(std::mt19937& generator, std::size_t unknowns)
{
    const auto draw = [&generator](int low, int high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    std::vector<ExactRow> rows;
    const auto count = static_cast<std::size_t>(draw(1, 4)) * unknowns;
    for (std::size_t k = 0; k < count; ++k) {
        ExactRow row;
        for (std::size_t i = 0; i < unknowns; ++i) {
            row.coefficients.push_back(draw(-2, 2));
        }
        row.rhs = draw(-6, 1);
        row.isEquality = draw(0, 19) == 0;
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The rows of a program, read by other code than ProgramRows.
std::vector<ExactRow> rowsOf(const Program& program)
{
    std::vector<ExactRow> rows;
    const auto integer = [](double value) {
        REQUIRE(value == std::trunc(value));
        return static_cast<std::int64_t>(value);
    };
    const auto append = [&](const Eigen::VectorXd& row, double rhs, bool isEquality, int sign) {
        ExactRow exact{{}, sign * integer(rhs), isEquality, 0};
        for (const double value : row) {
            exact.coefficients.push_back(sign * integer(value));
        }
        rows.push_back(std::move(exact));
    };
    const Eigen::MatrixXd equalities = program.equalities;
    for (Eigen::Index k = 0; k < equalities.rows(); ++k) {
        append(equalities.row(k), program.equalityRhs[k], true, 1);
    }
    const Eigen::MatrixXd inequalities = program.inequalities;
    for (Eigen::Index k = 0; k < inequalities.rows(); ++k) {
        append(inequalities.row(k), program.inequalityRhs[k], false, -1);
    }
    for (Eigen::Index i = 0; i < program.variables(); ++i) {
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(program.variables(), i);
        if (std::isfinite(program.lower[i])) {
            append(unit, program.lower[i], false, 1);
        }
        if (std::isfinite(program.upper[i])) {
            append(unit, program.upper[i], false, -1);
        }
    }
    return rows;
}

constexpr std::size_t maxRays = 10'000;

}  // namespace

TEST_CASE("double description: random small polyhedra have the generators that cddlib finds")
{
    std::mt19937 generator(11);
    int bounded = 0;
    int unbounded = 0;
    int empty = 0;
    for (int k = 0; k < 600; ++k) {
        const std::size_t unknowns = 1 + static_cast<std::size_t>(k) % 5;
        const std::vector<ExactRow> rows = randomRows(generator, unknowns);
        const auto truth = oracle(rows, unknowns);
        if (!truth) {
            continue;
        }
        const auto ours = generatorsOf(ListedRows(unknowns, rows), maxRays);
        REQUIRE(ours);
        const GeneratorSet mine = asSet(*ours);
        INFO("polyhedron " << k);
        REQUIRE(hasVertex(mine) == hasVertex(*truth));
        if (!hasVertex(mine)) {
            ++empty;
            continue;
        }
        REQUIRE(mine == *truth);
        ++(ours->directions.empty() ? bounded : unbounded);
    }
    CHECK(bounded > 50);
    CHECK(unbounded > 50);
    CHECK(empty > 20);
}

TEST_CASE("double description: a line counts as two directions")
{
    const auto strip = generatorsOf(ListedRows(2, {{{1, 0}, 0, false, 0}}), maxRays);
    REQUIRE(strip);
    CHECK(strip->vertices.size() == 1);
    CHECK(asSet(*strip).contains(Generator{"0", "0", "1"}));
    CHECK(asSet(*strip).contains(Generator{"0", "0", "-1"}));
    CHECK(asSet(*strip).contains(Generator{"0", "1", "0"}));
    CHECK(strip->directions.size() == 3);
    // More rays on the way than allowed: no answer rather than part of one.
    CHECK_FALSE(generatorsOf(
        ListedRows(3,
                   {{{1, 0, 0}, 0, false, 0}, {{0, 1, 0}, 0, false, 0}, {{0, 0, 1}, 0, false, 0}}),
        2));
}

TEST_CASE("double description: the sums of several contact phases have the vertices of cddlib")
{
    std::mt19937 generator(5);
    const auto draw = [&generator](int low, int high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    int compared = 0;
    int severalVertices = 0;
    for (int k = 0; k < 4000; ++k) {
        Schedule schedule{draw(2, 8), {}};
        for (std::int64_t phases = draw(2, 4); phases > 0; --phases) {
            schedule.phases.push_back({draw(1, 6), draw(1, 20)});
        }
        // Periods that share factors with 2N have many classes.
        schedule.phases.back().free += schedule.cells - steps(schedule) % schedule.cells;
        const Formulated posed = formulate(schedule, Formulation::lumped);
        const auto rows = ProgramRows::of(posed.program);
        REQUIRE(rows);
        if (rows->unknowns() == 0) {
            continue;
        }
        const auto truth = oracle(rowsOf(posed.program), rows->unknowns());
        const auto ours = generatorsOf(*rows, maxRays);
        REQUIRE(ours);
        INFO(describe(schedule));
        if (!truth) {
            continue;
        }
        const GeneratorSet mine = asSet(*ours);
        REQUIRE(hasVertex(mine) == hasVertex(*truth));
        if (hasVertex(mine)) {
            REQUIRE(mine == *truth);
            ++compared;
            severalVertices += ours->vertices.size() > 1 ? 1 : 0;
        }
    }
    CHECK(compared > 20);
    CHECK(severalVertices > 0);
}
