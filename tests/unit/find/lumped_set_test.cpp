#include "signorini/lumped_set.hpp"
#include "infeasibility.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "formulation.hpp"
#include "lumped_proof.hpp"
#include "lumped_support.hpp"
#include "sanitized.hpp"
#include "scene_oracle.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/verification.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using test::feasibleSchedule;
using test::hasSolver;
using test::nearMultiples;
using test::onePhase;

namespace {

bool isProvedEmpty(const LumpedSet& set, const Schedule& schedule)
{
    const Program program = formulate(schedule, Formulation::lumped).program;
    return isProof(proofOf(set, program), program);
}

double seconds(std::chrono::steady_clock::time_point since)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

struct KnownPoint {
    Schedule schedule;
    double leastEnergy;
};

/// Motions of least energy that press in every phase.
const std::vector<KnownPoint>& knownPoints()
{
    static const std::vector<KnownPoint> points{
        {{4, {{1, 10}, {1, 14}}}, 16.0},       {{4, {{1, 12}, {1, 14}}}, 8.0},
        {{4, {{1, 12}, {3, 12}}}, 16.0 / 3.0}, {{4, {{1, 13}, {2, 12}}}, 6.0},
        {{4, {{2, 12}, {3, 11}}}, 6.0},        {{5, {{1, 1}, {1, 13}}}, 50.0}};
    return points;
}

}  // namespace

TEST_CASE("lumped set: one phase gives the closed form's verdict, set and energies")
{
    int found = 0;
    test::forAllSchedules(8, 2, [&found](const Schedule& schedule) {
        const OnePhaseSet r = onePhaseSet(schedule);
        const LumpedSet set = lumpedSet(schedule);
        INFO(describe(schedule));
        REQUIRE(set.absence.has_value() == r.reason.has_value());
        if (set.absence) {
            REQUIRE(isProvedEmpty(set, schedule));
            return;
        }
        ++found;
        const LumpedShape shape = shapeOf(set);
        REQUIRE(shape.kind == r.set.kind);
        REQUIRE(shape.dimension == r.set.dimension());
        REQUIRE(shape.energy.least == Approx(energyRange(r).least).epsilon(1e-14));
        REQUIRE(shape.energy.most == Approx(energyRange(r).most).epsilon(1e-14));
        const AmplitudeSet amplitudes = amplitudesAt(set, set.leastSums, 0);
        REQUIRE(amplitudes.sum == r.set.sum);
        if (shape.kind == SetKind::box) {
            REQUIRE(amplitudes.lower == r.set.lower);
            REQUIRE(amplitudes.upper == r.set.upper);
        }
        REQUIRE(equalMotion(set, set.leastSums) == leastEnergyMotion(r));
    });
    CHECK(found > 200);
}

