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
    const Scene scene = common.sceneOfOneBar();
    const auto question = answers::familiesAsked(given, scene, common.weight());
    Outputs outputs(given, {"--csv", "--figure"});
    refuseIf(scene.bar.gap <= 0.0 && given.has("--figure"),
             "--figure: allowed with a gap > 0, whose modes it names; --csv holds the families");
    const answers::FamilyList list = watched(common, "listing families", question);
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
