#include "signorini/verification.hpp"

#include <cmath>
#include <random>

#include "arrivals.hpp"
#include "catch.hpp"
#include "equations.hpp"
#include "signorini/demands.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/one_phase_set.hpp"
#include "stepped_waves.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

TEST_CASE("verification: residuals are those of the paper's matrices, for any state")
{
    const Schedule schedule =
        GENERATE(onePhase(4, 3, 13), onePhase(3, 9, 31), Schedule{4, {{1, 10}, {1, 14}}});
    const State state = test::randomState(schedule.cells, 9);
    const Eigen::VectorXd x = test::stacked(state);
    const Inequalities rows = inequalities(schedule);
    const Residuals r = verify(state, schedule).residuals;
    const double size = x.lpNorm<Eigen::Infinity>();
    const double half = 0.5 * static_cast<double>(schedule.cells);
    CHECK(r.periodicity == Approx((periodMap(schedule) * x - x).lpNorm<Eigen::Infinity>() / size));
    CHECK(r.pressure == Approx(std::max(0.0, (rows.pressure * x).maxCoeff()) / size));
    CHECK(r.penetration == Approx(std::max(0.0, (rows.penetration * x).maxCoeff()) / half));
    CHECK(r.gap >= std::abs((gapRow(schedule.cells) * x)[0] / (2.0 * half) - 1.0) - 1e-12);
}

TEST_CASE("verification: found motions leave residuals at rounding, and the march agrees")
{
    test::forAllSchedules(7, 3, [](const Schedule& schedule) {
        const OnePhaseSet r = onePhaseSet(schedule);
        if (!r.reason) {
            INFO(describe(schedule));
            const Verification v = verify(leastEnergyMotion(r), schedule);
            REQUIRE(v.residuals.worst() < 1e-15);
            REQUIRE(v.canonical.empty() == (r.contact == Contact::grazing));
        }
    });
}

TEST_CASE("verification: each violation shows in its own residual")
{
    const Schedule schedule = onePhase(8, 5, 23);
    const OnePhaseSet r = onePhaseSet(schedule);
    const State good = leastEnergyMotion(r);
    const auto scaledBy = [&good](double factor) {
        return State{factor * good.a, factor * good.b};
    };
    CHECK(verify(scaledBy(1.01), schedule).residuals.gap == Approx(0.01));
    CHECK(verify(scaledBy(-1.0), schedule).residuals.pressure == Approx(1.0));
    CHECK(verify(scaledBy(-1.0), schedule).residuals.penetration > 0.1);
    State broken = good;
    broken.a[0] += 0.5;
    CHECK(verify(broken, schedule).residuals.periodicity > 0.1);
    CHECK(verify(scaledBy(0.0), schedule).residuals.gap == 1.0);
}

TEST_CASE("verification: a state that is not finite never passes")
{
    State state = leastEnergyMotion(onePhaseSet(onePhase(8, 5, 23)));
    state.b[3] = GENERATE(std::nan(""), INFINITY);
    CHECK(std::isinf(verify(state, onePhase(8, 5, 23)).residuals.worst()));
    CHECK(std::isinf(march(state, 28).residual));
}

TEST_CASE("verification: the march finds the contact phases without being told")
{
    const Schedule schedule = onePhase(300, 150, 900);
    const March seen = march(leastEnergyMotion(onePhaseSet(schedule)), 1050);
    CHECK(seen.residual == 0.0);
    CHECK(seen.firstFault == -1);
    CHECK(seen.phases == schedule.phases);
}

TEST_CASE("verification: the canonical schedule leaves out contact steps without pressure")
{
    const Schedule schedule = onePhase(8, 5, 23);
    const OnePhaseSet r = onePhaseSet(schedule);
    REQUIRE(r.set.count == 3);
    std::vector<double> z(3, 0.0);
    z[1] = r.set.sum;
    const Verification v = verify(motionOf(r, z), schedule);
    CHECK(v.residuals.worst() < 1e-15);
    CHECK(v.canonical != schedule.phases);
    std::int64_t contact = 0;
    std::int64_t total = 0;
    for (const Phase& phase : v.canonical) {
        contact += phase.contact;
        total += phase.contact + phase.free;
    }
    CHECK(total == 28);
    CHECK(contact < 5);
    // The same motion solves the canonical schedule, started at its first pressed step.
    test::UniformWaves line(motionOf(r, z));
    line.contact(2);  // z[1] belongs to class 2, pressed first in step 2
    const Schedule canonical{8, v.canonical};
    CHECK(verify(line.state(), canonical).residuals.worst() < 1e-15);
    CHECK(verify(line.state(), canonical).canonical == v.canonical);
}

