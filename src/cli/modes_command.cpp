#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "files.hpp"
#include "given.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

namespace {

/// Answers with a list, written and drawn as these do.
ExitStatus answer(const Given& given, const CommonOptions& common, const auto& question,
                  const auto& write, const auto& draw)
{
    Outputs outputs(given, {"--csv", "--figure"});
    const auto list = watched(common, "listing modes", question);
    if (list.isComplete) {
        outputs.put("--csv", [&](const std::string& path) { write(path, list); });
        outputs.draw("--figure", [&] { return draw(list); });
        outputs.commit();
    } else {
        common.say(fmt::format("interrupted; the list is not complete{}",
                               outputs.areWanted() ? ", so no file was written" : ""));
    }
    report(common, list);
    common.useOneThread();
    return list.isComplete ? exitFound : exitUndecided;
}

/// From the lowest energy there is to where curves are upright lines.
FrequencyEnergyOptions drawingOf(const auto& list)
{
    return {.maxEnergyRatio = std::clamp(list.bounds.maxEnergyRatio, 2.0, 1e6), .bar = list.bar};
}

}  // namespace

ExitStatus runModes(const Given& given)
{
    const CommonOptions common(given);
    const std::int64_t phases = given.whole("--phases").value_or(1);
    // Several contacts are known for a gap > 0.
    const Bar bar = phases == 1 ? common.barOfAnyGap() : common.bar();
    common.requireGap(bar, bar.gap != 0.0);
    refuseIf(given.has("--figure") && bar.gap < 0.0,
             "--figure: allowed with a gap > 0, whose plot it is; --csv holds the curves");
    if (phases > 1) {
        return answer(given, common, answers::polytopesAsked(given, phases, bar, common.weight()),
                      writePolytopesCsv, [](const answers::PolytopeList& list) {
                          return polytopesFigure(list.polytopes, drawingOf(list));
                      });
    }
    return answer(given, common, answers::modesAsked(given, bar, common.weight()), writeModesCsv,
                  [](const answers::ModeList& list) {
                      return frequencyEnergyFigure({.modes = list.modes}, drawingOf(list));
                  });
}

}  // namespace signorini::cli
