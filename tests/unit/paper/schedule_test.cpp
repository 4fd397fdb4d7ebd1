#include "signorini/schedule.hpp"

#include <limits>

#include "catch.hpp"
#include "equations.hpp"
#include "support.hpp"

using namespace signorini;

TEST_CASE("schedule: the paper's case has T = 3.5 L/c and omega = 8/7 omega_1")
{
    const Schedule schedule = test::onePhase(300, 150, 900);
    CHECK(steps(schedule) == 1050);
    CHECK(period(schedule) == 3.5);
    CHECK(frequencyRatio(schedule) == Approx(8.0 / 7.0).epsilon(1e-15));
}

TEST_CASE("schedule: a phase of zero or negative steps is refused")
{
    CHECK_THROWS_WITH(validate(test::onePhase(3, 0, 5)),
                      containsText("contact steps of phase 1 = 0") && containsText("allowed 1.."));
    CHECK_THROWS_WITH(validate(test::onePhase(3, 5, -2)),
                      containsText("free steps of phase 1 = -2"));
    CHECK_THROWS_WITH(validate(Schedule{3, {{1, 1}, {1, 0}}}), containsText("phase 2"));
    CHECK_THROWS_WITH(validate(Schedule{3, {}}), containsText("phases"));
}

TEST_CASE("schedule: cells out of range are refused")
{
    CHECK_THROWS_WITH(validate(test::onePhase(0, 1, 1)), containsText("cells = 0"));
    CHECK_THROWS_WITH(validate(test::onePhase(maxCells + 1, 1, 1)), containsText("cells"));
    CHECK_NOTHROW(validate(test::onePhase(maxCells, 1, 1)));
}

TEST_CASE("schedule: a sum beyond 2^62 is refused, not wrapped")
{
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    CHECK_THROWS_AS(validate(test::onePhase(3, most, most)), std::invalid_argument);
    CHECK_THROWS_WITH(validate(test::onePhase(3, maxSteps, 1)), containsText("sum of all steps"));
    CHECK_NOTHROW(validate(test::onePhase(3, 1, maxSteps - 1)));
}

TEST_CASE("schedule: folding keeps W and the set of rows of (32)")
{
    const auto rowSet = [](const SparseMatrix& rows) {
        std::vector<std::vector<double>> set;
        for (Eigen::Index k = 0; k < rows.rows(); ++k) {
            const Eigen::VectorXd dense = rows.row(k).transpose();
            set.emplace_back(dense.data(), dense.data() + dense.size());
        }
        std::sort(set.begin(), set.end());
        set.erase(std::unique(set.begin(), set.end()), set.end());
        return set;
    };
    for (std::int64_t cells = 1; cells <= 3; ++cells) {
        for (std::int64_t contact = 1; contact <= 7 * cells; contact += 2) {
            for (std::int64_t free = 1; free <= 14 * cells; ++free) {
                const Schedule original = test::onePhase(cells, contact, free);
                Schedule shorter = original;
                fold(shorter);
                INFO(describe(original));
                REQUIRE(shorter.phases[0].contact < 4 * cells);
                REQUIRE(shorter.phases[0].free < 8 * cells);
                REQUIRE((periodMap(original) - periodMap(shorter)).norm() == 0.0);
                const Inequalities all = inequalities(original);
                const Inequalities kept = inequalities(shorter);
                REQUIRE(rowSet(all.pressure) == rowSet(kept.pressure));
                REQUIRE(rowSet(all.penetration) == rowSet(kept.penetration));
            }
        }
    }
}

TEST_CASE("schedule: descriptions name cells and phases, and abridge long lists")
{
    CHECK(describe(test::onePhase(300, 150, 900)) == "N = 300, (150, 900)");
    const Schedule many{2, std::vector<Phase>(20, Phase{1, 2})};
    CHECK_THAT(describe(many), containsText("20 phases in all"));
}
