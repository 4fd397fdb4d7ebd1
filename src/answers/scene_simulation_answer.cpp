#include "scene_simulation_answer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "largest.hpp"
#include "network_watched.hpp"

namespace signorini::answers {

SceneDrive drivenBy(const Network& network, Drive drive)
{
    Faults faults;
    requireExcitable(faults, network, drive.place);
    faults.throwIfAny();
    const NetworkScales& scales = network.scales;
    const double unit = drive.place == Excited::tip ? scales.force() : scales.displacement;
    const double omega = drive.frequencyRatio * referenceOf(network).frequency;
    SceneDrive made{drive, harmonicDrive(network, drive.place, drive.amplitude / unit,
                                         omega * scales.time, drive.phase)};
    made.told->steps =
        static_cast<std::int64_t>(std::round(made.moved.period / made.moved.drive.step));
    made.told->period = made.moved.period * scales.time;
    return made;
}

namespace {

/// Where nothing is said, what is there.
Excited placeIn(const Network& network, const ForceOptions& force)
{
    const bool hasForce = isExcitable(network, Excited::tip);
    if (!force.place && hasForce == isExcitable(network, Excited::base)) {
        refuse("--amplitude", fmt::format("{}", *force.amplitude),
               "a scene with one word driven (a force [N]) or shaken (a clamp [m]); --force "
               "tip|base says which of two");
    }
    return force.place.value_or(hasForce ? Excited::tip : Excited::base);
}

}  // namespace

SceneDrive driveAsked(const Call& call, const Network& network)
{
    ForceOptions force(call);
    const FrequencyOption frequency(call, "--frequency", "--hertz");
    refuseIf(force.amplitude.has_value() != frequency.isGiven(),
             "--amplitude, --frequency: allowed only together");
    if (!force.amplitude) {
        refuseIf(force.place || call.has("--periods"),
                 "--force, --periods: allowed only together with --amplitude and --frequency");
        return {};
    }
    const Excited place = placeIn(network, force);
    if (place == Excited::tip && force.derivative > 0) {
        refuse("--amplitude-" + std::string(amplitudeOf(Excited::base, force.derivative)),
               fmt::format("{}", *force.amplitude), "only for a base that is shaken");
    }
    return drivenBy(network, driveAsked(call, firstHertz(referenceOf(network)), place));
}

NetworkStart startOf(const Network& network, std::vector<double> speeds)
{
    constexpr double largest = 1e100;  // so that energies are numbers
    for (double& speed : speeds) {
        const double scaled = speed / network.scales.velocity();
        const double joules = scaled * scaled * network.scales.energy();
        if (!(std::max(std::abs(scaled), joules) <= largest)) {
            refuse("--velocity", fmt::format("{}", speed),
                   fmt::format("speeds whose energies are numbers: at most {:.3g} [m/s] or 1e100 J",
                               largest * network.scales.velocity()));
        }
        speed = scaled;
    }
    return startWithSpeeds(network, speeds);
}

namespace {

/// How long a call asks for [h].
double durationOf(const Call& call, const Network& network, const SceneDrive& drive)
{
    const auto periods = call.whole("--periods");
    const auto time = call.number("--time");
    const double duration =
        periods ? static_cast<double>(*periods) * drive.moved.period : *time / network.scales.time;
    const double most = 1e9 * static_cast<double>(network.cells());
    if (!(duration <= most)) {
        const std::string allowed =
            fmt::format("what lasts at most {:.3g} s", most * network.scales.time);
        periods ? throwFault("periods", *periods, allowed) : throwFault("time", *time, allowed);
    }
    return duration;
}

}  // namespace

FollowedBars::FollowedBars(const Call& call, const Assembly& assembly, const Network& network,
                           const SceneDrive& drive, const NetworkStart& start, bool recordsPaths)
    : answer{.bars = severalOf(assembly, network), .drive = drive.told},
      simulation{network,
                 start,
                 driveFrom(network, start, drive.moved),
                 {.mergeBelow = 1e-12 * std::max(1.0, largestSizeOf(start.waves)),
                  .recordsPaths = recordsPaths}},
      moved(drive.moved),
      duration(durationOf(call, network, drive))
{
}

std::vector<NetworkContactEvent> contactsOf(const NetworkSimulation& simulation)
{
    const NetworkScales& scales = simulation.network().scales;
    std::vector<NetworkContactEvent> contacts = simulation.contacts();
    for (NetworkContactEvent& contact : contacts) {
        contact.start *= scales.time;
        contact.end *= scales.time;
        contact.impulse *= scales.force() * scales.time;
        contact.peakForce *= scales.force();
        contact.speed *= scales.velocity();
    }
    return contacts;
}

void FollowedBars::follow(const Watch& watch)
{
    const bool isHarmonic = moved.period > 0.0;
    const double stretch =
        isHarmonic ? moved.period : 16.0 * static_cast<double>(simulation.network().cells());
    WatchedNetwork seen(simulation, moved.drive);
    Followed followed =
        signorini::follow(seen, stretch, duration / stretch, watch.cancel, watch.show);
    answer.isComplete = followed.isComplete;
    answer.settling = isHarmonic ? std::move(followed.settling) : Settling{};
    answer.see(simulation);
}

void SceneSimulationAnswer::see(const NetworkSimulation& simulation)
{
    const NetworkScales& scales = simulation.network().scales;
    impulseUnit = scales.force() * scales.time;
    contacts.clear();
    for (const SceneContact& contact : bars.contacts) {
        contacts.push_back({contact});
    }
    for (const NetworkContactEvent& event : simulation.contacts()) {
        ContactTotals& total = contacts[event.contact];
        ++total.count;
        total.impulse += event.impulse * impulseUnit;
        total.peakForce = std::max(total.peakForce, event.peakForce * scales.force());
        total.time += (event.end - event.start) * scales.time;
    }
    time = simulation.time() * scales.time;
    energy = simulation.energy() * scales.energy();
    const NetworkBalance seen = simulation.balance();
    balance = {seen.work * scales.energy(), seen.dissipated * scales.energy(),
               seen.error * scales.energy(), seen.size * scales.energy()};
    const MomentumBalance pushed = simulation.momentumBalance();
    momentum = {pushed.given * impulseUnit, pushed.error * impulseUnit, pushed.size * impulseUnit};
    events = simulation.events();
    fronts = static_cast<std::int64_t>(simulation.fronts());
    merged = simulation.merged() * scales.displacement;
}

}  // namespace signorini::answers
