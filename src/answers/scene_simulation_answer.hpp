#pragma once
/// \file
/// What moves bars in a row, and what a simulation of them came to.

#include "network_sweep.hpp"
#include "scene_answer.hpp"
#include "watch.hpp"

namespace signorini::answers {

/// A harmonic as answers tell it, and in units of the network.
struct SceneDrive {
    std::optional<Drive> told = {};
    HarmonicDrive moved = {};  ///< nothing, in steps of h, without
};

/// The harmonic of this place, amplitude, frequency and phase; its steps follow.
/// \throws std::invalid_argument naming force or frequency where nothing is there to excite, or a
/// period has too few or too many steps.
[[nodiscard]] SceneDrive drivenBy(const Network& network, Drive drive);
/// The one that a call asks for, whose place need not be said where there is one.
/// \throws std::invalid_argument on options that do not go together, and as drivenBy.
[[nodiscard]] SceneDrive driveAsked(const Call& call, const Network& network);

/// Undeformed, each bar with its own speed [m/s]. \throws std::invalid_argument naming one whose
/// energy is no number, and as startWithSpeeds.
[[nodiscard]] NetworkStart startOf(const Network& network, std::vector<double> speeds);

/// All that its contacts did, in SI units.
[[nodiscard]] std::vector<NetworkContactEvent> contactsOf(const NetworkSimulation& simulation);

/// What was seen at one contact since the start, in SI units.
struct ContactTotals {
    static constexpr bool isDictionary = true;
    SceneContact contact;
    std::int64_t count = 0;
    double impulse = 0.0;
    double peakForce = 0.0;
    double time = 0.0;
};

/// [N s]
struct Momentum {
    static constexpr bool isDictionary = true;
    double given = 0.0;
    double error = 0.0;
    double size = 0.0;  ///< what the error is to be compared with
};

/// The outcome of one call, in SI units.
struct SceneSimulationAnswer {
    SeveralBars bars = {};
    std::optional<Drive> drive = {};
    Settling settling = {};
    bool isComplete = true;

    double time = 0.0;
    std::vector<ContactTotals> contacts = {};
    double energy = 0.0;
    Balance balance = {};
    Momentum momentum = {};
    std::int64_t events = 0;
    std::int64_t fronts = 0;
    double merged = 0.0;
    double impulseUnit = 1.0;  ///< of what it settled on

    /// Takes what was seen so far.
    void see(const NetworkSimulation& simulation);
    [[nodiscard]] Ending status() const { return isComplete ? Ending::done : Ending::interrupted; }
};

/// Bars that a call has followed, and their answer.
struct FollowedBars {
    SceneSimulationAnswer answer;
    NetworkSimulation simulation;
    HarmonicDrive moved;
    double duration;  ///< [h]

    /// From a start to --time or --periods of the drive; faded jumps become one.
    /// \throws std::invalid_argument naming those if they are beyond 1e9 crossings of all bars.
    FollowedBars(const Call& call, const Assembly& assembly, const Network& network,
                 const SceneDrive& drive, const NetworkStart& start, bool recordsPaths);
    /// Goes to the end, and takes what was seen.
    void follow(const Watch& watch);
};

void describe(auto& d, Type<ContactTotals>)
{
    using T = ContactTotals;
    d.record("SceneContactTotals", "A contact of bars, and what a simulation saw there.");
    describeContact(d, &T::contact);
    d.key("count", "- >= 0", "How often it pressed.", &T::count);
    d.key("impulse", "N s >= 0", "In all.", &T::impulse);
    d.key("peak_force", "N >= 0", "Largest.", &T::peakForce);
    d.key("contact_time", "s >= 0", "In all.", &T::time);
}

void describe(auto& d, Type<Momentum>)
{
    d.record("MomentumBalance", "Momentum of all bars and masses since the start.");
    d.key("given", "N s", "By forces, dashpots, springs, clamps and stops.", &Momentum::given);
    d.key("error", "N s", "What does not add up.", &Momentum::error);
}

void describe(auto& d, Type<SceneSimulationAnswer>)
{
    using T = SceneSimulationAnswer;
    d.record("SceneSimulation", "What bars in a row did, event by event.");
    d.key("status", "-", R"("done", or "interrupted".)", &T::status);
    describeBars(d, &T::bars);
    d.key("contacts", "-", "[dict, ...]: each contact, and what was seen there.", &T::contacts);
    d.key("excitation", "-", "What moves driven nodes (tip), or shaken clamps (base).", &T::drive);
    d.key("time", "s >= 0", "Simulated.", &T::time);
    describeSettled(
        d, [](const T& s) -> const Settling& { return s.settling; },
        [](const T& s) { return s.impulseUnit; });
    d.key("energy", "J >= 0", "At the end, about the shape at rest.", &T::energy);
    d.key("balance", "-", "Of energy since the start.", &T::balance);
    d.key("momentum", "-", "Of momentum since the start.", &T::momentum);
    d.key("events", "- >= 0", "So many.", &T::events);
    d.key("fronts", "- >= 0", "Under way at the end.", &T::fronts);
    d.key("merged", "m >= 0", "Most that merging faded jumps can have moved.", &T::merged);
}

}  // namespace signorini::answers
