#include <cmath>
#include <random>

#include "catch.hpp"
#include "has_solver.hpp"
#include "network_kernel.hpp"
#include "signorini/find_periodic.hpp"
#include "solver.hpp"
#include "stepped_oracle.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

FindOptions optionsFor(const std::vector<Segment>& segments,
                       Formulation formulation = Formulation::automatic)
{
    FindOptions options;
    options.scene.segments = segments;
    options.formulation = formulation;
    return options;
}

std::int64_t cellsOf(const std::vector<ExactSegment>& parts)
{
    std::int64_t cells = 0;
    for (const ExactSegment& part : parts) {
        cells += part.cells;
    }
    return cells;
}

/// 2..4 segments of 1..3 cells with impedances from 1/1000 to 1000, sometimes a dashpot.
std::vector<ExactSegment> randomParts(std::mt19937_64& generator)
{
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    std::vector<ExactSegment> parts;
    const std::int64_t count = draw(0, 3) == 0 ? draw(3, 4) : 2;
    for (std::int64_t k = 0; k < count; ++k) {
        ExactSegment part{draw(1, 3), 1, 1, 0};
        (draw(0, 1) == 0 ? part.numerator : part.denominator) =
            draw(0, 2) == 0 ? draw(1, 1000) : draw(1, 12);
        part.dashpot = k + 1 < count && draw(0, 9) == 0 ? draw(1, 20) : 0;
        parts.push_back(part);
    }
    return parts;
}

/// One schedule of the oracle's campaign: gaps of any sign, two stops, up to two phases.
struct Case {
    std::vector<ExactSegment> parts;
    Schedule schedule;
    Scene scene;
};

Case randomCase(std::mt19937_64& generator)
{
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    Case drawn{randomParts(generator), {}, {}};
    const std::int64_t cells = cellsOf(drawn.parts);
    drawn.schedule.cells = cells;
    drawn.scene.bar.gap = draw(0, 2) == 0 ? -1e-3 : 1e-3;
    if (draw(0, 3) == 0) {
        drawn.scene.secondStop = 1e-3 * static_cast<double>(draw(5, 8)) / 4.0;
    }
    const std::int64_t phases = draw(0, 3) == 0 ? 2 : 1;
    for (std::int64_t k = 0; k < phases; ++k) {
        const bool isLeft = drawn.scene.secondStop && k == 1;
        drawn.schedule.phases.push_back({draw(1, 2 * cells), draw(1, (phases == 1 ? 5 : 2) * cells),
                                         isLeft ? Stop::left : Stop::right});
    }
    drawn.scene.segments = segmentsOf(drawn.parts);
    drawn.schedule.stops = stopsOf(drawn.scene);
    return drawn;
}

/// Every verdict is right, and comes with what proves it.
void compareWithOracle(int count, unsigned seed)
{
    std::mt19937_64 generator(seed);
    int found = 0;
    int undecided = 0;
    for (int k = 0; k < count; ++k) {
        const Case drawn = randomCase(generator);
        FindOptions options;
        options.scene = drawn.scene;
        options.objective = Objective::any;
        options.formulation = Formulation::kernel;
        const PeriodicResult result = findPeriodic(drawn.schedule, options);
        INFO("case " << k << ": " << describe(drawn.schedule) << ", " << result.detail);
        if (result.status == Status::undecided) {
            ++undecided;
            continue;
        }
        const bool isThere = exists(drawn.parts, drawn.schedule);
        REQUIRE((result.status == Status::found) == isThere);
        CHECK((result.status == Status::found || isProof(result)));
        found += isThere ? 1 : 0;
    }
    CHECK(found > count / 100);
    CHECK(found < count / 2);
    CHECK(undecided <= 1 + count / 50);
    WARN(count << " schedules: " << found << " found, " << undecided << " undecided");
}

/// What became of schedules drawn at random.
struct Tally {
    int found = 0;
    int none = 0;
    int undecided = 0;
};

