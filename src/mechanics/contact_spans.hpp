#pragma once
/// \file
/// A schedule of any network: which contacts are closed, step after step; and distances at contacts
/// as functions of the waves.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "network.hpp"
#include "signorini/motion.hpp"

namespace signorini {

/// Most steps of a period of a network, nodes times steps being what its programs are made of.
inline constexpr std::int64_t maxNetworkSteps = 1'000'000;

/// Steps in which the same contacts are closed.
struct ContactSpan {
    ContactSet closed = 0;
    std::int64_t steps = 0;

    friend bool operator==(const ContactSpan&, const ContactSpan&) = default;
};

/// The words of a schedule: NC NF [NC NF ...] where there is one contact, else SET:STEPS ..., SET
/// the numbers of closed contacts, from 1, joined by +, or - for none.
/// \throws std::invalid_argument naming the word and what is allowed.
[[nodiscard]] std::vector<ContactSpan> spansOf(const std::vector<std::string>& words,
                                               std::size_t contacts);
/// "1:2 -:9 1+2:3 -:8".
[[nodiscard]] std::string textOf(const std::vector<ContactSpan>& schedule);

/// Numbers of the contacts of a set, from 1.
[[nodiscard]] std::vector<std::int64_t> numbersOf(ContactSet closed);

/// Of one period.
[[nodiscard]] std::int64_t stepsOf(std::span<const ContactSpan> schedule);

/// The same [s].
[[nodiscard]] inline double periodOf(const Network& network, std::span<const ContactSpan> schedule)
{
    return static_cast<double>(stepsOf(schedule)) * network.scales.time;
}

/// A schedule of a bar with one stop or two, bit 0 is the wall, bit 1 the second stop; or of bars
/// in a row, one contact after the other (`Stop`).
[[nodiscard]] inline std::vector<ContactSpan> spansOf(const Schedule& schedule)
{
    std::vector<ContactSpan> spans;
    for (const Phase& phase : schedule.phases) {
        spans.push_back({ContactSet{1} << static_cast<unsigned>(phase.stop), phase.contact});
        spans.push_back({0, phase.free});
    }
    return spans;
}

/// What drives a network, step by step: the force on driven nodes, the velocity of shaken clamps,
/// and their place when the step begins.
struct StepDrive {
    std::vector<double> forces = {};
    std::vector<double> velocities = {};
    std::vector<double> places = {};
};

/// One period of an excitation of the tip or the base of a bar, in units of its network.
[[nodiscard]] StepDrive driveOf(const Excitation& excitation);

/// The waves of a bar's state as those of its network, and back: a cell's a is what runs to the
/// right. O(M). \pre one bar of as many cells, without stubs.
[[nodiscard]] std::vector<double> wavesOf(const Network& network, const State& state);
[[nodiscard]] State stateOf(const Network& network, std::span<const double> waves);

/// Adds factor times the derivatives of the distance at a contact by the waves (`Network::waves`).
/// Returns that by the place of the shaken clamps. O(cells of its bars).
double addDistance(std::span<double> derivatives, const Network& network, std::size_t contact,
                   double factor);

/// What strain >= -limit asks of two waves of a row that arrive at its right end and at its left
/// end in these steps of a period: l - r is this or more. None: they do not pass each other. O(1).
/// \pre steps of the period.
[[nodiscard]] std::optional<double> leastDifference(const Network& network, double limit,
                                                    std::size_t row, std::int64_t right,
                                                    std::int64_t left, std::int64_t steps);

/// The same without constant forces.
[[nodiscard]] Network withoutForces(Network network);

/// The bars that drift, from the left: the displacement of their first node is an unknown.
[[nodiscard]] std::vector<std::size_t> driftingBars(const Network& network);

/// Bars among these with whose displacement a distance grows (1) or shrinks (-1).
[[nodiscard]] std::vector<std::pair<std::size_t, int>> driftsOf(const Network& network,
                                                                std::size_t contact);

/// What holds for the waves of bars that are held more than once, at all times: each list times the
/// waves is 0, at further clamps (u = 0, the base at rest) and springs (w = -u). O(waves) each.
[[nodiscard]] std::vector<std::vector<double>> tiesOf(const Network& network);

/// Z of each wave, in the order of Network::waves.
[[nodiscard]] std::vector<double> impedancesOf(const Network& network);

}  // namespace signorini
