#include "equations.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <set>

#include "catch.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

/// A travelling wave of the paper, extended by (21), (22), (24), (25) as functions of position: N
/// = cells, L = N, evaluated in the middle of a cell. The formulas are copied from the paper.
class PaperWaves {
public:
    explicit PaperWaves(const State& state)
        : state_(state), length_(static_cast<double>(state.a.size()))
    {
    }

    [[nodiscard]] double r1DD(double s) const
    {
        const double L = length_;
        s = reduced(s, 2 * L, L);
        if (s >= 0) {
            return a(s);
        }
        return s >= -L ? -b(-s) : a(2 * L + s);
    }
    [[nodiscard]] double r2DD(double s) const
    {
        const double L = length_;
        s = reduced(s, 2 * L, 2 * L);
        return s <= L ? b(s) : -a(2 * L - s);
    }
    [[nodiscard]] double r1DN(double s) const
    {
        const double L = length_;
        s = reduced(s, 4 * L, L);
        if (s >= 0) {
            return a(s);
        }
        if (s >= -L) {
            return -b(-s);
        }
        return s >= -2 * L ? -a(s + 2 * L) : b(-s - 2 * L);
    }
    [[nodiscard]] double r2DN(double s) const
    {
        const double L = length_;
        s = reduced(s, 4 * L, 4 * L);
        if (s <= L) {
            return b(s);
        }
        if (s <= 2 * L) {
            return a(2 * L - s);
        }
        return s <= 3 * L ? -b(s - 2 * L) : -a(4 * L - s);
    }

private:
    [[nodiscard]] double a(double s) const { return state_.a[static_cast<Eigen::Index>(s)]; }
    [[nodiscard]] double b(double s) const { return state_.b[static_cast<Eigen::Index>(s)]; }
    static double reduced(double s, double repeat, double top)
    {
        while (s > top) {
            s -= repeat;
        }
        while (s < top - repeat) {
            s += repeat;
        }
        return s;
    }

    State state_;
    double length_;
};

Eigen::MatrixXd dense(const SparseMatrix& matrix)
{
    return Eigen::MatrixXd(matrix);
}

}  // namespace

TEST_CASE("equations: A^DD, B^DD, A^DN, B^DN are the extensions (21)-(25)")
{
    const std::int64_t cells = GENERATE(1, 2, 5);
    const State state = test::randomState(cells);
    const PaperWaves paper(state);
    const ExtendedWaves waves = extendedWaves(cells);
    REQUIRE(waves.aDD.rows() == 4 * cells);
    REQUIRE(waves.aDD.cols() == 2 * cells);
    const Eigen::VectorXd x = test::stacked(state);
    for (std::int64_t j = -2 * cells + 1; j <= 2 * cells; ++j) {
        const auto row = static_cast<Eigen::Index>(j + 2 * cells - 1);
        const double middle = static_cast<double>(j) - 0.5;
        INFO("cell " << j);
        CHECK((waves.aDD * x)[row] == paper.r1DD(middle));
        CHECK((waves.bDD * x)[row] == paper.r2DD(middle));
        CHECK((waves.aDN * x)[row] == paper.r1DN(middle));
        CHECK((waves.bDN * x)[row] == paper.r2DN(middle));
    }
}

TEST_CASE("equations: the maps of (29) sample the extensions at x -+ c t_n")
{
    const std::int64_t cells = 4;
    const State state = test::randomState(cells);
    const PaperWaves paper(state);
    const Eigen::VectorXd x = test::stacked(state);
    for (std::int64_t n = 0; n <= 40; ++n) {
        const Eigen::VectorXd held = contactMap(cells, n) * x;
        const Eigen::VectorXd flying = freeMap(cells, n) * x;
        for (std::int64_t i = 1; i <= cells; ++i) {
            const double middle = static_cast<double>(i) - 0.5;
            const double shift = static_cast<double>(n);
            CHECK(held[i - 1] == paper.r1DD(middle - shift));
            CHECK(held[cells + i - 1] == paper.r2DD(middle + shift));
            CHECK(flying[i - 1] == paper.r1DN(middle - shift));
            CHECK(flying[cells + i - 1] == paper.r2DN(middle + shift));
        }
    }
}

TEST_CASE("equations: W is a signed permutation, so orthogonal")
{
    const SparseMatrix w = periodMap(Schedule{6, {{3, 8}, {2, 5}}});
    const Eigen::MatrixXd product = dense(w) * dense(w).transpose();
    CHECK(product == Eigen::MatrixXd::Identity(12, 12));
    CHECK(w.nonZeros() == 12);
}

