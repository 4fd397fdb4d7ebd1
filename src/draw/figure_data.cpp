#include "signorini/figure_data.hpp"

#include <array>
#include <limits>
#include <utility>

#include "names.hpp"
#include "palette.hpp"

namespace signorini::plot {

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

struct RoleRow {
    Role value;
    std::string_view name;
    const char* colour;
};

constexpr auto roles = std::to_array<RoleRow>({
    {Role::ink, "ink", palette::ink},
    {Role::strain, "strain", palette::strain},
    {Role::velocity, "velocity", palette::velocity},
    {Role::contact, "contact", palette::contact},
    {Role::faint, "faint", palette::faint},
    {Role::grid, "grid", palette::grid},
    {Role::paper, "paper", "#ffffff"},
    {Role::shade1, "shade1", palette::fading[0]},
    {Role::shade2, "shade2", palette::fading[1]},
    {Role::shade3, "shade3", palette::fading[2]},
    {Role::shade4, "shade4", palette::fading[3]},
    {Role::shade5, "shade5", palette::fading[4]},
    {Role::shade6, "shade6", palette::fading[5]},
});

constexpr auto kinds = std::to_array<Named<Kind>>({{Kind::line, "line"},
                                                   {Kind::dots, "dots"},
                                                   {Kind::strokes, "strokes"},
                                                   {Kind::arrows, "arrows"},
                                                   {Kind::band, "band"},
                                                   {Kind::boxes, "boxes"},
                                                   {Kind::image, "image"},
                                                   {Kind::words, "words"}});

constexpr auto dashes = std::to_array<Named<Dash>>({{Dash::solid, "solid"},
                                                    {Dash::dashed, "dashed"},
                                                    {Dash::dotted, "dotted"},
                                                    {Dash::longDashed, "long dashed"}});

constexpr auto markers = std::to_array<Named<Marker>>({{Marker::disc, "disc"},
                                                       {Marker::ring, "ring"},
                                                       {Marker::cross, "cross"},
                                                       {Marker::square, "square"},
                                                       {Marker::diamond, "diamond"},
                                                       {Marker::openDiamond, "open diamond"},
                                                       {Marker::triangle, "triangle"}});

constexpr auto aligns = std::to_array<Named<Align>>(
    {{Align::left, "left"}, {Align::centre, "centre"}, {Align::right, "right"}});

constexpr auto legends = std::to_array<Named<Legend>>({{Legend::none, "none"},
                                                       {Legend::topLeft, "top left"},
                                                       {Legend::topRight, "top right"},
                                                       {Legend::bottomLeft, "bottom left"},
                                                       {Legend::bottomRight, "bottom right"},
                                                       {Legend::above, "above"},
                                                       {Legend::below, "below"}});

}  // namespace

void Series::add(double atX, double atY)
{
    x.push_back(atX);
    y.push_back(atY);
}

void Series::add(double fromX, double fromY, double toX, double toY)
{
    add(fromX, fromY);
    x2.push_back(toX);
    y2.push_back(toY);
}

void Series::add(double atX, double atY, std::string text)
{
    add(atX, atY);
    words.push_back(std::move(text));
}

void Series::addStep(double from, double to, double value)
{
    if (x.empty() || y.back() != value || x.back() != from) {
        add(from, value);
    } else if (x.size() > 1 && y[y.size() - 2] == value) {
        x.pop_back();
        y.pop_back();
    }
    add(to, value);
}

void Series::breakOff()
{
    add(noNumber, noNumber);
}

void Panel::add(Series one)
{
    if (!one.x.empty()) {
        series.push_back(std::move(one));
    }
}

void Panel::explain(Series style, std::string words)
{
    style.legend = std::move(words);
    series.push_back(std::move(style));
}

Panel& FigureData::add(Panel panel)
{
    return panels.emplace_back(std::move(panel));
}

std::string colourOf(Role role)
{
    return roles.at(static_cast<std::size_t>(role)).colour;
}

std::vector<std::string> coloursOf(ColourMap map)
{
    switch (map) {
        case ColourMap::sequence:
            return {palette::sequence.begin(), palette::sequence.end()};
        case ColourMap::onPaper:
            return {palette::sequence.begin(), palette::sequence.begin() + palette::onPaper};
        case ColourMap::diverging:
            return {palette::diverging.begin(), palette::diverging.end()};
        case ColourMap::counts:
            return {colourOf(Role::paper), colourOf(Role::shade6), colourOf(Role::shade4),
                    colourOf(Role::shade3), colourOf(Role::shade2)};
    }
    return {};
}

std::string name(Role role)
{
    return std::string(nameIn(roles, role));
}
std::string name(Kind kind)
{
    return std::string(nameIn(kinds, kind));
}
std::string name(Dash dash)
{
    return std::string(nameIn(dashes, dash));
}
std::string name(Marker marker)
{
    return std::string(nameIn(markers, marker));
}
std::string name(Align align)
{
    return std::string(nameIn(aligns, align));
}
std::string name(Legend legend)
{
    return std::string(nameIn(legends, legend));
}

}  // namespace signorini::plot
