#include "hints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <system_error>

namespace signorini::cli {

namespace {

struct Unit {
    std::string_view base;  ///< the unit of the plain number
    std::string_view text;
    double factor;
};

constexpr std::array<Unit, 37> units{{
    {"-", "%", 0.01},          {"m", "m", 1.0},          {"m", "cm", 1e-2},
    {"m", "mm", 1e-3},         {"m", "um", 1e-6},        {"m", "µm", 1e-6},
    {"m", "nm", 1e-9},         {"m^2", "m2", 1.0},       {"m^2", "m^2", 1.0},
    {"m^2", "cm2", 1e-4},      {"m^2", "cm^2", 1e-4},    {"m^2", "mm2", 1e-6},
    {"m^2", "mm^2", 1e-6},     {"Pa", "Pa", 1.0},        {"Pa", "kPa", 1e3},
    {"Pa", "MPa", 1e6},        {"Pa", "GPa", 1e9},       {"kg/m^3", "kg/m3", 1.0},
    {"kg/m^3", "kg/m^3", 1.0}, {"kg/m^3", "g/cm3", 1e3}, {"kg/m^3", "g/cm^3", 1e3},
    {"N", "N", 1.0},           {"N", "kN", 1e3},         {"N", "MN", 1e6},
    {"J", "J", 1.0},           {"J", "mJ", 1e-3},        {"J", "kJ", 1e3},
    {"Hz", "Hz", 1.0},         {"Hz", "kHz", 1e3},       {"Hz", "MHz", 1e6},
    {"m/s", "m/s", 1.0},       {"m/s", "km/s", 1e3},     {"s", "s", 1.0},
    {"s", "ms", 1e-3},         {"s", "us", 1e-6},        {"s", "µs", 1e-6},
    {"m/s^2", "m/s2", 1.0},
}};

/// Letters that differ, lack, are too many or change places (optimal string alignment).
std::size_t distance(std::string_view one, std::string_view two)
{
    std::vector<std::size_t> before;
    std::vector<std::size_t> last(two.size() + 1);
    std::vector<std::size_t> row(two.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= one.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= two.size(); ++j) {
            const bool isSame = one[i - 1] == two[j - 1];
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (isSame ? 0 : 1)});
            if (i > 1 && j > 1 && one[i - 1] == two[j - 2] && one[i - 2] == two[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        before = last;
        last = row;
    }
    return last.back();
}

}  // namespace

std::string nearestName(std::string_view word, const std::vector<std::string>& names)
{
    constexpr std::size_t longest = 60;
    std::string plain(word.substr(0, word.find('=')));
    if (plain.size() > longest) {
        return {};
    }
    std::replace(plain.begin(), plain.end(), '_', '-');
    // Two dashes are no letters.
    const std::size_t letters = plain.size() - (plain.starts_with("--") ? 2 : 0);
    std::size_t least = letters >= 6 ? 3 : letters >= 3 ? 2 : 1;
    std::string nearest;
    for (const std::string& name : names) {
        if (const std::size_t here = distance(plain, name); here < least) {
            least = here;
            nearest = name;
        }
    }
    return nearest;
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& names)
{
    const std::string nearest = nearestName(word, names);
    return nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
}

std::string unitHint(std::string_view text, std::string_view unit)
{
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop == end || !std::isfinite(value)) {
        return {};
    }
    std::string_view rest(stop, static_cast<std::size_t>(end - stop));
    rest.remove_prefix(rest.starts_with(' ') ? 1 : 0);
    const auto* known = std::find_if(units.begin(), units.end(), [&](const Unit& one) {
        return one.base == unit && one.text == rest;
    });
    return known == units.end() ? "" : fmt::format("; {} is {:.9g}", text, value * known->factor);
}

std::string sizeOf(const Bar& bar)
{
    const bool isUsual = bar.length == Bar{}.length && bar.waveSpeed == Bar{}.waveSpeed;
    return fmt::format("L = {:.6g} m, c = {:.6g} m/s{}", bar.length, bar.waveSpeed,
                       isUsual ? " by default" : "");
}

}  // namespace signorini::cli