TEST_CASE("equations: the paper's kernel has dimension 150, and 149 after the gap row")
{
    const Schedule schedule = test::onePhase(300, 150, 900);
    Eigen::MatrixXd rows(601, 600);
    rows.topRows(600) = dense(periodMap(schedule)) - Eigen::MatrixXd::Identity(600, 600);
    rows.bottomRows(1) = dense(gapRow(300));
    CHECK(600 - Eigen::FullPivLU<Eigen::MatrixXd>(rows.topRows(600)).rank() == 150);
    CHECK(600 - Eigen::FullPivLU<Eigen::MatrixXd>(rows).rank() == 149);
}

TEST_CASE("equations: the gap row is N u(L)/g of (31)")
{
    const State state = test::randomState(7);
    CHECK((gapRow(7) * test::stacked(state))[0] == Approx(7.0 * displacement(state)[6]));
}

TEST_CASE("equations: of the (n_c + 1 + n_f) N rows of (32) all but n_c + n_f repeat or follow")
{
    // The paper's conditions sampled at N instants inside every step, from its own formulas.
    const Schedule schedule = test::onePhase(4, 3, 13);
    const std::int64_t cells = schedule.cells;
    const Phase phase = schedule.phases[0];
    const State q0 = test::randomState(cells, 3);
    const PaperWaves atContact(q0);
    const Eigen::VectorXd x1 = contactMap(cells, phase.contact) * test::stacked(q0);
    const State q1{x1.head(cells), x1.tail(cells)};
    const PaperWaves atRelease(q1);
    const Inequalities kept = inequalities(schedule);
    REQUIRE(kept.pressure.rows() == phase.contact);
    REQUIRE(kept.penetration.rows() == phase.free);
    const Eigen::VectorXd pressure = kept.pressure * test::stacked(q0);
    const Eigen::VectorXd penetration = kept.penetration * test::stacked(q0);
    const auto L = static_cast<double>(cells);

    std::int64_t rows = 0;
    for (std::int64_t m = 0; m < phase.contact; ++m) {
        for (std::int64_t k = 0; k < cells; ++k, ++rows) {
            const double t = static_cast<double>(m) + (static_cast<double>(k) + 0.5) / L;
            const double strainAtTip = atContact.r2DD(L + t) - atContact.r1DD(L - t);
            CHECK(0.5 * strainAtTip == pressure[m]);
        }
    }
    // (11): the strain right after the last contact step, were contact to go on, is >= 0.
    const double t = static_cast<double>(phase.contact) + 0.5;
    const double strainAtRelease = atContact.r2DD(L + t) - atContact.r1DD(L - t);
    CHECK(-0.5 * strainAtRelease == penetration[0]);
    rows += cells;
    // (12): inside a step the integral of v(L) lies between its values at the ends of the step.
    double before = 0.0;
    for (std::int64_t m = 0; m < phase.free; ++m) {
        const double middle = static_cast<double>(m) + 0.5;
        const double v = atRelease.r1DN(L - middle) + atRelease.r2DN(L + middle);
        for (std::int64_t k = 1; k <= cells; ++k, ++rows) {
            const double share = static_cast<double>(k) / L;
            const double integral = before + 0.5 * v * share;
            const double between = (1.0 - share) * before + share * penetration[m];
            CHECK(integral == Approx(between).margin(1e-14));
        }
        before = penetration[m];
    }
    CHECK(rows == (phase.contact + 1 + phase.free) * cells);
}

TEST_CASE("equations: the penetration rows are prefix sums of the tip velocity, phase by phase")
{
    const Schedule schedule{3, {{1, 4}, {2, 7}}};
    const TipRows tip = tipRows(schedule);
    const Inequalities rows = inequalities(schedule);
    REQUIRE(tip.velocity.rows() == 11);
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(6);
    for (Eigen::Index k = 0; k < 11; ++k) {
        if (k == 4) {
            sum.setZero();
        }
        sum += dense(tip.velocity).row(k);
        CHECK(dense(rows.penetration).row(k) == sum);
        CHECK(dense(tip.velocity).row(k).cwiseAbs().sum() == 1.0);
    }
}

TEST_CASE("equations: sizes out of range are refused, not attempted")
{
    CHECK_THROWS_AS(extendedWaves(0), std::invalid_argument);
    CHECK_THROWS_AS(contactMap(3, -1), std::invalid_argument);
    CHECK_THROWS_AS(freeMap(3, -1), std::invalid_argument);
    CHECK_THROWS_AS(gapRow(maxEquationCells + 1), std::invalid_argument);
    CHECK_THROWS_AS(tipRows(test::onePhase(3, 1, 1'000'000'000)), std::invalid_argument);
    CHECK_THROWS_AS(inequalities(test::onePhase(100'000, 1, 100'000)), std::invalid_argument);
}
