// Several contact phases: what the exact verdict costs as the grid is refined, and the state.

#include <benchmark/benchmark.h>

#include "signorini/find_periodic.hpp"
#include "signorini/lumped_set.hpp"

namespace {

using namespace signorini;

/// Three phases, (2, 24)(1, 26)(1, 2) on eight cells, refined: n/G stays, classes grow.
Schedule refinedPhases(std::int64_t cells)
{
    const std::int64_t unit = cells / 8;
    return {cells, {{2 * unit, 24 * unit}, {unit, 26 * unit}, {unit, 2 * unit}}};
}

/// Three phases with G = 1: n/G = n steps, the longest walk.
Schedule longestWalk(std::int64_t cells)
{
    const std::int64_t contact = cells / 3;
    return {cells, std::vector<Phase>(3, Phase{contact, 4 * cells - 2 * contact})};
}

void decide(benchmark::State& bench, const Schedule& schedule)
{
    std::int64_t members = 0;
    bool found = false;
    for (auto _ : bench) {
        const LumpedSet set = lumpedSet(schedule);
        members = set.classes.members;
        found = !set.absence;
        benchmark::DoNotOptimize(found);
    }
    bench.counters["members"] = static_cast<double>(members);
    bench.counters["found"] = found ? 1 : 0;
    bench.SetComplexityN(members);
}

void threePhasesRefined(benchmark::State& bench)
{
    decide(bench, refinedPhases(bench.range(0)));
}
BENCHMARK(threePhasesRefined)->Arg(1'000)->Arg(1'000'000);

void threePhasesLongestWalk(benchmark::State& bench)
{
    decide(bench, longestWalk(bench.range(0)));
}
BENCHMARK(threePhasesLongestWalk)
    ->Arg(1'000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Complexity(benchmark::oN);

/// Dimension, vertices and energy range of the set.
void threePhasesShape(benchmark::State& bench)
{
    const LumpedSet set = lumpedSet(refinedPhases(bench.range(0)));
    for (auto _ : bench) {
        benchmark::DoNotOptimize(shapeOf(set).dimension);
    }
}
BENCHMARK(threePhasesShape)->Arg(1'000)->Arg(1'000'000);

/// 2N numbers from a verdict.
void threePhasesState(benchmark::State& bench)
{
    const LumpedSet set = lumpedSet(refinedPhases(bench.range(0)));
    for (auto _ : bench) {
        const State state = equalMotion(set, set.leastSums);
        benchmark::DoNotOptimize(state.a.data());
    }
    bench.SetComplexityN(bench.range(0));
}
BENCHMARK(threePhasesState)
    ->Arg(1'000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Complexity(benchmark::oN);

/// Everything a user gets, the march included.
void threePhasesInFull(benchmark::State& bench)
{
    const Schedule schedule = refinedPhases(bench.range(0));
    for (auto _ : bench) {
        benchmark::DoNotOptimize(findPeriodic(schedule).motion->energyRatio);
    }
}
BENCHMARK(threePhasesInFull)->Arg(1'000)->Arg(1'000'000);

}  // namespace
