#include "signorini/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <vector>

#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/families.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"
#include "text.hpp"

namespace signorini {

namespace {

/// Top of the energies told apart by colour; what is above has the same colour.
constexpr double mostColoured = 100.0;
constexpr double plotWidth = 13.0;  ///< [cm]

/// Families of any grid that the frequency-energy plot shows.
constexpr std::int64_t maxShadedOrder = 60;

/// omega/omega_1 of the linear motions of one phase that only touch the wall: p changes its sign
/// after G steps, so their period is 2G steps, whatever the schedule repeats.
double grazingFrequency(const Schedule& schedule)
{
    return 2.0 * static_cast<double>(schedule.cells) /
           static_cast<double>(std::gcd(2 * schedule.cells, steps(schedule)));
}

}  // namespace

void drawFrequencyEnergyPlot(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                             FigureFormat format, const std::string& path)
{
    std::set<std::array<std::int64_t, 3>> seen;
    std::vector<Family> onGrid;
    std::vector<EnergyBar> bars;
    atlas.forEachFound(cells, [&](const AtlasEntry& entry) {
        const bool hasOnePhase = entry.schedule.phases.size() == 1;
        if (hasOnePhase && entry.row.contact == Contact::pressing) {
            const Family family = familyOf(entry.schedule).value().family;
            if (seen.insert({family.order, family.blocks, family.contactBlocks}).second) {
                onGrid.push_back(family);
            }
            return;
        }
        const EnergyBar bar{.frequencyRatio = hasOnePhase ? grazingFrequency(entry.schedule)
                                                          : frequencyRatio(entry.schedule),
                            .least = entry.row.energy.least,
                            .most = entry.row.energy.most,
                            .contact = entry.row.contact};
        if (!hasOnePhase || bars.empty() || bars.back() != bar) {
            bars.push_back(bar);
        }
    });
    const std::vector<Mode> modes = findModes();
    const std::vector<Family> families = findFamilies(maxShadedOrder);
    writeFrequencyEnergyFigure(
        path, {.modes = modes, .families = families, .onGrid = onGrid, .bars = bars},
        {.format = format, .maxFrequencyRatio = {}});
}

void drawExistenceMap(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                      FigureFormat format, const std::string& path)
{
    Text pressing;
    Text grazing;
    double contactTime = 0.0;
    double flightTime = 0.0;
    atlas.forEachFound(cells, [&](const AtlasEntry& entry) {
        if (entry.schedule.phases.size() != 1) {
            return;
        }
        const auto size = static_cast<double>(entry.schedule.cells);
        const Phase& phase = entry.schedule.phases.front();
        const double contact = static_cast<double>(phase.contact) / size;
        const double flight = static_cast<double>(phase.free) / size;
        contactTime = std::max(contactTime, contact);
        flightTime = std::max(flightTime, flight);
        if (entry.row.contact == Contact::pressing) {
            print(pressing, "{:.6g} {:.6g} {:.4g}\n", flight, contact,
                  std::min(entry.row.energy.least, mostColoured));
        } else {
            print(grazing, "{:.6g} {:.6g}\n", flight, contact);
        }
    });
    if (pressing.size() == 0 && grazing.size() == 0) {
        contactTime = 2.0;  // the usual range
        flightTime = 4.0;
    }

    Text script;
    const auto table = [&script](const char* name, const Text& rows) {
        print(script, "${} << EOD\n{}EOD\n", name, fmt::to_string(rows));
    };
    table("pressing", pressing);
    table("grazing", grazing);
    // Both times to one scale, so that lines of equal period run at 45 degrees.
    const double height = std::clamp(plotWidth * contactTime / flightTime, 2.0, plotWidth);
    print(script,
          "set size ratio -1\nset border lw 0.8\nset tics out nomirror scale 0.6\nset grid lw 0.4 "
          "lc '#dddddd'\n"
          "set xrange [0:{}]\nset yrange [0:{}]\n"
          "set xlabel 'flight time  t_f c/L'\nset ylabel 'contact time  t_c c/L'\n"
          "{}set logscale cb\nset cbrange [1:{}]\nset cbtics add (2, 5, 20, 50)\n"
          "set cblabel 'least energy  E_{{min}}/E_1'\n"
          "set key above left Left reverse samplen 1\n",
          flightTime * 1.01, contactTime * 1.01, palette::sequential(palette::onPaper),
          mostColoured);
    print(script, "plot NaN notitle, ");
    if (grazing.size() > 0) {
        print(script,
              "$grazing using 1:2 with points pt 7 ps 0.15 lc '#bbbbbb' notitle, "
              "NaN with points pt 7 ps 1 lc '#bbbbbb' title 'grazing: contact without force', ");
    }
    if (pressing.size() > 0) {
        print(script,
              "$pressing using 1:2:3 with points pt 7 ps 0.2 lc palette notitle, "
              "NaN with points pt 7 ps 1 lc '#21918c' title 'pressing, coloured by energy'");
    }
    print(script, "\n");
    runGnuplot(fmt::to_string(script), format, plotWidth + 5.0, height + 2.6, path);
}

}  // namespace signorini
