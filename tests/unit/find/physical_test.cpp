#include <cmath>
#include <numeric>

#include "catch.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

/// What can be seen of the field alone, sampled at every cell and instant of a grid twice as fine:
/// there every p stands alone at the clamp for a moment.
Extremes sampled(const State& state, const Schedule& schedule)
{
    Schedule fine{2 * schedule.cells, schedule.phases};
    for (Phase& phase : fine.phases) {
        phase = {2 * phase.contact, 2 * phase.free};
    }
    const Motion motion(refined(state, 2), fine);
    const std::int64_t cells = fine.cells;
    const double dt = 1.0 / static_cast<double>(cells);
    Extremes seen{.period = dt * static_cast<double>(motion.steps()), .lowestTip = 1.0};
    double momentum = 0.0;
    for (std::int64_t m = 0; m < motion.steps(); ++m) {
        for (std::int64_t i = 1; i <= cells; ++i) {
            seen.peakCompression = std::max(seen.peakCompression, -motion.strain(i, m));
            seen.peakTension = std::max(seen.peakTension, motion.strain(i, m));
        }
        // Over a period the bar keeps its momentum: what the wall gives, the clamp takes.
        momentum += dt * -motion.strain(1, m);
        const double before = motion.displacement(cells, m);
        const double after = motion.displacement(cells, m + 1);
        seen.lowestTip = std::min(seen.lowestTip, after);
        if (after > 1.0 - 1e-9 && before < 1.0 - 1e-9) {
            seen.approachSpeed = std::max(seen.approachSpeed, (after - before) / dt);
        }
        // A tip held at the wall sends back what arrives; the last cell sees both in turn.
        const double force = motion.wallForce(m);
        seen.peakForce = std::max(seen.peakForce, force);
        if (force > 1e-9) {
            seen.contactTime += dt;
            CHECK(before == Approx(1.0));
            CHECK(after == Approx(1.0));
        }
    }
    seen.impulse = momentum;
    return seen;
}

/// The least number of steps after which the waves repeat, from the law p_{m+2N} = +-p_m alone.
std::int64_t leastPeriod(const State& state, const Schedule& schedule)
{
    std::vector<double> p;
    for (std::int64_t i = schedule.cells; i-- > 0;) {
        p.push_back(state.a[i]);
    }
    for (const double b : state.b) {
        p.push_back(-b);
    }
    const std::int64_t n = steps(schedule);
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t k = 0; k < phase.contact + phase.free; ++k) {
            const double echo = p[p.size() - static_cast<std::size_t>(2 * schedule.cells)];
            p.push_back(k < phase.contact ? echo : -echo);
        }
    }
    for (std::int64_t d = 1; d < n; ++d) {
        bool repeats = n % d == 0;
        for (std::int64_t m = 0; repeats && m < n; ++m) {
            repeats = std::abs(p[static_cast<std::size_t>(m)] -
                               p[static_cast<std::size_t>((m + d) % n)]) < 1e-9;
        }
        if (repeats) {
            return d;
        }
    }
    return n;
}

}  // namespace

TEST_CASE("physical: extremes are those of the sampled field")
{
    const Schedule schedule =
        GENERATE(onePhase(10, 5, 30), onePhase(12, 4, 38), onePhase(8, 1, 31), onePhase(20, 1, 79),
                 onePhase(14, 12, 32), Schedule{4, {{1, 12}, {3, 12}}},
                 Schedule{10, {{2, 3}, {1, 29}}}, Schedule{4, {{1, 12}, {3, 12}}});
    const PeriodicResult found = findPeriodic(schedule);
    REQUIRE(found.motion);
    test::checkEqual(extremesOf(found.motion->state, schedule),
                     sampled(found.motion->state, schedule));
    if (const auto& set = found.set.amplitudes; set && found.motion->contact == Contact::pressing) {
        std::mt19937_64 generator(7);
        for (int k = 0; k < 5; ++k) {
            const State state = motionOf(onePhaseSet(schedule), drawAmplitudes(*set, generator));
            test::checkEqual(extremesOf(state, schedule), sampled(state, schedule));
        }
    }
}

TEST_CASE("physical: a mode at a rational period is the motion of a grid")
{
    for (const Mode& mode : findModes({.maxOrder = 9})) {
        for (const std::int64_t cells : {7, 12, 30}) {
            // lowest < n/N < highest, in whole numbers.
            const std::int64_t first = cells * mode.lowest.numerator / mode.lowest.denominator + 1;
            for (std::int64_t n = first;
                 n * mode.highest.denominator < cells * mode.highest.numerator; ++n) {
                const Schedule schedule = scheduleOf(mode, cells, n);
                const ModeMotion motion(mode, period(schedule));
                CAPTURE(mode.a, mode.b, cells, n);
                test::checkEqual(extremesOf(leastEnergyMotion(onePhaseSet(schedule)), schedule),
                                 motion.extremes(), 1e-9);
            }
        }
    }
}

