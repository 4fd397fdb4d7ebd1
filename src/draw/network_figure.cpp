#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "axes.hpp"
#include "gnuplot.hpp"
#include "network_simulation.hpp"
#include "palette.hpp"
#include "scene_figures.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr std::size_t mostPanels = 6;
constexpr std::size_t mostPoints = 4000;
constexpr double shownCrossings = 24.0;  ///< of all cells

/// What is drawn of a simulation, in SI and units of engineers.
class ContactPanels {
public:
    explicit ContactPanels(const NetworkSimulation& simulation)
        : simulation_(simulation),
          network_(simulation.network()),
          end_(simulation.time()),
          begin_(std::max(0.0, end_ - shownCrossings * static_cast<double>(network_.cells()))),
          second_(unitFor(end_ * network_.scales.time, "s")),
          metre_(unitFor(extent(), "m"))
    {
    }

    std::string script()
    {
        Text script;
        const std::size_t panels = std::min(network_.contacts.size(), mostPanels);
        for (std::size_t j = 0; j < panels; ++j) {
            const NetworkContact& contact = network_.contacts[j];
            printPath(script, fmt::format("face{}", j), contact.node, 0.0);
            if (contact.kind == ContactKind::gap) {
                printPath(script, fmt::format("other{}", j), contact.node + 1, contact.gap);
            }
            printPresses(script, j);
        }
        print(script,
              "set multiplot layout {},1\nset border lw 0.8\nset tics out nomirror scale 0.6\n"
              "set grid lw 0.4 lc '{}'\nset xrange [{:.9g}:{:.9g}]\nset lmargin 12\n",
              panels, palette::grid, inSeconds(begin_), inSeconds(end_));
        for (std::size_t j = 0; j < panels; ++j) {
            plot(script, j, j + 1 == panels);
        }
        print(script, "unset multiplot\n");
        return fmt::to_string(script);
    }

private:
    [[nodiscard]] double inSeconds(double time) const
    {
        return time * network_.scales.time * second_.factor;
    }
    [[nodiscard]] double inMetres(double displacement) const
    {
        return displacement * network_.scales.displacement * metre_.factor;
    }

    /// [m], of all that is drawn.
    [[nodiscard]] double extent() const
    {
        double most = 0.0;
        for (const auto& path : simulation_.paths()) {
            for (const NodePoint& point : path) {
                most = std::max(most, std::abs(point.displacement));
            }
        }
        for (const NetworkContact& contact : network_.contacts) {
            most = std::max(most, std::abs(contact.gap));
        }
        return most * network_.scales.displacement;
    }

    void printPath(Text& script, const std::string& block, std::size_t node, double offset) const
    {
        const std::vector<NodePoint>& path = simulation_.paths()[node];
        const auto first =
            std::lower_bound(path.begin(), path.end(), begin_,
                             [](const NodePoint& point, double time) { return point.time < time; });
        const std::size_t count = static_cast<std::size_t>(path.end() - first);
        const std::size_t stride = 1 + count / mostPoints;
        print(script, "${} << EOD\n", block);
        for (std::size_t k = 0; k < count; k += stride) {
            const NodePoint& point = first[static_cast<std::ptrdiff_t>(k)];
            print(script, "{:.9g} {:.7g}\n", inSeconds(point.time),
                  inMetres(point.displacement + offset));
        }
        print(script, "{:.9g} {:.7g}\nEOD\n", inSeconds(end_),
              inMetres(simulation_.displacement(node) + offset));
    }

    /// From start to end, where the face is just then.
    void printPresses(Text& script, std::size_t contact) const
    {
        print(script, "$presses{} << EOD\nNaN NaN NaN\n", contact);
        std::size_t printed = 0;
        const NetworkContact& place = network_.contacts[contact];
        const std::vector<NodePoint>& path = simulation_.paths()[place.node];
        for (const NetworkContactEvent& event : simulation_.contacts()) {
            if (event.contact != contact || event.end < begin_ || ++printed > mostPoints) {
                continue;
            }
            for (const NodePoint& point : path) {
                if (point.time >= event.start && point.time <= event.end) {
                    print(script, "{:.9g} {:.7g} 0\n", inSeconds(point.time),
                          inMetres(point.displacement));
                }
            }
            print(script, "\n");
        }
        print(script, "EOD\n");
    }

    void plot(Text& script, std::size_t j, bool isLast) const
    {
        const NetworkContact& contact = network_.contacts[j];
        print(script, "set ylabel 'contact {}  [{}]'\n{}\n", j + 1, metre_.name,
              isLast ? fmt::format("set xlabel 'time  [{}]'", second_.name)
                     : std::string("unset xlabel"));
        const std::string other =
            contact.kind == ContactKind::gap
                ? fmt::format("$other{} using 1:2 with lines lw 1.2 lc '{}'", j, palette::strain)
                : fmt::format(
                      "{:.9g} with lines lw 2 lc '{}'",
                      inMetres(contact.kind == ContactKind::stopRight ? contact.gap : -contact.gap),
                      palette::faint);
        print(script,
              "plot {} notitle, $face{} using 1:2 with lines lw 1.2 lc '{}' notitle, "
              "$presses{} using 1:2 with lines lw 4 lc '{}' notitle\n",
              other, j, palette::ink, j, palette::contact);
    }

    const NetworkSimulation& simulation_;
    const Network& network_;
    double end_;
    double begin_;
    Unit second_;
    Unit metre_;
};

}  // namespace

void drawSimulation(const NetworkSimulation& simulation, FigureFormat format,
                    const std::string& path)
{
    const auto& paths = simulation.paths();
    if (std::all_of(paths.begin(), paths.end(), [](const auto& one) { return one.empty(); })) {
        throw std::invalid_argument("figure: the simulation holds no paths to draw");
    }
    const auto panels =
        static_cast<double>(std::min(simulation.network().contacts.size(), mostPanels));
    runGnuplot(ContactPanels(simulation).script(), format, 16.0, 4.0 + 4.0 * panels, path);
}

}  // namespace signorini
