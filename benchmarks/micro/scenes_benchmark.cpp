// What other stops cost, next to the paper's scene: the same grids, everything a user gets.

#include <benchmark/benchmark.h>

#include "signorini/find_periodic.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/response.hpp"
#include "signorini/simulation.hpp"

namespace {

using namespace signorini;

/// One contact phase, G = N/2: the paper's, pressed at rest, and without a gap; all motions of a
/// family, or a face of it, where half of the classes are dead.
Schedule onePhaseOf(std::int64_t cells, int gapSign, bool isFace)
{
    const std::int64_t contact =
        (gapSign < 0 ? 3 * cells / 2 : cells / 2) + (isFace ? cells / 4 : 0);
    const std::int64_t all = gapSign > 0 ? 7 * cells / 2 : 5 * cells / 2;
    return {cells, {{contact, all - contact}}, {.right = gapSign}};
}

/// Two phases on one wall, and one on each of two stops.
Schedule twoPhasesOf(std::int64_t cells, bool hasTwoStops)
{
    const std::int64_t unit = cells / 4;
    if (!hasTwoStops) {
        return {cells, {{unit, 12 * unit}, {3 * unit, 12 * unit}}};
    }
    return {cells,
            {{unit, 5 * unit}, {unit, 5 * unit, Stop::left}},
            {.right = 1, .left = Fraction{1, 1}}};
}

FindOptions optionsFor(const Schedule& schedule)
{
    FindOptions options;
    options.scene = Scene(Bar{.gap = 1e-3 * schedule.stops.right},
                          schedule.stops.left ? std::optional(1e-3) : std::nullopt);
    if (schedule.stops.right == 0) {
        options.energyRatio = 1.0;
    }
    return options;
}

void find(benchmark::State& bench, const Schedule& schedule)
{
    const FindOptions options = optionsFor(schedule);
    for (auto _ : bench) {
        benchmark::DoNotOptimize(findPeriodic(schedule, options).motion->energyRatio);
    }
}

void findOnePhase(benchmark::State& bench)
{
    find(bench, onePhaseOf(bench.range(0), static_cast<int>(bench.range(1)), bench.range(2) == 1));
}
BENCHMARK(findOnePhase)
    ->ArgsProduct({{300, 100'000}, {1, -1, 0}, {0, 1}})
    ->ArgNames({"N", "gap", "face"});

/// With an energy to hold: what a motion without a gap, which has no size of its own, compares
/// with.
void findOfEnergy(benchmark::State& bench)
{
    const Schedule schedule =
        onePhaseOf(bench.range(0), static_cast<int>(bench.range(1)), bench.range(2) == 1);
    FindOptions options = optionsFor(schedule);
    options.energyRatio = 20.0;
    for (auto _ : bench) {
        benchmark::DoNotOptimize(findPeriodic(schedule, options).motion->energyRatio);
    }
}
BENCHMARK(findOfEnergy)
    ->ArgsProduct({{300, 100'000}, {1, -1, 0}, {0, 1}})
    ->ArgNames({"N", "gap", "face"});

void findTwoPhases(benchmark::State& bench)
{
    find(bench, twoPhasesOf(bench.range(0), bench.range(1) == 2));
}
BENCHMARK(findTwoPhases)->ArgsProduct({{300, 100'000}, {1, 2}})->ArgNames({"N", "stops"});

/// The verdict alone.
void decideTwoPhases(benchmark::State& bench)
{
    const Schedule schedule = twoPhasesOf(bench.range(0), bench.range(1) == 2);
    for (auto _ : bench) {
        benchmark::DoNotOptimize(lumpedSet(schedule).leastEnergy);
    }
}
BENCHMARK(decideTwoPhases)->ArgsProduct({{300}, {1, 2}})->ArgNames({"N", "stops"});

/// Events of a motion for a hundred periods.
void simulateMotion(benchmark::State& bench)
{
    const Schedule schedule = twoPhasesOf(300, bench.range(0) == 2);
    const State state = equalMotion(lumpedSet(schedule), lumpedSet(schedule).leastSums);
    const auto length = static_cast<double>(steps(schedule));
    std::int64_t events = 0;
    for (auto _ : bench) {
        BarSimulation simulation(wavesOf(state), {}, {.stepsPerCrossing = 300.0},
                                 {.mergeBelow = {}, .recordsTip = false, .stops = schedule.stops});
        simulation.advance(100.0 * length);
        events = simulation.events();
        benchmark::DoNotOptimize(events);
    }
    bench.SetItemsProcessed(bench.iterations() * events);
}
BENCHMARK(simulateMotion)->Arg(1)->Arg(2)->ArgNames({"stops"});

/// One schedule, forced and damped: its line and the motion of least amplitude, checked.
void forcedMotion(benchmark::State& bench)
{
    const auto cells = bench.range(0);
    const bool hasTwo = bench.range(1) == 2;
    Schedule schedule{cells, {{cells / 4, 15 * cells / 4 - 1}}, {}};
    if (hasTwo) {
        schedule.stops.left = Fraction{10, 1};
    }
    schedule.stops.right = static_cast<int>(bench.range(2));
    for (auto _ : bench) {
        benchmark::DoNotOptimize(forcedMotions(schedule, {0.02}, {}).leastAmplitude);
    }
}
BENCHMARK(forcedMotion)
    ->Args({300, 1, 1})
    ->Args({300, 1, -1})
    ->Args({300, 1, 0})
    ->Args({300, 2, 1})
    ->ArgNames({"N", "stops", "gap"});

/// All motions at one frequency, with one stop and two far apart: motions on both cost twice.
void response(benchmark::State& bench)
{
    ResponseRange range;
    range.amplitude = 0.2;
    if (bench.range(0) == 2) {
        range.stops.left = Fraction{10, 1};
    }
    for (auto _ : bench) {
        benchmark::DoNotOptimize(responseAt(range, 1049)->motions.size());
    }
}
BENCHMARK(response)->Arg(1)->Arg(2)->ArgNames({"stops"});

}  // namespace
