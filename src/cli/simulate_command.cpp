#include "simulate_command.hpp"

#include <algorithm>
#include <cmath>

#include "files.hpp"
#include "force_history.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "scene_simulation.hpp"
#include "signorini/figures.hpp"
#include "signorini/settling.hpp"
#include "simulation_report.hpp"
#include "stepped_bar.hpp"
#include "table.hpp"

namespace signorini::cli {

namespace {

constexpr double longestTime = 1e9;  // [L/c]

/// The segments of a bar that is not uniform.
std::vector<Segment> partsOf(const Scene& scene)
{
    return isUniform(scene.segments) ? std::vector<Segment>{} : scene.segments;
}

}  // namespace

void SimulateCommand::addTo(CLI::App& command)
{
    addFile(command, "--from", fromFile, "state to start from, as find --state writes it");
    addFlag(command, "--rest", fromRest, "start at rest (so without --from)");
    force.addTo(command);
    frequency.addTo(command, "--frequency", "--hertz", "frequency of the excitation, ω/ω₁");
    addWord(command, "--phase", "RAD", "of the excitation at the start, cos(ωt - phase) (0)",
            [this](const std::string& text) { phase = parseReal("--phase", text, "rad"); });
    addPositive(command, "--time", "s", time, "T", "duration in seconds");
    addWhole(command, "--periods", 1, 1'000'000'000, periods, "P",
             "or how many periods of the excitation");
    addPositive(command, "--resolve", "s", resolution, "S",
                "merge contacts no further apart, and average forces over S (a step, L/(N c))");
    addFile(command, "--force-file", forceFile,
            "force on the tip, or where a scene is driven: columns time [s], force [N]");
    addWord(command, "--force-range", "LO,HI",
            "what any force between these can do where a scene is driven, from rest [N]",
            [this](const std::string& text) {
                const std::size_t comma = std::min(text.find(','), text.size());
                const double low = parseReal("--force-range", text.substr(0, comma), "N");
                const double high = comma < text.size()
                                        ? parseReal("--force-range", text.substr(comma + 1), "N")
                                        : low;
                if (comma == text.size() || !(low <= high)) {
                    refuse("--force-range", text, "LO,HI with LO <= HI [N]");
                }
                forceRange.emplace(low, high);
            });
    addFile(command, "--events", eventsFile,
            "write all contacts: start, end, impulse, peak and mean force, speed, energy");
    addFile(command, "--statistics", statisticsFile,
            "write how impacts are spread: rate, impulse, speed, energy turned over");
    addFile(command, "--tip", tipFile, "write the path of the tip");
    addFigure(command, "--figure", figureFile, "draw tip, contacts and force");
    addWord(command, "--velocity", "V1,V2,...",
            "start undeformed, each bar with its own speed [m/s], from the left",
            [this](const std::string& text) {
                for (std::size_t at = 0; at <= text.size();) {
                    const std::size_t comma = std::min(text.find(',', at), text.size());
                    speeds.push_back(parseReal("--velocity", text.substr(at, comma - at), "m/s"));
                    at = comma + 1;
                }
            });
    addFile(command, "--state", stateFile, "write the final state, which --from continues");
    common.addTo(command);
    addFooter(command,
              "Only the excitation is on a grid: it is constant for L/(N c), or a time near it "
              "that fits a\n"
              "whole number of times into its period.");
}

void SimulateCommand::requireWhole() const
{
    if ((fromRest ? 1 : 0) + (fromFile.empty() ? 0 : 1) + (speeds.empty() ? 0 : 1) > 1) {
        throw std::invalid_argument(
            "--rest, --from, --velocity: allowed one of them: each is a start");
    }
    const int given =
        (force.place ? 1 : 0) + (force.amplitude ? 1 : 0) + (frequency.isGiven() ? 1 : 0);
    if (!forceFile.empty() && (given > 0 || periods)) {
        throw std::invalid_argument(
            "--force-file clashes with --force, --amplitude, --frequency and --periods: allowed a "
            "force of one kind, and --time");
    }
    if (!isOfNetwork() && given != 0 && given != 3) {
        throw std::invalid_argument(
            "--force, --amplitude, --frequency: allowed only all three together");
    }
    if (!isOfNetwork() && periods && !force.place) {
        throw std::invalid_argument("--periods: allowed only together with --force");
    }
    if (time.has_value() == periods.has_value()) {
        throw std::invalid_argument(time ? "--time clashes with --periods: allowed one of them"
                                         : "--time, --periods: missing: allowed one of them");
    }
}

Waves SimulateCommand::start(const Scene& scene, double base) const
{
    const std::vector<Segment> parts = partsOf(scene);
    if (fromFile.empty()) {
        return parts.empty()
                   ? wavesAtRest(static_cast<double>(common.usualCells()), stopsOf(scene), base)
                   : wavesAtRest(parts, stopsOf(scene), base);
    }
    // A table of waves brings its own grid, whatever --cells says of the excitation.
    const std::int64_t cells = parts.empty() ? common.usualCells() : steppedBar(parts).cells;
    return wavesOf(forFile("--from", fromFile, [&] {
        return readState(fromFile, firstMaterial(scene), cells, maxMeasurements).state;
    }));
}

Excitation SimulateCommand::excitation(const Bar& bar, double cells) const
{
    if (!forceFile.empty()) {
        const double step = scales(bar).time / cells;
        return {.values = forceHistory(step, answers::forceUnit(bar), *time / step),
                .stepsPerCrossing = cells};
    }
    if (!force.place) {
        return {.stepsPerCrossing = cells};
    }
    const double ratio = frequency.ratioFor(firstHertz(bar));
    return excitationAt({.place = *force.place,
                         .amplitude = force.at(ratio, firstHertz(bar)).scaledAmplitude(bar),
                         .phase = phase,
                         .stepsPerCrossing = cells},
                        ratio, "--frequency");
}

double SimulateCommand::stretches(double stretch, double crossing, const Bar& bar) const
{
    const double unit = scales(bar).time;
    const double total =
        periods ? static_cast<double>(*periods) : *time / unit * crossing / stretch;
    if (!(total * stretch <= longestTime * crossing)) {
        refuse(time ? "--time" : "--periods",
               time ? fmt::format("{}", *time) : fmt::format("{}", *periods),
               fmt::format("what lasts at most {} L/c, {:.3g} s", longestTime, longestTime * unit));
    }
    return total;
}

std::vector<double> SimulateCommand::forceHistory(double step, double newtons, double steps) const
{
    const double whole = std::floor(steps) + 1.0;
    if (!(whole <= static_cast<double>(maxExcitationSteps))) {
        refuse("--time", fmt::format("{}", *time),
               fmt::format("at most {} steps of {:.6g} s under --force-file", maxExcitationSteps,
                           step));
    }
    std::vector<ForcePoint> points;
    forFile("--force-file", forceFile, [&] {
        Table table(forceFile);
        const std::size_t times = table.columnOf("time");
        const std::size_t forces = table.columnOf("force");
        while (table.next()) {
            const double at = table.numberAt(times);
            if (!points.empty() && !(at > points.back().time)) {
                table.refuse(times, fmt::format("times that increase, in s: more than {}",
                                                points.back().time));
            }
            points.push_back({at, table.numberAt(forces) / newtons});
        }
    });
    return meanForces(points, step, static_cast<std::int64_t>(whole));
}

ExitStatus SimulateCommand::run() const
{
    requireWhole();
    if (isOfNetwork()) {
        return simulateScene(*this);
    }
    const Scene scene = common.scene();
    const Bar bar = firstMaterial(scene);
    SimulationAnswer answer{.scene = scene, .damping = force.damping()};
    Outputs outputs({{"--events", eventsFile},
                     {"--statistics", statisticsFile},
                     {"--tip", tipFile},
                     {"--figure", figureFile}},
                    {{"--from", fromFile}, {"--force-file", forceFile}});
    const auto usual = static_cast<double>(common.usualCells());
    const Waves waves = start(scene, excitation(bar, usual).baseDisplacement(0));
    answer.cells = static_cast<std::int64_t>(waves.crossing);
    const Excitation driving = excitation(bar, common.cells ? usual : waves.crossing);
    if (force.place) {
        const double ratio = frequency.ratioFor(firstHertz(bar));
        answer.drive =
            answers::Drive{*force.place, *force.at(ratio, firstHertz(bar)).amplitude, ratio, phase};
        answer.drive->follow(driving, bar);
    }
    const double second = scales(bar).time;
    answer.resolution = resolution ? *resolution / second : 1.0 / driving.stepsPerCrossing;
    BarSimulation simulation(waves, force.damping(), driving,
                             {.mergeBelow = {},
                              .recordsTip = !tipFile.empty() || !figureFile.empty(),
                              .stops = stopsOf(scene),
                              .segments = partsOf(scene),
                              .resolution = answer.resolution});
    const double stretch = stretchOf(force.place ? driving : Excitation{}, waves.crossing);
    const double total = stretches(stretch, waves.crossing, bar);
    {
        const Interrupt interrupt;
        Progress progress(!common.quiet, "simulating");
        const Followed followed =
            follow(simulation, stretch, total, interrupt.cancel(),
                   [&progress](double done, double all) { progress.show(done, all); });
        answer.isComplete = followed.isComplete;
        answer.settling = answer.drive ? followed.settling : Settling{};
    }
    if (!std::isfinite(simulation.energyRatio() * scales(bar).energy)) {
        throw std::overflow_error("the energy [J] is beyond the range of numbers");
    }
    if (answer.isComplete) {
        outputs.put("--events",
                    [&](const std::string& path) { writeEvents(path, simulation, bar); });
        outputs.put("--statistics",
                    [&](const std::string& path) { writeStatistics(path, simulation, bar); });
        outputs.put("--tip", [&](const std::string& path) { writeTip(path, simulation, bar); });
        outputs.put("--figure", [&](const std::string& path) {
            drawFigure(simulationFigure(simulation, force.place ? driving : Excitation{}, bar),
                       figureFormat(figureFile), path);
        });
        outputs.commit();
    } else if (!common.quiet) {
        tell("signorini simulate: interrupted; no file was written\n");
    }
    writeOut(common.wantsJson
                 ? asJson(answer, simulation)
                 : common.restated(answer.cells, force.ratio) + asText(answer, simulation));
    common.useOneThread("simulate");
    return answer.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
