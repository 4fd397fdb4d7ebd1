// What a verdict and a motion cost, next to writing the numbers.

#include <benchmark/benchmark.h>

#include <limits>

#include "signorini/atlas.hpp"
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

/// Every schedule n_c <= 2N, n_f <= 8N, batch by batch, without a database: items are those found.
void atlasVerdicts(benchmark::State& bench)
{
    AtlasRange range = usualRange(bench.range(0));
    range.maxFree = 8 * range.cells;
    range.familiesOnly = bench.range(1) != 0;
    range.maxEnergyRatio = range.familiesOnly ? 50.0 : std::numeric_limits<double>::infinity();
    std::vector<std::int8_t> signs;
    AtlasTally tally;
    std::size_t families = 0;
    for (auto _ : bench) {
        tally = {};
        families = 0;
        for (std::int64_t number = 0; number < batchesOf(range); ++number) {
            const AtlasBatch batch = decideBatch(range, number, signs).value();
            tally += batch.tally;
            families += batch.families.size();
        }
        benchmark::DoNotOptimize(tally);
    }
    bench.SetItemsProcessed(bench.iterations() * (tally.pressing + tally.grazing));
    bench.counters["found"] = static_cast<double>(tally.pressing + tally.grazing);
    bench.counters["families"] = static_cast<double>(families);
}
BENCHMARK(atlasVerdicts)
    ->ArgsProduct({{300, 3'000, 10'000, 100'000}, {0, 1}})
    ->ArgNames({"N", "families_only"})
    ->Unit(benchmark::kMillisecond);

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
