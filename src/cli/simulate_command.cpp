#include "simulate_command.hpp"

#include <algorithm>
#include <cmath>

#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "scene_simulation.hpp"
#include "signorini/figures.hpp"
#include "signorini/settling.hpp"
#include "simulation_report.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

namespace {

constexpr double longestTime = 1e9;  // [L/c]

/// Simulates so many stretches of time, or until a signal comes, and says what came of it.
void goOn(BarSimulation& simulation, double stretch, double total, bool isQuiet,
          SimulationAnswer& answer)
{
    const Interrupt interrupt;
    const Cancel cancel = interrupt.cancel();
    Progress progress(!isQuiet, "simulating");
    SettlingWatch watch(static_cast<std::int64_t>(total));
    double done = 0.0;
    for (; done + 1.0 <= total && !isRequested(cancel); done += 1.0) {
        simulation.advance(stretch);
        watch.see(simulation);
        progress.show(done, total);
    }
    answer.isComplete = done + 1.0 > total;
    if (answer.drive) {
        answer.settling =
            answer.isComplete ? watch.settling(simulation, stretch) : Settling{{}, "interrupted"};
    }
    if (answer.isComplete && total > done) {
        simulation.advance((total - done) * stretch);
    }
}

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
    addPositive(command, "--frequency", "omega_1", frequencyRatio, "W",
                "frequency of the excitation, ω/ω₁");
    addWord(command, "--phase", "RAD", "of the excitation at the start, cos(ωt - phase) (0)",
            [this](const std::string& text) { phase = parseReal("--phase", text, "rad"); });
    addPositive(command, "--time", "s", time, "T", "duration in seconds");
    addWhole(command, "--periods", 1, 1'000'000'000, periods, "P",
             "or how many periods of the excitation");
    addPositive(command, "--resolve", "s", resolution, "S",
                "merge contacts no further apart, and average forces over S (a step, L/(N c))");
    addFile(command, "--events", eventsFile,
            "write all contacts: start, end, impulse, peak force, mean force");
    addFile(command, "--tip", tipFile, "write the path of the tip");
    addFigure(command, "--figure", figureFile, "draw tip, contacts and force");
    sceneGiven.addTo(command);
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
    const int given = (force.place ? 1 : 0) + (force.amplitude ? 1 : 0) + (frequencyRatio ? 1 : 0);
    if (given != 0 && given != 3) {
        throw std::invalid_argument(
            "--force, --amplitude, --frequency: allowed only all three together");
    }
    if (periods && !force.place) {
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
    if (!force.place) {
        return {.stepsPerCrossing = cells};
    }
    // A period of 4/W L/c is as many whole steps as come nearest to cells in L/c.
    const double exact = 4.0 * cells / *frequencyRatio;
    const double steps = std::round(exact);
    if (!(steps >= 3.0 && steps <= static_cast<double>(maxExcitationSteps))) {
        refuse("--frequency", fmt::format("{}", *frequencyRatio),
               fmt::format("about {:.3g}..{:.3g} [ω₁] with {} steps in L/c (--cells)",
                           4.0 * cells / static_cast<double>(maxExcitationSteps), 4.0 * cells / 3.0,
                           cells));
    }
    const bool isWhole = std::abs(exact - steps) <= 1e-9 * exact;
    return excitationOf({.place = *force.place,
                         .amplitude = force.scaledAmplitude(bar),
                         .phase = phase,
                         .cycles = 1,
                         .steps = static_cast<std::int64_t>(steps),
                         .stepsPerCrossing = isWhole ? cells : steps * *frequencyRatio / 4.0});
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

ExitStatus SimulateCommand::run() const
{
    if (isOfNetwork()) {
        return simulateScene(*this);
    }
    requireWhole();
    const Scene scene = common.scene();
    const Bar bar = firstMaterial(scene);
    SimulationAnswer answer{.scene = scene, .damping = force.damping()};
    Outputs outputs({{"--events", eventsFile}, {"--tip", tipFile}, {"--figure", figureFile}});
    const auto usual = static_cast<double>(common.usualCells());
    const Waves waves = start(scene, excitation(bar, usual).baseDisplacement(0));
    answer.cells = static_cast<std::int64_t>(waves.crossing);
    const Excitation driving = excitation(bar, common.cells ? usual : waves.crossing);
    if (force.place) {
        answer.drive = answers::Drive{*force.place, *force.amplitude, *frequencyRatio, phase};
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
    // In units of the simulation's; a period of the excitation is a whole number of its steps.
    const double stretch = driving.steps() > 0 ? static_cast<double>(driving.steps()) *
                                                     waves.crossing / driving.stepsPerCrossing
                                               : 16.0 * waves.crossing;
    goOn(simulation, stretch, stretches(stretch, waves.crossing, bar), common.quiet, answer);
    if (!std::isfinite(simulation.energyRatio() * scales(bar).energy)) {
        throw std::overflow_error("the energy [J] is beyond the range of numbers");
    }
    if (answer.isComplete) {
        outputs.put("--events",
                    [&](const std::string& path) { writeEvents(path, simulation, bar); });
        outputs.put("--tip", [&](const std::string& path) { writeTip(path, simulation, bar); });
        outputs.put("--figure", [&](const std::string& path) {
            drawSimulation(simulation, driving, figureFormat(figureFile), path);
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
