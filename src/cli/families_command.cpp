#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "files.hpp"
#include "given.hpp"
#include "progress.hpp"
#include "reports.hpp"

namespace signorini::cli {

namespace {

/// The families, or those found until a signal came or the list was full.
void fill(answers::FamilyList& list, const FamilyBounds& bounds, const Stops& stops,
          const auto& show)
{
    const auto last = static_cast<double>(list.maxOrder);
    std::int64_t order = 0;
    const bool isWhole = forEachFamily(list.maxOrder, bounds, [&](const Family& family) {
        if (family.order > order) {
            order = family.order;
            // The work up to an order grows with its square.
            const auto done = static_cast<double>(order - 1);
            show(done * done, last * last);
        }
        if (!staysClear(family, stops)) {
            return true;
        }
        if (list.families.size() == answers::FamilyList::most) {
            list.ended =
                fmt::format("{} families are the most in a list", answers::FamilyList::most);
            return false;
        }
        list.families.push_back(family);
        return true;
    });
    if (!isWhole && list.ended.empty()) {
        // Who interrupts it does not wait until millions are printed.
        constexpr std::size_t shown = 10'000;
        const std::size_t found = list.families.size();
        list.ended = found > shown
                         ? fmt::format("interrupted, the first {} of {} found", shown, found)
                         : "interrupted";
        list.families.resize(std::min(found, shown));
    }
}

}  // namespace

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
        fill(list, bounds, stops, show);
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
