#include <fmt/format.h>

#include "solving.hpp"
#include "suites.hpp"

namespace signorini::bench {

namespace {

/// Which back ends, forms, sizes and tolerances.
struct Range {
    std::vector<std::int64_t> cells;
    std::vector<double> tolerances;
    int randomSchedules;
};

Range rangeOf(Extent extent)
{
    if (extent == Extent::quick) {
        return {{30}, {1e-6}, 4};
    }
    return {{30, 100, 300, 1000, 3000}, {1e-3, 1e-6, 1e-9, 1e-12}, 30};
}

constexpr double leastOfE = 1.0;  // [E_1], by a quadratic program on four cells
constexpr std::int64_t largestWithAllTolerances = 300;
constexpr double leftOutOnLargeGrids = 1e-9;

/// The forms of the benchmark's own rows know one stop.
std::vector<std::string_view> formsFor(const Problem& problem, bool sumsWillDo)
{
    std::vector<std::string_view> names;
    if (!problem.schedule.stops.left) {
        names = comparedForms();
    }
    names.emplace_back("reduced");
    if (sumsWillDo) {
        names.emplace_back("lumped");
    }
    return names;
}

/// One request on growing grids: all back ends, all forms, all tolerances, then our own answer.
void addFamily(std::vector<Case>& cases, Problem (*family)(std::int64_t), const char* letter,
               const char* what, const std::vector<std::string_view>& backEnds, bool sumsWillDo,
               const Range& range, Problem (*demand)(Problem))
{
    const CaseName name{"accuracy", fmt::format("{} {}", letter, what), what};
    for (const std::int64_t cells : range.cells) {
        const Problem problem = demand(family(cells));
        for (const double tolerance : range.tolerances) {
            // On large grids the ends of the range and the usual value say enough.
            if (cells > largestWithAllTolerances && tolerance == leftOutOnLargeGrids) {
                continue;
            }
            cases.push_back(libraryCase(name, problem, tolerance));
            if (problem.schedule.phases.size() == 1) {
                cases.push_back(closedFormCase(name, problem, tolerance));
            }
            for (const std::string_view backEnd : backEnds) {
                if (!hasTolerance(backEnd) && tolerance != usualTolerance) {
                    continue;
                }
                for (const std::string_view form : formsFor(problem, sumsWillDo)) {
                    cases.push_back(programCase(name, problem, backEnd, form, tolerance));
                }
            }
        }
    }
}

}  // namespace

std::vector<Case> accuracySuite(Extent extent)
{
    const Range range = rangeOf(extent);
    std::vector<Case> cases;
    const auto asIs = [](Problem problem) { return problem; };
    addFamily(cases, familyA, "A", "any", linearBackEnds(), true, range, asIs);
    addFamily(cases, familyB, "B", "any", linearBackEnds(), true, range, asIs);
    addFamily(cases, familyC, "C", "any", linearBackEnds(), true, range, asIs);
    addFamily(cases, familyA, "A", "least energy", quadraticBackEnds(), true, range,
              [](Problem problem) { return leastEnergyOf(std::move(problem), 4.0); });
    addFamily(cases, familyB, "B", "least energy", quadraticBackEnds(), true, range,
              [](Problem problem) { return leastEnergyOf(std::move(problem), 4.0 / 3.0); });
    addFamily(cases, familyD, "D", "any", linearBackEnds(), true, range, asIs);
    addFamily(cases, familyE, "E", "any", linearBackEnds(), true, range, asIs);
    addFamily(cases, familyD, "D", "least energy", quadraticBackEnds(), true, range,
              [](Problem problem) { return leastEnergyOf(std::move(problem), 4.0); });
    addFamily(cases, familyE, "E", "least energy", quadraticBackEnds(), true, range,
              [](Problem problem) { return leastEnergyOf(std::move(problem), 8.0); });
    addFamily(cases, familyA, "A", "energy 20", energyBackEnds(), false, range,
              [](Problem problem) { return withEnergy(std::move(problem), 20.0); });

    const CaseName random{"accuracy", "", "any"};
    const auto addRandom = [&](const Problem& problem) {
        cases.push_back(libraryCase(random, problem, usualTolerance));
        for (const std::string_view backEnd : linearBackEnds()) {
            for (const char* form : {"sy", "ky", "reduced"}) {
                cases.push_back(programCase(random, problem, backEnd, form, usualTolerance));
            }
        }
    };
    for (const Problem& problem : randomProblems(range.randomSchedules)) {
        addRandom(problem);
    }
    for (const Problem& problem : randomPhases(range.randomSchedules / 2)) {
        addRandom(problem);
    }
    return cases;
}

}  // namespace signorini::bench
