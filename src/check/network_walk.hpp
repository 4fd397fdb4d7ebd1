#pragma once
/// \file
/// Checks a state of any network against a schedule of sets of closed contacts: cells that are
/// moved by a law written down here once more, and that know nothing of programs, matrices or who
/// found the state.

#include <cstdint>
#include <span>
#include <vector>

#include "network.hpp"

namespace signorini {

/// Steps in a row with the same contacts closed.
struct ContactSteps {
    ContactSet closed = 0;
    std::int64_t steps = 0;
};

/// What is to be checked; units as in network.hpp.
struct NetworkClaim {
    std::vector<double> waves = {};           ///< in the order of Network::waves
    std::vector<double> displacements = {};   ///< of the nodes, at the start
    std::vector<ContactSteps> schedule = {};  ///< one period
    std::vector<double> forces = {};          ///< on the driven nodes, step by step; empty: none
    std::vector<double> velocities = {};      ///< of the shaken clamps; empty: none
};

/// Violations, 0 where there are none; all infinite if a value is not finite.
struct NetworkResiduals {
    double periodicity = 0.0;  ///< change of waves / largest wave, of displacements / a cell count
    double tie = 0.0;          ///< displacements at the start that do not follow from the waves
    double gap = 0.0;          ///< |distance| where a contact is closed that was open
    double pressure = 0.0;     ///< deepest pull of a closed contact / largest force of a wave
    double penetration = 0.0;  ///< deepest overlap of an open contact
    std::vector<double> impulses = {};    ///< by contact, over the period
    std::vector<double> peakForces = {};  ///< by contact

    /// The largest of the five.
    [[nodiscard]] double worst() const;
};

/// Walks a state along the schedule for one period. Lengths are relative to the largest wave times
/// the steps in which it crosses all cells. O(M + n nodes): a row is two rings.
/// \throws std::invalid_argument on an invalid network or schedule, sets without a law, or numbers
/// of values that do not fit.
[[nodiscard]] NetworkResiduals walk(const Network& network, const NetworkClaim& claim);

}  // namespace signorini
