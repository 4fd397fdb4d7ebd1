#pragma once
/// \file
/// A figure as data: panels with axes, units and ticks, series, legend and words. A builder, such
/// as `responseFigure`, makes it of an answer, once; gnuplot (`drawFigure`), matplotlib
/// (`signorini.plot`) and the page (both through `asJson`) draw it and know nothing of answers.
///
/// To add a figure: a builder in src/draw, its declaration in figures.hpp, its name in
/// src/draw/CMakeLists.txt.
///
/// A curve of motions with a stable and an unstable part, and a named point on it:
///
///     FigureData figure{.width = 16.0, .height = 10.0};
///     Panel& panel = figure.add({.name = "force", .place = {0.12, 0.88, 0.12, 0.9}});
///     panel.x = {.label = "frequency  [Hz]", .low = 381.0, .high = 532.0};
///     panel.y = {.label = "force  [kN]", .low = 0.0};
///     panel.legend = Legend::topLeft;
///     panel.series.push_back({.legend = "attracts", .x = f, .y = r});
///     panel.series.push_back({.dash = Dash::dashed, .legend = "repels", .x = g, .y = q});
///     panel.series.push_back({.kind = Kind::dots, .role = Role::contact, .x = {401.0},
///                             .y = {2.1}});
///     panel.series.push_back({.kind = Kind::words, .x = {401.0}, .y = {2.1}, .words = {" fold"}});
///
/// Words hold Greek letters as they are, and of markup only ω_1, E_{max} and 10^{-6}.

#include <optional>
#include <string>
#include <vector>

namespace signorini::plot {

/// Who a thing is: the one source of its colour (src/draw/palette.hpp).
enum class Role {
    ink,       ///< lines one follows: tip, modes
    strain,    ///< s; the second of two things told apart
    velocity,  ///< v; the third
    contact,   ///< where a stop presses, its force
    faint,     ///< stops, linear and grazing motions
    grid,
    paper,
    shade1,  ///< the boldest of six: what matters less and less
    shade2,
    shade3,
    shade4,
    shade5,
    shade6
};

enum class Kind {
    line,     ///< through (x, y); a NaN breaks it
    dots,     ///< at (x, y), coloured by z where there is one
    strokes,  ///< from (x, y) to (x2, y2)
    arrows,   ///< the same, with heads: `heads`
    band,     ///< between y and y2 over x; without y2 the closed polygon (x, y)
    boxes,    ///< [x, x2] x [y, y2], coloured by z where there is one
    image,    ///< z at x[i], y[j], both even; z[i + j * x.size()]
    words     ///< `words` at (x, y), in panel coordinates 0 to 1 where `isInPanel`
};

enum class Dash { solid, dashed, dotted, longDashed };
enum class Marker { disc, ring, cross, square, diamond, openDiamond, triangle };
enum class Align { left, centre, right };

/// What is drawn, in the units of its axes. Series are drawn in their order, the last on top.
struct Series {
    Kind kind = Kind::line;
    Role role = Role::ink;
    double width = 1.5;  ///< [pt], of lines
    Dash dash = Dash::solid;
    Marker marker = Marker::disc;
    double size = 1.0;     ///< of markers and letters, relative
    double opacity = 1.0;  ///< of bands and boxes
    bool isHatched = false;
    bool isInPanel = false;
    Align align = Align::left;
    double turn = 0.0;        ///< [degrees], of words
    std::string legend = {};  ///< empty: not there
    std::vector<double> x = {};
    std::vector<double> y = {};
    std::vector<double> x2 = {};
    std::vector<double> y2 = {};
    std::vector<double> z = {};
    std::vector<std::string> words = {};

    void add(double atX, double atY);
    void add(double fromX, double fromY, double toX, double toY);
    void add(double atX, double atY, std::string text);
    void addStep(double from, double to, double value);  ///< constant from x to x
    void breakOff();                                     ///< what follows is another line

    /// The same with words in the legend, or drawn another way.
    [[nodiscard]] Series named(std::string said) const;
    [[nodiscard]] Series as(Kind other) const;
};

/// The usual ones, for a start.
[[nodiscard]] Series line(Role role, double width, Dash dash = Dash::solid);
[[nodiscard]] Series dots(Role role, double size = 1.0, Marker marker = Marker::disc);
[[nodiscard]] Series strokes(Role role, double width, Dash dash = Dash::solid);
[[nodiscard]] Series labels(double size = 1.0, Align align = Align::left, Role role = Role::ink);
[[nodiscard]] Series notes(Align align = Align::left, Role role = Role::ink);  ///< in the panel
[[nodiscard]] Series box(Role role, double left, double low, double right, double high);
[[nodiscard]] Series across(double low, double high, double level, double width, Dash dash);

struct Tick {
    double at;
    std::string text;
};

/// The same axis on the other side of its panel: factor * value, or factor / value.
struct OtherSide {
    std::string label = {};
    double factor = 1.0;
    bool isInverse = false;
    std::vector<double> ticks = {};  ///< empty: round ones
};

struct Axis {
    std::string label = {};          ///< "time  t  [ms]"
    std::optional<double> low = {};  ///< unset: as the data have it
    std::optional<double> high = {};
    bool isLogarithmic = false;
    double step = 0.0;             ///< between ticks; 0: as the drawer likes
    std::vector<Tick> ticks = {};  ///< in their place
    bool hasNumbers = true;
    std::optional<OtherSide> other = {};
};

/// Which colours z has.
enum class ColourMap {
    sequence,   ///< dark to light
    onPaper,    ///< without the lightest, for dots
    diverging,  ///< compression, nothing, tension
    counts      ///< of 0, 1, 2, 3 and more
};

/// Edges [-], in parts of the figure from its lower left corner.
struct Place {
    double left = 0.12;
    double right = 0.95;
    double bottom = 0.12;
    double top = 0.92;
};

enum class Legend { none, topLeft, topRight, bottomLeft, bottomRight, above, below };

struct Panel {
    std::string name = {};
    Place place = {};
    Axis x = {};
    Axis y = {};
    std::string title = {};
    Legend legend = Legend::none;
    int legendRows = 0;    ///< at most so many; 0: any
    bool isFramed = true;  ///< no: only words and legend
    bool hasGrid = true;
    bool isEqual = false;  ///< x and y to one scale
    ColourMap map = ColourMap::sequence;
    Axis colour = {};                     ///< of z
    std::optional<Place> colourBar = {};  ///< unset: none
    std::vector<Series> series = {};

    /// Series behind all words; nothing if it has no points.
    void add(Series one);
    /// A line of the legend that no points go with.
    void explain(Series style, std::string words);
};

struct FigureData {
    double width = 16.0;   ///< [cm]
    double height = 12.0;  ///< [cm]
    std::string title = {};
    std::vector<Panel> panels = {};

    Panel& add(Panel panel);
};

/// "#d55e00".
[[nodiscard]] std::string colourOf(Role role);

/// The colours of a map, evenly from its least value to its largest.
[[nodiscard]] std::vector<std::string> coloursOf(ColourMap map);

/// All of it as JSON, for drawers in other languages: keys are the names of the fields, enumerators
/// have their names, series their colour beside their role, numbers that are not finite are null.
[[nodiscard]] std::string asJson(const FigureData& figure);

}  // namespace signorini::plot

namespace signorini {

using plot::FigureData;

}  // namespace signorini
