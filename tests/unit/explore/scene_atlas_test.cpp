// Families, modes, atlas, continuum and simulation where the gap is negative or 0.

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "catch.hpp"
#include "signorini/atlas.hpp"
#include "signorini/continuum.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/modes.hpp"
#include "signorini/simulation.hpp"

using namespace signorini;

namespace {

const Bar pressed{.gap = -1e-3};

}  // namespace

TEST_CASE("gap <= 0: the tents of families are what deciding every schedule finds")
{
    const int gapSign = GENERATE(-1, 0);
    std::vector<std::int8_t> signs;
    for (std::int64_t cells = 1; cells <= 14; ++cells) {
        AtlasRange range = usualRange(cells);
        range.maxFree = 5 * cells + 3;
        range.maxContact = 5 * cells + 1;
        range.gapSign = gapSign;
        std::map<Phase, Verdict> listed;
        forEachSchedule(range, [&](const Phase& phase, const Verdict& verdict) {
            CHECK(listed.emplace(phase, verdict).second);
            return true;
        });
        std::size_t exist = 0;
        for (std::int64_t contact = 1; contact <= range.maxContact; ++contact) {
            for (std::int64_t free = 1; free <= range.maxFree; ++free) {
                const Phase phase{contact, free};
                const Verdict verdict = decide(cells, phase, signs, gapSign);
                INFO("N = " << cells << " (" << contact << ", " << free << ")");
                const Schedule schedule{cells, {phase}, {.right = gapSign}};
                const auto place = familyOf(schedule);
                REQUIRE(place.has_value() == !verdict.reason.has_value());
                REQUIRE(listed.contains(phase) == !verdict.reason.has_value());
                if (verdict.reason) {
                    continue;
                }
                ++exist;
                const Verdict& found = listed.at(phase);
                REQUIRE(found.set.kind == verdict.set.kind);
                REQUIRE(found.set.count == verdict.set.count);
                REQUIRE(found.set.sum == verdict.set.sum);
                REQUIRE(found.firstLive == verdict.firstLive);
                REQUIRE(found.members == verdict.members);
                REQUIRE(found.contactMembers == verdict.contactMembers);
                REQUIRE(found.isCanonical() == verdict.isCanonical());
                REQUIRE(place->amplitudes == verdict.kernelDimension);
                if (gapSign < 0) {
                    CHECK(energyRange(verdict).least ==
                          Approx(leastEnergy(place->family).value() *
                                 static_cast<double>(place->classes) /
                                 static_cast<double>(place->amplitudes)));
                }
            }
        }
        CHECK(exist == listed.size());
    }
}

TEST_CASE("gap <= 0: batches count families and the schedules that show them")
{
    const int gapSign = GENERATE(-1, 0);
    for (std::int64_t cells = 2; cells <= 12; ++cells) {
        AtlasRange range = usualRange(cells);
        range.gapSign = gapSign;
        range.keepsRefuted = true;
        std::map<Phase, std::int64_t> promised;
        std::map<Phase, std::int64_t> shown;
        AtlasTally tally;
        std::vector<std::int8_t> signs;
        for (std::int64_t batch = 0; batch < batchesOf(range); ++batch) {
            const auto done = decideBatch(range, batch, signs).value();
            tally += done.tally;
            for (const AtlasFamily& family : done.families) {
                CHECK(promised.emplace(family.top, family.schedules).second);
            }
            for (const AtlasRow& row : done.rows) {
                if (row.familyTop) {
                    ++shown[*row.familyTop];
                }
            }
        }
        INFO("N = " << cells);
        CHECK(promised == shown);
        CHECK(tally.decided == range.maxContact * range.maxFree);
        CHECK(tally.grazing == 0);
        CHECK(tally.families == static_cast<std::int64_t>(promised.size()));
    }
}

