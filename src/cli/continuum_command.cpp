#include "commands.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "faults.hpp"
#include "files.hpp"
#include "given.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_continuum.hpp"
#include "signorini/continuum.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

/// Of the member that is compressed most.
void warnOfWorst(const CommonOptions& common, const Continuum& curve)
{
    const auto worst = std::max_element(
        curve.points.begin(), curve.points.end(),
        [](const auto& one, const auto& other) { return one.peakStrain < other.peakStrain; });
    if (worst != curve.points.end()) {
        common.warnUnlessAdmissible(
            physicalOf(extremesOf(worst->state, curve.schedule), curve.scene.bar));
    }
}

}  // namespace

ExitStatus runContinuum(const Given& given)
{
    const CommonOptions common(given);
    refuseIf(given.has("--member") != given.has("--state"),
             "--member and --state: allowed both or neither");
    if (const auto assembly = barsOf(given, common)) {
        return continuumInBars(given, common, *assembly);
    }
    const Scene scene = common.scene();
    const auto question = answers::continuumAsked(
        given, scene, {common.usualCells(), parsePhases(given.words())}, [&](const char* option) {
            const std::string path = given.text(option);
            return forFile(option, path,
                           [&] { return readState(path, scene.bar, common.usualCells()).state; });
        });
    Outputs outputs(given, {"--csv", "--state", "--figure", "--animate"});
    bool isInterrupted = false;
    answers::ContinuumAnswer answer = watched(common, "tracing", question, isInterrupted);
    const Continuum& curve = *answer.curve;
    if (!curve.points.empty() && !isInterrupted) {
        if (const auto member = given.number("--member")) {
            answer.asked = memberAt(curve, *member);
        }
        outputs.put("--state", [&](const std::string& path) {
            writeStateCsv(path, answer.asked->point.state, scene.bar);
        });
        outputs.put("--csv", [&](const std::string& path) { writeContinuumCsv(path, curve); });
        outputs.draw("--figure", [&] { return continuumFigure(curve); });
        outputs.draw("--animate", [&] { return continuumFrames(curve); });
        outputs.commit();
    } else if (outputs.areWanted()) {
        common.sayNoFile(isInterrupted ? "the curve is not complete" : "no motion to write");
    }
    report(common, answer);
    warnOfWorst(common, curve);
    common.useOneThread();
    return exitStatusOf(curve.status);
}

}  // namespace signorini::cli
