#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "excited_amplitude.hpp"
#include "files.hpp"
#include "network_watched.hpp"
#include "printing.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_figures.hpp"
#include "scene_options.hpp"
#include "scene_report.hpp"
#include "simulate_command.hpp"
#include "state_table.hpp"

namespace signorini::cli {

namespace {

constexpr double mostCrossings = 1e9;  // [crossings of all bars]

/// What a call asks for, in the units of its network.
struct Question {
    Assembly assembly;
    Network network;
    NetworkDrive drive = {};
    double period = 0.0;  ///< [h], of the excitation; 0: none
    Excited place = Excited::tip;
    double amplitude = 0.0;       ///< [N] or [m]
    double frequencyRatio = 0.0;  ///< ω/ω₁
    double frequency = 0.0;       ///< [Hz]
    double duration = 0.0;        ///< [h]
};

bool isDriven(const Network& network)
{
    return std::any_of(network.nodes.begin(), network.nodes.end(),
                       [](const NetworkNode& node) { return node.isDriven; });
}

/// The force of a file, constant in each cell's time.
void setHistory(const SimulateCommand& command, Question& question)
{
    const NetworkScales& scales = question.network.scales;
    refuseIf(!isDriven(question.network), "--force-file", command.given.text("--force-file"),
             "a scene with the word driven");
    question.drive.forces =
        command.forceHistory(scales.time, scales.force(), *command.time / scales.time);
}

/// The harmonic force of the driven node, or the base that shakes.
void setDrive(const SimulateCommand& command, Question& question)
{
    const ForceOptions& force = command.force;
    if (!command.given.text("--force-file").empty()) {
        setHistory(command, question);
        return;
    }
    refuseIf(force.amplitude.has_value() != command.frequency.isGiven(),
             "--amplitude, --frequency: allowed only together");
    const auto& nodes = question.network.nodes;
    const bool isShaken = std::any_of(nodes.begin(), nodes.end(),
                                      [](const NetworkNode& node) { return node.isShaken; });
    if (!force.amplitude) {
        refuseIf(force.place || command.periods,
                 "--force, --periods: allowed only together with --amplitude and --frequency");
        return;
    }
    const bool hasForce = isDriven(question.network);
    question.place = force.place.value_or(hasForce ? Excited::tip : Excited::base);
    const bool hasPlace = question.place == Excited::tip ? hasForce : isShaken;
    if (!hasPlace || (!force.place && hasForce && isShaken)) {
        refuse("--amplitude", fmt::format("{}", *force.amplitude),
               "a scene with one word driven (a force [N]) or shaken (a clamp [m]); --force "
               "tip|base says which of two");
    }
    const SceneReference reference = referenceOf(question.network);
    question.frequencyRatio =
        command.frequency.ratioFor(reference.frequency / (2.0 * std::numbers::pi));
    const double omega = question.frequencyRatio * reference.frequency;
    const double exact = 2.0 * std::numbers::pi / (omega * question.network.scales.time);
    const double steps = std::round(exact);
    refuseIf(!(steps >= 3.0 && steps <= static_cast<double>(maxExcitationSteps)), "--frequency",
             fmt::format("{}", question.frequencyRatio),
             fmt::format("periods of 3..{} steps of {:.6g} s, 1/ω₁ = {:.6g} s", maxExcitationSteps,
                         question.network.scales.time, 1.0 / reference.frequency));
    const bool isWhole = std::abs(exact - steps) <= 1e-9 * exact;
    question.drive.step = isWhole ? 1.0 : exact / steps;
    question.period = question.drive.step * steps;
    question.frequency = omega / (2.0 * std::numbers::pi);
    const NetworkScales& scales = question.network.scales;
    const bool isForce = question.place == Excited::tip;
    if (isForce && force.derivative > 0) {
        refuse("--amplitude-" + std::string(amplitudeOf(Excited::base, force.derivative)),
               fmt::format("{}", *force.amplitude), "only for a base that is shaken");
    }
    question.amplitude = *force.at(1.0, question.frequency).amplitude;
    const Excitation excitation = excitationOf(
        {.place = question.place,
         .amplitude = question.amplitude / (isForce ? scales.force() : scales.displacement),
         .phase = command.phase,
         .steps = static_cast<std::int64_t>(steps),
         .stepsPerCrossing = 1.0 / question.drive.step});
    for (std::int64_t m = 0; m < excitation.steps(); ++m) {
        if (isForce) {
            question.drive.forces.push_back(excitation.force(m));
        } else {
            question.drive.velocities.push_back(excitation.baseVelocity(m));
        }
    }
}

Question questionOf(const SimulateCommand& command)
{
    Question question;
    if (command.common.hasScene()) {
        refuseIf(command.force.ratio.has_value(),
                 "--damping clashes with --scene: allowed dash=D among its words");
        question.assembly = command.common.assembly();
    } else {
        const Scene scene = command.common.shortForms();
        question.assembly = assemblyOf(scene, command.common.usualCells(), command.force.damping());
        question.assembly.gravity = command.common.gravity;
    }
    question.network = networkOf(question.assembly);
    setDrive(command, question);
    const double unit = question.network.scales.time;
    question.duration = command.periods ? static_cast<double>(*command.periods) * question.period
                                        : *command.time / unit;
    const double most = mostCrossings * static_cast<double>(question.network.cells());
    if (!(question.duration <= most)) {
        refuse(
            command.time ? "--time" : "--periods",
            command.time ? fmt::format("{}", *command.time) : fmt::format("{}", *command.periods),
            fmt::format("what lasts at most {:.3g} s", most * unit));
    }
    return question;
}

NetworkStart startOf(const SimulateCommand& command, const Network& network)
{
    if (!command.given.text("--from").empty()) {
        const std::string path = command.given.text("--from");
        return forFile("--from", path, [&] { return readStateTable(path, network); });
    }
    if (command.speeds.empty()) {
        return startAtRest(network);
    }
    std::vector<double> speeds = command.speeds;
    for (double& speed : speeds) {
        speed /= network.scales.velocity();
    }
    return startWithSpeeds(network, speeds);
}

/// What was seen at one contact.
struct ContactTotals {
    std::int64_t count = 0;
    double impulse = 0.0;
    double peakForce = 0.0;
    double time = 0.0;
};

std::vector<ContactTotals> totalsOf(const NetworkSimulation& simulation)
{
    std::vector<ContactTotals> totals(simulation.network().contacts.size());
    for (const NetworkContactEvent& event : simulation.contacts()) {
        ContactTotals& total = totals[event.contact];
        ++total.count;
        total.impulse += event.impulse;
        total.peakForce = std::max(total.peakForce, event.peakForce);
        total.time += event.end - event.start;
    }
    return totals;
}

struct SceneAnswer {
    const Question& question;
    const NetworkSimulation& simulation;
    bool isComplete = true;
    Settling settling = {};
};

std::string asText(const SceneAnswer& answer)
{
    const NetworkSimulation& simulation = answer.simulation;
    const NetworkScales& scales = simulation.network().scales;
    const double impulseUnit = scales.force() * scales.time;
    std::string text = headline(answer.question.assembly, simulation.network());
    text +=
        fmt::format("{:<12}{:.6g} s, {} events\n", answer.isComplete ? "simulated" : "interrupted",
                    simulation.time() * scales.time, simulation.events());
    std::size_t number = 0;
    for (const ContactTotals& total : totalsOf(simulation)) {
        text += fmt::format(
            "contact {:<4}{} times, impulse {:.6g} N s, peak force {:.6g} N, {:.6g} s in all\n",
            ++number, total.count, total.impulse * impulseUnit, total.peakForce * scales.force(),
            total.time * scales.time);
    }
    if (answer.question.period > 0.0) {
        text += cli::asText(answer.settling, impulseUnit);
    }
    const NetworkBalance energy = simulation.balance();
    const MomentumBalance momentum = simulation.momentumBalance();
    text += fmt::format(
        "energy      {:.10g} J; work {:.6g} J, dissipated {:.6g} J, balance off by {:.3g} of the "
        "largest\nmomentum    balance off by {:.3g} of the largest\n",
        simulation.energy() * scales.energy(), energy.work * scales.energy(),
        energy.dissipated * scales.energy(),
        energy.size > 0.0 ? std::abs(energy.error) / energy.size : 0.0,
        momentum.size > 0.0 ? std::abs(momentum.error) / momentum.size : 0.0);
    if (simulation.merged() > 0.0) {
        text += fmt::format("merged      faded jumps, at most {:.3g} m of displacement in all\n",
                            simulation.merged() * scales.displacement);
    }
    return text;
}

Json excitationAsJson(const SimulateCommand& command, const Question& question)
{
    if (question.period == 0.0) {
        return nullptr;
    }
    return {
        {"force", name(question.place)},
        {"amplitude", question.amplitude},
        {"frequency_ratio", question.frequencyRatio},
        {"frequency", question.frequency},
        {"phase", command.phase},
        {"steps", static_cast<std::int64_t>(std::round(question.period / question.drive.step))}};
}

std::string asJson(const SimulateCommand& command, const SceneAnswer& answer)
{
    const NetworkSimulation& simulation = answer.simulation;
    const NetworkScales& scales = simulation.network().scales;
    const double impulseUnit = scales.force() * scales.time;
    const NetworkBalance energy = simulation.balance();
    const MomentumBalance momentum = simulation.momentumBalance();
    Json contacts = jsonOf(contactsOf(simulation.network(), answer.question.assembly.length));
    std::size_t number = 0;
    for (const ContactTotals& total : totalsOf(simulation)) {
        Json& contact = contacts[number++];
        contact["count"] = total.count;
        contact["impulse"] = total.impulse * impulseUnit;
        contact["peak_force"] = total.peakForce * scales.force();
        contact["contact_time"] = total.time * scales.time;
    }
    Json json = newAnswer();
    json.update(
        Json{{"status", answer.isComplete ? "done" : "interrupted"},
             {"scene", jsonOf(answer.question.assembly)},
             {"reference", jsonOf(referenceOf(simulation.network()))},
             {"contacts", std::move(contacts)},
             {"excitation", excitationAsJson(command, answer.question)},
             {"time", simulation.time() * scales.time},
             {"settled", nullptr},
             {"why", nullptr},
             {"energy", simulation.energy() * scales.energy()},
             {"balance",
              {{"work", energy.work * scales.energy()},
               {"dissipated", energy.dissipated * scales.energy()},
               {"error", energy.error * scales.energy()}}},
             {"momentum",
              {{"given", momentum.given * impulseUnit}, {"error", momentum.error * impulseUnit}}},
             {"events", simulation.events()},
             {"fronts", simulation.fronts()},
             {"merged", simulation.merged() * scales.displacement}});
    if (const std::optional<Settled>& settled = answer.settling.settled) {
        json["settled"] = {{"periods", settled->periods},
                           {"contacts", settled->contacts},
                           {"impulse", settled->impulse * impulseUnit},
                           {"residual", settled->residual}};
    } else if (answer.question.period > 0.0) {
        json["why"] = answer.settling.why;
    }
    return asLine(json);
}

void writeEventsOf(const std::string& path, const NetworkSimulation& simulation)
{
    const NetworkScales& scales = simulation.network().scales;
    writeCsv(path, "contact,start,end,impulse,peak_force,speed", [&](CsvRows& row) {
        for (const NetworkContactEvent& event : simulation.contacts()) {
            row(event.contact + 1, event.start * scales.time, event.end * scales.time,
                event.impulse * scales.force() * scales.time, event.peakForce * scales.force(),
                event.speed * scales.velocity());
        }
    });
}

void writeStatisticsOf(const std::string& path, const NetworkSimulation& simulation)
{
    const NetworkScales& scales = simulation.network().scales;
    std::vector<Impacts> all(simulation.network().contacts.size());
    for (std::size_t contact = 0; contact < all.size(); ++contact) {
        all[contact].contact = fmt::format("{}", contact + 1);
    }
    for (const NetworkContactEvent& event : simulation.contacts()) {
        all[event.contact].impulse.push_back(event.impulse * scales.force() * scales.time);
        all[event.contact].speed.push_back(event.speed * scales.velocity());
    }
    writeImpacts(path, all, simulation.time() * scales.time);
}

void writePaths(const std::string& path, const NetworkSimulation& simulation)
{
    const NetworkScales& scales = simulation.network().scales;
    writeCsv(path, "node,time,displacement", [&](CsvRows& row) {
        for (std::size_t node = 0; node < simulation.paths().size(); ++node) {
            std::vector<NodePoint> points = simulation.paths()[node];
            if (!points.empty() && points.back().time < simulation.time()) {
                points.push_back({simulation.time(), simulation.displacement(node)});
            }
            // Displacements are counted from the shape at rest, which comes back here.
            const double rest = simulation.network().nodes[node].rest;
            for (const NodePoint& point : points) {
                row(node + 1, point.time * scales.time,
                    (point.displacement + rest) * scales.displacement);
            }
        }
    });
}

/// Until its end, or a signal.
void goOn(NetworkSimulation& simulation, const Question& question, const CommonOptions& common,
          SceneAnswer& answer)
{
    const double stretch = question.period > 0.0
                               ? question.period
                               : 16.0 * static_cast<double>(simulation.network().cells());
    WatchedNetwork seen(simulation, question.drive);
    const Followed followed =
        watched(common, "simulating", [&](const Cancel& cancel, const auto& show) {
            return follow(seen, stretch, question.duration / stretch, cancel, show);
        });
    answer.isComplete = followed.isComplete;
    answer.settling = question.period > 0.0 ? followed.settling : Settling{};
}

}  // namespace

ExitStatus simulateScene(const SimulateCommand& command)
{
    if (command.forceRange) {
        return reportReach(command);
    }
    const Question question = questionOf(command);
    Outputs outputs(command.given, {"--events", "--statistics", "--tip", "--figure", "--state"});
    const NetworkStart start = startOf(command, question.network);
    double size = 0.0;
    for (const double wave : start.waves) {
        size = std::max(size, std::abs(wave));
    }
    NetworkSimulation simulation(
        question.network, start, question.drive,
        {.mergeBelow = 1e-12 * std::max(size, 1.0),
         .recordsPaths = command.given.has("--tip") || command.given.has("--figure")});
    SceneAnswer answer{.question = question, .simulation = simulation};
    goOn(simulation, question, command.common, answer);
    if (answer.isComplete) {
        outputs.put("--events", writeEventsOf, simulation);
        outputs.put("--statistics", writeStatisticsOf, simulation);
        outputs.put("--tip", writePaths, simulation);
        outputs.put("--state", [&](const std::string& path) {
            writeStateTable(path, simulation.network(), simulation.state());
        });
        outputs.draw("--figure", [&] { return simulationFigure(simulation); });
        outputs.commit();
    } else {
        command.common.say("interrupted; no file was written");
    }
    writeOut(command.common.wantsJson ? asJson(command, answer) : asText(answer));
    command.common.useOneThread();
    return answer.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
