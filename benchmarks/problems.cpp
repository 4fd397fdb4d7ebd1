#include "problems.hpp"

#include <fmt/format.h>

#include <random>

#include "signorini/lumped_set.hpp"
#include "signorini/one_phase_set.hpp"

namespace signorini::bench {

namespace {

Problem family(const char* letter, std::int64_t cells, std::int64_t free, bool exists)
{
    return {.name = fmt::format("{} N={}", letter, cells),
            .schedule = {cells, {{cells / 2, free}}},
            .exists = exists};
}

bool hasMotion(const Schedule& schedule)
{
    return schedule.phases.size() == 1 ? !onePhaseSet(schedule).reason
                                       : !lumpedSet(schedule).absence;
}

/// Draws until as many exist as do not.
template <typename Draw>
std::vector<Problem> drawProblems(int count, Draw draw)
{
    std::vector<Problem> problems;
    int left[2] = {count / 2, count - count / 2};
    while (left[0] + left[1] > 0) {
        Problem problem{.name = "", .schedule = draw()};
        problem.exists = hasMotion(problem.schedule);
        problem.name = fmt::format("random, {}", describe(problem.schedule));
        if (left[problem.exists ? 1 : 0] > 0) {
            --left[problem.exists ? 1 : 0];
            problems.push_back(std::move(problem));
        }
    }
    return problems;
}

}  // namespace

Problem familyA(std::int64_t cells)
{
    return family("A", cells, 3 * cells, true);
}

Problem familyB(std::int64_t cells)
{
    return family("B", cells, 7 * cells / 2, true);
}

Problem familyC(std::int64_t cells)
{
    return family("C", cells, 4 * cells, false);
}

Problem familyD(std::int64_t cells)
{
    Problem problem = family("D", cells, cells, true);
    problem.schedule.phases.front().contact = 3 * cells / 2;
    problem.scene = Bar{.gap = -1e-3};
    problem.schedule.stops = stopsOf(problem.scene);
    return problem;
}

Problem familyE(std::int64_t wanted)
{
    const std::int64_t cells = (wanted + 3) / 4 * 4;
    Problem problem = family("E", cells, 5 * cells / 4, true);
    problem.schedule.phases = {{cells / 4, 5 * cells / 4}, {cells / 4, 5 * cells / 4, Stop::left}};
    problem.scene = Scene(Bar{}, 1e-3);
    problem.schedule.stops = stopsOf(problem.scene);
    return problem;
}

Problem leastEnergyOf(Problem problem, double leastEnergy)
{
    problem.demands.objective = Objective::minEnergy;
    problem.leastEnergy = leastEnergy;
    return problem;
}

Problem withEnergy(Problem problem, double energyRatio)
{
    problem.demands.energyRatio = energyRatio;
    return problem;
}

std::vector<Problem> randomProblems(int count)
{
    std::mt19937_64 generator(2019);
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    return drawProblems(count, [&draw] {
        const std::int64_t cells = draw(20, 60);
        const std::int64_t contact = draw(1, cells);
        return Schedule{cells, {{contact, 4 * cells - contact - draw(0, 2 * cells)}}};
    });
}

std::vector<Problem> randomPhases(int count)
{
    std::mt19937_64 generator(2019);
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    return drawProblems(count, [&draw] {
        Schedule schedule{draw(3, 12), {}};
        for (std::int64_t k = draw(2, 3); k > 0; --k) {
            const std::int64_t contact = draw(1, schedule.cells);
            schedule.phases.push_back(
                {contact, 4 * schedule.cells - contact - draw(0, 2 * schedule.cells - 1)});
        }
        return schedule;
    });
}

}  // namespace signorini::bench
