#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "files.hpp"
#include "given.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

ExitStatus runModes(const Given& given)
{
    const CommonOptions common(given);
    const std::int64_t phases = given.whole("--phases").value_or(1);
    // Several contacts are known for a gap > 0.
    const Bar bar = phases == 1 ? common.barOfAnyGap() : common.bar();
    common.requireGap(bar, bar.gap != 0.0);
    ModeBounds all = answers::modesAsked(given, phases, bar);
    FrequencyEnergyOptions drawing;
    if (given.has("--figure")) {
        refuseIf(bar.gap < 0.0,
                 "--figure: allowed with a gap > 0, whose plot it is; --csv holds the curves");
        drawing.bar = bar;
        // From the lowest energy there is to where curves are upright lines.
        drawing.maxEnergyRatio = std::clamp(all.maxEnergyRatio, 2.0, 1e6);
    }
    answers::ModeList listing{all, bar, {}};
    answers::PolytopeList polytopes{phases, all, bar, {}};
    Outputs outputs(given, {"--csv", "--figure"});
    const bool isComplete =
        watched(common, "listing modes", [&](const Cancel& cancel, const auto& show) {
            all.cancel = cancel;
            all.progress = show;
            if (phases == 1) {
                listing.modes = findModes(all);
            } else {
                polytopes.polytopes = findPolytopes(phases, all);
            }
            return !isRequested(cancel);
        });
    listing.isComplete = polytopes.isComplete = isComplete;
    listing.gravity = polytopes.gravity = common.weight();
    if (isComplete) {
        outputs.put("--csv", [&](const std::string& path) {
            phases == 1 ? writeModesCsv(path, listing) : writePolytopesCsv(path, polytopes);
        });
        outputs.draw("--figure", [&] {
            return phases == 1 ? frequencyEnergyFigure({.modes = listing.modes}, drawing)
                               : polytopesFigure(polytopes.polytopes, drawing);
        });
        outputs.commit();
    } else {
        common.say(fmt::format("interrupted; the list is not complete{}",
                               outputs.areWanted() ? ", so no file was written" : ""));
    }
    phases == 1 ? report(common, listing) : report(common, polytopes);
    common.useOneThread();
    return isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