TEST_CASE("lumped set: 24,000 random schedules agree with an LP on the paper's own rows", "[glpk]")
{
    const auto solver = makeSolver("glpk-simplex");
    std::mt19937_64 generator(2026);
    int found = 0;
    int several = 0;
    for (int trial = 0; trial < test::drawn(24'000); ++trial) {
        const Schedule schedule = trial % 2 == 0 ? test::randomSchedule(generator, 10, 4)
                                                 : nearMultiples(generator, 10, 4);
        INFO(describe(schedule));
        const LumpedSet set = lumpedSet(schedule);
        const SolverStatus witness =
            solver->solve(formulate(schedule, Formulation::state).program).status;
        REQUIRE((witness == SolverStatus::optimal || witness == SolverStatus::infeasible));
        REQUIRE(set.absence.has_value() == (witness == SolverStatus::infeasible));
        if (set.absence) {
            REQUIRE(isProvedEmpty(set, schedule));
            continue;
        }
        const State state = equalMotion(set, set.leastSums);
        REQUIRE(verify(state, schedule).residuals.worst() < 1e-13);
        REQUIRE(energyRatio(state) == Approx(set.leastEnergy).epsilon(1e-13));
        ++found;
        several += schedule.phases.size() > 1 ? 1 : 0;
    }
    CHECK(found > test::drawn(2000));
    CHECK(several > test::drawn(1000));
}

TEST_CASE("lumped set: known points of two phases, pressing in each")
{
    for (const KnownPoint& known : knownPoints()) {
        const PeriodicResult result = findPeriodic(known.schedule);
        INFO(describe(known.schedule) << " " << result.detail);
        REQUIRE(result.status == Status::found);
        CHECK(result.motion->energyRatio == Approx(known.leastEnergy).epsilon(1e-14));
        CHECK(result.set.energy->least == Approx(known.leastEnergy).epsilon(1e-15));
        CHECK(result.motion->pressing == std::vector<bool>{true, true});
        CHECK(result.motion->residuals.worst() < 1e-15);
        CHECK(result.how.route == "lumped");
        if (hasSolver("ipopt")) {
            const PeriodicResult witness =
                findPeriodic(known.schedule, {.solver = "ipopt",
                                              .formulation = Formulation::state,
                                              .objective = Objective::minEnergy});
            CHECK(witness.motion->energyRatio == Approx(known.leastEnergy).epsilon(1e-6));
        }
    }
}

TEST_CASE("lumped set: the least energy is that of a quadratic program", "[ipopt]")
{
    const auto solver = makeSolver("ipopt");
    std::mt19937_64 generator(8);
    for (int trial = 0; trial < 200; ++trial) {
        const Schedule schedule = feasibleSchedule(generator, 10, trial);
        const LumpedSet set = lumpedSet(schedule);
        const Formulated posed =
            pose(schedule, {.objective = Objective::minEnergy}, Formulation::reduced);
        const SolverResult result = solver->solve(posed.program, {.tolerance = 1e-10});
        INFO(describe(schedule) << " " << result.detail);
        REQUIRE(result.status == SolverStatus::optimal);
        REQUIRE(energyRatio(stateOf(posed, result.x)) == Approx(set.leastEnergy).epsilon(1e-6));
    }
}

TEST_CASE("lumped set: random members are motions within the energy range")
{
    std::mt19937_64 generator(77);
    int boxes = 0;
    int polytopes = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const Schedule schedule = feasibleSchedule(generator, 12, trial);
        const LumpedSet set = lumpedSet(schedule);
        const LumpedShape shape = shapeOf(set);
        INFO(describe(schedule));
        REQUIRE(static_cast<std::int64_t>(shape.spanning.size()) <= shape.dimension + 1);
        for (int draw = 0; draw < 3; ++draw) {
            const State state = drawMotion(set, shape, generator);
            REQUIRE(verify(state, schedule).residuals.worst() < 1e-12);
            const double energy = energyRatio(state);
            REQUIRE(energy >= shape.energy.least * (1.0 - 1e-12));
            REQUIRE_FALSE(energy > shape.energy.most * (1.0 + 1e-12));
        }
        boxes += shape.kind == SetKind::box ? 1 : 0;
        polytopes += shape.kind == SetKind::polytope ? 1 : 0;
    }
    CHECK(boxes > 10);
    CHECK(polytopes > 10);
}

TEST_CASE("lumped set: the most energy is reached, at a vertex with each sum in one class")
{
    std::mt19937_64 generator(5);
    for (int trial = 0; trial < 600; ++trial) {
        const Schedule schedule = feasibleSchedule(generator, 10, trial);
        const LumpedSet set = lumpedSet(schedule);
        const LumpedShape shape = shapeOf(set);
        INFO(describe(schedule));
        REQUIRE(shape.isBounded);
        REQUIRE(std::isfinite(shape.energy.most));
        const State state = mostEnergyMotion(set, shape);
        REQUIRE(verify(state, schedule).residuals.worst() < 1e-12);
        REQUIRE(energyRatio(state) == Approx(shape.energy.most).epsilon(1e-12));
    }
}

TEST_CASE("lumped set: reasons for absence of several phases, each with a proof")
{
    const auto reasonOf = [](const Schedule& schedule) {
        const PeriodicResult result = findPeriodic(schedule);
        REQUIRE(result.status == Status::none);
        CHECK(std::get<ProgramProof>(result.absence->proof).rows == Formulation::lumped);
        CHECK(isProof(result));
        CHECK(result.set.kind == SetKind::empty);
        return result.absence->reason;
    };
    CHECK(reasonOf({4, {{1, 1}, {1, 1}}}) == Reason::gap);
    CHECK(reasonOf({40, {{20, 109}, {20, 110}}}) == Reason::noLiveClass);
    std::mt19937_64 generator(3);
    std::vector<int> seen(4, 0);
    for (int trial = 0; trial < 3000; ++trial) {
        Schedule schedule = test::randomSchedule(generator, 8, 3);
        schedule.phases.push_back({1, 2});
        if (lumpedSet(schedule).absence) {
            ++seen.at(static_cast<std::size_t>(reasonOf(schedule)));
        }
    }
    for (const int count : seen) {
        CHECK(count > 0);
    }
}

