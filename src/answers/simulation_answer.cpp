#include "simulation_answer.hpp"

#include <algorithm>
#include <utility>

#include "faults.hpp"
#include "stepped_bar.hpp"

namespace signorini::answers {

Excitation Drive::excitation(const Bar& bar, double cells, std::string_view field)
{
    Excitation made = excitationAt({.place = place,
                                    .amplitude = amplitude / amplitudeUnit(place, bar),
                                    .phase = phase,
                                    .stepsPerCrossing = cells},
                                   frequencyRatio, field);
    follow(made, bar);
    return made;
}

void Drive::follow(const Excitation& excitation, const Bar& bar)
{
    steps = excitation.steps();
    period = static_cast<double>(steps) / excitation.stepsPerCrossing * scales(bar).time;
}

void requireWhole(const Call& call, bool isOfBars)
{
    const auto given = [&call](std::initializer_list<const char*> options) {
        return std::count_if(options.begin(), options.end(),
                             [&call](const char* option) { return call.has(option); });
    };
    refuseIf(given({"--rest", "--from", "--velocity"}) > 1,
             "--rest, --from, --velocity: allowed one of them: each is a start");
    const bool isPlaced = call.has("--force");
    const bool isSized =
        given({"--amplitude", "--amplitude-velocity", "--amplitude-acceleration"}) > 0;
    const bool isTimed = given({"--frequency", "--hertz"}) > 0;
    const bool isDriven = isPlaced || isSized || isTimed;
    const bool hasPeriods = call.has("--periods");
    refuseIf(call.has("--force-file") && (isDriven || hasPeriods),
             "--force-file clashes with --force, --amplitude, --frequency and --periods: allowed a "
             "force of one kind, and --time");
    refuseIf(!isOfBars && isDriven && !(isPlaced && isSized && isTimed),
             "--force, --amplitude, --frequency: allowed only all three together");
    refuseIf(!isOfBars && hasPeriods && !isPlaced, "--periods: allowed only together with --force");
    refuseIf(call.has("--time") && hasPeriods,
             "--time clashes with --periods: allowed one of them");
    refuseIf(!call.has("--time") && !hasPeriods, "--time, --periods: missing: allowed one of them");
}

Drive driveAsked(const Call& call, double firstHertz, Excited place)
{
    const ForceOptions force(call);
    const double ratio = FrequencyOption(call, "--frequency", "--hertz").ratioFor(firstHertz);
    return {place, force.at(ratio * firstHertz).amplitude.value(), ratio,
            call.number("--phase").value_or(0.0)};
}

std::string_view name(Ending ending)
{
    switch (ending) {
        case Ending::done:
            return "done";
        case Ending::interrupted:
            return "interrupted";
    }
    return {};
}

void SimulationAnswer::see(const BarSimulation& simulation)
{
    time = simulation.time();
    contactCount = static_cast<std::int64_t>(simulation.contacts().size());
    impulse = simulation.impulse();
    tip = simulation.tip();
    isHeld = simulation.isHeld();
    heldAt = simulation.stop();
    energyRatio = simulation.energyRatio();
    balance = simulation.balance();
    events = simulation.events();
    pieces = simulation.pieces();
    merged = simulation.merged();
}

Bar SimulationAnswer::bar() const
{
    return firstMaterial(scene);
}

void FollowedBar::follow(const Watch& watch)
{
    Followed followed = signorini::follow(simulation, stretch, total, watch.cancel, watch.show);
    answer.isComplete = followed.isComplete;
    answer.settling = answer.drive ? std::move(followed.settling) : Settling{};
    answer.see(simulation);
}

FollowedBar started(SimulationAnswer asked, const Waves& start, const Excitation& driving,
                    const SimulationWish& wish)
{
    constexpr double longest = 1e9;  // [L/c]
    const double unit = scales(asked.bar()).time;
    const double crossing = start.crossing;
    const double stretch = stretchOf(asked.drive ? driving : Excitation{}, crossing);
    const double total =
        wish.periods ? static_cast<double>(*wish.periods) : *wish.time / unit * crossing / stretch;
    if (!(total * stretch <= longest * crossing)) {
        const std::string allowed =
            fmt::format("what lasts at most {} L/c, {:.3g} s", longest, longest * unit);
        wish.periods ? throwFault("periods", *wish.periods, allowed)
                     : throwFault("time", *wish.time, allowed);
    }
    const std::vector<Segment>& parts = asked.scene.segments;
    asked.cells = static_cast<std::int64_t>(crossing);
    asked.resolution = wish.resolution ? *wish.resolution / unit : 1.0 / driving.stepsPerCrossing;
    BarSimulation simulation(start, asked.damping, driving,
                             {.mergeBelow = {},
                              .recordsTip = wish.recordsTip,
                              .stops = stopsOf(asked.scene),
                              .segments = isUniform(parts) ? std::vector<Segment>{} : parts,
                              .resolution = asked.resolution});
    return {std::move(asked), std::move(simulation), stretch, total};
}

}  // namespace signorini::answers
