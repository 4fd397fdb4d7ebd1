#pragma once
/// \file
/// Cases that hand a problem to a solver, or to the library as a whole, time it and judge it.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "forms.hpp"
#include "problems.hpp"
#include "runner.hpp"
#include "solver.hpp"

namespace signorini::bench {

/// What a case is called.
struct CaseName {
    std::string suite;
    std::string series;   ///< see Case
    std::string setting;  ///< in front of the tolerance, e.g. "least energy"
};

/// Back ends of the library and CLP that can solve programs of this kind.
[[nodiscard]] std::vector<std::string_view> linearBackEnds();
[[nodiscard]] std::vector<std::string_view> quadraticBackEnds();
[[nodiscard]] std::vector<std::string_view> energyBackEnds();

/// Can it be told how accurate to be? Of those that cannot, one tolerance is enough.
[[nodiscard]] bool hasTolerance(std::string_view backEnd);

/// \throws BackendUnavailable if this build does not contain it.
[[nodiscard]] std::unique_ptr<Solver> makeRival(std::string_view backEnd);

/// Rows, entries and unknowns of a program.
void recordSize(const Program& program, Record& record);

/// The problem in one form, by one back end.
[[nodiscard]] Case programCase(const CaseName& name, const Problem& problem,
                               std::string_view backEnd, std::string_view form, double tolerance,
                               const Kept& kept = {});

/// `findPeriodic` with the route it chooses itself, verification included.
[[nodiscard]] Case libraryCase(const CaseName& name, const Problem& problem, double tolerance);

/// Verdict and state from the closed form alone; one contact phase.
[[nodiscard]] Case closedFormCase(const CaseName& name, const Problem& problem, double tolerance);

}  // namespace signorini::bench
