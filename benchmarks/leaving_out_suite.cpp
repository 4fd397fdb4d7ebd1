#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "signorini/one_phase_set.hpp"
#include "solving.hpp"
#include "suites.hpp"

namespace signorini::bench {

namespace {

constexpr std::array solvers{"glpk-simplex", "clp-simplex"};

/// From what the library does to the paper's (32) as it stands.
constexpr std::array shapes{"lumped", "reduced", "kd",           "ky",   "dy",
                            "sy",     "sd",      "sd-redundant", "paper"};

}  // namespace

std::vector<Case> leavingOutSuite(Extent extent)
{
    const bool isFull = extent == Extent::full;
    std::vector<Case> cases;
    const CaseName exists{"leaving-out", "", "any"};
    for (const std::int64_t cells :
         isFull ? std::vector<std::int64_t>{30, 60, 300} : std::vector<std::int64_t>{30}) {
        for (const Problem& problem : {familyA(cells), familyC(cells)}) {
            cases.push_back(closedFormCase(exists, problem, usualTolerance));
            cases.push_back(libraryCase(exists, problem, usualTolerance));
            for (const char* solver : solvers) {
                for (const char* shape : shapes) {
                    cases.push_back(programCase(exists, problem, solver, shape, usualTolerance));
                }
            }
        }
    }

    // A strain limit: one bound per unknown, or a row for each cell and step.
    for (const std::int64_t cells :
         isFull ? std::vector<std::int64_t>{10, 30, 100} : std::vector<std::int64_t>{10}) {
        Problem problem = familyA(cells);
        problem.name = "strain limit " + problem.name;
        problem.demands.strainLimit =
            1.5 * extremesOf(leastEnergyMotion(onePhaseSet(problem.schedule)), problem.schedule)
                      .peakCompression;
        const CaseName limit{"leaving-out", "", "strain limit"};
        cases.push_back(libraryCase(limit, problem, usualTolerance));
        for (const char* solver : solvers) {
            for (const char* shape : {"lumped", "reduced"}) {
                cases.push_back(programCase(limit, problem, solver, shape, usualTolerance));
            }
            for (const char* shape : {"kd", "ky", "sy"}) {
                Case all = programCase({"leaving-out", "", "strain limit all rows"}, problem,
                                       solver, shape, usualTolerance, {.strainRows = true});
                cases.push_back(std::move(all));
            }
        }
    }

    // A long flight: folded to less than 8N steps, or written down in full.
    Problem flight = familyB(isFull ? 60 : 12);
    flight.schedule.phases.front().free += 100 * 4 * flight.schedule.cells;
    flight.name = fmt::format("flight of 403.5 N steps N={}", flight.schedule.cells);
    const CaseName folded{"leaving-out", "", "folded"};
    cases.push_back(libraryCase(folded, flight, usualTolerance));
    for (const char* solver : solvers) {
        for (const char* shape : {"sy", "dy"}) {
            cases.push_back(programCase(folded, flight, solver, shape, usualTolerance));
            cases.push_back(programCase({"leaving-out", "", "not folded"}, flight, solver, shape,
                                        usualTolerance, {.longPhases = true}));
        }
    }
    return cases;
}

}  // namespace signorini::bench