TEST_CASE("physical: extremes of a mode are those of its sampled field at any period")
{
    for (const Mode& mode : findModes({.maxOrder = 7})) {
        const double t =
            mode.lowest.value() + 0.6180339887 * (mode.highest.value() - mode.lowest.value());
        const ModeMotion motion(mode, t);
        const Extremes claimed = motion.extremes();
        constexpr int samples = 20000;
        Extremes seen{.period = t, .lowestTip = 1.0};
        for (int k = 0; k < samples; ++k) {
            const double now = t * (k + 0.5) / samples;
            seen.peakForce = std::max(seen.peakForce, motion.wallForce(now));
            seen.impulse += motion.wallForce(now) * t / samples;
            seen.contactTime += motion.wallForce(now) > 0.0 ? t / samples : 0.0;
            seen.peakCompression = std::max(seen.peakCompression, -motion.strain(0.0, now));
            seen.peakTension = std::max(seen.peakTension, motion.strain(0.0, now));
            seen.lowestTip = std::min(seen.lowestTip, motion.displacement(1.0, now));
        }
        // The last moment of flight, in which the tip comes back.
        const double eps = 1e-7 * t;
        seen.approachSpeed =
            (motion.displacement(1.0, t - eps) - motion.displacement(1.0, t - 2.0 * eps)) / eps;
        CAPTURE(mode.a, mode.b);
        test::checkEqual(claimed, seen, 2e-3 * (1.0 + motion.amplitude()));
    }
}

TEST_CASE("physical: SI units, for a bar of steel")
{
    const Bar steel = barOfMaterial(2.0, 210e9, 7800.0, 1e-4, 1e-5);
    const PeriodicResult found = findPeriodic(150, 900, 300, {.scene = steel});
    REQUIRE(found.motion);
    const Physical& p = found.motion->physical;
    // 4 E_1: p = +-1, so strains are 2 g/L, the force 2 EA g/L, speeds 2 c g/L; the tip goes back
    // by t_c = 1/2 of a flight at that speed.
    const double c = std::sqrt(210e9 / 7800.0);
    const double strain = 2.0 * 1e-5 / 2.0;
    CHECK(p.frequency == Approx(c / (3.5 * 2.0)));
    CHECK(p.contactTime == Approx(0.5 * 2.0 / c));
    CHECK(p.peakForce == Approx(210e9 * 1e-4 * strain));
    CHECK(p.impulse == Approx(p.peakForce * p.contactTime));
    CHECK(p.approachSpeed == Approx(c * strain));
    CHECK(p.peakCompression == Approx(strain));
    CHECK(p.peakTension == Approx(strain));
    REQUIRE(p.peakStress);
    CHECK(*p.peakStress == Approx(210e9 * strain));
    CHECK(p.isAdmissible());
    CHECK_FALSE(findPeriodic(150, 900, 300, {.scene = Bar{}}).motion->physical.peakStress);
    CHECK_FALSE(
        findPeriodic(150, 900, 300, {.scene = Bar{.gap = 0.51}}).motion->physical.isAdmissible());
    CHECK(findPeriodic(150, 900, 300, {.scene = Bar{.gap = 0.49}}).motion->physical.isAdmissible());
}

TEST_CASE("physical: a motion that repeats within the schedule has its own frequency")
{
    std::mt19937_64 generator(3);
    std::int64_t repeating = 0;
    test::forAllSchedules(5, 3, [&](const Schedule& schedule) {
        const OnePhaseSet whole = onePhaseSet(schedule);
        if (whole.reason) {
            return;
        }
        for (int k = 0; k < 3; ++k) {
            const State state = k == 0   ? leastEnergyMotion(whole)
                                : k == 1 ? motionOf(whole, mostAmplitudes(whole.set))
                                         : motionOf(whole, drawAmplitudes(whole.set, generator));
            const std::int64_t own = leastPeriod(state, schedule);
            CAPTURE(describe(schedule), k);
            REQUIRE(verify(state, schedule).repetitions == steps(schedule) / own);
            repeating += own < steps(schedule) ? 1 : 0;
            if (k == 0) {
                const PeriodicResult found = findPeriodic(schedule);
                CHECK(found.motion->repetitions == steps(schedule) / own);
                CHECK(found.motion->physical.frequency ==
                      Approx(static_cast<double>(schedule.cells) / static_cast<double>(own)));
            }
        }
    });
    CHECK(repeating > 50);
    // A member that is antiperiodic sooner: its three parts are of one shape.
    const Schedule schedule = onePhase(9, 1, 35);
    const OnePhaseSet whole = onePhaseSet(schedule);
    REQUIRE(whole.contact == Contact::grazing);
    std::vector<double> z(17);
    for (std::size_t j = 0; j < z.size(); ++j) {
        z[j] = j % 6 < 5 ? (j / 6 % 2 == 0 ? -1.8 : 1.8) : 0.0;
    }
    const State state = motionOf(whole, z);
    CHECK(leastPeriod(state, schedule) == 12);
    CHECK(verify(state, schedule).repetitions == 3);
    CHECK(findPeriodic(1, 1'000'000'000'000'000'007, 1).motion->repetitions ==
          1'000'000'000'000'000'008 / 4);
}
