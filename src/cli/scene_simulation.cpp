#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "excited_amplitude.hpp"
#include "files.hpp"
#include "printing.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_figures.hpp"
#include "scene_report.hpp"
#include "scene_simulation_answer.hpp"
#include "simulate_command.hpp"
#include "state_table.hpp"

namespace signorini::cli {

namespace {

using answers::SceneSimulationAnswer;

/// The force of a file, constant in each cell's time.
answers::SceneDrive historyOf(const SimulateCommand& command, const Network& network)
{
    const NetworkScales& scales = network.scales;
    refuseIf(!isExcitable(network, Excited::tip), "--force-file",
             command.given.text("--force-file"), "a scene with the word driven");
    answers::SceneDrive drive;
    drive.moved.drive.forces =
        command.forceHistory(scales.time, scales.force(), *command.time / scales.time);
    return drive;
}

NetworkStart startOf(const SimulateCommand& command, const Network& network, double base)
{
    if (!command.given.text("--from").empty()) {
        const std::string path = command.given.text("--from");
        return forFile("--from", path, [&] { return readStateTable(path, network); });
    }
    if (command.speeds.empty()) {
        return startAtRest(network, base);
    }
    return answers::startOf(network, command.speeds);
}

std::string asText(const SceneSimulationAnswer& answer)
{
    std::string text =
        fmt::format("{:<12}{:.6g} s, {} events\n", answer.isComplete ? "simulated" : "interrupted",
                    answer.time, answer.events);
    for (const answers::ContactTotals& total : answer.contacts) {
        text += fmt::format(
            "contact {:<4}{} times, impulse {:.6g} N s, peak force {:.6g} N, {:.6g} s in all\n",
            total.contact.number, total.count, total.impulse, total.peakForce, total.time);
    }
    if (answer.drive) {
        text += cli::asText(answer.settling, answer.impulseUnit);
    }
    const auto relative = [](const auto& balance) {
        return balance.size > 0.0 ? std::abs(balance.error) / balance.size : 0.0;
    };
    text += fmt::format(
        "energy      {:.10g} J; work {:.6g} J, dissipated {:.6g} J, balance off by {:.3g} of the "
        "largest\nmomentum    balance off by {:.3g} of the largest\n",
        answer.energy, answer.balance.work, answer.balance.dissipated, relative(answer.balance),
        relative(answer.momentum));
    if (answer.merged > 0.0) {
        text += fmt::format("merged      faded jumps, at most {:.3g} m of displacement in all\n",
                            answer.merged);
    }
    return text;
}

void writeEventsOf(const std::string& path, const NetworkSimulation& simulation)
{
    writeCsv(path, "contact,start,end,impulse,peak_force,speed", [&](CsvRows& row) {
        for (const NetworkContactEvent& event : answers::contactsOf(simulation)) {
            row(event.contact + 1, event.start, event.end, event.impulse, event.peakForce,
                event.speed);
        }
    });
}

void writeStatisticsOf(const std::string& path, const NetworkSimulation& simulation)
{
    std::vector<Impacts> all(simulation.network().contacts.size());
    for (std::size_t contact = 0; contact < all.size(); ++contact) {
        all[contact].contact = fmt::format("{}", contact + 1);
    }
    for (const NetworkContactEvent& event : answers::contactsOf(simulation)) {
        all[event.contact].impulse.push_back(event.impulse);
        all[event.contact].speed.push_back(event.speed);
    }
    writeImpacts(path, all, simulation.time() * simulation.network().scales.time);
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

}  // namespace

ExitStatus simulateScene(const SimulateCommand& command)
{
    if (command.forceRange) {
        return reportReach(command);
    }
    const Given& given = command.given;
    command.common.requireOwnDamping();
    const Assembly& assembly = command.common.assembly();
    const Network network = networkOf(assembly);
    const answers::SceneDrive drive = given.has("--force-file")
                                          ? historyOf(command, network)
                                          : answers::driveAsked(given, network);
    Outputs outputs(given, {"--events", "--statistics", "--tip", "--figure", "--state"});
    answers::FollowedBars bars(given, assembly, network, drive,
                               startOf(command, network, drive.moved.base),
                               given.has("--tip") || given.has("--figure"));
    watched(command.common, "simulating", [&](const answers::Watch& watch) { bars.follow(watch); });
    const SceneSimulationAnswer& answer = bars.answer;
    const NetworkSimulation& simulation = bars.simulation;
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
    report(command.common, answer, assembly, asText(answer));
    command.common.useOneThread();
    return answer.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