TEST_CASE("lumped set: a motion told twice is recognised")
{
    const PeriodicResult twice = findPeriodic(Schedule{3, {{1, 9}, {1, 9}}});
    CHECK(twice.motion->canonical == std::vector<Phase>{{1, 9}});
    CHECK(twice.motion->repetitions == 2);
    const PeriodicResult thrice = findPeriodic(Schedule{3, {{1, 9}, {1, 9}, {1, 9}}});
    CHECK(thrice.motion->canonical == std::vector<Phase>{{1, 9}});
    CHECK(thrice.motion->repetitions == 3);
    const PeriodicResult pairs = findPeriodic(Schedule{4, {{1, 12}, {3, 12}, {1, 12}, {3, 12}}});
    CHECK(pairs.motion->canonical == std::vector<Phase>{{1, 12}, {3, 12}});
    CHECK(pairs.motion->repetitions == 2);
}

TEST_CASE("lumped set: some phases press and others only touch")
{
    std::mt19937_64 generator(14);
    int mixed = 0;
    const Verification known = verify(findPeriodic(Schedule{10, {{2, 3}, {1, 29}}}).motion->state,
                                      {10, {{2, 3}, {1, 29}}});
    CHECK(known.canonical == std::vector<Phase>{{1, 34}});
    CHECK(known.pressing == std::vector<bool>{true, false});
    for (int trial = 0; trial < 1000; ++trial) {
        const Schedule schedule = feasibleSchedule(generator, 12, trial);
        const LumpedSet set = lumpedSet(schedule);
        const State state = equalMotion(set, set.leastSums);
        const Verification seen = verify(state, schedule);
        INFO(describe(schedule));
        REQUIRE(seen.pressing.size() == schedule.phases.size());
        const auto pressing = std::count(seen.pressing.begin(), seen.pressing.end(), true);
        REQUIRE((pressing == 0) == seen.canonical.empty());
        mixed += pressing > 0 && pressing < static_cast<int>(schedule.phases.size()) ? 1 : 0;
    }
    CHECK(mixed > 5);
}

TEST_CASE("lumped set: further demands are met by its motion, or handed on")
{
    const Schedule schedule{4, {{1, 12}, {3, 12}}};
    CHECK(findPeriodic(schedule, {.strainLimit = 10.0}).how.route == "lumped");
    CHECK(findPeriodic(schedule, {.objective = Objective::any}).how.route == "lumped");
    CHECK(findPeriodic(schedule, {.objective = Objective::maxEnergy}).motion->energyRatio == 8.0);
    CHECK(findPeriodic(schedule, {.energyRatio = 8.1}).absence->reason == Reason::constraints);
    CHECK(findPeriodic(schedule, {.energyRatio = 5.3}).absence->reason == Reason::constraints);
    if (hasSolver("glpk-simplex")) {
        const PeriodicResult none = findPeriodic(schedule, {.strainLimit = 1e-3});
        CHECK(none.status == Status::none);
        CHECK(none.absence->reason == Reason::constraints);
        CHECK(findPeriodic(schedule, {.solver = "glpk-simplex"}).how.solver.name == "glpk-simplex");
    }
}

