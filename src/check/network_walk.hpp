#pragma once
/// \file
/// Checks a state of any network: cells that are moved by a law written down here once more, along
/// a schedule of sets of closed contacts or by their own decisions, and that know nothing of
/// programs, matrices or who found the state.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "contact_spans.hpp"

namespace signorini {

/// What is to be checked; units as in network.hpp.
struct NetworkClaim {
    std::vector<double> waves = {};          ///< in the order of Network::waves
    std::vector<double> displacements = {};  ///< of the nodes, at the start
    std::vector<ContactSpan> schedule = {};  ///< one period
    std::vector<double> forces = {};         ///< on the driven nodes, step by step; empty: none
    std::vector<double> velocities = {};     ///< of the shaken clamps; empty: none
    /// Lengths are compared with it; 0: with the largest wave times the steps in which it crosses
    /// all cells, or a wider gap.
    double length = 0.0;
    double wave = 0.0;  ///< waves are compared with it; 0: with the largest of them

    /// Of one period.
    [[nodiscard]] std::int64_t steps() const { return stepsOf(schedule); }
};

/// What a contact saw.
struct ContactExtremes {
    double impulse = 0.0;
    double peakForce = 0.0;
    std::int64_t pressed = 0;  ///< steps in which it presses
    double approach = 0.0;     ///< largest speed with which it closes

    friend bool operator==(const ContactExtremes&, const ContactExtremes&) = default;
};

/// What a network reaches in a period. Strains are those of motions: waves that meet before the
/// period or after it are among them.
struct NetworkExtremes {
    std::vector<ContactExtremes> contacts;
    double leastStrain = 0.0;  ///< of (l - r)/speed, in cells, between them and at their nodes, and
                               ///< of the shape at rest under constant forces
    double mostStrain = 0.0;
    std::vector<double> leastDisplacements;  ///< by node

    [[nodiscard]] double largestStrain() const { return std::max(-leastStrain, mostStrain); }
};

/// Violations, 0 where there are none; all infinite if a value is not finite.
struct NetworkResiduals {
    double periodicity = 0.0;  ///< change of waves / largest wave, of displacements / a cell count
    double tie = 0.0;          ///< displacements at the start that do not follow from the waves
    double gap = 0.0;          ///< |distance| where a contact is closed that was open
    double pressure = 0.0;     ///< deepest pull of a closed contact / largest force of a wave
    double penetration = 0.0;  ///< deepest overlap of an open contact
    double balance = 0.0;      ///< |work of forces and clamps - dissipation| / what was exchanged
    std::vector<double> impulses = {};    ///< by contact, over the period
    std::vector<double> peakForces = {};  ///< by contact
    NetworkExtremes extremes = {};
    std::vector<ContactSet> pressed = {};  ///< in each part of the schedule: those that press
    /// The largest of the six.
    [[nodiscard]] double worst() const;
    /// Does any contact press?
    [[nodiscard]] bool presses() const;
};

/// Walks a state along the schedule for one period. A push of less than `tolerance` times what the
/// largest wave can press is none, a distance of less than that of the length none, either.
/// O(M + n nodes): a row is two rings.
/// \throws std::invalid_argument on an invalid network or schedule, sets without a law, or numbers
/// of values that do not fit.
[[nodiscard]] NetworkResiduals walk(const Network& network, const NetworkClaim& claim,
                                    double tolerance = 1e-9);

/// By how much strain goes beyond the limit of the network, relative to the limit or the strain of
/// the largest wave; 0: it does not.
[[nodiscard]] double strainExcess(const Network& network, const NetworkClaim& claim,
                                  const NetworkExtremes& seen);

/// What time stepping saw that is not told the schedule.
struct NetworkMarch {
    double residual = 0.0;         ///< change of the waves over the period / largest wave, or the
                                   ///< overlap / length at a fault
    std::int64_t firstFault = -1;  ///< step in which contacts overlap; -1: none
    std::int64_t repeats = 0;  ///< steps, a divisor of n, after which the waves are back; 0: none
    std::vector<ContactSpan> pressed;  ///< the contacts that press, step after step
    NetworkExtremes extremes;
};

/// Marches a state for as many steps as its schedule has, of which nothing else is asked: in each
/// step contacts without distance that are pushed close (the one that is overlapped fastest first),
/// and closed ones that would pull open. A contact that would be met in the middle of a step is a
/// fault. As `walk`; waves are compared where a part of the period has passed, O(M) each.
[[nodiscard]] NetworkMarch march(const Network& network, const NetworkClaim& claim,
                                 double tolerance = 1e-9);

}  // namespace signorini
