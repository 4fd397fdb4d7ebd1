// The march goes a piece of the way at a time; here it has to decide as the Signorini rule does one
// step after the other, on waves that are whole numbers. The march of stepped bars has cells of its
// own; where all segments are alike, both have to see the same. So has the one of forced bars,
// where no force is.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "catch.hpp"
#include "forced_check.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/verification.hpp"
#include "stepped_check.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

/// Of each step: 1 pressed on the wall, -1 on the second stop, 0 neither.
using Marks = std::vector<int>;

/// Phases of a cycle of marks, from the start of the first pressed run.
std::vector<Phase> phasesOf(const Marks& marks)
{
    const std::size_t n = marks.size();
    const auto mark = [&](std::size_t m) { return marks[m % n]; };
    std::size_t first = 0;
    while (first < n && mark(first) == 0) {
        ++first;
    }
    if (first == n) {
        return {};
    }
    std::size_t turns = 0;
    for (; turns < n && first == 0 && mark(n - 1 - turns) == mark(0); ++turns) {
    }
    first += turns > 0 ? n - turns : 0;  // the run goes on before the period begins
    std::vector<Phase> phases;
    for (std::size_t m = 0; m < n; ++m) {
        const int here = mark(first + m);
        if (here == 0) {
            ++phases.back().free;
            continue;
        }
        if (m == 0 || mark(first + m - 1) != here) {
            phases.push_back({0, 0, here > 0 ? Stop::right : Stop::left});
        }
        ++phases.back().contact;
    }
    return phases;
}

/// (21)-(25) and the rule, a step at a time. Distances in units of p: a free step moves the tip by
/// p. `second` is the distance from the wall to the second stop.
March marchBySteps(const State& start, std::int64_t count, int wall, std::optional<double> second)
{
    State now = start;
    const Eigen::Index n = now.a.size();
    const double half = 0.5 * static_cast<double>(n);
    double opening = wall * half + 0.5 * (start.a - start.b).sum();
    Marks marks;
    for (std::int64_t m = 0; m < count; ++m) {
        const double p = now.a[n - 1];
        const double room = p > 0.0 ? opening : second ? *second - opening : 1e300;
        const bool isStopped = p != 0.0 && std::abs(p) > room;
        const bool isHeld = isStopped && room <= 0.0;
        if (isStopped && room > 0.0) {
            return {(std::abs(p) - room) / half, m, {}};
        }
        marks.push_back(!isHeld ? 0 : p > 0.0 ? 1 : -1);
        opening -= isHeld ? 0.0 : p;
        const double clamped = -now.b[0];
        for (Eigen::Index i = n - 1; i > 0; --i) {
            now.a[i] = now.a[i - 1];
        }
        for (Eigen::Index i = 0; i + 1 < n; ++i) {
            now.b[i] = now.b[i + 1];
        }
        now.a[0] = clamped;
        now.b[n - 1] = isHeld ? -p : p;
    }
    const auto largest = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
        return std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
    };
    const double size = largest(start.a, start.b);
    const double change = largest(now.a - start.a, now.b - start.b);
    return {size > 0.0 ? change / size : change, -1, phasesOf(marks)};
}

/// Waves in long stretches of one value each, so that whole pieces do the same to the tip.
State stretches(std::mt19937_64& draw, std::int64_t cells)
{
    const auto below = [&draw](std::int64_t end) {
        return std::uniform_int_distribution<std::int64_t>(0, end - 1)(draw);
    };
    std::vector<double> waves;
    const bool isRugged = below(3) == 0;
    while (waves.size() < 2 * static_cast<std::size_t>(cells)) {
        const auto value = static_cast<double>(below(5) - 2);
        waves.insert(waves.end(), static_cast<std::size_t>(1 + below(isRugged ? 4 : cells)), value);
    }
    const Eigen::Map<const Eigen::VectorXd> all(waves.data(), 2 * cells);
    return {all.head(cells), all.tail(cells)};
}

/// Shifts a wave so that the tip starts `opening` (a multiple of 1/2) before the wall.
void place(State& state, int wall, double opening)
{
    const double half = 0.5 * static_cast<double>(state.cells());
    const double now = wall * half + 0.5 * (state.a - state.b).sum();
    state.a[0] += 2.0 * (opening - now);
}

}  // namespace

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
        const auto count = static_cast<std::int64_t>(1 + draw() % (12 * cells));
        INFO("trial " << trial << ", N = " << cells << ", " << count << " steps");
        const March expected = marchBySteps(state, count, stops.right, second);
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

/// The third way: what a walk of a forced bar sees if its force is 0.
ForcedWalk unforced(const State& state, const Schedule& schedule)
{
    const auto cells = static_cast<double>(schedule.cells);
    return walkForced(state, schedule, {},
                      {.values = std::vector<double>(static_cast<std::size_t>(steps(schedule))),
                       .stepsPerCrossing = cells});
}

void checkAlike(const ForcedWalk& one, const Verification& other, double unit, bool isBetweenStops)
{
    CHECK(one.periodicity == Approx(other.residuals.periodicity));
    CHECK(one.gap * unit == Approx(other.residuals.gap));
    CHECK(one.pressure == Approx(2.0 * other.residuals.pressure));
    CHECK(one.penetration * unit == Approx(other.residuals.penetration));
    if (isBetweenStops) {  // it does not go on from inside a stop
        CHECK(one.march == Approx(other.residuals.march));
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
        const Verification seen = verifyStepped(state, schedule, pieces(draw, cells)).seen;
        checkAlike(seen, uniform);
        if (amplitude(state) > 0.0) {
            const double tip = (state.b - state.a).mean();
            checkAlike(unforced(state, schedule), seen,
                       schedule.stops.right != 0 ? 1.0 : amplitude(state),
                       tip <= schedule.stops.right &&
                           !(schedule.stops.left && tip < -schedule.stops.left->value()));
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
    test::forAllSchedules(6, 6, [&](const Schedule& schedule) {
        const OnePhaseSet set = onePhaseSet(schedule);
        if (set.reason) {
            return;
        }
        INFO(describe(schedule));
        ++motions;
        const State state = leastEnergyMotion(set);
        const Verification uniform = verify(state, schedule);
        const auto [seen, extremes] = verifyStepped(state, schedule, pieces(draw, schedule.cells));
        CHECK(seen.residuals.worst() < 1e-12);
        CHECK(seen.canonical == uniform.canonical);
        CHECK(seen.repetitions == uniform.repetitions);
        CHECK(seen.peakStrain == Approx(uniform.peakStrain));
        test::checkEqual(extremes, extremesOf(state, schedule, uniform.repetitions));
        const ForcedWalk walk = unforced(state, schedule);
        CHECK(walk.worst() < 1e-12);
        test::checkEqual(walk.extremes, extremesOf(state, schedule, 1));
    });
    CHECK(motions > 100);
}