TEST_CASE("lumped set: extreme schedules are answered or refused, and quickly")
{
    const auto start = std::chrono::steady_clock::now();
    CHECK_THROWS_AS(findPeriodic(Schedule{4, {}}), std::invalid_argument);
    CHECK_THROWS_AS(findPeriodic(Schedule{4, {{maxSteps, 1}, {1, maxSteps}}}),
                    std::invalid_argument);
    CHECK(findPeriodic(Schedule{4, {{maxSteps / 4, 1}, {1, maxSteps / 4}}}).status !=
          Status::undecided);

    const Schedule periodic{3, std::vector<Phase>(10'000, Phase{1, 9})};
    const PeriodicResult repeated = findPeriodic(periodic);
    CHECK(repeated.status == Status::found);
    CHECK(repeated.motion->repetitions == 10'000);

    std::mt19937_64 generator(1);
    Schedule random{20, {}};
    for (int k = 0; k < 10'000; ++k) {
        random.phases.push_back({1 + static_cast<std::int64_t>(generator() % 20),
                                 1 + static_cast<std::int64_t>(generator() % 80)});
    }
    CHECK(findPeriodic(random).status == Status::none);
    random.cells = 10'000;
    const PeriodicResult large = findPeriodic(random);
    CHECK(large.status != Status::found);
    CHECK_FALSE((large.status == Status::undecided && large.detail.empty()));

    Schedule wide{maxCells, {{maxCells / 3, 3 * maxCells}, {maxCells / 7, 3 * maxCells + 1}}};
    const PeriodicResult refused = findPeriodic(wide);
    CHECK(refused.status == Status::undecided);
    CHECK_THROWS_AS(lumpedSet(wide), std::invalid_argument);
    CHECK(seconds(start) < 60.0);
}

TEST_CASE("lumped set: misuse is refused")
{
    const LumpedSet set = lumpedSet(Schedule{4, {{1, 12}, {3, 12}}});
    const LumpedSet none = lumpedSet(Schedule{4, {{1, 1}, {1, 1}}});
    std::mt19937_64 generator(1);
    CHECK_THROWS_AS(equalMotion(set, std::vector<double>(3)), std::invalid_argument);
    REQUIRE(set.live.size() == 2);
    CHECK_THROWS_AS(amplitudesAt(set, set.leastSums, 2), std::invalid_argument);
    CHECK_THROWS_WITH(amplitudesAt(set, set.leastSums, 2), "index = 2: allowed 0..1");
    CHECK_THROWS_AS(motionOf(set.classes, std::vector<double>(1)), std::invalid_argument);
    CHECK_THROWS_AS(equalMotion(none, std::vector<double>(2)), std::invalid_argument);
    CHECK_THROWS_AS(drawMotion(none, shapeOf(none), generator), std::invalid_argument);
    CHECK_THROWS_AS(
        proofOf(set, formulate(Schedule{4, {{1, 12}, {3, 12}}}, Formulation::lumped).program),
        std::invalid_argument);
    CHECK(shapeOf(none).dimension == -1);
}

TEST_CASE("lumped set: between two stops at any distance, verified or proved absent")
{
    std::mt19937_64 generator(19);
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    std::array<int, 2> found{};  // small fractions, and such that exact numbers leave 64 bits
    for (std::int64_t trial = 0; trial < 8000; ++trial) {
        const std::int64_t denominator =
            trial % 2 == 0 ? draw(1, 3) : draw(1'000'000'000, 4'000'000'000);
        const Schedule schedule = test::randomScene(
            generator,
            {static_cast<int>(trial % 3) - 1,
             exactPeriod((trial % 3 == 2 ? 0 : 2 * denominator) + draw(1, 3 * denominator),
                         denominator)},
            6);
        INFO(describe(schedule));
        const LumpedSet set = lumpedSet(schedule);
        if (set.absence) {
            REQUIRE(isProvedEmpty(set, schedule));
            continue;
        }
        const State state = equalMotion(set, set.leastSums);
        REQUIRE(verify(state, schedule).residuals.worst() < 1e-12);
        REQUIRE(energyRatio(state) == Approx(set.leastEnergy).epsilon(1e-12));
        const LumpedShape shape = shapeOf(set);
        REQUIRE(energyRatio(mostEnergyMotion(set, shape)) ==
                Approx(shape.energy.most).epsilon(1e-12));
        if (shape.kind == SetKind::point) {  // both ends are exact, rounded once
            REQUIRE(shape.energy.most == shape.energy.least);
        }
        ++found[static_cast<std::size_t>(trial % 2)];
    }
    CHECK(found[0] > 100);
    CHECK(found[1] > 100);
}

TEST_CASE("lumped set: as many live types as allowed, and one more")
{
    // Steps of contact and of flight in turn, one class each: waves that push in every period and
    // never return in flight hold the tip on the wrong side of the gap.
    const auto alternating = [](std::int64_t phases) {
        return Schedule{phases, std::vector<Phase>(static_cast<std::size_t>(phases), Phase{1, 1})};
    };
    const LumpedSet most = lumpedSet(alternating(maxLiveTypes));
    CHECK(most.live.size() == maxLiveTypes);
    CHECK(most.absence);
    CHECK_THROWS_AS(lumpedSet(alternating(maxLiveTypes + 1)), std::invalid_argument);
}

TEST_CASE("lumped set: as many blocks as allowed, and two more")
{
    // n = maxBlocks and gcd(2N, n) = 2. Both classes have an odd number of free steps: both are
    // dead, which is seen at once.
    const Schedule schedule{9'999'999, {{2, maxBlocks - 2}}};
    REQUIRE(blockCount(schedule) == maxBlocks);
    CHECK(lumpedSet(schedule).classes.kernelDimension == 0);
    const Schedule larger{9'999'999, {{2, maxBlocks}}};
    REQUIRE(blockCount(larger) > maxBlocks);
    CHECK_THROWS_AS(lumpedSet(larger), std::invalid_argument);
}

TEST_CASE("lumped set: touched often by the linear motion, and still one vertex where it is known")
{
    for (const std::int64_t touches : {12, 13}) {
        // n = 4N: N touches in the first half of the period, and all classes between are live.
        Schedule schedule{touches,
                          std::vector<Phase>(static_cast<std::size_t>(touches), Phase{1, 1})};
        schedule.phases.back().free = 2 * touches + 1;
        const LumpedSet set = lumpedSet(schedule);
        INFO(describe(schedule));
        REQUIRE(set.live.size() == static_cast<std::size_t>(touches));
        const LumpedShape shape = shapeOf(set);
        CHECK(shape.kind == SetKind::point);
        // All of the wave is in the last class: the others lie between two touches.
        const double sum = -static_cast<double>(touches);
        CHECK(shape.spanning.front().back() == sum);
        CHECK(shape.energy.least == -2.0 * sum);
        if (!shape.vertices.empty()) {
            CHECK(shape.vertices == shape.spanning);
            CHECK(shape.energy.most == shape.energy.least);
        }
        CHECK(shape.vertices.empty() == std::isnan(shape.energy.most));
        CHECK(shape.vertices.empty() == (touches > 12));  // the most that they are listed for
    }
}

TEST_CASE("lumped set: a multiplier of a proof may be as large as integers are")
{
    // One live type, epsilon adding up to -8 over a window and to -7 over the first flight. Without
    // a gap S is 0 and the flight to a stop at h > 0 does not close: 7/h times the gap row is 8
    // times that of closing.
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    static_assert(most % 7 == 0);
    const LumpedSet set =
        lumpedSet(Schedule{8, {{1, 11}, {2, 13, Stop::left}}, {0, Fraction{1, most / 7}}});
    REQUIRE(set.live.size() == 1);
    REQUIRE(set.classes.types[set.live.front()].windowSum == -8);
    REQUIRE(set.absence);
    CHECK(set.absence->gap == -most);
    REQUIRE(set.absence->closures.size() == 1);
    CHECK(set.absence->closures.front().value == 8);
    CHECK(set.absence->prefixes.empty());
}

TEST_CASE("lumped set: a stop at a fraction that no row can hold is refused")
{
    for (const std::int64_t below : {3222068122716970711, 3126803249808189121}) {
        const Stops stops{0, Fraction{1, below}};
        CHECK_THROWS_AS(lumpedSet({13, {{1, 4}, {1, 4, Stop::left}}, stops}), std::overflow_error);
        CHECK_THROWS_AS(lumpedSet({6, {{2, 4, Stop::left}, {7, 3}}, stops}), std::overflow_error);
    }
    CHECK_FALSE(lumpedSet({13, {{1, 4}, {1, 4, Stop::left}}, {0, Fraction{1, 1}}}).absence);
    CHECK_FALSE(
        lumpedSet({13, {{1, 4}, {1, 4, Stop::left}}, {0, Fraction{1, 1'000'000'007}}}).absence);
}
