// Files to take away, written by the code of the command line.

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

/// The curve of a schedule at the energy that is held.
const Continuum& curveOf(const Request& of)
{
    return web::curveOf(of.schedule(), of.number("energy", 0.0, 1e12));
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

/// The JSON of what answers a question.
template <auto answerTo>
Text json(const Request& of)
{
    return cli::asLine(cli::wholeJsonOf(answerTo(of)));
}

/// A table of it.
template <auto write, auto answerTo>
Text table(const Request& of)
{
    const auto& answer = answerTo(of);
    return textOf([&](const Text& path) { write(path, answer); });
}

/// A motion on no grid, on so many cells.
template <auto motionOf>
Text motion(const Request& of)
{
    const ModeMotion one = motionOf(of);
    return textOf([&](const Text& path) {
        writeMotionCsv(path, MotionSamples(one, bar, of.whole("cells", 2, mostCells)));
    });
}

Text scheduleJson(const Request& of)
{
    if (isMember(of)) {
        const Continuum& curve = curveOf(of);
        return cli::asLine(cli::wholeJsonOf(answers::ContinuumAnswer{
            std::shared_ptr<const Continuum>(std::shared_ptr<void>(), &curve),
            memberOf(of, curve)}));
    }
    return cli::asLine(cli::wholeJsonOf(answers::FindAnswer{found(of)}));
}

Text scheduleState(const Request& of)
{
    if (isMember(of)) {
        return stateOf(memberOf(of, curveOf(of)).point.state);
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

answers::ModeAnswer modeAnswer(const Request& of)
{
    return {modeOf(of), bar, modeMotion(of)};
}

Text forcedState(const Request& of)
{
    const answers::ForcedAnswer answer = forcedAnswer(of);
    if (answer.motions.empty()) {
        throw std::invalid_argument("there is no motion to write");
    }
    return stateOf(answer.motions.back().value.state);
}

cli::SimulationAnswer simulationAnswer(const Request& of)
{
    return simulated(of).answer;
}

/// A table of all that happened.
template <auto write>
Text happened(const Request& of)
{
    const Simulated result = simulated(of, true);
    return textOf([&](const Text& path) { write(path, result.simulation, bar); });
}

answers::FamilyList familiesOf(const Request& of)
{
    const FamilyBounds bounds;
    answers::FamilyList list{of.whole("order", 1, 200), bounds.maxEnergyRatio, bar, {}, {}};
    list.families = findFamilies(list.maxOrder);
    return list;
}

const std::map<Text, Text (*)(const Request&)>& files()
{
    static const std::map<Text, Text (*)(const Request&)> all{
        {"schedule.json", scheduleJson},
        {"schedule.state", scheduleState},
        {"schedule.motion", scheduleMotion},
        {"schedule.continuum",
         [](const Request& of) {
             const Continuum& curve = curveOf(of);
             return textOf([&](const Text& path) { writeContinuumCsv(path, curve); });
         }},
        {"mode.json", json<modeAnswer>},
        {"mode.motion", motion<modeMotion>},
        {"polygon.motion", motion<polygonMotion>},
        {"polygons.json", json<polygonsOf>},
        {"polygons.csv", table<cli::writePolytopesCsv, polygonsOf>},
        {"forced.json", json<forcedAnswer>},
        {"forced.state", forcedState},
        {"simulation.json", json<simulationAnswer>},
        {"simulation.start", startTable},
        {"simulation.events", happened<cli::writeEvents>},
        {"simulation.tip", happened<cli::writeTip>},
        {"response.json", json<responseOf>},
        {"response.csv", table<cli::writeResponseCsv, responseOf>},
        {"sweep.json", json<sweepOf>},
        {"sweep.csv", table<cli::writeSweepCsv, sweepOf>},
        {"families.csv", table<cli::writeFamiliesCsv, familiesOf>},
    };
    return all;
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