/// Two to four segments, impedances within a factor of 10, periods of three to four travel times.
Tally decideAtRealSize(std::mt19937_64& generator, std::int64_t cells, int count)
{
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    Tally tally;
    for (int k = 0; k < count; ++k) {
        std::vector<Segment> parts;
        std::int64_t left = cells;
        for (std::int64_t more = draw(1, 3); more >= 0; --more) {
            const std::int64_t size = more == 0 ? left : draw(1, left - more);
            const double power = std::uniform_real_distribution<double>(-0.5, 0.5)(generator);
            parts.push_back({.cells = size, .impedance = std::pow(10.0, power)});
            left -= size;
        }
        const std::int64_t steps = draw(3 * cells, 4 * cells);
        const std::int64_t contact = draw(1, steps - 1);
        const PeriodicResult result =
            findPeriodic(contact, steps - contact, cells, optionsFor(parts));
        INFO("case " << k << ": " << describe(result.schedule) << ": " << result.detail);
        CHECK((result.status != Status::none || isProof(result)));
        CHECK((result.status != Status::found || result.motion->residuals.worst() < 1e-7));
        tally.found += result.status == Status::found ? 1 : 0;
        tally.none += result.status == Status::none ? 1 : 0;
        tally.undecided += result.status == Status::undecided ? 1 : 0;
    }
    return tally;
}

void compareAtRealSize(int count, unsigned seed)
{
    std::mt19937_64 generator(seed);
    const Tally tally = decideAtRealSize(generator, 300, count);
    CHECK(100 * tally.undecided <= count);
    CHECK(tally.none > count / 2);
    WARN(count << " schedules: " << tally.found << " found, " << tally.undecided << " undecided");
}

}  // namespace

TEST_CASE("stepped: of two halves with impedances 1 and 1.3, forty schedules exist",
          "[glpk][ipopt]")
{
    const std::vector<Segment> halves{{.cells = 4}, {.cells = 4, .impedance = 1.3}};
    int found = 0;
    for (std::int64_t contact = 1; contact < 16; ++contact) {
        for (std::int64_t free = 1; free < 40; ++free) {
            const PeriodicResult result = findPeriodic(contact, free, 8, optionsFor(halves));
            INFO(contact << ", " << free << ": " << result.detail);
            REQUIRE(result.status != Status::undecided);
            if (result.status == Status::none) {
                CHECK(isProof(result));
                continue;
            }
            ++found;
            CHECK(result.motion->residuals.worst() < 1e-9);
            // det W = (-1)^n_c: one of the eigenvalues of an odd number of contact steps is 1.
            CHECK((contact % 2 == 0 || result.set.kernelDimension.value() % 2 == 1));
        }
    }
    CHECK(found == 40);
    const PeriodicResult wide = findPeriodic(3, 25, 8, optionsFor(halves));
    CHECK(wide.set.kernelDimension == 3);
    CHECK(wide.motion->energyRatio == Approx(15.807707).epsilon(1e-6));
    const PeriodicResult isolated = findPeriodic(1, 30, 8, optionsFor(halves));
    CHECK(isolated.set.kernelDimension == 1);
    CHECK(isolated.set.kind == SetKind::point);
    CHECK(isolated.motion->energyRatio == Approx(9.15).margin(0.005));
}

TEST_CASE("stepped: equal impedances give the verdicts, kernels and energies of the closed form",
          "[glpk][ipopt]")
{
    for (const auto& [left, right] : {std::pair<std::int64_t, std::int64_t>{1, 1},
                                      {1, 2},
                                      {2, 2},
                                      {1, 4},
                                      {3, 3},
                                      {5, 2},
                                      {4, 4},
                                      {3, 5}}) {
        const std::vector<Segment> parts{{.cells = left}, {.cells = right}};
        const std::int64_t cells = left + right;
        for (std::int64_t contact = 1; contact <= cells + 1; ++contact) {
            for (std::int64_t free = 1; free <= 4 * cells + 1; ++free) {
                const PeriodicResult exact = findPeriodic(contact, free, cells);
                const PeriodicResult result =
                    findPeriodic(contact, free, cells, optionsFor(parts, Formulation::kernel));
                INFO(left << " + " << right << ": " << contact << ", " << free << ": "
                          << result.detail);
                REQUIRE(result.status == exact.status);
                CHECK(result.set.kernelDimension == exact.set.kernelDimension);
                if (exact.motion) {
                    CHECK(result.motion->energyRatio ==
                          Approx(exact.motion->energyRatio).epsilon(1e-6));
                    CHECK(result.motion->physical.impulse ==
                          Approx(exact.motion->physical.impulse).epsilon(1e-6).margin(1e-9));
                    CHECK(result.motion->contact == exact.motion->contact);
                    CHECK(result.motion->repetitions == exact.motion->repetitions);
                } else {
                    CHECK(isProof(result));
                }
            }
        }
    }
}