TEST_CASE("verification: a coarse tolerance never loses a motion")
{
    for (const double tolerance : {1e-2, 1e-7, 1e-12}) {
        for (std::int64_t contact = 1; contact < 300; ++contact) {
            const Schedule schedule = onePhase(300, contact, 1200 - 2 * contact);
            const Verification v =
                verify(leastEnergyMotion(onePhaseSet(schedule)), schedule, tolerance);
            INFO(describe(schedule) << ", tolerance " << tolerance);
            REQUIRE(v.residuals.worst() < 1e-12);
        }
    }
}

TEST_CASE("verification: a march over 10^6 periods returns exactly")
{
    const Schedule schedule = onePhase(5, 3, 14);
    const State start = leastEnergyMotion(onePhaseSet(schedule));
    const March seen = march(start, 17'000'000);
    CHECK(seen.residual == 0.0);
    CHECK(seen.firstFault == -1);
}

TEST_CASE("verification: a tip that would meet the wall inside a step is a fault")
{
    // At rest one cell away from the wall with a wave of 3 g per step on its way.
    const State state{Eigen::Vector2d{0.0, 3.0}, Eigen::Vector2d{0.0, 0.0}};
    const March seen = march(state, 10);
    CHECK(seen.firstFault == 0);
    CHECK(seen.residual > 0.1);
    CHECK(seen.phases.empty());
}

TEST_CASE("verification: wrong use is refused")
{
    CHECK_THROWS_AS(march(test::randomState(2), -1), std::invalid_argument);
    CHECK_THROWS_AS(verify(test::randomState(2), onePhase(3, 1, 1)), std::invalid_argument);
    CHECK_THROWS_AS(isProof({}, onePhase(0, 1, 1)), std::invalid_argument);
}

TEST_CASE("verification: the echo sends what the waves of single steps send, piece by piece")
{
    std::mt19937_64 generator(4);
    for (const std::int64_t cells : {1, 2, 7, 40}) {
        const State state = test::randomState(cells, 3);
        Echo echo(state);
        test::UniformWaves line(state);
        for (int piece = 0; piece < 400; ++piece) {
            const Arrivals next = echo.ahead(1 + static_cast<std::int64_t>(generator() % 13));
            const bool isContact = generator() % 2 == 0;
            double low = next.at(0);
            double high = low;
            double sum = 0.0;
            REQUIRE(next.count() >= 1);
            for (std::int64_t k = 0; k < next.count(); ++k) {
                REQUIRE(next.at(k) == line.arriving());
                low = std::min(low, next.at(k));
                high = std::max(high, next.at(k));
                sum += next.at(k);
                isContact ? line.contact() : line.free();
            }
            REQUIRE(next.low() == low);
            REQUIRE(next.high() == high);
            REQUIRE(next.sum().value() == Approx(sum).margin(1e-14));
            echo.advance(next.count(), isContact);
            const Eigen::VectorXd moved = test::stacked(line.state()) - test::stacked(state);
            REQUIRE(echo.distance() == moved.lpNorm<Eigen::Infinity>());
        }
    }
}

TEST_CASE("verification: beside the schedule or alone, the march sees the same")
{
    // Motions agree with their schedules; other states part from them, at once or later.
    for (const Schedule& schedule : {onePhase(2000, 1000, 6000), onePhase(8, 5, 23),
                                     onePhase(300, 700, 4000), Schedule{4, {{1, 12}, {3, 12}}}}) {
        const State other = test::randomState(schedule.cells, 5);
        std::vector<State> states{other, {0.01 * other.a, 0.01 * other.b}};
        if (schedule.phases.size() == 1 && !onePhaseSet(schedule).reason) {
            states.push_back(leastEnergyMotion(onePhaseSet(schedule)));
        }
        for (const State& state : states) {
            INFO(describe(schedule));
            const March alone = march(state, steps(schedule));
            const Verification seen = verify(state, schedule);
            CHECK(seen.residuals.march == alone.residual);
            CHECK((seen.repetitions > 1 || seen.canonical == alone.phases));
            CHECK(seen.peakStrain == extremesOf(state, schedule).peakCompression);
        }
    }
}

