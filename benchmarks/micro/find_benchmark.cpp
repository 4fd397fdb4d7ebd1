// What a verdict and a motion cost, next to writing the numbers.

#include <benchmark/benchmark.h>

#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/verification.hpp"

namespace {

using namespace signorini;

/// Family A of the paper's period: n_c = N/2, n_f = 3N; E_min/E_1 = 4.
Schedule paperCase(std::int64_t cells)
{
    return {cells, {{cells / 2, 3 * cells}}};
}

void verdict(benchmark::State& bench)
{
    const Schedule schedule = paperCase(bench.range(0));
    OnePhaseSet workspace;
    for (auto _ : bench) {
        onePhaseSet(schedule, workspace);
        benchmark::DoNotOptimize(workspace.set.sum);
    }
}
BENCHMARK(verdict)->Arg(300)->Arg(1'000'000);

/// gcd(2N, n) = 1: the longest walk a verdict can need, n/G = n steps.
void verdictLongestWalk(benchmark::State& bench)
{
    const std::int64_t cells = bench.range(0);
    const Schedule schedule{cells, {{cells / 2 + 1, 3 * cells + cells % 2}}};
    OnePhaseSet workspace;
    for (auto _ : bench) {
        onePhaseSet(schedule, workspace);
        benchmark::DoNotOptimize(workspace.windowSum);
    }
    bench.counters["members"] = static_cast<double>(workspace.members);
    bench.SetComplexityN(workspace.members);
}
BENCHMARK(verdictLongestWalk)->RangeMultiplier(10)->Range(300, 3'000'000)->Complexity();

/// Every schedule n_c <= 2N, n_f <= 8N, as the atlas decides them: items are schedules.
void atlasVerdicts(benchmark::State& bench)
{
    const std::int64_t cells = bench.range(0);
    std::vector<std::int8_t> signs;
    std::int64_t found = 0;
    for (auto _ : bench) {
        found = 0;
        for (std::int64_t contact = 1; contact <= 2 * cells; ++contact) {
            for (std::int64_t free = 1; free <= 8 * cells; ++free) {
                found += decide(cells, {contact, free}, signs).reason ? 0 : 1;
            }
        }
        benchmark::DoNotOptimize(found);
    }
    bench.SetItemsProcessed(bench.iterations() * 16 * cells * cells);
    bench.counters["found"] = static_cast<double>(found);
}
BENCHMARK(atlasVerdicts)->Arg(300)->Unit(benchmark::kMillisecond);

void verdictAndLeastEnergyState(benchmark::State& bench)
{
    const Schedule schedule = paperCase(bench.range(0));
    OnePhaseSet workspace;
    for (auto _ : bench) {
        onePhaseSet(schedule, workspace);
        State state = leastEnergyMotion(workspace);
        benchmark::DoNotOptimize(state.a.data());
    }
}
BENCHMARK(verdictAndLeastEnergyState)->Arg(300)->Arg(3'000)->Arg(1'000'000);

/// The floor for any state: 2N doubles into fresh memory.
void write2NDoubles(benchmark::State& bench)
{
    const auto cells = bench.range(0);
    for (auto _ : bench) {
        Eigen::VectorXd a = Eigen::VectorXd::Constant(cells, 1.0);
        Eigen::VectorXd b = Eigen::VectorXd::Constant(cells, -1.0);
        benchmark::DoNotOptimize(a.data());
        benchmark::DoNotOptimize(b.data());
    }
}
BENCHMARK(write2NDoubles)->Arg(300)->Arg(3'000)->Arg(1'000'000);

void verification(benchmark::State& bench)
{
    const Schedule schedule = paperCase(bench.range(0));
    const State state = leastEnergyMotion(onePhaseSet(schedule));
    for (auto _ : bench) {
        benchmark::DoNotOptimize(verify(state, schedule).residuals.march);
    }
}
BENCHMARK(verification)->Arg(300)->Arg(1'000'000);

/// Everything a user gets: verdict, motion, energy, residuals, march.
void findPeriodicInFull(benchmark::State& bench)
{
    const Schedule schedule = paperCase(bench.range(0));
    for (auto _ : bench) {
        const PeriodicResult result = findPeriodic(schedule);
        benchmark::DoNotOptimize(result.motion->energyRatio);
    }
}
BENCHMARK(findPeriodicInFull)->Arg(300)->Arg(1'000'000);

}  // namespace
