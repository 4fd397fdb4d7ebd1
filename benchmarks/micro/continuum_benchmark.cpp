// Cost of one point of a continuum against the number of amplitudes d, geometry alone and with
// everything a user gets.

#include <benchmark/benchmark.h>

#include "signorini/continuum.hpp"
#include "sphere_section.hpp"

namespace {

using namespace signorini;

/// The paper's family: d = N/2, E_min = 4 E_1; 20 E_1 is rho = 5/d.
SphereSection paperSection(std::int64_t count)
{
    return {count, 5.0 / static_cast<double>(count)};
}

void pathPoint(benchmark::State& bench)
{
    const SphereSection section = paperSection(bench.range(0));
    const PulsePair pulses(section);
    const SectionPath path(section, pulses.at(0.0), pulses.at(pulses.longestPause()));
    double s = 0.0;
    for (auto _ : bench) {
        s = s < 0.99 ? s + 0.01 : 0.0;
        benchmark::DoNotOptimize(path.at(s).data());
    }
    bench.SetComplexityN(bench.range(0));
}
BENCHMARK(pathPoint)->Arg(150)->Arg(1'500)->Arg(15'000)->Complexity();

void pulsePairPoint(benchmark::State& bench)
{
    const PulsePair pulses(paperSection(bench.range(0)));
    double share = 0.0;
    for (auto _ : bench) {
        share = share < 0.99 ? share + 0.0073 : 0.0;
        benchmark::DoNotOptimize(pulses.at(share * pulses.longestPause()).data());
    }
    bench.SetComplexityN(bench.range(0));
}
BENCHMARK(pulsePairPoint)->Arg(150)->Arg(1'500)->Arg(15'000)->Complexity();

/// A whole curve, each point verified; time per point in the counter.
void tracedContinuum(benchmark::State& bench)
{
    const std::int64_t cells = 2 * bench.range(0);
    const Schedule schedule{cells, {{cells / 2, 3 * cells}}};
    ContinuumOptions options;
    options.points = 51;
    for (auto _ : bench) {
        benchmark::DoNotOptimize(traceContinuum(schedule, 20.0, options).points.data());
    }
    bench.SetComplexityN(bench.range(0));
    bench.counters["per_point"] = benchmark::Counter(
        static_cast<double>(options.points * static_cast<std::int64_t>(bench.iterations())),
        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(tracedContinuum)->Arg(150)->Arg(1'500)->Arg(15'000)->Complexity();

/// One move of the walk over the set: d log d.
void sampledPoint(benchmark::State& bench)
{
    const std::int64_t count = bench.range(0);
    SectionSampler sampler({SetKind::simplex, count, 1.0, 0.0, 0.0},
                           5.0 / static_cast<double>(count), 1);
    for (auto _ : bench) {
        benchmark::DoNotOptimize(sampler.next(1).data());
    }
}
BENCHMARK(sampledPoint)->Arg(150)->Arg(1'500)->Arg(15'000);

}  // namespace
