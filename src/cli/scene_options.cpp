#include "scene_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "faults.hpp"
#include "given.hpp"
#include "json.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t mostBytes = 16'000'000;

/// An object whose entries are taken one by one.
class Entries {
public:
    Entries(const Json& json, std::string place) : json_(json), place_(std::move(place))
    {
        refuseIf(!json.is_object(), place_, shortened(json.dump(-1, ' ', true)), "an object {...}");
    }

    [[nodiscard]] bool has(std::string_view key) const
    {
        const auto found = json_.find(std::string(key));
        return found != json_.end() && !found->is_null();
    }
    /// `fallback` if it is not there. \throws std::invalid_argument if it is no finite number.
    [[nodiscard]] double number(std::string_view key, std::optional<double> fallback = {})
    {
        taken_.emplace_back(key);
        if (!has(key) && fallback) {
            return *fallback;
        }
        const Json value = json_.value(std::string(key), Json());
        const bool isNumber = value.is_number() && std::isfinite(value.get<double>());
        if (!isNumber) {
            refuseEntry(key, value, "finite numbers");
        }
        return value.get<double>();
    }
    [[nodiscard]] std::int64_t whole(std::string_view key)
    {
        const double value = number(key);
        if (!(value >= 1.0 && value <= static_cast<double>(maxCells) &&
              value == std::floor(value))) {
            refuseEntry(key, json_[std::string(key)], fmt::format("whole numbers 1..{}", maxCells));
        }
        return static_cast<std::int64_t>(value);
    }
    [[nodiscard]] const Json& take(std::string_view key)
    {
        taken_.emplace_back(key);
        static const Json nothing;
        const auto found = json_.find(std::string(key));
        return found == json_.end() ? nothing : *found;
    }
    [[noreturn]] void refuseEntry(std::string_view key, const Json& value,
                                  std::string_view allowed) const
    {
        refuse(fmt::format("{}{}{}", place_, place_.empty() ? "" : ".", key),
               shortened(value.dump(-1, ' ', true)), allowed);
    }
    /// \throws std::invalid_argument if there are entries that nobody took.
    void requireAllTaken() const
    {
        for (const auto& [key, value] : json_.items()) {
            if (std::find(taken_.begin(), taken_.end(), key) == taken_.end()) {
                std::string allowed;
                for (const std::string& name : taken_) {
                    allowed += (allowed.empty() ? "" : ", ") + name;
                }
                refuseEntry(shortened(key), value, "no such entry; there are " + allowed);
            }
        }
    }

private:
    const Json& json_;
    std::string place_;
    std::vector<std::string> taken_;
};

AssemblyPart partOfJson(const Json& json, const std::string& place)
{
    Entries entries(json, place);
    const Json& kind = entries.take("kind");
    const std::string word = kind.is_string() ? kind.get<std::string>() : "";
    const auto known = valueIn(partNames, word);
    if (!known) {
        entries.refuseEntry("kind", kind, namesIn(partNames));
    }
    AssemblyPart part{.kind = *known};
    const std::string_view entry = answers::entryOf(*known);
    if (known == PartKind::cells) {
        part.cells = entries.whole("cells");
        part.impedance = entries.number("impedance", 1.0);
        part.speed = entries.number("speed", 1.0);
    } else if (!entry.empty()) {
        part.value = entries.number(entry);
    }
    entries.requireAllTaken();
    return part;
}

Assembly assemblyIn(const Json& json)
{
    // The answer of `scene` has it as an entry.
    Entries whole(json, "");
    const Json& inner = whole.take("scene");
    Entries entries(inner.is_null() ? json : inner, inner.is_null() ? "" : "scene");
    Assembly assembly{.length = entries.number("length", 1.0),
                      .waveSpeed = entries.number("wave_speed", 1.0),
                      .axialStiffness = entries.number("axial_stiffness", 1.0),
                      .gravity = entries.number("gravity", 0.0)};
    if (entries.has("young")) {
        assembly.young = entries.number("young");
    }
    (void)entries.take("young");
    const Json& parts = entries.take("parts");
    if (!parts.is_array() || parts.size() > maxParts) {
        entries.refuseEntry("parts", parts, fmt::format("a list of at most {} parts", maxParts));
    }
    entries.requireAllTaken();
    std::size_t number = 0;
    for (const Json& part : parts) {
        assembly.parts.push_back(partOfJson(part, fmt::format("parts[{}]", number++)));
    }
    return assembly;
}

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw FileError(path, "cannot read it");
    }
    std::string text;
    std::array<char, 65536> block{};
    while (text.size() <= mostBytes &&
           (file.read(block.data(), block.size()) || file.gcount() > 0)) {
        text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (text.size() > mostBytes) {
        throw FileError(path, fmt::format("longer than {} bytes", mostBytes));
    }
    return text;
}

}  // namespace

Assembly readAssembly(const std::string& text, const Bar& bar, double gravity)
{
    if (!text.ends_with(".json")) {
        return answers::assemblyIn(text, bar, gravity);
    }
    refuseIf(!(bar == Bar{}) || gravity != 0.0,
             "--scene FILE.json clashes with --length, --wave-speed, --axial-stiffness, --young, "
             "--density, --area, --gravity: the file gives them");
    Assembly assembly = assemblyOfJson(contentOf(text), text);
    validate(assembly);
    return assembly;
}

Assembly assemblyOfJson(std::string_view text, const std::string& name)
{
    const Json json = Json::parse(text, nullptr, false);
    refuseIf(json.is_discarded(), shortened(name), shortened(text),
             "JSON, as signorini scene --format json prints it");
    try {
        return assemblyIn(json);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("{}: {}", shortened(name), error.what()));
    }
}

Scene CommonOptions::scene() const
{
    if (!hasScene()) {
        return shortForms();
    }
    Assembly still = assembly();
    still.gravity = 0.0;
    const std::optional<Scene> bar = sceneText.empty() ? shortForms() : barOf(still);
    if (!bar) {
        throw std::invalid_argument(fmt::format(
            "--scene '{}': allowed for this question: one bar, clamped on the left, with stops at "
            "its tip, as in 'clamp 300 stop=1e-3'; of other scenes find, continuum, response, "
            "simulate, sweep and atlas know motions",
            shortened(sceneText)));
    }
    validate(*bar);
    refuseIf(weight() != 0.0 && !bar->segments.empty(),
             "--gravity: allowed of segments with find, continuum, response, simulate, sweep and "
             "atlas");
    return weight() != 0.0 ? aboutRest(*bar, weight()) : *bar;
}

void CommonOptions::requireOwnDamping() const
{
    refuseIf(!sceneText.empty() && dampingRatio,
             "--damping clashes with --scene: allowed dash=D among its words");
}

const Assembly& CommonOptions::assembly() const
{
    if (!assembly_ && sceneText.empty()) {
        assembly_ = assemblyOf(shortForms(), usualCells(), {dampingRatio.value_or(0.0)});
        assembly_->gravity = gravity;
        validate(*assembly_);
    } else if (!assembly_) {
        const Bar bar = answers::barAsked(*given_, false);
        refuseIf(cells || secondStop_ || !segments_.empty() || !piecesFile_.empty() ||
                     bar.gap != Bar{}.gap,
                 "--scene clashes with --cells, --gap, --second-stop, --segments, --segments-file: "
                 "allowed one of them");
        assembly_ = readAssembly(sceneText, bar, gravity);
    }
    return *assembly_;
}

}  // namespace signorini::cli
