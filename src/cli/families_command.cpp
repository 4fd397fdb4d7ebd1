#include "families_command.hpp"

#include <fmt/format.h>

#include "families_report.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "signorini/figures.hpp"

namespace signorini::cli {

namespace {

/// The families, or those found until a signal came or the list was full.
void fill(answers::FamilyList& list, FamilyBounds bounds, const Stops& stops, bool isQuiet)
{
    const Interrupt interrupt;
    Progress progress(!isQuiet, "listing families");
    bounds.cancel = interrupt.cancel();
    const auto last = static_cast<double>(list.maxOrder);
    std::int64_t order = 0;
    const bool isWhole = forEachFamily(list.maxOrder, bounds, [&](const Family& family) {
        if (family.order > order) {
            order = family.order;
            // The work up to an order grows with its square.
            const auto done = static_cast<double>(order - 1);
            progress.show(done * done, last * last);
        }
        if (!staysClear(family, stops)) {
            return true;
        }
        if (list.families.size() == maxListedFamilies) {
            list.ended = fmt::format("{} families are the most in a list", maxListedFamilies);
            return false;
        }
        list.families.push_back(family);
        return true;
    });
    if (!isWhole && list.ended.empty()) {
        list.ended = "interrupted";
    }
}

}  // namespace

void FamiliesCommand::addTo(CLI::App& command)
{
    addWhole(command, "--max-order", 1, maxListedOrder, maxOrder, "W",
             "only families of at most W blocks in 2 L/c (12)");
    addPositive(command, "--max-energy-ratio", "E_1", bounds.maxEnergyRatio, "X",
                "only families with a motion of E/E_1 <= X (all)");
    addFigure(command, "--figure", figureFile,
              "draw them as a periodic table, period against order");
    addFile(command, "--csv", tableFile, "write them as a table, one row per family");
    common.addTo(command);
    addFooter(
        command,
        "A family (w, nu, k) is all motions of one period T = 2 nu/w and one contact pattern, with "
        "energies from the least one upwards, on every grid with w | 2N. Times are in units of L/c "
        "and energies in E_1: the list holds for every bar. Hz, s and J are those of the bar that "
        "the options name. Ordered by w, nu, k.");
}

ExitStatus FamiliesCommand::run() const
{
    const Scene scene = common.sceneOfOneBar();
    const Stops stops = stopsOf(scene);
    answers::FamilyList list{maxOrder, bounds.maxEnergyRatio, scene.bar, {}, {}, scene.secondStop};
    Outputs outputs({{"--csv", tableFile}, {"--figure", figureFile}});
    if (list.bar.gap == 0.0 && !figureFile.empty()) {
        throw std::invalid_argument(
            "--figure: allowed only with a gap: without one families have every energy");
    }
    FamilyBounds asked = bounds;
    asked.gapSign = stops.right;
    fill(list, asked, stops, common.quiet);
    if (!list.isComplete() && !common.quiet) {
        tell(fmt::format("signorini families: {}; the list is not complete{}\n", list.ended,
                         outputs.areWanted() ? ", so no file was written" : ""));
    }
    if (list.isComplete()) {
        outputs.put("--csv", [&](const std::string& path) { writeFamiliesCsv(path, list); });
        outputs.put("--figure", [&](const std::string& path) {
            drawFigure(familiesFigure(list.families, list.maxOrder), figureFormat(figureFile),
                       path);
        });
        outputs.commit();
    }
    if (common.wantsJson) {
        writeJson(list, writeOut);
    } else {
        writeOut(common.restated());
        writeText(list, writeOut);
    }
    common.useOneThread("families");
    return list.isComplete() ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
