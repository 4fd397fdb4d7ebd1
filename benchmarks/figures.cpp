#include "figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gnuplot.hpp"
#include "text.hpp"

namespace signorini::bench {

namespace {

/// Colours of Okabe and Ito, which colour-blind readers can tell apart; the marks differ too.
constexpr std::array colours{"#000000", "#0072b2", "#d55e00", "#009e73",
                             "#cc79a7", "#e69f00", "#56b4e9", "#777777"};
constexpr std::array marks{7, 5, 9, 11, 13, 4, 6, 8};

/// An error of 0 cannot be drawn on a logarithmic axis.
constexpr double smallestError = 1e-17;

struct Curve {
    std::string title;
    std::vector<std::pair<double, double>> points = {};
};

/// A plot of curves with logarithmic axes.
struct Panel {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::vector<Curve> curves = {};
    std::string settings = {};  ///< further commands of gnuplot
    const char* style = "linespoints";
};

std::string quoted(std::string text)
{
    std::replace(text.begin(), text.end(), '\'', ' ');
    return "'" + text + "'";
}

void printPanel(Text& script, const Panel& panel)
{
    for (std::size_t k = 0; k < panel.curves.size(); ++k) {
        print(script, "$curve{} << EOD\n", k);
        for (const auto& [x, y] : panel.curves[k].points) {
            print(script, "{} {}\n", x, y);
        }
        print(script, "EOD\n");
    }
    print(script,
          "set title {} offset 0,-0.5\nset xlabel {}\nset ylabel {}\nset logscale xy\n"
          "set format x '10^{{%T}}'\nset format y '10^{{%T}}'\n{}\nplot ",
          quoted(panel.title), quoted(panel.xLabel), quoted(panel.yLabel), panel.settings);
    for (std::size_t k = 0; k < panel.curves.size(); ++k) {
        print(script, "{}$curve{} using 1:2 with {} lw 1.6 lc rgb '{}' {} title {}",
              k == 0 ? "" : ", ", k, panel.style, colours[k % colours.size()],
              panel.style == std::string_view("steps")
                  ? fmt::format("dt {}", 1 + k % 5)
                  : fmt::format("pt {} ps 1.1 dt {}", marks[k % marks.size()],
                                1 + k / colours.size()),
              quoted(panel.curves[k].title));
    }
    print(script, "\n");
}

/// Panels side by side.
void draw(const std::vector<Panel>& panels, double width, double height, const std::string& path)
{
    Text script;
    print(script,
          "set border lw 0.8\nset tics out nomirror scale 0.6\nset grid lw 0.4 lc '#cccccc'\n"
          "set multiplot layout 1,{}\n",
          panels.size());
    for (const Panel& panel : panels) {
        printPanel(script, panel);
    }
    print(script, "unset multiplot\n");
    runGnuplot(fmt::to_string(script), FigureFormat::png, width, height, path);
}

/// A margin of its own keeps panels side by side equally high.
constexpr const char* keyBelow =
    "set bmargin 9.5\nset key below center maxrows 5 samplen 2 width -1 spacing 1.1 font ',15'";

/// The grid that headline figures are about: 300 cells if they were measured.
double headlineCells(const Table& table)
{
    double largest = 0.0;
    for (const Record& r : table) {
        if (r.figure("cells") == 300.0) {
            return 300.0;
        }
        largest = std::fmax(largest, r.figure("cells"));
    }
    return largest;
}

/// Each back end on the paper's unknowns (sy), over all tolerances.
Panel workPrecision(const Table& all, const std::string& what, const char* title)
{
    const Table any = where(all, [&](const Record& r) {
        return r.suite == "accuracy" && r.problem.starts_with("A ") && r.setting.starts_with(what);
    });
    const double cells = headlineCells(any);
    const Table table = where(any, [&](const Record& r) {
        return r.figure("cells") == cells && isClaim(r) && r.outcome != "wrong" &&
               (r.formulation == "sy" || isOurs(r));
    });
    Panel panel{.title = fmt::format("{}, N = {:.0f}", title, cells),
                .xLabel = "time [s]",
                .yLabel = "error (0 is drawn at 10^{-17})",
                .settings = fmt::format("set yrange [{}:1]\n{}", 0.3 * smallestError, keyBelow)};
    for (const std::string& backEnd : distinct(table, &Record::backEnd)) {
        const Table rows = where(table, [&](const Record& r) { return r.backEnd == backEnd; });
        Curve curve{.title = backEnd};
        for (const Record& r : rows) {
            curve.points.emplace_back(r.figure("seconds_median"),
                                      std::fmax(r.figure("error"), smallestError));
        }
        if (!curve.points.empty()) {
            panel.curves.push_back(std::move(curve));
        }
    }
    return panel;
}

Panel profile(const Table& all, const std::string& form)
{
    const Table table = where(all, [&](const Record& r) {
        return r.suite == "accuracy" && r.setting == "any 1e-06" && wasTried(r) &&
               (r.formulation == form || r.backEnd == "signorini");
    });
    Panel panel{.title = form == "sy" ? "a, b and prefix sums (sy)" : "amplitudes (" + form + ")",
                .xLabel = "time over the best time of any",
                .yLabel = "share of the cases done right",
                .settings = std::string("unset logscale y\nset format y '%g'\nset yrange [0:1.02]\n"
                                        "set xrange [0.8:*]\n") +
                            keyBelow,
                .style = "steps"};
    double farthest = 10.0;
    auto profiles = performanceProfiles(table, [](const Record& r) { return r.backEnd; });
    for (const auto& [solver, points] : profiles) {
        if (!points.empty()) {
            farthest = std::max(farthest, points.back().factor);
        }
    }
    for (const auto& [solver, points] : profiles) {
        Curve curve{.title = solver};
        double share = 0.0;
        curve.points.emplace_back(0.8, 0.0);
        for (const ProfilePoint& point : points) {
            curve.points.emplace_back(point.factor, point.share);
            share = point.share;
        }
        curve.points.emplace_back(2.0 * farthest, share);
        panel.curves.push_back(std::move(curve));
    }
    return panel;
}

Panel scaling(const Table& all, bool ours)
{
    const Table table = where(all, [ours](const Record& r) {
        return r.suite == "scaling" && (r.backEnd == "signorini") == ours &&
               (r.outcome == "right" || r.outcome == "reference");
    });
    Panel panel{.title = ours ? "the library" : "programs, family A",
                .xLabel = "cells N",
                .yLabel = "time [s]",
                .settings = fmt::format(
                    "set yrange [5e-8:*]\nset xtics 1,{}\nset key outside right top Left "
                    "reverse samplen 2.5 spacing 1.1 font ',15'",
                    ours ? 100 : 10)};
    std::vector<std::string> labels;
    const auto labelOf = [ours](const Record& r) {
        return ours ? r.setting : r.backEnd + ", " + r.formulation;
    };
    for (const Record& r : table) {
        if (std::find(labels.begin(), labels.end(), labelOf(r)) == labels.end()) {
            labels.push_back(labelOf(r));
        }
    }
    for (const std::string& label : labels) {
        Curve curve;
        for (const Record& r : table) {
            if (labelOf(r) == label) {
                curve.points.emplace_back(r.figure("cells"), r.figure("seconds_median"));
            }
        }
        const PowerLaw law = fitPowerLaw(curve.points);
        curve.title =
            std::isnan(law.exponent) ? label : fmt::format("{}: N^{{{:.2f}}}", label, law.exponent);
        panel.curves.push_back(std::move(curve));
    }
    return panel;
}

/// Bars: time of each program, for two solvers.
void drawLeavingOut(const Table& all, const std::string& path)
{
    const Table table = where(all, [](const Record& r) {
        return r.suite == "leaving-out" && r.problem.starts_with("A ") && r.backEnd != "signorini";
    });
    const std::vector<std::string> problems = distinct(table, &Record::problem);
    const std::vector<std::string> forms = distinct(table, &Record::formulation);
    Text script;
    print(script,
          "set border lw 0.8\nset tics out nomirror scale 0.6\nset grid y lw 0.4 lc '#cccccc'\n"
          "set multiplot layout 1,2\nset logscale y\nset format y '10^{{%T}}'\n"
          "set ylabel 'time to pose and solve [s]'\n"
          "set style fill solid 0.85 border lc rgb 'black'\nset boxwidth 0.9 relative\n"
          "set style data histograms\nset style histogram clustered gap 1\n"
          "set xtics rotate by -40 left\nset key top left samplen 1.5\nset yrange [5e-8:20]\n");
    for (const char* solver : {"glpk-simplex", "clp-simplex"}) {
        print(script, "$bars << EOD\n");
        for (const std::string& form : forms) {
            print(script, "\"{}\"", form == "-" ? "closed form" : form);
            for (const std::string& problem : problems) {
                double time = NAN;
                for (const Record& r : table) {
                    const bool isProgram = r.backEnd == solver;
                    if (r.problem == problem && r.formulation == form && r.outcome == "right" &&
                        (isProgram || r.backEnd == "closed-form")) {
                        time = r.figure("seconds_median") +
                               (isProgram ? r.figure("pose_seconds") : 0.0);
                    }
                }
                print(script, " {}", std::isnan(time) ? "?" : fmt::format("{}", time));
            }
            print(script, "\n");
        }
        print(script, "EOD\nset datafile missing '?'\nset title '{}'\nplot ", solver);
        for (std::size_t k = 0; k < problems.size(); ++k) {
            print(script, "{}$bars using {}:xtic(1) lc rgb '{}' title {}", k == 0 ? "" : ", ",
                  k + 2, colours[1 + k % (colours.size() - 1)], quoted(problems[k]));
        }
        print(script, "\n");
    }
    print(script, "unset multiplot\n");
    runGnuplot(fmt::to_string(script), FigureFormat::png, 22.0, 9.0, path);
}

Panel rivals(const Table& all, const std::string& periods)
{
    Panel panel{.title = "main mode, T = 3.5 L/c, over " + periods,
                .xLabel = "time [s]",
                .yLabel = "tip error, r.m.s. (0 is drawn at 10^{-17})",
                .settings = fmt::format("set yrange [{}:1]\n{}", 0.3 * smallestError,
                                        "set key at graph 0.5,0.5 center samplen 3")};
    for (const char* who : {"siconos", "signorini"}) {
        Curve curve{.title = who};
        for (const Record& r : all) {
            if (r.suite == "rivals" && r.backEnd == who && r.setting.ends_with(periods) &&
                !std::isnan(r.figure("tip_error"))) {
                curve.points.emplace_back(r.figure("seconds_median"),
                                          std::fmax(r.figure("tip_error"), smallestError));
            }
        }
        if (!curve.points.empty()) {
            panel.curves.push_back(std::move(curve));
        }
    }
    return panel;
}

bool has(const Table& table, const char* suite)
{
    return std::any_of(table.begin(), table.end(), [suite](const Record& r) {
        return r.suite == suite && r.outcome == "right";
    });
}

}  // namespace

std::vector<Figure> drawFigures(const Table& table, const std::string& folder)
{
    std::vector<Figure> figures;
    /// Panels without a single curve are left out, and figures without panels.
    const auto add = [&](const char* file, const char* caption, std::vector<Panel> panels,
                         double width, double height) {
        std::erase_if(panels, [](const Panel& panel) { return panel.curves.empty(); });
        if (!panels.empty()) {
            draw(panels, width * static_cast<double>(panels.size()), height, folder + "/" + file);
            figures.push_back({file, caption});
        }
    };
    if (has(table, "accuracy")) {
        add("work_precision.png",
            "Error against time, one point per tolerance 1e-3 ... 1e-12, in the paper's unknowns "
            "(sy); wrong claims are not drawn",
            {workPrecision(table, "any", "any motion"),
             workPrecision(table, "least energy", "least energy"),
             workPrecision(table, "energy 20", "energy 20 E_1")},
            10.5, 11.0);
        add("performance_profile.png",
            "Share of the existence problems (families and random schedules) done right within a "
            "multiple of the best time; a failure takes for ever",
            {profile(table, "sy"), profile(table, "reduced")}, 11.0, 11.0);
    }
    if (has(table, "scaling")) {
        add("scaling.png", "Time against the number of cells, with fitted exponents",
            {scaling(table, true), scaling(table, false)}, 12.5, 7.5);
    }
    if (std::any_of(table.begin(), table.end(), [](const Record& r) {
            return r.suite == "leaving-out" && r.problem.starts_with("A ") &&
                   r.formulation == "lumped" && r.outcome == "right";
        })) {
        drawLeavingOut(table, folder + "/leaving_out.png");
        figures.push_back(
            {"leaving_out.png",
             "Time to pose and solve the same request, existence, with more and more of what "
             "the library leaves out; missing bars were ended by a limit"});
    }
    if (has(table, "rivals")) {
        add("rivals.png",
            "Error of the tip displacement against time: finite elements with Moreau-Jean time "
            "stepping (Siconos) and the exact motion",
            {rivals(table, "1 periods"), rivals(table, "5 periods")}, 10.0, 7.5);
    }
    return figures;
}

}  // namespace signorini::bench
