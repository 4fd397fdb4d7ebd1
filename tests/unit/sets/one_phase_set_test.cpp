#include "signorini/one_phase_set.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "catch.hpp"
#include "equations.hpp"
#include "signorini/verification.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

TEST_CASE("one phase: the paper's case is a simplex of dimension 149 with E/E_1 in [4, 600]")
{
    const OnePhaseSet r = onePhaseSet(onePhase(300, 150, 900));
    CHECK_FALSE(r.reason);
    CHECK(r.kernelDimension == 150);
    CHECK(r.set.kind == SetKind::simplex);
    CHECK(r.set.dimension() == 149);
    CHECK(r.contact == Contact::pressing);
    CHECK(energyRange(r).least == 4.0);
    CHECK(energyRange(r).most == 600.0);
}

TEST_CASE("one phase: least energies known from theory")
{
    struct Known {
        std::int64_t cells, contact, free;
        double energy;
    };
    const auto known = GENERATE(values<Known>({{3, 1, 9, 18.0},
                                               {5, 1, 12, 25.0},
                                               {5, 3, 14, 6.25},
                                               {6, 1, 19, 36.0},
                                               {7, 3, 23, 3.92},
                                               {8, 5, 23, 16.0 / 3.0},
                                               {9, 3, 20, 81.0}}));
    const OnePhaseSet r = onePhaseSet(onePhase(known.cells, known.contact, known.free));
    INFO(known.cells << " " << known.contact << " " << known.free);
    REQUIRE_FALSE(r.reason);
    CHECK(r.contact == Contact::pressing);
    CHECK(energyRange(r).least == Approx(known.energy).epsilon(1e-14));
    CHECK(energyRatio(leastEnergyMotion(r)) == Approx(known.energy).epsilon(1e-14));
}

TEST_CASE("one phase: schedules known to have no motion, and why")
{
    CHECK(onePhaseSet(onePhase(2, 2, 4)).reason == Reason::gap);
    CHECK(onePhaseSet(onePhase(4, 2, 13)).reason == Reason::noLiveClass);
    CHECK(onePhaseSet(onePhase(3, 1, 8)).reason.has_value());
    CHECK(onePhaseSet(onePhase(40, 20, 109)).reason == Reason::noLiveClass);
}

TEST_CASE(
    "one phase: main branch E_min/E_1 = (N/(N - n_c))^2 = 1/(4 w_1/w - 3)^2 for every n_c < N")
{
    for (std::int64_t contact = 1; contact < 300; ++contact) {
        const Schedule schedule = onePhase(300, contact, 1200 - 2 * contact);
        const OnePhaseSet r = onePhaseSet(schedule);
        INFO("n_c = " << contact);
        REQUIRE_FALSE(r.reason);
        const double root = 300.0 / static_cast<double>(300 - contact);
        CHECK(energyRange(r).least == Approx(root * root).epsilon(1e-12));
        const double ratio = 4.0 / frequencyRatio(schedule) - 3.0;
        CHECK(energyRange(r).least == Approx(1.0 / (ratio * ratio)).epsilon(1e-12));
    }
}

TEST_CASE("one phase: E_min depends on the times only, E_max = d E_min grows with the grid")
{
    for (const std::int64_t factor : {1, 2, 7, 100}) {
        const OnePhaseSet r = onePhaseSet(onePhase(6 * factor, 3 * factor, 18 * factor));
        CHECK(energyRange(r).least == Approx(4.0).epsilon(1e-14));
        CHECK(energyRange(r).most ==
              Approx(4.0 * static_cast<double>(r.kernelDimension)).epsilon(1e-14));
    }
}

TEST_CASE("one phase: 7,900 schedules up to N = 10 give 451 motions, 154 pressing, 297 grazing")
{
    std::map<std::string, int> count;
    test::forAllSchedules(10, 3, [&](const Schedule& schedule) {
        const OnePhaseSet r = onePhaseSet(schedule);
        ++count[std::string(r.reason ? "none" : name(r.contact))];
    });
    CHECK(count["pressing"] == 154);
    CHECK(count["grazing"] == 297);
    CHECK(count["none"] == 7900 - 451);
}

