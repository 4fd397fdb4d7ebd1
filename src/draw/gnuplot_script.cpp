#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axes.hpp"
#include "faults.hpp"
#include "gnuplot.hpp"
#include "signorini/figures.hpp"
#include "text.hpp"

namespace signorini {

namespace {

using namespace plot;

std::string dashOf(Dash dash)
{
    constexpr std::array dashes{"", " dt (6,3)", " dt (2,3)", " dt (10,4)"};
    return dashes.at(static_cast<std::size_t>(dash));
}

int pointOf(Marker marker)
{
    constexpr std::array points{7, 6, 2, 5, 13, 12, 9};
    return points.at(static_cast<std::size_t>(marker));
}

/// A limit of a range.
std::string limit(const std::optional<double>& value)
{
    return value ? fmt::format("{:.10g}", *value) : "*";
}

/// Writes one panel; numbers of data blocks go on from panel to panel.
class PanelScript {
public:
    PanelScript(Text& script, const Panel& panel, double height, int& blocks)
        : script_(script), panel_(panel), height_(height), blocks_(blocks)
    {
    }

    void write()
    {
        std::string plots;
        for (const Series& series : panel_.series) {
            plots += series.kind == Kind::words ? "" : plotOf(series);
        }
        for (const Series& series : panel_.series) {
            plots += series.kind == Kind::words && !series.isInPanel ? plotOf(series) : "";
        }
        frame();
        axis("x", panel_.x);
        axis("y", panel_.y);
        colours();
        legend();
        for (const Series& series : panel_.series) {
            if (series.isInPanel) {
                labels(series);
            }
        }
        print(script_, "plot {}NaN with lines lc '{}' notitle\nunset label\n", plots,
              colourOf(Role::ink));
    }

private:
    void frame()
    {
        const Place& place = panel_.place;
        print(script_,
              "set lmargin at screen {:.5g}\nset rmargin at screen {:.5g}\n"
              "set bmargin at screen {:.5g}\nset tmargin at screen {:.5g}\n"
              "set size {}\n{} border{}\n{}\nset title {} offset 0,{}\n",
              place.left, place.right, place.bottom, place.top,
              panel_.isEqual ? "ratio -1" : "noratio", panel_.isFramed ? "set" : "unset",
              panel_.isFramed ? " 31 lw 0.8 front" : "",
              panel_.hasGrid && panel_.isFramed
                  ? fmt::format("set grid lw 0.4 lc '{}'", colourOf(Role::grid))
                  : "unset grid",
              quoted(panel_.title), panel_.x.other ? "0" : "-0.5");
    }

    void axis(const char* side, const Axis& axis)
    {
        print(script_,
              "unset logscale {0}\nunset link {0}2\nunset logscale {0}2\nset {0}range [{1}:{2}] "
              "noextend\n{3}set {0}label "
              "{4}{5}\n"
              "set format {0} {6}\n",
              side, limit(axis.low), limit(axis.high),
              axis.isLogarithmic ? fmt::format("set logscale {}\n", side) : "", quoted(axis.label),
              *side == 'x' ? " offset 0,0.3" : "",
              !axis.hasNumbers ? "''"
              : isWide(axis)   ? "'10^{%L}'"
                               : "'%g'");
        if (!panel_.isFramed) {
            print(script_, "unset {0}tics\nunset {0}2tics\nunset {0}2label\n", side);
            return;
        }
        print(script_, "set {}tics out nomirror scale 0.6 {}\n", side, ticksOf(axis));
        if (!axis.other || !axis.low || !axis.high) {
            print(script_, "unset {0}2tics\nunset {0}2label\n", side);
            return;
        }
        const OtherSide& other = *axis.other;
        const double span = (*axis.high - *axis.low) * other.factor;
        const std::string inverse = fmt::format("{:.17g}/{}", other.factor, side);
        // Of a logarithmic axis, which cannot be linked, it is an axis of its own.
        const std::string own =
            fmt::format("set {0}2range [{1:.17g}:{2:.17g}] noextend\nset logscale {0}2", side,
                        *axis.low * other.factor, *axis.high * other.factor);
        const std::string linked =
            fmt::format("set link {}2 via {} inverse {}", side,
                        other.isInverse ? inverse : fmt::format("{}*{:.17g}", side, other.factor),
                        other.isInverse ? inverse : fmt::format("{}/{:.17g}", side, other.factor));
        std::string ticks;
        for (const double tick : other.ticks) {
            ticks += fmt::format("{}{}", ticks.empty() ? "(" : ", ", tick);
        }
        print(script_,
              "{1}\nset {0}2tics out nomirror scale 0.6 {2}\n"
              "set {0}2label {3}{4}\nset format {0}2 '%g'\n",
              side, axis.isLogarithmic && !other.isInverse ? own : linked,
              !ticks.empty()    ? ticks + ")"
              : other.isInverse ? "autofreq"
                                : fmt::format("{:.17g}", niceStep(span / 5.0)),
              quoted(other.label), *side == 'x' ? " offset 0,-0.4" : "");
    }