TEST_CASE("second stop: tents that stay clear of it and sums decide alike, schedule by schedule")
{
    const int gapSign = GENERATE(1, -1);
    std::vector<std::int8_t> signs;
    std::int64_t barred = 0;
    for (std::int64_t cells = 2; cells <= 7; ++cells) {
        for (const Fraction second :
             {Fraction{1, 1}, Fraction{6, 5}, Fraction{2, 1}, Fraction{5, 1}}) {
            if (gapSign < 0 && second == Fraction{1, 1}) {
                continue;
            }
            AtlasRange range = usualRange(cells);
            range.gapSign = gapSign;
            range.secondStop = second;
            range.keepsRefuted = true;
            AtlasTally tally;
            for (std::int64_t batch = 0; batch < batchesOf(range); ++batch) {
                const AtlasBatch done = decideBatch(range, batch, signs).value();
                tally += done.tally;
                for (const AtlasRow& row : done.rows) {
                    const Schedule schedule{cells, phasesAt(range, row.number), stopsOf(range)};
                    const LumpedSet set = lumpedSet(schedule);
                    INFO(describe(schedule) << " h " << second.value());
                    REQUIRE((row.status == Status::none) == set.absence.has_value());
                    if (row.status == Status::found) {
                        const LumpedShape shape = shapeOf(set);
                        REQUIRE(row.energy.least == Approx(shape.energy.least));
                        REQUIRE(row.dimension == shape.dimension);
                    } else if (!decide(cells, schedule.phases.front(), signs, gapSign).reason) {
                        barred += schedule.phases.front().stop == Stop::right ? 1 : 0;
                    }
                }
            }
            CHECK(tally.decided == 2 * range.maxContact * range.maxFree);
            CHECK(tally.undecided == 0);
        }
    }
    CHECK(barred > 10);
}

TEST_CASE("second stop: the lowest place of a family's tip is the same in all its motions")
{
    for (const int gapSign : {1, -1}) {
        for (const Family& family : findFamilies(12, {.gapSign = gapSign})) {
            const Fraction lowest = lowestTip(family, gapSign);
            for (const std::int64_t times : {1, 3}) {
                if (family.contactBlocks == family.blocks) {
                    continue;
                }
                const Schedule schedule = scheduleOf(family, times * family.order);
                const OnePhaseSet whole =
                    onePhaseSet({schedule.cells, schedule.phases, {.right = gapSign}});
                std::vector<double> spike(static_cast<std::size_t>(whole.set.count), 0.0);
                spike.front() = whole.set.sum;
                for (const State& state : {leastEnergyMotion(whole), motionOf(whole, spike)}) {
                    const Schedule walked{schedule.cells, schedule.phases, {.right = gapSign}};
                    CHECK(extremesOf(state, walked).lowestTip == Approx(lowest.value()));
                }
            }
            CHECK(staysClear(family, {gapSign, Fraction{100, 1}}));
        }
    }
    CHECK(lowestTip(*findFamily(4, 7, 1)) == Fraction{-2, 1});
    CHECK_THROWS_AS(lowestTip({2, 3, 1, 0}, 0), std::invalid_argument);
}

TEST_CASE("gap < 0: modes are the other side of the period of infinite energy")
{
    const auto other = findModes({.maxOrder = 25, .maxEnergyRatio = 1e9, .gapSign = -1});
    CHECK(other.size() > 10);
    for (const Mode& mode : other) {
        const auto usual = findMode(mode.a, mode.b);
        REQUIRE(usual);
        CHECK(usual->lowest == mode.highest);
        CHECK(mode.highestEnd == ModeEnd::energyInfinite);
        const double period = 0.5 * (mode.lowest.value() + mode.highest.value());
        const ModeMotion motion(mode, period);
        CHECK(motion.tipGap(0.0) == Approx(0.0).margin(1e-12));
        CHECK(motion.displacement(1.0, 0.0) == Approx(-1.0));
        for (int k = 0; k < 200; ++k) {
            CHECK(motion.tipGap(period * k / 200.0) >= -1e-12);
        }
        CHECK(4.0 * motion.amplitude() * motion.amplitude() == Approx(energyRatio(mode, period)));
    }
    CHECK_THROWS_WITH(findModes({.gapSign = 0}), containsText("no modes"));
}

TEST_CASE("gap < 0: families are the rational points of these modes, but for tips that stay")
{
    std::set<std::pair<std::int64_t, std::int64_t>> seen;
    for (const Family& family : findFamilies(40, {.gapSign = -1})) {
        if (family.contactBlocks == family.blocks) {
            CHECK(leastEnergy(family).value() == 1.0);
            CHECK_THROWS_AS(modeThrough(family), std::invalid_argument);
            continue;
        }
        const Mode mode = modeThrough(family);
        const double period = exactPeriod(family).value();
        CHECK(energyRatio(mode, period) == Approx(leastEnergy(family).value()));
        CHECK(4.0 * static_cast<double>(mode.a) + static_cast<double>(mode.b) * period ==
              Approx(longestContact(family).value()));
        seen.emplace(mode.a, mode.b);
    }
    CHECK(seen.size() > 5);
    for (const Family& family : findFamilies(40, {.gapSign = 0})) {
        CHECK(family.windowSum == 0);
        CHECK(familyOf(scheduleOf(family, 2 * family.order))->family == family);
    }
}

