#include "simulate_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>

#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "signorini/figures.hpp"
#include "simulation_report.hpp"

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
    SettlingWatch watch;
    double done = 0.0;
    for (; done + 1.0 <= total && !isRequested(cancel); done += 1.0) {
        simulation.advance(stretch);
        watch.see(simulation);
        progress.show(done, total);
    }
    answer.isComplete = done + 1.0 > total;
    if (answer.isComplete && total > done) {
        simulation.advance((total - done) * stretch);
    }
    if (answer.amplitude) {
        answer.settled = watch.settled();
    }
}

}  // namespace

void SimulateCommand::addTo(CLI::App& command)
{
    addFile(command, "--from", fromFile, "state to start from, as find --state writes it");
    command.add_flag("--rest", fromRest, "start at rest (so without --from)");
    force.addTo(command);
    addPositive(command, "--frequency", "omega_1", frequencyRatio, "W",
                "frequency of the excitation, ω/ω₁");
    addWord(command, "--phase", "RAD", "of the excitation at the start, cos(ωt - phase) (0)",
            [this](const std::string& text) { phase = parseReal("--phase", text, "rad"); });
    addPositive(command, "--time", "s", time, "T", "how long, in seconds");
    addWhole(command, "--periods", 1, 1'000'000'000, periods, "P",
             "or how many periods of the excitation");
    addFile(command, "--events", eventsFile, "write all contacts: start, end, impulse, peak force");
    addFile(command, "--tip", tipFile, "write the path of the tip");
    addFigure(command, "--figure", figureFile, "draw tip, contacts and force");
    common.addTo(command);
    command.footer(
        "Nothing is on a grid but the excitation, which is constant for L/(N c), or as much as "
        "fits "
        "a whole number of\ntimes into its period.");
}

void SimulateCommand::requireWhole() const
{
    if (fromRest && !fromFile.empty()) {
        throw std::invalid_argument("--rest clashes with --from: allowed one of them");
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

Waves SimulateCommand::start(const Bar& bar) const
{
    if (fromFile.empty()) {
        return wavesAtRest(static_cast<double>(common.usualCells()), stopsOf(bar));
    }
    // A table of waves brings its own grid, whatever --cells says of the excitation.
    return wavesOf(forFile("--from", fromFile, [&] {
        return readState(fromFile, bar, common.usualCells(), maxMeasurements).state;
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
    requireWhole();
    const Scene scene = common.scene();
    if (!scene.segments.empty()) {
        throw std::invalid_argument("--segments: allowed only where stepped bars are known: find");
    }
    SimulationAnswer answer{.scene = scene,
                            .damping = force.damping(),
                            .amplitude = force.amplitude,
                            .excitation = {},
                            .frequencyRatio = frequencyRatio.value_or(0.0),
                            .phase = phase,
                            .cells = 0,
                            .settled = {}};
    Outputs outputs({{"--events", eventsFile}, {"--tip", tipFile}, {"--figure", figureFile}});
    const Waves waves = start(scene.bar);
    answer.cells = static_cast<std::int64_t>(waves.crossing);
    answer.excitation =
        excitation(scene.bar, common.cells ? static_cast<double>(*common.cells) : waves.crossing);
    BarSimulation simulation(waves, force.damping(), answer.excitation,
                             {.mergeBelow = {},
                              .recordsTip = !tipFile.empty() || !figureFile.empty(),
                              .stops = stopsOf(scene)});
    // In units of the simulation's; a period of the excitation is a whole number of its steps.
    const double stretch = answer.excitation.steps() > 0
                               ? static_cast<double>(answer.excitation.steps()) * waves.crossing /
                                     answer.excitation.stepsPerCrossing
                               : 16.0 * waves.crossing;
    goOn(simulation, stretch, stretches(stretch, waves.crossing, scene.bar), common.quiet, answer);
    if (answer.isComplete) {
        outputs.put("--events",
                    [&](const std::string& path) { writeEvents(path, simulation, scene.bar); });
        outputs.put("--tip",
                    [&](const std::string& path) { writeTip(path, simulation, scene.bar); });
        outputs.put("--figure", [&](const std::string& path) {
            drawSimulation(simulation, answer.excitation, figureFormat(figureFile), path);
        });
        outputs.commit();
    } else if (!common.quiet) {
        tell("signorini simulate: interrupted; no file was written\n");
    }
    writeOut(common.wantsJson ? asJson(answer, simulation) : asText(answer, simulation));
    common.useOneThread("simulate");
    return answer.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
