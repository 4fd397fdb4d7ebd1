#include "request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace signorini::web {

namespace {

[[noreturn]] void refuse(const char* name, const Json& value, const std::string& allowed)
{
    constexpr std::size_t mostLetters = 60;  // all of them ASCII
    std::string shown = value.dump(-1, ' ', true);
    if (shown.size() > mostLetters) {
        shown = shown.substr(0, mostLetters) + "...";
    }
    throw std::invalid_argument(fmt::format("{} = {}: allowed {}", name, shown, allowed));
}

/// A number of 64 bits with a sign, which the library's JSON would make of greater ones, too.
bool isWhole(const Json& value)
{
    return value.is_number_unsigned() ? value.get<std::uint64_t>() <=
                                            std::uint64_t{std::numeric_limits<std::int64_t>::max()}
                                      : value.is_number_integer();
}

}  // namespace

Request requestOf(const std::string& question)
{
    constexpr int deepest = 8;
    const auto keeps = [](int depth, Json::parse_event_t, Json&) {
        if (depth > deepest) {
            throw std::invalid_argument("the question is nested too deeply");
        }
        return true;
    };
    try {
        return Request(Json::parse(question, keeps));
    } catch (const Json::parse_error& fault) {
        throw std::invalid_argument(
            fmt::format("the question is no JSON, from byte {} on", fault.byte));
    } catch (const Json::out_of_range&) {
        throw std::invalid_argument("a number of the question is beyond the largest double");
    }
}

const Json& Request::at(const char* name) const
{
    if (!has(name)) {
        throw std::invalid_argument(fmt::format("{} is missing", name));
    }
    return values_[name];
}

std::int64_t Request::whole(const char* name, std::int64_t low, std::int64_t high) const
{
    const Json& value = at(name);
    if (!isWhole(value) || value.get<std::int64_t>() < low || value.get<std::int64_t>() > high) {
        refuse(name, value, fmt::format("whole numbers {}..{}", low, high));
    }
    return value.get<std::int64_t>();
}

double Request::number(const char* name, double low, double high) const
{
    const Json& value = at(name);
    if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high)) {
        refuse(name, value, fmt::format("numbers {}..{}", low, high));
    }
    return value.get<double>();
}

std::optional<double> Request::positive(const char* name) const
{
    return has(name) ? std::optional(number(name, std::numeric_limits<double>::min(),
                                            std::numeric_limits<double>::max()))
                     : std::nullopt;
}

std::string Request::word(const char* name) const
{
    const Json& value = at(name);
    if (!value.is_string()) {
        refuse(name, value, "a word");
    }
    return value.get<std::string>();
}

bool Request::isOn(const char* name) const
{
    return has(name) && at(name).is_boolean() && at(name).get<bool>();
}

Scene Request::scene() const
{
    constexpr double widest = 0.1;
    Scene scene = bar;
    if (has("gap")) {
        scene.bar.gap = number("gap", -widest, widest);
    }
    if (has("second_stop")) {
        scene.secondStop = number("second_stop", std::numeric_limits<double>::min(), widest);
    }
    return scene;
}

Schedule Request::schedule() const
{
    Schedule schedule{whole("cells", 1, mostCells), {}, stopsOf(scene())};
    const Json& phases = at("phases");
    for (const Json& phase : phases) {
        const bool isLeft = phase.is_array() && phase.size() == 3 && phase[2] == "L";
        if (!phase.is_array() || (phase.size() != 2 && !isLeft) || !isWhole(phase[0]) ||
            !isWhole(phase[1])) {
            refuse("phases", phases,
                   "pairs of whole numbers, contact and free steps, and \"L\" at the second stop");
        }
        schedule.phases.push_back({phase[0].get<std::int64_t>(), phase[1].get<std::int64_t>(),
                                   isLeft ? Stop::left : Stop::right});
    }
    validate(schedule);
    constexpr std::int64_t mostSteps = 20;  // periods in L/c
    if (steps(schedule) > mostSteps * schedule.cells) {
        refuse("phases", phases,
               fmt::format("at most {} steps on this page", mostSteps * schedule.cells));
    }
    return schedule;
}

std::vector<std::array<std::int64_t, 3>> Request::triples(const char* name, std::int64_t high) const
{
    const Json& rows = at(name);
    std::vector<std::array<std::int64_t, 3>> all;
    const auto isPart = [high](const Json& value) {
        return isWhole(value) && value >= 0 && value <= high;
    };
    for (const Json& row : rows) {
        if (!row.is_array() || row.size() != 3 || rows.size() > 10 ||
            !std::all_of(row.begin(), row.end(), isPart)) {
            refuse(name, rows, fmt::format("at most ten rows of three whole numbers 0..{}", high));
        }
        all.push_back({row[0], row[1], row[2]});
    }
    return all;
}

std::vector<double> Request::numbers(const char* name, double low, double high) const
{
    std::vector<double> all;
    for (const Json& value : has(name) ? at(name) : Json::array()) {
        if (!value.is_number() || !(value >= low && value <= high)) {
            refuse(name, value, fmt::format("numbers {}..{}", low, high));
        }
        all.push_back(value.get<double>());
    }
    return all;
}

Request Request::part(const char* name) const
{
    const Json& value = at(name);
    if (!value.is_object()) {
        refuse(name, value, "a question of its own");
    }
    return Request(value);
}

void Reply::add(const char* name, std::span<const double> values)
{
    json["arrays"][name] = {numbers_.size(), values.size()};
    numbers_.insert(numbers_.end(), values.begin(), values.end());
}

std::uint64_t Reply::digest() const
{
    std::uint64_t hash = 0xcbf29ce484222325U;
    const auto take = [&hash](std::uint64_t value) { hash = (hash ^ value) * 0x100000001b3U; };
    for (const char letter : json.dump()) {
        take(static_cast<unsigned char>(letter));
    }
    for (const double value : numbers_) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        take(bits & 0xffffffffU);
        take(bits >> 32U);
    }
    return hash;
}

}  // namespace signorini::web
