#include "units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <system_error>

namespace signorini {

namespace {

struct Unit {
    std::string_view base;  ///< the unit of the plain number
    std::string_view text;
    int exponent;  ///< of ten
};

constexpr std::array<Unit, 52> units{{
    {"-", "%", -2},          {"m", "m", 0},          {"m", "cm", -2},
    {"m", "mm", -3},         {"m", "um", -6},        {"m", "µm", -6},
    {"m", "nm", -9},         {"m^2", "m2", 0},       {"m^2", "m^2", 0},
    {"m^2", "cm2", -4},      {"m^2", "cm^2", -4},    {"m^2", "mm2", -6},
    {"m^2", "mm^2", -6},     {"Pa", "Pa", 0},        {"Pa", "kPa", 3},
    {"Pa", "MPa", 6},        {"Pa", "GPa", 9},       {"kg/m^3", "kg/m3", 0},
    {"kg/m^3", "kg/m^3", 0}, {"kg/m^3", "g/cm3", 3}, {"kg/m^3", "g/cm^3", 3},
    {"N", "N", 0},           {"N", "kN", 3},         {"N", "MN", 6},
    {"J", "J", 0},           {"J", "mJ", -3},        {"J", "kJ", 3},
    {"Hz", "Hz", 0},         {"Hz", "kHz", 3},       {"Hz", "MHz", 6},
    {"m/s", "m/s", 0},       {"m/s", "mm/s", -3},    {"m/s", "km/s", 3},
    {"s", "s", 0},           {"s", "ms", -3},        {"s", "us", -6},
    {"s", "µs", -6},         {"m/s^2", "m/s2", 0},   {"m/s^2", "m/s^2", 0},
    {"kg", "kg", 0},         {"kg", "g", -3},        {"kg", "t", 3},
    {"N/m", "N/m", 0},       {"N/m", "N/mm", 3},     {"N/m", "kN/m", 3},
    {"N/m", "kN/mm", 6},     {"N/m", "MN/m", 6},     {"rad", "rad", 0},
    {"m/s", "cm/s", -2},     {"N", "mN", -3},        {"N", "µN", -6},
    {"N", "uN", -6},
}};

/// All of a text, finite. libc++ 14 reads only whole numbers by from_chars.
template <typename Number = double>
std::optional<Number> finiteOf(std::string_view text)
{
    Number value = 0.0;
    const char* const end = text.data() + text.size();
    if constexpr (requires { std::from_chars(end, end, value); }) {
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        return error == std::errc{} && stop == end && std::isfinite(value) ? std::optional(value)
                                                                           : std::nullopt;
    } else {
        const std::string copy(text);
        char* stop = nullptr;
        value = std::strtod(copy.c_str(), &stop);
        const bool isPlain = !copy.empty() && copy.front() != '+' &&
                             copy.find_first_not_of("0123456789.eE+-") == std::string::npos &&
                             stop == copy.c_str() + copy.size();
        return isPlain && std::isfinite(value) ? std::optional(value) : std::nullopt;
    }
}

}  // namespace

std::optional<std::int64_t> wholeIn(std::string_view text, std::int64_t low, std::int64_t high)
{
    std::int64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool isWhole = error == std::errc{} && stop == end && value >= low && value <= high;
    return isWhole ? std::optional(value) : std::nullopt;
}

std::optional<double> numberIn(std::string_view text, std::string_view unit)
{
    if (const auto plain = finiteOf(text)) {
        return plain;
    }
    for (const Unit& known : units) {
        if (known.base != unit || !text.ends_with(known.text)) {
            continue;
        }
        std::string_view number = text.substr(0, text.size() - known.text.size());
        number.remove_suffix(number.ends_with(' ') ? 1 : 0);
        if (!finiteOf(number)) {
            continue;
        }
        const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
        std::int64_t exponent = 0;
        if (mark < number.size()) {
            const std::size_t start = mark + (number.substr(mark + 1).starts_with('+') ? 2 : 1);
            std::from_chars(number.data() + start, number.data() + number.size(), exponent);
        }
        return finiteOf(fmt::format("{}e{}", number.substr(0, mark), exponent + known.exponent));
    }
    return std::nullopt;
}

}  // namespace signorini
