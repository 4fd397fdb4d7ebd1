#include "signorini/figure_data.hpp"

#include <array>
#include <limits>
#include <utility>

#include "palette.hpp"

namespace signorini::plot {

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

/// In the order of `Role`.
constexpr std::array roleColours{palette::ink,       palette::strain,    palette::velocity,
                                 palette::contact,   palette::faint,     palette::grid,
                                 "#ffffff",          palette::fading[0], palette::fading[1],
                                 palette::fading[2], palette::fading[3], palette::fading[4],
                                 palette::fading[5]};

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

Series Series::named(std::string said) const
{
    Series made = *this;
    made.legend = std::move(said);
    return made;
}

Series Series::as(Kind other) const
{
    Series made = *this;
    made.kind = other;
    return made;
}

Series line(Role role, double width, Dash dash)
{
    return {.role = role, .width = width, .dash = dash};
}

Series dots(Role role, double size, Marker marker)
{
    return {.kind = Kind::dots, .role = role, .marker = marker, .size = size};
}

Series strokes(Role role, double width, Dash dash)
{
    return line(role, width, dash).as(Kind::strokes);
}

Series labels(double size, Align align, Role role)
{
    return {.kind = Kind::words, .role = role, .size = size, .align = align};
}

Series notes(Align align, Role role)
{
    Series made = labels(1.0, align, role);
    made.isInPanel = true;
    return made;
}

Series box(Role role, double left, double low, double right, double high)
{
    Series made{.kind = Kind::boxes, .role = role};
    made.add(left, low, right, high);
    return made;
}

Series across(double low, double high, double level, double width, Dash dash)
{
    Series made = line(Role::ink, width, dash);
    made.addStep(low, high, level);
    return made;
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
    return roleColours.at(static_cast<std::size_t>(role));
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

}  // namespace signorini::plot