TEST_CASE("gap < 0: a continuum of one energy is traced and verified")
{
    FindOptions options;
    options.scene = pressed;
    std::optional<Schedule> found;
    for (const Family& family : findFamilies(8, {.gapSign = -1})) {
        if (family.contactBlocks < family.blocks && family.order == 6) {
            found = scheduleOf(family, 12);
        }
    }
    REQUIRE(found);
    const double least = findPeriodic(*found, options).set.energy->least;
    ContinuumOptions tracing;
    tracing.scene = pressed;
    tracing.points = 7;
    const Continuum curve = traceContinuum(*found, 1.7 * least, tracing);
    INFO(curve.detail);
    REQUIRE(curve.points.size() == 7);
    for (const ContinuumPoint& point : curve.points) {
        CHECK(point.energyRatio == Approx(1.7 * least));
        CHECK(verify(point.state, curve.schedule).residuals.worst() < 1e-9);
    }
}

TEST_CASE("scenes: a simulation knows nothing of schedules and repeats every motion")
{
    struct Case {
        Scene scene;
        Schedule schedule;
    };
    const Case cases[] = {
        {pressed, {4, {{1, 7}}}},
        {pressed, {4, {{5, 3}}}},
        {Scene(Bar{}, 1e-3), {4, {{1, 5}, {1, 5, Stop::left}}}},
        {Scene(Bar{}, 1e-3), {4, {{3, 2}, {3, 2, Stop::left}}}},
        {Scene(Bar{}, 1e-3), {4, {{2, 6}, {2, 6, Stop::left}}}},
        {Scene(Bar{.gap = 0.0}), {4, {{3, 7}}}},
    };
    for (const Case& each : cases) {
        INFO(describe(each.schedule));
        FindOptions options;
        options.scene = each.scene;
        if (each.scene.bar.gap == 0.0) {
            options.energyRatio = 1.0;
        }
        const PeriodicResult result = findPeriodic(each.schedule, options);
        REQUIRE(result.motion);
        const State& state = result.motion->state;
        BarSimulation simulation(wavesOf(state), {}, {.stepsPerCrossing = 4.0},
                                 {.stops = stopsOf(each.scene)});
        const auto n = static_cast<double>(steps(each.schedule));
        simulation.advance(50.0 * n);
        const Eigen::VectorXd now = stretching(simulation.waves(), 4);
        CHECK((now.tail(4) - displacement(state)).norm() < 1e-12);
        const double period = n / 4.0;
        const Extremes seen = extremesOf(state, result.schedule);
        CHECK(simulation.impulse() == Approx(50.0 * seen.impulse));
        CHECK(simulation.time() == Approx(50.0 * period));
        bool left = false;
        for (const ContactEvent& contact : simulation.contacts()) {
            left = left || contact.stop == Stop::left;
            CHECK(contact.peakForce <= seen.peakForce * (1.0 + 1e-12));
        }
        // Of a motion that only grazes its stops rounding decides whether they are met.
        if (result.motion->contact == Contact::pressing) {
            CHECK(left == each.scene.secondStop.has_value());
        }
    }
}

TEST_CASE(
    "scenes: a bar pressed at rest stays so, and one that is let go between two stops is held "
    "by both")
{
    const Stops stops = stopsOf(pressed);
    BarSimulation rest(wavesAtRest(8.0, stops), {}, {.stepsPerCrossing = 8.0}, {.stops = stops});
    rest.advance(8000.0);
    CHECK(rest.isHeld());
    CHECK(rest.tip() == -1.0);
    CHECK(rest.impulse() == Approx(1000.0));

    const Stops two = stopsOf(Scene(Bar{}, 1e-3));
    // A pulse that the stops never let through.
    Waves waves = wavesAtRest();
    waves.a = {{0.25, 3.0}, {0.25, -3.0}, {0.5, 0.0}};
    BarSimulation between(waves, {}, {}, {.mergeBelow = {}, .recordsTip = true, .stops = two});
    between.advance(200.0);
    double lowest = 0.0;
    double highest = 0.0;
    for (const TipPoint& point : between.tipPath()) {
        lowest = std::min(lowest, point.displacement);
        highest = std::max(highest, point.displacement);
    }
    CHECK(lowest == Approx(-1.0).epsilon(1e-9));
    CHECK(highest == Approx(1.0).epsilon(1e-9));
    CHECK(std::abs(between.balance().error) <= 1e-9 * between.balance().size);
    CHECK_THROWS_WITH(BarSimulation(wavesAtRest(), {}, {}, {.stops = stops}),
                      containsText("at most -1, the wall"));
}