TEST_CASE("one phase: the verdict alone agrees with the full set on every schedule N <= 8")
{
    std::vector<std::int8_t> signs;
    test::forAllSchedules(8, 3, [&signs](const Schedule& schedule) {
        const OnePhaseSet full = onePhaseSet(schedule);
        const Verdict verdict = decide(schedule.cells, schedule.phases.front(), signs);
        INFO(describe(schedule));
        REQUIRE(verdict.reason == full.reason);
        REQUIRE(verdict.kernelDimension == full.kernelDimension);
        REQUIRE(verdict.set.kind == full.set.kind);
        REQUIRE(verdict.set.count == full.set.count);
        REQUIRE(verdict.isCanonical() == full.isCanonical());
        if (!full.reason) {
            REQUIRE(verdict.contact == full.contact);
            REQUIRE(verdict.windowSum == full.windowSum);
            REQUIRE(energyRange(verdict).least == energyRange(full).least);
            REQUIRE(energyRange(verdict).most == energyRange(full).most);
            const Verification seen = verify(leastEnergyMotion(full), schedule);
            REQUIRE(verdict.isCanonical() == (seen.canonical == schedule.phases));
        }
    });
}

TEST_CASE("one phase: at N = 12, T <= 8 exactly 36 schedules press at every contact step")
{
    int pressing = 0;
    std::vector<std::int8_t> signs;
    for (std::int64_t contact = 1; contact <= 24; ++contact) {
        for (std::int64_t free = 1; contact + free <= 96; ++free) {
            pressing += decide(12, {contact, free}, signs).isCanonical() ? 1 : 0;
        }
    }
    CHECK(pressing == 36);
}

TEST_CASE("one phase: the kernel dimension is 2N - rank(W - 1)")
{
    test::forAllSchedules(4, 2, [](const Schedule& schedule) {
        const Eigen::Index size = 2 * schedule.cells;
        const Eigen::MatrixXd matrix =
            Eigen::MatrixXd(periodMap(schedule)) - Eigen::MatrixXd::Identity(size, size);
        INFO(describe(schedule));
        REQUIRE(onePhaseSet(schedule).kernelDimension ==
                size - Eigen::FullPivLU<Eigen::MatrixXd>(matrix).rank());
    });
}

TEST_CASE("one phase: every vertex of a simplex is a motion, a step beyond is none")
{
    const Schedule schedule = onePhase(12, 6, 36);
    const OnePhaseSet r = onePhaseSet(schedule);
    REQUIRE(r.set.kind == SetKind::simplex);
    for (std::size_t k = 0; k < 6; ++k) {
        std::vector<double> z(6, 0.0);
        z[k] = r.set.sum;
        CHECK(verify(motionOf(r, z), schedule).residuals.worst() < 1e-15);
        z[k] *= 1.01;
        z[(k + 1) % 6] -= 0.01 * r.set.sum;
        CHECK_THROWS_AS(motionOf(r, z), std::invalid_argument);
    }
}

TEST_CASE("one phase: grazing boxes with d near 2N hold motions at both ends")
{
    const Schedule schedule = onePhase(50, 1, 199);  // n = 4N: linear motion, d = 2N - 1
    const OnePhaseSet r = onePhaseSet(schedule);
    REQUIRE(r.contact == Contact::grazing);
    CHECK(r.set.kind == SetKind::box);
    CHECK(r.kernelDimension == 99);
    std::vector<double> jump(99, 0.0);
    jump[0] = r.set.lower;
    CHECK(verify(motionOf(r, jump), schedule).residuals.worst() < 1e-14);
    CHECK(verify(leastEnergyMotion(r), schedule).residuals.worst() < 1e-14);
    CHECK(verify(leastEnergyMotion(r), schedule).canonical.empty());
    jump[0] = r.set.lower * 1.01;
    jump[1] = -r.set.lower * 0.01;
    CHECK_THROWS_AS(motionOf(r, jump), std::invalid_argument);
}

TEST_CASE("one phase: feasible by one cell, infeasible by one cell")
{
    const std::int64_t cells = 1000;
    CHECK_FALSE(onePhaseSet(onePhase(cells, cells - 1, 4 * cells - 2 * (cells - 1))).reason);
    CHECK(onePhaseSet(onePhase(cells, cells, 2 * cells)).reason.has_value());
    CHECK(onePhaseSet(onePhase(cells, cells - 1, 4 * cells - 2 * (cells - 1) - 1)).reason ==
          Reason::gap);
    CHECK(onePhaseSet(onePhase(cells, cells - 1, 4 * cells - 2 * (cells - 1) + 2))
              .reason.has_value());
}

