#include "forced_find.hpp"

#include <cmath>

#include "files.hpp"
#include "forced_report.hpp"
#include "json.hpp"
#include "report.hpp"
#include "stepped_bar.hpp"
#include "stops.hpp"

namespace signorini::cli {

void ForcedFind::addTo(CLI::App& command)
{
    force.addTo(command);
    addWhole(command, "--cycles", 1, maxForcedSteps / 2, cycles, "K",
             "cycles of the excitation in a period of the motion (1)");
}

ExitStatus ForcedFind::answer(const Schedule& schedule, const CommonOptions& common,
                              const std::string& stateFile, const std::string& certificateFile,
                              double strainLimit) const
{
    if (!force.ratio) {
        refuse("--damping", "missing", fmt::format("numbers 0..{} [-]", maxDampingRatio));
    }
    if (!force.place) {
        refuse("--force", "missing", "tip|base");
    }
    const Scene scene = common.scene();
    // Equal segments are one bar.
    const bool isStepped = !isUniform(scene.segments);
    if (isStepped && std::isfinite(strainLimit)) {
        refuse("--strain-limit", fmt::format("{}", strainLimit),
               "none for a forced bar of several segments");
    }
    if (canRest(schedule.phases, schedule.stops) && !force.amplitude) {
        refuse("--amplitude", "missing",
               "numbers > 0 [N or m]: without a gap motions are as small as one likes");
    }
    const Bar bar = isStepped ? firstMaterial(scene) : scene.bar;
    const OutputOption ofState{"--state", stateFile};
    const OutputOption ofProof{"--certificate", certificateFile};
    Outputs states({ofState}, {ofProof});
    Outputs proofs({ofProof}, {ofState});
    const ForcedLimits limits{strainLimit / scales(bar).strain};
    const Forcing forcing{*force.place, cycles};
    const answers::ForcedAnswer answer =
        answers::answerOf(forcedMotions(schedule, force.damping(), forcing, limits, scene.segments),
                          scene, force.amplitude);
    if (!answer.motions.empty()) {
        states.put("--state", [&](const std::string& path) {
            writeStateCsv(path, answer.motions.back().value.state, bar);
        });
        states.commit();
    } else if (states.areWanted() && !common.quiet) {
        tell("signorini find: no motion to write, so no file was written\n");
    }
    if (answer.status() == Status::none) {
        proofs.put("--certificate", [&](const std::string& path) {
            TextFile file(path);
            file.write(asLine(wholeJsonOf(answer)));
            file.close();
        });
        proofs.commit();
    } else if (proofs.areWanted() && !common.quiet) {
        tell("signorini find: no proof to write, so --certificate was not written\n");
    }
    writeOut(common.wantsJson ? asLine(wholeJsonOf(answer))
                              : common.restated({}, force.ratio) + asText(answer));
    for (const answers::ForcedMotionOf& motion : answer.motions) {
        if (!common.quiet) {
            warnUnlessAdmissible("find", physicalOf(motion.value.extremes, bar));
        }
    }
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