    /// Powers of ten rather than numbers?
    static bool isWide(const Axis& axis)
    {
        return axis.isLogarithmic && axis.ticks.empty() && axis.high && *axis.high > 1000.0;
    }

    static std::string ticksOf(const Axis& axis)
    {
        std::string ticks;
        for (const Tick& tick : axis.ticks) {
            ticks +=
                fmt::format("{}{} {:.10g}", ticks.empty() ? "(" : ", ", quoted(tick.text), tick.at);
        }
        return !ticks.empty()    ? ticks + ")"
               : axis.step > 0.0 ? fmt::format("{:.10g}", axis.step)
                                 : "autofreq";
    }

    void colours()
    {
        const Axis& axis = panel_.colour;
        std::string map;
        int stop = 0;
        for (const std::string& colour : coloursOf(panel_.map)) {
            map += fmt::format("{}{} '{}'", stop == 0 ? "" : ", ", stop, colour);
            ++stop;
        }
        print(script_, "set palette {}defined ({})\nset cbrange [{}:{}]\n{} logscale cb\n",
              panel_.map == ColourMap::counts ? fmt::format("maxcolors {} ", stop) : "", map,
              limit(axis.low), limit(axis.high), axis.isLogarithmic ? "set" : "unset");
        if (!panel_.colourBar) {
            print(script_, "unset colorbox\n");
            return;
        }
        const Place& bar = *panel_.colourBar;
        print(script_,
              "set colorbox user origin screen {:.5g},{:.5g} size screen {:.5g},{:.5g}\n"
              "set cblabel {} offset 0.6,0\nset format cb '{}'\nset cbtics {}\n",
              bar.left, bar.bottom, bar.right - bar.left, bar.top - bar.bottom, quoted(axis.label),
              isWide(axis) ? "10^{%L}" : "%g", ticksOf(axis));
    }

    void legend()
    {
        constexpr std::array corners{"", "top left", "top right", "bottom left", "bottom right"};
        const Place& place = panel_.place;
        std::string where;
        switch (panel_.legend) {
            case Legend::none:
                print(script_, "unset key\n");
                return;
            case Legend::above:
                where = fmt::format("at screen {:.5g},{:.5g} left bottom horizontal maxrows 1",
                                    place.left, place.top + 0.1 / height_);
                break;
            case Legend::below:
                where =
                    fmt::format("at screen {:.5g},{:.5g} left top vertical maxrows {}", place.left,
                                place.bottom - 1.6 / height_, std::max(panel_.legendRows, 1));
                break;
            default:
                where =
                    fmt::format("inside {} vertical maxrows {}",
                                corners.at(static_cast<std::size_t>(panel_.legend)),
                                panel_.legendRows > 0 ? std::to_string(panel_.legendRows) : "auto");
        }
        // Markup has no width: what gnuplot allows for it is taken back where columns stand close.
        print(script_, "set key {} reverse Left samplen 2 spacing 1.15 width {}\n", where,
              panel_.legendRows > 0 ? -4 : 1);
    }

    void labels(const Series& series)
    {
        for (std::size_t k = 0; k < series.words.size(); ++k) {
            print(script_, "set label {} at graph {:.5g},{:.5g} {}{} front textcolor '{}'\n",
                  sized(series, series.words[k]), series.x[k], series.y[k], alignOf(series),
                  turnOf(series), colourOf(series.role));
        }
    }

    static std::string sized(const Series& series, const std::string& words)
    {
        return quoted(series.size == 1.0 ? words
                                         : fmt::format("{{/*{:.3g} {}}}", series.size, words));
    }
    static std::string alignOf(const Series& series)
    {
        constexpr std::array aligns{"left", "center", "right"};
        return aligns.at(static_cast<std::size_t>(series.align));
    }
    static std::string turnOf(const Series& series)
    {
        return series.turn == 0.0 ? "" : fmt::format(" rotate by {:.4g}", series.turn);
    }

    /// A data block and how it is plotted; a title without data where there are none.
    std::string plotOf(const Series& series)
    {
        const std::string title = series.legend.empty()
                                      ? " notitle, "
                                      : fmt::format(" title {}, ", quoted(series.legend));
        const std::string line = fmt::format("lw {:.3g}{} lc '{}'", series.width,
                                             dashOf(series.dash), colourOf(series.role));
        if (series.x.empty() && series.legend.empty()) {
            return "";
        }
        ++blocks_;
        const std::string block = fmt::format("$d{} using ", blocks_);
        print(script_, "$d{} << EOD\n", blocks_);
        rows(series);
        print(script_, "EOD\n");
        const bool hasColour = !series.z.empty();
        const std::string paint =
            hasColour ? "palette" : fmt::format("'{}'", colourOf(series.role));
        const std::string fill = fmt::format(
            "fillstyle {} noborder fillcolor {}",
            series.isHatched       ? std::string("pattern 4")
            : series.opacity < 1.0 ? fmt::format("transparent solid {:.3g}", series.opacity)
                                   : std::string("solid 1.0"),
            paint);
        return block + lookOf(series, line, paint, fill) + title;
    }