TEST_CASE("one phase: extremes answer at once and without overflow")
{
    SECTION("n_c = N - 1 at N = 10^5: E/E_1 = 10^10")
    {
        const OnePhaseSet r = onePhaseSet(onePhase(100'000, 99'999, 200'002));
        REQUIRE_FALSE(r.reason);
        CHECK(energyRange(r).least == Approx(1e10).epsilon(1e-12));
        CHECK(verify(leastEnergyMotion(r), onePhase(100'000, 99'999, 200'002)).residuals.worst() <
              1e-12);
    }
    SECTION("n_f = 10^9 and beyond at N = 1")
    {
        CHECK(onePhaseSet(onePhase(1, 1, 1'000'000'000)).reason.has_value());
        CHECK(onePhaseSet(onePhase(1, 1, 1'000'000'001)).reason.has_value());
        CHECK(onePhaseSet(onePhase(1, 1, maxSteps - 1)).signs.size() <= 12);
    }
    SECTION("n_f = 10^18 grazing: the motion is marched exactly")
    {
        const std::int64_t free = 4'000'000'000'000'000'000 - 1;
        const Schedule schedule = onePhase(2, 1, free);
        const OnePhaseSet r = onePhaseSet(schedule);
        REQUIRE_FALSE(r.reason);
        CHECK(verify(leastEnergyMotion(r), schedule).residuals.worst() < 1e-15);
    }
    SECTION("products beyond 32 bits")
    {
        const OnePhaseSet r = onePhaseSet(onePhase(50'000'000, 25'000'000, 150'000'000));
        CHECK(energyRange(r).least == Approx(4.0).epsilon(1e-14));
        CHECK(r.kernelDimension == 25'000'000);
    }
}

TEST_CASE("one phase: what it cannot do is refused")
{
    CHECK_THROWS_AS(onePhaseSet(Schedule{4, {{1, 10}, {1, 14}}}), std::invalid_argument);
    CHECK_THROWS_AS(onePhaseSet(onePhase(0, 1, 1)), std::invalid_argument);
    CHECK_THROWS_AS(energyRange(onePhaseSet(onePhase(2, 2, 4))), std::invalid_argument);
    CHECK_THROWS_AS(leastEnergyMotion(onePhaseSet(onePhase(2, 2, 4))), std::invalid_argument);
    CHECK_THROWS_AS(motionOf(onePhaseSet(onePhase(8, 5, 23)), std::vector{1.0}),
                    std::invalid_argument);
}

TEST_CASE("one phase: sums of epsilon are those of its signs, and 0 where nothing is live")
{
    OnePhaseSet r;
    int dead = 0;
    test::forAllSchedules(6, 3, [&](const Schedule& schedule) {
        onePhaseSet(schedule, r);  // used again: nothing may be left of the schedule before
        INFO(describe(schedule));
        REQUIRE(r.signs.size() == static_cast<std::size_t>(r.kernelDimension == 0 ? 0 : r.members));
        std::int64_t window = 0;
        for (std::int64_t block = 0; !r.signs.empty() && block < r.window; ++block) {
            window += r.signs[static_cast<std::size_t>(block % r.members)];
        }
        REQUIRE(r.windowSum == window);
        std::int64_t prefix = 0;
        std::int64_t worst = 0;
        std::int64_t where = -1;
        for (auto alpha = static_cast<std::size_t>(r.contactMembers); alpha < r.signs.size();
             ++alpha) {
            prefix += r.signs[alpha];
            where = prefix > worst ? static_cast<std::int64_t>(alpha) : where;
            worst = std::max(worst, prefix);
        }
        REQUIRE(r.worstPrefix == worst);
        REQUIRE(r.worstBlock == where);
        dead += r.kernelDimension == 0 ? 1 : 0;
    });
    CHECK(dead > 100);
}

TEST_CASE("one phase: a verdict that nobody has reached knows no motion")
{
    CHECK_THROWS_AS(energyRange(Verdict{}), std::invalid_argument);
    CHECK_THROWS_AS(motionOf(OnePhaseSet{}, {}), std::invalid_argument);
}
