// The march goes a piece of the way at a time; here it has to decide as the Signorini rule does one
// step after the other, on waves that are whole numbers. The march of stepped bars has cells of its
// own; where all segments are alike, both have to see the same, and of forced bars where no force
// is.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "bar_check.hpp"
#include "catch.hpp"
#include "march_support.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/verification.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("march: a piece at a time it decides as step by step, beside one stop and between two")
{
    std::mt19937_64 draw(19);
    int faults = 0;
    int pressed = 0;
    int left = 0;
    for (int trial = 0; trial < 30000; ++trial) {
        const auto most = draw() % 2 == 0 ? 150 : 10;
        const std::int64_t cells = std::uniform_int_distribution<std::int64_t>(1, most)(draw);
        State state = stretches(draw, cells);
        Stops stops{std::uniform_int_distribution<int>(-1, 1)(draw)};
        std::optional<double> second;
        if (draw() % 2 == 0) {
            stops.left = Fraction{static_cast<std::int64_t>(2 + draw() % 4), 1};
            second = 0.5 * static_cast<double>(cells * (stops.right + stops.left->numerator));
        }
        if (draw() % 4 != 0) {
            place(state, stops.right, second && draw() % 3 == 0 ? *second : 0.0);
        }
        const auto count =
            static_cast<std::int64_t>(1 + draw() % static_cast<unsigned>(12 * cells));
        INFO("trial " << trial << ", N = " << cells << ", " << count << " steps");
        const March expected = marchBySteps(state, count, {stops.right, second}).march;
        const March seen = march(state, count, 1e-9, stops);
        REQUIRE(seen.firstFault == expected.firstFault);
        REQUIRE(seen.residual == Approx(expected.residual).epsilon(1e-12));
        REQUIRE(seen.phases == expected.phases);
        faults += seen.firstFault >= 0 ? 1 : 0;
        pressed += seen.phases.empty() ? 0 : 1;
        left += std::any_of(seen.phases.begin(), seen.phases.end(),
                            [](const Phase& phase) { return phase.stop == Stop::left; })
                    ? 1
                    : 0;
    }
    CHECK(faults > 500);
    CHECK(pressed > 500);
    CHECK(left > 100);
}

namespace {

/// A bar of one material, in two or three pieces.
std::vector<Segment> pieces(std::mt19937_64& draw, std::int64_t cells)
{
    const auto first = static_cast<std::int64_t>(
        1 + draw() % static_cast<std::uint64_t>(std::max<std::int64_t>(1, cells - 1)));
    if (first == cells) {
        return {{cells}};
    }
    if (first == 1 || draw() % 2 == 0) {
        return {{first}, {cells - first}};
    }
    return {{1}, {first - 1}, {cells - first}};
}

void checkAlike(const Verification& one, const Verification& other)
{
    CHECK(one.residuals.periodicity == Approx(other.residuals.periodicity));
    CHECK(one.residuals.gap == Approx(other.residuals.gap));
    CHECK(one.residuals.pressure == Approx(other.residuals.pressure));
    if (one.residuals.gap == 0.0) {  // else depths are counted from different places
        CHECK(one.residuals.penetration == Approx(other.residuals.penetration));
    }
    CHECK(one.residuals.march == Approx(other.residuals.march));
    CHECK(one.pressing == other.pressing);
}

/// What is seen of a forced bar if its force is 0.
BarVerification unforced(const State& state, const Schedule& schedule)
{
    const auto cells = static_cast<double>(schedule.cells);
    return verifyBar(state, schedule, {}, 1e-9, {},
                     {.values = std::vector<double>(static_cast<std::size_t>(steps(schedule))),
                      .stepsPerCrossing = cells});
}

void checkAlike(const Residuals& one, const Residuals& other, double unit)
{
    CHECK(one.periodicity == Approx(other.periodicity).margin(1e-14));
    CHECK(one.gap * unit == Approx(other.gap));
    CHECK(one.pressure == Approx(other.pressure));
    if (other.gap == 0.0) {
        CHECK(one.penetration * unit == Approx(other.penetration));
    }
    if (other.gap == 0.0 && unit == 1.0) {  // else a depth has another unit than a change
        CHECK(one.march == Approx(other.march));
    }
}

}  // namespace

TEST_CASE("march: equal segments, checked cell by cell, are the uniform bar")
{
    std::mt19937_64 draw(20);
    int contacts = 0;
    int placed = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const std::int64_t cells = std::int64_t{1} << (1 + draw() % 4);  // so that N/2 divides
        const auto upTo = [&](std::int64_t most) {
            return static_cast<std::int64_t>(1 + draw() % static_cast<std::uint64_t>(most));
        };
        Schedule schedule{cells, {{upTo(2 * cells), upTo(4 * cells)}}};
        schedule.stops.right = static_cast<int>(upTo(3)) - 2;
        std::optional<double> second;
        if (draw() % 2 == 0) {
            schedule.stops.left = Fraction{2 + upTo(3), 1};
            schedule.phases.push_back({upTo(cells), upTo(2 * cells), Stop::left});
            second = 0.5 * static_cast<double>(
                               cells * (schedule.stops.right + schedule.stops.left->numerator));
        }
        State state = stretches(draw, cells);
        if (draw() % 4 != 0) {
            place(state, schedule.stops.right, second && draw() % 3 == 0 ? *second : 0.0);
        }
        INFO("trial " << trial << ": " << describe(schedule));
        const Verification uniform = verify(state, schedule);
        const Verification seen = verifyBar(state, schedule, pieces(draw, cells)).seen;
        checkAlike(seen, uniform);
        if (amplitude(state) > 0.0) {
            checkAlike(unforced(state, schedule).seen.residuals, uniform.residuals,
                       schedule.stops.right != 0 ? 1.0 : amplitude(state));
        }
        if (seen.repetitions == 1 && uniform.repetitions == 1) {
            REQUIRE(seen.canonical == uniform.canonical);
        }
        contacts += seen.canonical.empty() ? 0 : 1;
        placed += seen.residuals.gap == 0.0 ? 1 : 0;
    }
    CHECK(contacts > 500);
    CHECK(placed > 500);
}

TEST_CASE("march: of motions of equal segments the extremes are those of the uniform bar")
{
    std::mt19937_64 draw(21);
    int motions = 0;
    forAllSchedules(6, 6, [&](const Schedule& schedule) {
        const OnePhaseSet set = onePhaseSet(schedule);
        if (set.reason) {
            return;
        }
        INFO(describe(schedule));
        ++motions;
        const State state = leastEnergyMotion(set);
        const Verification uniform = verify(state, schedule);
        const auto [seen, extremes] = verifyBar(state, schedule, pieces(draw, schedule.cells));
        CHECK(seen.residuals.worst() < 1e-12);
        CHECK(seen.canonical == uniform.canonical);
        CHECK(seen.repetitions == uniform.repetitions);
        CHECK(seen.peakStrain == Approx(uniform.peakStrain));
        checkEqual(extremes, extremesOf(state, schedule, uniform.repetitions));
        const BarVerification driven = unforced(state, schedule);
        CHECK(driven.seen.residuals.worst() < 1e-12);
        checkEqual(driven.extremes, extremesOf(state, schedule, 1));
    });
    CHECK(motions > 100);
}
