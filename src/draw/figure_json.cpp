#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "signorini/figure_data.hpp"
#include "text.hpp"

namespace signorini::plot {

namespace {

// In the order of the enumerators.
constexpr std::array roleNames{"ink",    "strain", "velocity", "contact", "faint",
                               "grid",   "paper",  "shade1",   "shade2",  "shade3",
                               "shade4", "shade5", "shade6"};
constexpr std::array kindNames{"line", "dots",  "strokes", "arrows",
                               "band", "boxes", "image",   "words"};
constexpr std::array dashNames{"solid", "dashed", "dotted", "long dashed"};
constexpr std::array markerNames{"disc",    "ring",         "cross",   "square",
                                 "diamond", "open diamond", "triangle"};
constexpr std::array alignNames{"left", "centre", "right"};
constexpr std::array legendNames{"none",         "top left", "top right", "bottom left",
                                 "bottom right", "above",    "below"};

/// Members of an object, in the order in which they are put.
class Object {
public:
    Object() { text_ = "{"; }

    void put(const char* key, const std::string& json)
    {
        text_ += fmt::format("{}\"{}\": {}", text_.size() == 1 ? "" : ", ", key, json);
    }
    void put(const char* key, double value)
    {
        put(key, std::isfinite(value) ? fmt::format("{:.10g}", value) : std::string("null"));
    }
    void put(const char* key, bool value) { put(key, std::string(value ? "true" : "false")); }
    void put(const char* key, const std::optional<double>& value)
    {
        put(key, value.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    void say(const char* key, const std::string& words) { put(key, quoted(words)); }
    void say(const char* key, const auto& names, auto value)
    {
        say(key, names.at(static_cast<std::size_t>(value)));
    }

    [[nodiscard]] std::string text() const { return text_ + "}"; }

private:
    std::string text_;
};

std::string listOf(const auto& range, auto write)
{
    std::string text = "[";
    for (const auto& one : range) {
        text += (text.size() == 1 ? "" : ", ") + write(one);
    }
    return text + "]";
}

std::string numbers(const std::vector<double>& values)
{
    return listOf(values, [](double value) {
        return std::isfinite(value) ? fmt::format("{:.10g}", value) : std::string("null");
    });
}

std::string objectOf(const Series& series)
{
    Object object;
    object.say("kind", kindNames, series.kind);
    object.say("role", roleNames, series.role);
    object.say("colour", colourOf(series.role));
    object.put("width", series.width);
    object.say("dash", dashNames, series.dash);
    object.say("marker", markerNames, series.marker);
    object.put("size", series.size);
    object.put("opacity", series.opacity);
    object.put("isHatched", series.isHatched);
    object.put("isInPanel", series.isInPanel);
    object.say("align", alignNames, series.align);
    object.put("turn", series.turn);
    object.say("legend", series.legend);
    object.put("x", numbers(series.x));
    object.put("y", numbers(series.y));
    object.put("x2", numbers(series.x2));
    object.put("y2", numbers(series.y2));
    object.put("z", numbers(series.z));
    object.put("words", listOf(series.words, quoted));
    return object.text();
}

std::string objectOf(const Axis& axis)
{
    Object object;
    object.say("label", axis.label);
    object.put("low", axis.low);
    object.put("high", axis.high);
    object.put("isLogarithmic", axis.isLogarithmic);
    object.put("step", axis.step);
    object.put("ticks", listOf(axis.ticks, [](const Tick& tick) {
                   return fmt::format("[{:.10g}, {}]", tick.at, quoted(tick.text));
               }));
    object.put("hasNumbers", axis.hasNumbers);
    if (axis.other) {
        Object other;
        other.say("label", axis.other->label);
        other.put("factor", axis.other->factor);
        other.put("isInverse", axis.other->isInverse);
        other.put("ticks", numbers(axis.other->ticks));
        object.put("other", other.text());
    }
    return object.text();
}

std::string listOf(const Place& place)
{
    return numbers({place.left, place.right, place.bottom, place.top});
}

std::string objectOf(const Panel& panel)
{
    Object object;
    object.say("name", panel.name);
    object.put("place", listOf(panel.place));
    object.put("x", objectOf(panel.x));
    object.put("y", objectOf(panel.y));
    object.say("title", panel.title);
    object.say("legend", legendNames, panel.legend);
    object.put("legendRows", static_cast<double>(panel.legendRows));
    object.put("isFramed", panel.isFramed);
    object.put("hasGrid", panel.hasGrid);
    object.put("isEqual", panel.isEqual);
    object.put("map", listOf(coloursOf(panel.map), quoted));
    object.put("isStepped", panel.map == ColourMap::counts);
    object.put("colour", objectOf(panel.colour));
    object.put("colourBar", panel.colourBar ? listOf(*panel.colourBar) : std::string("null"));
    object.put("series",
               listOf(panel.series, [](const Series& series) { return objectOf(series); }));
    return object.text();
}

}  // namespace

std::string asJson(const FigureData& figure)
{
    Object object;
    object.put("width", figure.width);
    object.put("height", figure.height);
    object.say("title", figure.title);
    object.put("panels", listOf(figure.panels, [](const Panel& panel) { return objectOf(panel); }));
    return object.text();
}

}  // namespace signorini::plot
