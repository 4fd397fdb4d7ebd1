#include "simulate_command.hpp"
#include "commands.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "files.hpp"
#include "force_history.hpp"
#include "hints.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "state_table.hpp"
#include "stepped_bar.hpp"
#include "table.hpp"

namespace signorini::cli {

namespace {

/// The segments of a bar that is not uniform.
std::vector<Segment> partsOf(const Scene& scene)
{
    return isUniform(scene.segments) ? std::vector<Segment>{} : scene.segments;
}

}  // namespace

SimulateCommand::SimulateCommand(const Given& words)
    : given(words),
      common(words),
      force(words),
      frequency(words, "--frequency", "--hertz"),
      time(words.number("--time")),
      periods(words.whole("--periods"))
{
    const std::string text = given.text("--velocity");
    for (std::size_t at = 0; !text.empty() && at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        speeds.push_back(parseReal("--velocity", text.substr(at, comma - at), "m/s"));
        at = comma + 1;
    }
    if (const std::string ends = given.text("--force-range"); !ends.empty()) {
        const std::size_t comma = std::min(ends.find(','), ends.size());
        const double low = parseReal("--force-range", ends.substr(0, comma), "N");
        const double high =
            comma < ends.size() ? parseReal("--force-range", ends.substr(comma + 1), "N") : low;
        if (comma == ends.size() || !(low <= high)) {
            refuse("--force-range", ends, "LO,HI with LO <= HI [N]");
        }
        forceRange.emplace(low, high);
    }
}

Waves SimulateCommand::start(const Scene& scene, double base) const
{
    const std::vector<Segment> parts = partsOf(scene);
    const std::string fromFile = given.text("--from");
    if (fromFile.empty()) {
        return parts.empty()
                   ? wavesAtRest(static_cast<double>(common.usualCells()), stopsOf(scene), base)
                   : wavesAtRest(parts, stopsOf(scene), base);
    }
    // A table of waves brings its own grid, whatever --cells says of the excitation.
    const std::int64_t cells = parts.empty() ? common.usualCells() : steppedBar(parts).cells;
    return forFile("--from", fromFile,
                   [&] { return readWaves(fromFile, firstMaterial(scene), cells, parts.empty()); });
}

Excitation SimulateCommand::excitation(std::optional<answers::Drive>& drive, const Bar& bar,
                                       double cells) const
{
    if (given.has("--force-file")) {
        const double step = scales(bar).time / cells;
        return {.values = forceHistory(step, answers::forceUnit(bar), *time / step),
                .stepsPerCrossing = cells};
    }
    if (!drive) {
        return {.stepsPerCrossing = cells};
    }
    return hinting(given, "--frequency", frequency.ratio, answers::firstHertz(bar), bar, [&] {
        (void)force.at(drive->frequencyRatio * answers::firstHertz(bar)).scaledAmplitude(bar);
        return drive->excitation(bar, cells, "--frequency");
    });
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
    const std::string forceFile = given.text("--force-file");
    forFile("--force-file", forceFile, [&] {
        Table table(forceFile);
        constexpr std::string_view allowed = "a header with columns time [s] and force [N]";
        const std::size_t times = table.columnOf("time", allowed);
        const std::size_t forces =
            table.columnOf(table.has("newtons") ? "newtons" : "force", allowed);
        while (table.next()) {
            const double at = table.numberAt(times, "s");
            if (!points.empty() && !(at > points.back().time)) {
                table.refuse(times, fmt::format("times that increase, in s: more than {}",
                                                points.back().time));
            }
            points.push_back({at, table.numberAt(forces, "N") / newtons});
        }
    });
    return meanForces(points, step, static_cast<std::int64_t>(whole));
}

ExitStatus SimulateCommand::run() const
{
    answers::requireWhole(given, isOfNetwork());
    if (isOfNetwork()) {
        return simulateScene(*this);
    }
    const Scene scene = common.scene();
    const Bar bar = firstMaterial(scene);
    SimulationAnswer asked{.scene = scene, .damping = force.damping()};
    if (force.place) {
        asked.drive = answers::driveAsked(given, answers::firstHertz(bar), *force.place);
    }
    Outputs outputs(given, {"--events", "--statistics", "--tip", "--figure", "--state"},
                    {"--from", "--force-file"});
    const auto usual = static_cast<double>(common.usualCells());
    const Waves waves = start(scene, excitation(asked.drive, bar, usual).baseDisplacement(0));
    refuseIf(common.cells && !force.place && !given.has("--force-file") && usual != waves.crossing,
             "--cells", given.text("--cells"),
             fmt::format("{:.17g}, those of the state; others only as steps of a force",
                         waves.crossing));
    const Excitation driving = excitation(asked.drive, bar, common.cells ? usual : waves.crossing);
    answers::FollowedBar followed = started(
        std::move(asked), waves, driving,
        {time, periods, given.number("--resolve"), given.has("--tip") || given.has("--figure")});
    watched(common, "simulating", [&](const answers::Watch& watch) { followed.follow(watch); });
    const SimulationAnswer& answer = followed.answer;
    const BarSimulation& simulation = followed.simulation;
    if (!std::isfinite(simulation.energyRatio() * scales(bar).energy)) {
        throw std::overflow_error("the energy [J] is beyond the range of numbers");
    }
    if (answer.isComplete) {
        outputs.put("--events", writeEvents, simulation, bar);
        outputs.put("--statistics", writeStatistics, simulation, bar);
        outputs.put("--tip", writeTip, simulation, bar);
        outputs.put("--state", [&](const std::string& path) {
            writeStateTable(path, simulation.waves(), simulation.tip(), bar);
        });
        outputs.draw("--figure", [&] {
            return simulationFigure(simulation, force.place ? driving : Excitation{}, bar);
        });
        outputs.commit();
    } else {
        common.say("interrupted; no file was written");
    }
    report(common, answer, answer.cells, force.ratio);
    common.useOneThread();
    return exitStatusOf(answer.status());
}

ExitStatus runSimulate(const Given& given)
{
    return SimulateCommand(given).run();
}

}  // namespace signorini::cli