    /// Columns and style.
    static std::string lookOf(const Series& series, const std::string& line,
                              const std::string& paint, const std::string& fill)
    {
        const bool hasColour = !series.z.empty();
        switch (series.kind) {
            case Kind::line:
            case Kind::strokes:
                return "1:2 with lines " + line;
            case Kind::dots:
                return fmt::format("{} with points pt {} ps {:.3g} lw {:.3g} lc {}",
                                   hasColour ? "1:2:3" : "1:2", pointOf(series.marker),
                                   0.8 * series.size, series.width, paint);
            case Kind::arrows:
                return "1:2:3:4 with vectors head filled size screen 0.01,25 " + line;
            case Kind::band:
                return (series.y2.empty() ? "1:2 with filledcurves closed "
                                          : "1:2:3 with filledcurves ") +
                       fill;
            case Kind::boxes:
                return fmt::format("1:2:3:4:5:6{} with boxxyerror {}", hasColour ? ":7" : "", fill);
            case Kind::image:
                return "1:2:3 with image";
            case Kind::words:
                return fmt::format("1:2:3 with labels {}{} textcolor {}", alignOf(series),
                                   turnOf(series), paint);
        }
        return "";
    }

    void rows(const Series& series)
    {
        if (series.x.empty()) {
            print(script_, "NaN NaN NaN NaN NaN NaN NaN\n");
        }
        if (series.kind == Kind::image) {
            for (std::size_t k = 0; k < series.z.size(); ++k) {
                print(script_, "{:.7g} {:.7g} {:.5g}\n", series.x[k % series.x.size()],
                      series.y[k / series.x.size()], series.z[k]);
            }
            return;
        }
        for (std::size_t k = 0; k < series.x.size(); ++k) {
            row(series, k);
        }
    }

    void row(const Series& series, std::size_t k)
    {
        const double x = series.x[k];
        const double y = series.y[k];
        if (!std::isfinite(x) || !std::isfinite(y)) {
            print(script_, "\n");
            return;
        }
        print(script_, "{:.9g} {:.7g}", x, y);
        switch (series.kind) {
            case Kind::strokes:
                print(script_, "\n{:.9g} {:.7g}\n", series.x2[k], series.y2[k]);
                break;
            case Kind::arrows:
                print(script_, " {:.7g} {:.7g}", series.x2[k] - x, series.y2[k] - y);
                break;
            case Kind::band:
                print(script_, " {:.7g}", series.y2.empty() ? y : series.y2[k]);
                break;
            case Kind::boxes:
                print(script_, " {:.9g} {:.9g} {:.7g} {:.7g}", x, series.x2[k], y, series.y2[k]);
                break;
            case Kind::words:
                print(script_, " {}", sized(series, series.words[k]));
                break;
            default:
                break;
        }
        print(script_, "{}\n", series.z.empty() ? "" : fmt::format(" {:.6g}", series.z[k]));
    }

    Text& script_;
    const Panel& panel_;
    double height_;  ///< [cm], of the figure
    int& blocks_;
};

void printFigure(Text& script, const FigureData& figure)
{
    int blocks = 0;
    print(script, "set multiplot\n");
    if (!figure.title.empty()) {
        print(script, "set label {} at screen 0.5,{:.5g} center\n", quoted(figure.title),
              1.0 - 0.45 / figure.height);
    }
    for (const Panel& panel : figure.panels) {
        PanelScript(script, panel, figure.height, blocks).write();
    }
    print(script, "unset multiplot\n");
}

/// By the ending of a name.
auto formatOf(const char* field, const std::string& path, const auto& formats, const char* allowed)
{
    for (const auto& [ending, format] : formats) {
        if (path.ends_with(ending)) {
            return format;
        }
    }
    throwFault(field, onOneLine(path), fmt::format("a name ending in {}", allowed));
}

}  // namespace

FigureFormat figureFormat(const std::string& path)
{
    constexpr std::array formats{std::pair{".svg", FigureFormat::svg},
                                 std::pair{".png", FigureFormat::png},
                                 std::pair{".pdf", FigureFormat::pdf}};
    return formatOf("figure", path, formats, ".svg, .png or .pdf");
}

AnimationFormat animationFormat(const std::string& path)
{
    constexpr std::array formats{std::pair{".gif", AnimationFormat::gif},
                                 std::pair{".mp4", AnimationFormat::mp4}};
    return formatOf("animation", path, formats, ".gif or .mp4");
}

void drawFigure(const FigureData& figure, FigureFormat format, const std::string& path)
{
    Text script;
    printFigure(script, figure);
    runGnuplot(fmt::to_string(script), format, figure.width, figure.height, path);
}

void drawFigures(std::span<const FigureData> frames, AnimationFormat format,
                 const std::string& path)
{
    Text script;
    for (const FigureData& frame : frames) {
        printFigure(script, frame);
    }
    runGnuplot(fmt::to_string(script), format, path);
}

}  // namespace signorini