TEST_CASE("verification: the worst residual is the worst of all")
{
    for (double Residuals::*which :
         {&Residuals::periodicity, &Residuals::gap, &Residuals::pressure, &Residuals::penetration,
          &Residuals::march, &Residuals::demands}) {
        Residuals residuals;
        CHECK(residuals.worst() == 0.0);
        residuals.*which = 0.25;
        CHECK(residuals.worst() == 0.25);
    }
}

TEST_CASE("verification: no steps change nothing, and an exact motion is one without tolerance")
{
    const State state = test::randomState(5, 3);
    const March still = march(state, 0);
    CHECK(still.residual == 0.0);
    CHECK(still.phases.empty());

    const Schedule twice{8, {{5, 23}, {5, 23}}};
    const State motion = leastEnergyMotion(onePhaseSet(onePhase(8, 5, 23)));
    const Verification seen = verify(motion, twice, 0.0);
    CHECK(seen.repetitions == 2);
}

TEST_CASE("verification: equal contacts are one motion twice only if the state comes back")
{
    std::mt19937_64 draw(7);
    int once = 0;
    int twice = 0;
    test::forAllSchedules(9, 9, [&](const Schedule& single) {
        Schedule doubled = single;
        doubled.phases.push_back(single.phases.front());
        const LumpedSet set = lumpedSet(doubled);
        if (set.absence) {
            return;
        }
        INFO(describe(doubled));
        // Amplitudes of the same sums, all pressing: the contacts last equally long whatever they
        // are.
        std::vector<double> z(static_cast<std::size_t>(set.classes.classes), 0.0);
        for (std::size_t i = 0; i < set.live.size(); ++i) {
            const ClassType& type = set.classes.types[set.live[i]];
            double* const first = z.data() + type.first;
            double sum = 0.0;
            for (std::int64_t j = 0; j < type.count; ++j) {
                first[j] = type.kind == TypeKind::pressing
                               ? std::uniform_real_distribution<double>(0.5, 1.5)(draw)
                               : 1.0;
                sum += first[j];
            }
            for (std::int64_t j = 0; j < type.count; ++j) {
                first[j] *= set.leastSums[i] / sum;
            }
        }
        for (const State& state : {motionOf(set.classes, z), equalMotion(set, set.leastSums)}) {
            const bool returns = verify(state, single).residuals.worst() < 1e-12;
            const Verification seen = verify(state, doubled);
            REQUIRE(seen.residuals.worst() < 1e-12);
            REQUIRE(seen.repetitions % 2 == (returns ? 0 : 1));
            ++(returns ? twice : once);
        }
    });
    CHECK(once > 10);
    CHECK(twice > 20);
}

TEST_CASE("verification: what proves nothing is no proof")
{
    Schedule schedule = onePhase(4, 3, 13);
    CHECK_FALSE(isProof(FarkasCertificate{}, schedule));
    schedule.stops.right = 0;
    CHECK_FALSE(isProof(FarkasCertificate{}, schedule));

    // A proof beside one stop says nothing of two: there are rows with other right sides.
    const auto proof = [](const Schedule& asked) { return proveAbsence(onePhaseSet(asked)); };
    Schedule alone = onePhase(4, 3, 12);
    CHECK(isProof(proof(alone), alone));
    alone.stops.left = Fraction{3, 1};
    CHECK_FALSE(isProof(proof(onePhase(4, 3, 12)), alone));
}

TEST_CASE("verification: a motion whose second half mirrors the first exactly is symmetric")
{
    // N = 2 between stops at g and -g: p = 1, -1, -1 and then -1, 1, 1, a push at each stop.
    const State state{Eigen::Vector2d{-1.0, 1.0}, Eigen::Vector2d{1.0, 1.0}};
    Schedule schedule{2, {{1, 2}, {1, 2, Stop::left}}};
    schedule.stops.left = Fraction{1, 1};
    const Verification seen = verify(state, schedule, 0.0);
    CHECK(seen.residuals.worst() == 0.0);
    CHECK(seen.canonical == schedule.phases);
    CHECK(seen.isSymmetric);

    State other = state;
    other.a[0] += 0.25;
    CHECK_FALSE(verify(other, schedule, 0.0).isSymmetric);
}
