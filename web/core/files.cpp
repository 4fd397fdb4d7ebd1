// Files to take away, written by the code of the command line.

#include <functional>
#include <map>
#include <stdexcept>

#include "reports.hpp"
#include "signorini/output.hpp"
#include "text_of.hpp"
#include "views.hpp"

namespace signorini::web {

namespace {

using Text = std::string;

PeriodicResult requireMotion(const Request& of)
{
    PeriodicResult result = found(of);
    if (!result.motion) {
        throw std::invalid_argument("there is no motion to write");
    }
    return result;
}

bool isMember(const Request& of)
{
    return of.has("pause") && of.has("energy");
}

Member memberOf(const Request& of, const Continuum& curve)
{
    return memberAt(curve,
                    of.number("pause", curve.points.front().lambda, curve.points.back().lambda));
}

Text stateOf(const State& state, const Bar& of = bar)
{
    return textOf([&](const Text& path) { writeStateCsv(path, state, of); });
}

Text scheduleJson(const Request& of)
{
    if (isMember(of)) {
        const Continuum& curve = curveOf(of.schedule(), of.number("energy", 0.0, 1e12));
        return cli::asLine(cli::wholeJsonOf(answers::ContinuumAnswer{
            std::shared_ptr<const Continuum>(std::shared_ptr<void>(), &curve),
            memberOf(of, curve)}));
    }
    return cli::asLine(cli::wholeJsonOf(answers::FindAnswer{found(of)}));
}

Text scheduleState(const Request& of)
{
    if (isMember(of)) {
        return stateOf(
            memberOf(of, curveOf(of.schedule(), of.number("energy", 0.0, 1e12))).point.state);
    }
    const PeriodicResult result = requireMotion(of);
    return stateOf(result.motion->state, result.scene.bar);
}

Text scheduleMotion(const Request& of)
{
    const PeriodicResult result = requireMotion(of);
    const Motion motion(result.motion->state, result.schedule);
    return textOf(
        [&](const Text& path) { writeMotionCsv(path, MotionSamples(motion, result.scene)); });
}

ModeMotion modeMotion(const Request& of)
{
    return {modeOf(of), of.number("period", 0.0, 4.0)};
}

Text modeMotionFile(const Request& of)
{
    const ModeMotion motion = modeMotion(of);
    return textOf([&](const Text& path) {
        writeMotionCsv(path, MotionSamples(motion, bar, of.whole("cells", 2, mostCells)));
    });
}

Text forcedState(const Request& of)
{
    const answers::ForcedAnswer answer = forcedAnswer(of);
    if (answer.motions.empty()) {
        throw std::invalid_argument("there is no motion to write");
    }
    return stateOf(answer.motions.back().value.state);
}

Text simulationFile(const Request& of, void (*write)(const Text&, const BarSimulation&, const Bar&))
{
    const Simulated result = simulated(of, true);
    return textOf([&](const Text& path) { write(path, result.simulation, bar); });
}

Text familiesFile(const Request& of)
{
    const FamilyBounds bounds;
    answers::FamilyList list{of.whole("order", 1, 200), bounds.maxEnergyRatio, bar, {}, {}};
    list.families = findFamilies(list.maxOrder);
    return textOf([&](const Text& path) { cli::writeFamiliesCsv(path, list); });
}

const std::map<Text, std::function<Text(const Request&)>>& files()
{
    static const std::map<Text, std::function<Text(const Request&)>> table{
        {"schedule.json", scheduleJson},
        {"schedule.state", scheduleState},
        {"schedule.motion", scheduleMotion},
        {"schedule.continuum",
         [](const Request& of) {
             const Continuum& curve = curveOf(of.schedule(), of.number("energy", 0.0, 1e12));
             return textOf([&](const Text& path) { writeContinuumCsv(path, curve); });
         }},
        {"mode.json",
         [](const Request& of) {
             return cli::asLine(
                 cli::wholeJsonOf(answers::ModeAnswer{modeOf(of), bar, modeMotion(of)}));
         }},
        {"mode.motion", modeMotionFile},
        {"polygon.motion", polygonMotion},
        {"polygons.json", polygonsJson},
        {"polygons.csv", polygonsTable},
        {"forced.json",
         [](const Request& of) { return cli::asLine(cli::wholeJsonOf(forcedAnswer(of))); }},
        {"forced.state", forcedState},
        {"simulation.json",
         [](const Request& of) { return cli::asLine(cli::wholeJsonOf(simulated(of).answer)); }},
        {"simulation.start", startTable},
        {"simulation.events",
         [](const Request& of) { return simulationFile(of, cli::writeEvents); }},
        {"simulation.tip", [](const Request& of) { return simulationFile(of, cli::writeTip); }},
        {"response.json",
         [](const Request& of) { return cli::asLine(cli::wholeJsonOf(responseOf(of))); }},
        {"response.csv",
         [](const Request& of) {
             return textOf([&](const Text& path) { cli::writeResponseCsv(path, responseOf(of)); });
         }},
        {"sweep.json",
         [](const Request& of) { return cli::asLine(cli::wholeJsonOf(sweepOf(of))); }},
        {"sweep.csv",
         [](const Request& of) {
             return textOf([&](const Text& path) { cli::writeSweepCsv(path, sweepOf(of)); });
         }},
        {"families.csv", familiesFile},
    };
    return table;
}

}  // namespace

Reply download(const Request& request)
{
    const Text name = request.word("name");
    const auto file = files().find(name);
    if (file == files().end()) {
        throw std::invalid_argument("name = " + name + ": there is no such file");
    }
    Reply reply;
    reply.json["text"] = file->second(request.part("of"));
    return reply;
}

}  // namespace signorini::web