TEST_CASE("stepped: equal segments without a formulation of their own are one bar")
{
    const std::vector<Segment> parts{{.cells = 100}, {.cells = 200}};
    const PeriodicResult result = findPeriodic(150, 900, 300, optionsFor(parts));
    CHECK(result.how.route == "closed-form");
    CHECK(result.scene.segments == parts);
    CHECK(result.motion->energyRatio == 4.0);
    CHECK_THROWS_WITH(findPeriodic(150, 900, 301, optionsFor(parts)),
                      containsText("cells of all segments = 300"));
}

TEST_CASE("stepped: random schedules of random bars are decided as exact linear programming does",
          "[glpk][ipopt]")
{
    compareWithOracle(120, 20);
}

TEST_CASE("stepped: ten thousand of them", "[.slow][glpk][ipopt]")
{
    compareWithOracle(10'000, 21);
}

TEST_CASE("stepped: kernels have the dimension that rational elimination finds")
{
    std::mt19937_64 generator(22);
    int open = 0;  // whose dimension rounding hides
    for (int k = 0; k < 60; ++k) {
        const Case drawn = randomCase(generator);
        const auto kernel = kernelOf<double>(
            NetworkBlocks(networkOf(drawn.scene, drawn.schedule.cells), spansOf(drawn.schedule)));
        INFO("case " << k << ": " << describe(drawn.schedule));
        REQUIRE(kernel);
        if (!kernel->isClear) {
            ++open;
            continue;
        }
        CHECK(kernel->dimension == kernelDimension(drawn.parts, drawn.schedule));
    }
    CHECK(open <= 2);
}

TEST_CASE("stepped: an odd number of contact steps always leaves a kernel where nothing damps")
{
    std::mt19937_64 generator(23);
    for (int k = 0; k < 100; ++k) {
        Case drawn = randomCase(generator);
        std::int64_t contact = 0;
        for (ExactSegment& part : drawn.parts) {
            part.dashpot = 0;
        }
        for (const Phase& phase : drawn.schedule.phases) {
            contact += phase.contact;
        }
        drawn.scene.segments = segmentsOf(drawn.parts);
        const auto kernel = kernelOf<double>(
            NetworkBlocks(networkOf(drawn.scene, drawn.schedule.cells), spansOf(drawn.schedule)));
        CHECK((!kernel || !kernel->isClear || contact % 2 == 0 || kernel->dimension % 2 == 1));
    }
}

TEST_CASE("stepped: a back end agrees on the least energy")
{
    if (!test::hasSolver("nlopt-slsqp")) {
        return;
    }
    const std::vector<Segment> parts{
        {.cells = 3}, {.cells = 1, .impedance = 0.2}, {.cells = 4, .impedance = 1.7}};
    int found = 0;
    for (std::int64_t contact = 1; contact < 9; contact += 2) {
        for (std::int64_t free = 20; free < 34; ++free) {
            FindOptions options = optionsFor(parts, Formulation::kernel);
            const PeriodicResult one = findPeriodic(contact, free, 8, options);
            if (one.status != Status::found) {
                continue;
            }
            ++found;
            options.solver = "nlopt-slsqp";
            const PeriodicResult other = findPeriodic(contact, free, 8, options);
            INFO(contact << ", " << free << ": " << other.detail);
            REQUIRE(other.motion);
            CHECK(other.motion->energyRatio == Approx(one.motion->energyRatio).epsilon(1e-6));
        }
    }
    CHECK(found >= 3);
}

TEST_CASE(
    "stepped: an energy is held, a tip floor kept, and the most impulse is at least the least",
    "[glpk][ipopt]")
{
    const std::vector<Segment> halves{{.cells = 4}, {.cells = 4, .impedance = 1.3}};
    FindOptions options = optionsFor(halves);
    const PeriodicResult least = findPeriodic(8, 24, 8, options);
    REQUIRE(least.motion);
    options.energyRatio = 2.0 * least.motion->energyRatio;
    const PeriodicResult held = findPeriodic(8, 24, 8, options);
    INFO(held.detail);
    REQUIRE(held.motion);
    CHECK(held.motion->energyRatio == Approx(*options.energyRatio).epsilon(1e-7));
    options.energyRatio = 0.5 * least.motion->energyRatio;
    const PeriodicResult below = findPeriodic(8, 24, 8, options);
    CHECK(below.status == Status::none);
    CHECK(below.absence->reason == Reason::constraints);
    CHECK(isProof(below));
    CHECK(std::get<EnergyFloorProof>(below.absence->proof).energyRatio ==
          Approx(least.motion->energyRatio).epsilon(1e-7));

    options = optionsFor(halves);
    options.objective = Objective::maxImpulse;
    const PeriodicResult most = findPeriodic(8, 24, 8, options);
    REQUIRE(most.motion);
    CHECK(most.motion->physical.impulse >= least.motion->physical.impulse * (1.0 - 1e-7));

    options = optionsFor(halves);
    const double lowest = least.motion->physical.tipLowest / options.scene.bar.gap;
    options.tipFloor = lowest - 0.5;
    CHECK(findPeriodic(8, 24, 8, options).status == Status::found);
    options.tipFloor = 0.5;
    const PeriodicResult none = findPeriodic(8, 24, 8, options);
    INFO(none.detail);
    CHECK(none.status == Status::none);
    CHECK(isProof(none));
}

TEST_CASE("stepped: a tip that hardly leaves the wall is lowest at it", "[glpk][ipopt]")
{
    // The flight's wave is 0 but for rounding, and rounding may say that it presses.
    for (const double impedance : {1.3, 2.0, 7.3, 11.0}) {
        FindOptions options = optionsFor({{.cells = 2}, {.cells = 2, .impedance = impedance}});
        options.scene.bar.gap = -1e-3;
        const PeriodicResult result = findPeriodic(7, 1, 4, options);
        INFO(impedance << ": " << result.detail);
        REQUIRE(result.motion);
        CHECK(result.motion->physical.tipLowest == Approx(-1e-3).epsilon(1e-9));
    }
}

TEST_CASE("stepped: where doubles cannot say it rationals do; a tampered proof is none",
          "[glpk][ipopt]")
{
    const std::vector<Segment> parts{{.cells = 5}, {.cells = 7, .impedance = 1e-6}};
    PeriodicResult none = findPeriodic(4, 31, 12, optionsFor(parts));
    REQUIRE(none.status == Status::none);
    REQUIRE(isProof(none));
    PeriodicResult other = none;
    other.scene.segments.back().impedance = 1e-5;
    CHECK_FALSE(isProof(other));
    other = none;
    other.schedule.phases.front().free = 30;
    CHECK_FALSE(isProof(other));
    other = none;
    auto& rows = std::get<SteppedProof>(other.absence->proof).multipliers.equalities;
    rows.front().value += "1";
    CHECK_FALSE(isProof(other));
    rows.front().value = "no number";
    CHECK_FALSE(isProof(other));
    rows.front().value = "1/0";
    CHECK_FALSE(isProof(other));
}

TEST_CASE("stepped: a tampered bound on the energy is none, and neither is one for another bar")
{
    const std::vector<Segment> parts{{.cells = 37}, {.cells = 63, .impedance = 2.3}};
    const PeriodicResult none = findPeriodic(40, 301, 100, optionsFor(parts));
    INFO(none.detail);
    REQUIRE(none.status == Status::none);
    REQUIRE(isProof(none));
    PeriodicResult other = none;
    other.scene.segments.back().impedance = 2.4;
    CHECK_FALSE(isProof(other));
    other = none;
    other.schedule.phases.front().free = 300;
    CHECK_FALSE(isProof(other));
    other = none;
    auto& proof = std::get<EnergyFloorProof>(other.absence->proof);
    CHECK(proof.energyRatio > 1e15);
    proof.energyRatio *= 1.01;
    CHECK_FALSE(isProof(other));
    proof.energyRatio = 1e8;  // it holds, and excludes nothing
    CHECK_FALSE(isProof(other));
    proof = std::get<EnergyFloorProof>(none.absence->proof);
    proof.multipliers.periodicity.front() += 1.0;
    CHECK_FALSE(isProof(other));
    proof.multipliers.periodicity.front() = std::nan("");
    CHECK_FALSE(isProof(other));
}

TEST_CASE("stepped: fine grids cost what their steps have in common", "[glpk][ipopt]")
{
    const std::vector<Segment> parts{{.cells = 150}, {.cells = 150, .impedance = 1.3}};
    const std::vector<Segment> coarse{{.cells = 1}, {.cells = 1, .impedance = 1.3}};
    const PeriodicResult fine = findPeriodic(150, 900, 300, optionsFor(parts));
    const PeriodicResult same = findPeriodic(1, 6, 2, optionsFor(coarse));
    CHECK(fine.status == same.status);
    const PeriodicResult shifted = findPeriodic(151, 899, 300, optionsFor(parts));
    CHECK(shifted.status != Status::undecided);
    for (std::int64_t contact = 100; contact <= 200; contact += 5) {
        const PeriodicResult result = findPeriodic(contact, 1050 - contact, 300, optionsFor(parts));
        INFO(contact << ": " << result.detail);
        CHECK(result.status != Status::undecided);
    }
}

TEST_CASE("stepped: impedances that differ by 10^6 leave motions of huge energies")
{
    // GLPK's pivots went in circles here; the exact program says that both exist.
    const std::vector<ExactSegment> parts{{4, 1, 1000, 0}, {3, 1000, 1, 0}};
    for (const std::int64_t free : {23, 27}) {
        const Schedule schedule{7, {{1, free}}};
        REQUIRE(exists(parts, schedule));
        const PeriodicResult result = findPeriodic(schedule, optionsFor(segmentsOf(parts)));
        INFO(free << ": " << result.detail);
        REQUIRE(result.motion);
        CHECK(result.motion->energyRatio > hugeEnergyRatio);
        CHECK(result.motion->residuals.worst() < 1e-7);
    }
}

TEST_CASE("stepped: impedances that are equal but for 1e-13 are not taken for equal ones")
{
    // With equal ones 7 waves repeat, and one of them grazes the wall: within rounding, not
    // exactly.
    const PeriodicResult result = findPeriodic(
        1, 15, 4,
        optionsFor({{.cells = 1}, {.cells = 1, .impedance = 1.0000000000001}, {.cells = 2}}));
    INFO(result.detail);
    const std::vector<ExactSegment> parts{
        {1, 1, 1, 0}, {1, 10000000000001, 10000000000000, 0}, {2, 1, 1, 0}};
    CHECK(result.set.kernelDimension == kernelDimension(parts, result.schedule));
    CHECK(result.status == (exists(parts, result.schedule) ? Status::found : Status::none));
    CHECK((result.status == Status::found || isProof(result)));
}

TEST_CASE(
    "stepped: the nearest motion is the target itself, if that is one, and else no other is nearer")
{
    if (!test::hasSolver("ipopt") && !test::hasSolver("nlopt-slsqp")) {
        return;
    }
    const std::vector<Segment> halves{{.cells = 4}, {.cells = 4, .impedance = 1.3}};
    FindOptions options = optionsFor(halves);
    const PeriodicResult least = findPeriodic(8, 24, 8, options);
    REQUIRE(least.motion);
    options.energyRatio = 3.0 * least.motion->energyRatio;
    const PeriodicResult other = findPeriodic(8, 24, 8, options);
    REQUIRE(other.motion);
    options.energyRatio.reset();
    options.objective = Objective::nearest;
    const auto distance = [&](const State& x, const State& y) {
        return std::sqrt(energyRatio(State{x.a - y.a, x.b - y.b}, halves));
    };
    options.target = other.motion->state;
    const PeriodicResult same = findPeriodic(8, 24, 8, options);
    INFO(same.detail);
    REQUIRE(same.motion);
    CHECK(distance(same.motion->state, other.motion->state) < 1e-9);
    // On the way from one motion to the other all are motions: none is nearer to a point aside.
    const State aside = randomState(8, 5U);
    options.target = aside;
    const PeriodicResult near = findPeriodic(8, 24, 8, options);
    REQUIRE(near.motion);
    const double shortest = distance(near.motion->state, aside);
    for (const State* end : {&least.motion->state, &other.motion->state}) {
        for (const double part : {0.001, 0.01, 0.1, 0.5, 1.0}) {
            const State& from = near.motion->state;
            const State on{from.a + part * (end->a - from.a), from.b + part * (end->b - from.b)};
            CHECK(distance(on, aside) >= shortest * (1.0 - 1e-12));
        }
    }
}

TEST_CASE("stepped: the most energy that is found of equal segments is that of the closed form")
{
    if (!test::hasSimplex()) {
        return;
    }
    FindOptions options = optionsFor({{.cells = 6}, {.cells = 6}});
    options.formulation = Formulation::kernel;
    options.objective = Objective::maxEnergy;
    FindOptions closed;
    closed.objective = Objective::maxEnergy;
    for (const auto& [contact, free] :
         std::vector<std::pair<int, int>>{{6, 36}, {1, 41}, {3, 39}}) {
        const PeriodicResult found = findPeriodic(contact, free, 12, options);
        const PeriodicResult known = findPeriodic(contact, free, 12, closed);
        REQUIRE(found.status == Status::found);
        CHECK(found.motion->energyRatio == Approx(known.motion->energyRatio));
    }
}

TEST_CASE("stepped: what is not known of such bars is refused in a sentence")
{
    const std::vector<Segment> halves{{.cells = 4}, {.cells = 4, .impedance = 1.3}};
    const auto find = [&](auto change) {
        FindOptions options = optionsFor(halves);
        change(options);
        return findPeriodic(8, 24, 8, options);
    };
    CHECK_THROWS_WITH(find([](auto& o) { o.solver = "closed-form"; }),
                      containsText("for a bar of several segments"));
    CHECK_THROWS_WITH(find([](auto& o) { o.formulation = Formulation::state; }),
                      containsText("formulation = state"));
    CHECK_THROWS_WITH(find([](auto& o) { o.scene.bar.gap = 0.0; }), containsText("gap = 0"));
    CHECK_THROWS_WITH(findPeriodic(8, 24, 9, optionsFor(halves)),
                      containsText("cells of all segments = 8"));
    FindOptions uniform;
    uniform.formulation = Formulation::kernel;
    CHECK_THROWS_WITH(findPeriodic(8, 24, 8, uniform), containsText("without segments"));
}

TEST_CASE("stepped: random bars of 300 cells are decided, each with what proves it", "[.slow]")
{
    compareAtRealSize(60, 26);
}

TEST_CASE("stepped: bars of 100 cells with two to four segments are decided")
{
    std::mt19937_64 generator(27);
    const auto tally = decideAtRealSize(generator, 100, 12);
    CHECK(tally.undecided == 0);
    CHECK(tally.none > 6);
}

TEST_CASE("stepped: impedances a thousandfold apart, and more blocks than rationals could bear")
{
    // A grid of two and one cells, Z_2/Z_1 = 1/2: only what rounds decided it before.
    const PeriodicResult two = findPeriodic(
        {3, {{2, 5}, {4, 3}}}, optionsFor({{.cells = 2}, {.cells = 1, .impedance = 0.5}}));
    INFO(two.detail);
    CHECK(two.status != Status::undecided);
    for (const double ratio : {1e-3, 1e3, 1e-6, 1e6}) {
        for (const std::int64_t contact : {1, 4, 5, 9}) {
            const PeriodicResult result = findPeriodic(
                contact, 31, 12, optionsFor({{.cells = 5}, {.cells = 7, .impedance = ratio}}));
            INFO(ratio << ", " << contact << ": " << result.detail);
            CHECK(result.status != Status::undecided);
            CHECK((result.status == Status::found || isProof(result)));
        }
    }
}
