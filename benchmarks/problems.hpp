#pragma once
/// \file
/// What is asked: schedules whose truth is known before any solver is called.

#include <optional>
#include <string>
#include <vector>

#include "signorini/demands.hpp"

namespace signorini::bench {

/// A request and its right answer.
struct Problem {
    std::string name;
    Schedule schedule;
    Demands demands = {.objective = Objective::any};
    bool exists = false;                               ///< is there such a motion?
    std::optional<double> leastEnergy = std::nullopt;  ///< [E_1], when it is asked for
    Scene scene = {};                                  ///< the stops are the schedule's, too
};

/// Family A, n_c = N/2, n_f = 3N: motions exist, E_min = 4 E_1, a simplex.
[[nodiscard]] Problem familyA(std::int64_t cells);
/// Family B, n_c = N/2, n_f = 7N/2: motions exist, E_min = 4/3 E_1, a box: they graze.
[[nodiscard]] Problem familyB(std::int64_t cells);
/// Family C, n_c = N/2, n_f = 4N: none exists.
[[nodiscard]] Problem familyC(std::int64_t cells);

/// Family D, pressed at rest, n_c = 3N/2, n_f = N: motions exist, E_min = 4 E_1, a simplex.
[[nodiscard]] Problem familyD(std::int64_t cells);
/// Family E, two stops at equal distances, on the next N divisible by 4, n_c = N/4, n_f = 5N/4 on
/// each: motions exist, E_min = 8 E_1: p = +-2 g/L in steps that are N/2 apart.
[[nodiscard]] Problem familyE(std::int64_t wanted);

/// The same request for the motion of least energy, or for a motion of given energy.
[[nodiscard]] Problem leastEnergyOf(Problem problem, double leastEnergy);
[[nodiscard]] Problem withEnergy(Problem problem, double energyRatio);

/// One-phase schedules on 20..60 cells, the same for the same seed; half of them have motions.
[[nodiscard]] std::vector<Problem> randomProblems(int count);

/// Two and three phases on up to 12 cells; half of them have motions.
[[nodiscard]] std::vector<Problem> randomPhases(int count);

}  // namespace signorini::bench
