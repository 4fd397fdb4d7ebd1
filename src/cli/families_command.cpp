#include "commands.hpp"

#include <fmt/format.h>

#include "files.hpp"
#include "given.hpp"
#include "progress.hpp"
#include "reports.hpp"

namespace signorini::cli {

ExitStatus runFamilies(const Given& given)
{
    const CommonOptions common(given);
    FamilyBounds bounds;
    bounds.maxEnergyRatio = given.number("--max-energy-ratio").value_or(bounds.maxEnergyRatio);
    const Scene scene = common.sceneOfOneBar();
    const Stops stops = stopsOf(scene);
    answers::FamilyList list{given.whole("--max-order").value_or(12),
                             bounds.maxEnergyRatio,
                             scene.bar,
                             {},
                             {},
                             scene.secondStop,
                             common.weight()};
    Outputs outputs(given, {"--csv", "--figure"});
    refuseIf(list.bar.gap <= 0.0 && given.has("--figure"),
             "--figure: allowed with a gap > 0, whose modes it names; --csv holds the families");
    bounds.gapSign = stops.right;
    watched(common, "listing families", [&](const Cancel& cancel, const auto& show) {
        bounds.cancel = cancel;
        answers::fill(list, bounds, stops, show);
    });
    if (list.isComplete()) {
        outputs.put("--csv", writeFamiliesCsv, list);
        outputs.draw("--figure", [&] { return familiesFigure(list.families, list.maxOrder); });
        outputs.commit();
    } else {
        common.say(fmt::format("{}; the list is not complete{}", list.ended,
                               outputs.areWanted() ? ", so no file was written" : ""));
    }
    if (common.wantsJson) {
        writeJson(list, writeOut);
    } else {
        writeOut(common.restated());
        writeText(list, writeOut);
    }
    common.useOneThread();
    return list.isComplete() ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
