#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "files.hpp"
#include "given.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

namespace {

/// Orders that a few seconds list, by number of contacts.
std::int64_t usualOrder(std::int64_t phases)
{
    constexpr std::array<std::int64_t, maxPolytopePhases> orders{25, 25, 9, 5, 3};
    return orders[static_cast<std::size_t>(phases - 1)];
}

}  // namespace

ExitStatus runModes(const Given& given)
{
    const CommonOptions common(given);
    const std::int64_t phases = given.whole("--phases").value_or(1);
    const auto maxOrder = given.whole("--max-order");
    // Several contacts are known for a gap > 0.
    const Bar bar = phases == 1 ? common.barOfAnyGap() : common.bar();
    if (phases > 1 && maxOrder && *maxOrder > maxPolytopeOrder) {
        refuse("--max-order", fmt::format("{}", *maxOrder),
               fmt::format("whole numbers 1..{} with several contacts", maxPolytopeOrder));
    }
    ModeBounds all;
    all.maxEnergyRatio = given.number("--max-energy-ratio").value_or(all.maxEnergyRatio);
    all.maxOrder = maxOrder.value_or(usualOrder(phases));
    all.maxPeriod =
        given.number("--max-period").value_or(std::max(8.0, 4.0 * static_cast<double>(phases)));
    common.requireGap(bar, bar.gap != 0.0);
    all.gapSign = answers::gapSignOfModes(bar);
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
