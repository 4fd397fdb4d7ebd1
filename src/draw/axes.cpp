#include "axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace signorini {

namespace {

constexpr std::array prefixes{"p", "n", "µ", "m", "", "k", "M", "G"};
constexpr int unprefixed = 4;  ///< place of "" among them

/// Powers of 1000 that a double and its inverse hold.
constexpr int mostThousands = 100;

/// Rounding must not make 1000 of 999.9999.
constexpr double nearlyOne = 1.0 - 1e-9;

}  // namespace

Unit unitFor(double largest, const std::string& base)
{
    const double magnitude = largest > 0.0 ? std::log10(largest / nearlyOne) : 0.0;
    const int thousands =
        std::clamp(static_cast<int>(std::floor(magnitude / 3.0)), -mostThousands, mostThousands);
    const double factor = std::pow(10.0, -3 * thousands);
    const int place = thousands + unprefixed;
    if (!base.empty() && place >= 0 && place < static_cast<int>(prefixes.size())) {
        return {factor, prefixes.at(static_cast<std::size_t>(place)) + base};
    }
    if (thousands == 0) {
        return {1.0, base.empty() ? "-" : base};
    }
    return {factor, fmt::format("10^{{{}}}{}{}", 3 * thousands, base.empty() ? "" : " ", base)};
}

std::string withUnit(double value, const std::string& base)
{
    const Unit unit = unitFor(std::abs(value), base);
    if (base.empty()) {
        return fmt::format("{:.4g}{}", value * unit.factor,
                           unit.factor == 1.0 ? "" : "·" + unit.name);
    }
    return fmt::format("{:.4g} {}", value * unit.factor, unit.name);
}

std::string energyLabel(const Bar& bar, double energyRatio)
{
    return bar.gap == 0.0 ? "E = " + withUnit(energyRatio * scales(bar).energy, "J")
                          : fmt::format("E/E_1 = {:.5g}", energyRatio);
}

double niceStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

Unit axisUnit(double scale, double largest, const std::string& base)
{
    const Unit unit = unitFor(scale * std::abs(largest), base);
    return {scale * unit.factor, unit.name};
}

std::string labelled(const std::string& words, const Unit& unit)
{
    return fmt::format("{}  [{}]", words, unit.name);
}

plot::Axis axisIn(const Unit& unit, const std::string& words, double low, double high,
                  const std::string& other)
{
    plot::Axis axis{
        .label = labelled(words, unit), .low = unit.factor * low, .high = unit.factor * high};
    if (!other.empty() && std::isfinite(1.0 / unit.factor)) {
        axis.other = plot::OtherSide{.label = other, .factor = 1.0 / unit.factor};
    }
    return axis;
}

plot::Axis axisAround(const std::vector<plot::Series>& series, const std::string& label,
                      bool isFromZero)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const plot::Series& one : series) {
        for (const std::vector<double>* values : {&one.y, &one.y2}) {
            for (const double y : *values) {  // a NaN changes neither
                low = std::min(low, y);
                high = std::max(high, y);
            }
        }
    }
    if (low > high) {  // nothing to draw
        return {.label = label, .low = 0.0, .high = 1.0};
    }
    if (low == high) {
        return {.label = label, .low = isFromZero ? std::optional(0.0) : std::nullopt};
    }
    low = isFromZero ? 0.0 : low;
    const double room = 0.07 * (high - low);
    return {.label = label, .low = isFromZero ? 0.0 : low - room, .high = high + room};
}

std::vector<plot::Tick> roundTicks(double low, double high, std::initializer_list<double> digits)
{
    std::vector<plot::Tick> ticks;
    for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10.0) {
        for (const double digit : digits) {
            if (digit * power >= low && digit * power <= high) {
                ticks.push_back({digit * power, fmt::format("{:g}", digit * power)});
            }
        }
    }
    return ticks;
}

plot::Axis energyAxis(const std::string& label, double low, double high)
{
    constexpr double fewDecades = 1500.0;
    plot::Axis axis{.label = label, .low = low, .high = high, .isLogarithmic = true};
    if (high < fewDecades * low) {
        axis.ticks = roundTicks(low, high, {1.0, 2.0, 5.0});
    }
    return axis;
}

plot::Axis bare(plot::Axis axis)
{
    axis.label.clear();
    axis.hasNumbers = false;
    return axis;
}

plot::Axis frequencyAxis(const std::string& words, double low, double high, const Bar& bar)
{
    plot::Axis axis{.label = words + "  ω/ω_1", .low = low, .high = high};
    const Unit unit = axisUnit(0.25 / scales(bar).time, high, "Hz");
    if (std::isfinite(unit.factor) && unit.factor > 0.0) {
        axis.other = plot::OtherSide{.label = labelled("frequency", unit), .factor = unit.factor};
    }
    return axis;
}

plot::Axis hertzAxis(double low, double high, double first)
{
    plot::Axis axis{.label = "frequency of the excitation  [Hz]", .low = low, .high = high};
    if (first > 0.0) {
        axis.other = plot::OtherSide{.label = "ω/ω_1", .factor = 1.0 / first};
    }
    return axis;
}

plot::Series contactDots(std::size_t contact, double size)
{
    using namespace plot;
    constexpr std::array roles{Role::contact, Role::strain, Role::velocity, Role::ink};
    constexpr std::array markers{Marker::disc, Marker::square, Marker::triangle, Marker::diamond};
    return dots(roles.at(contact % roles.size()), size, markers.at(contact % markers.size()));
}

}  // namespace signorini
