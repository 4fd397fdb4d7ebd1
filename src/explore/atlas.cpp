#include "signorini/atlas.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact_spans.hpp"
#include "faults.hpp"
#include "network_find.hpp"
#include "segments_text.hpp"
#include "stepped_bar.hpp"
#include "text.hpp"

namespace signorini {

namespace {

/// A phase is one of so many: n_c, n_f, and the contact.
std::int64_t choicesOf(const AtlasRange& range)
{
    return range.maxContact * range.maxFree * contactsOf(range);
}

/// What a range must not have where programs decide. `of`: "for ...".
void requirePlain(const AtlasRange& range, const char* of, Faults& faults)
{
    if (range.familiesOnly) {
        faults.add("families only", true, fmt::format("false {}", of));
    }
    if (range.secondStop) {
        faults.add("second stop", range.secondStop->value(), fmt::format("none {}", of));
    }
    const std::int64_t most = maxNetworkSteps / maxAtlasPhases;
    if (range.maxContact + range.maxFree > most) {
        faults.add("max contact + max free", range.maxContact + range.maxFree,
                   fmt::format("at most {} {}", most, of));
    }
}

void requireBars(const AtlasRange& range, Faults& faults)
{
    constexpr const char* of = "for bars in a row";
    validate(*range.bars);
    const Network network = networkOf(*range.bars);
    if (range.cells != network.cells()) {
        faults.add("cells", range.cells, fmt::format("{}, of all bars", network.cells()));
    }
    if (!range.segments.empty() || range.gapSign != 1) {
        faults.add("segments, gap sign", range.gapSign, fmt::format("none, 1 {}", of));
    }
    if (std::isfinite(range.maxEnergyRatio) && !firstEnergy(network)) {
        faults.add("max energy ratio", range.maxEnergyRatio,
                   "none where no energy E₁ is needed to reach contact 1");
    }
    requirePlain(range, of, faults);
}

/// pairs + pairs^2 + ... + pairs^phases, if that is at most 2^62.
std::optional<std::int64_t> countNumbers(const AtlasRange& range)
{
    constexpr std::int64_t limit = maxSteps;
    if (range.maxContact > limit / contactsOf(range) / range.maxFree) {
        return std::nullopt;
    }
    const std::int64_t phases = range.maxPhases;
    const std::int64_t pairs = choicesOf(range);
    std::int64_t power = 1;
    std::int64_t sum = 0;
    for (std::int64_t k = 0; k < phases; ++k) {
        if (power > limit / pairs || sum > limit - power * pairs) {
            return std::nullopt;
        }
        power *= pairs;
        sum += power;
    }
    return sum;
}

}  // namespace

AtlasRange usualRange(std::int64_t cells)
{
    if (cells < 1 || cells > maxCells) {
        throwFault("cells", cells, fmt::format("1..{}", maxCells));
    }
    AtlasRange range;
    range.cells = cells;
    range.maxContact = 2 * cells;
    range.maxFree = 4 * cells;
    return range;
}

Stops stopsOf(const AtlasRange& range)
{
    return {range.gapSign, range.secondStop};
}

std::int64_t contactsOf(const AtlasRange& range)
{
    if (!range.bars) {
        return range.secondStop ? 2 : 1;
    }
    return std::max<std::int64_t>(
        1, std::count_if(
               range.bars->parts.begin(), range.bars->parts.end(), [](const AssemblyPart& part) {
                   return part.kind == PartKind::gap || part.kind == PartKind::rightStop ||
                          part.kind == PartKind::leftStop;
               }));
}

std::string sceneText(const AtlasRange& range)
{
    if (!range.bars) {
        return textOf(range.segments);
    }
    const Assembly& bars = *range.bars;
    return fmt::format("{}; {} {} {} {} {}", textOf(bars.parts), bars.length, bars.waveSpeed,
                       bars.axialStiffness, bars.gravity, bars.young.value_or(0.0));
}

void readScene(AtlasRange& range, std::string_view text)
{
    const std::size_t end = text.find(';');
    if (end == std::string_view::npos) {
        range.segments = segmentsOf(text);
        return;
    }
    Assembly bars{.parts = partsOf(text.substr(0, end))};
    const std::string ended = std::string(text.substr(end + 1)) + ' ';
    std::string_view scales = ended;
    scales.remove_prefix(1);
    double young = 0.0;
    for (double* value :
         {&bars.length, &bars.waveSpeed, &bars.axialStiffness, &bars.gravity, &young}) {
        if (!takeNumberBefore(scales, ' ', *value)) {
            throw std::invalid_argument(
                fmt::format("scene = {}: allowed what sceneText writes", text));
        }
    }
    if (!scales.empty() || young < 0.0) {
        throw std::invalid_argument(fmt::format("scene = {}: allowed what sceneText writes", text));
    }
    bars.young = young > 0.0 ? std::optional(young) : std::nullopt;
    range.bars = std::move(bars);
}

void validate(const AtlasRange& range)
{
    Faults faults;
    const auto check = [&faults](const char* field, std::int64_t value, std::int64_t most) {
        if (value < 1 || value > most) {
            faults.add(field, value, fmt::format("1..{}", most));
        }
    };
    check("cells", range.cells, maxCells);
    check("max contact", range.maxContact, maxSteps / (2 * maxAtlasPhases));
    check("max free", range.maxFree, maxSteps / (2 * maxAtlasPhases));
    check("phases", range.maxPhases, maxAtlasPhases);
    if (range.gapSign < -1 || range.gapSign > 1) {
        faults.add("gap sign", range.gapSign, "-1..1");
    }
    if (!range.segments.empty()) {
        requireCells(steppedBar(range.segments), range.cells);
        if (range.gapSign == 0) {
            faults.add("gap sign", 0, "-1, 1 for a bar of several segments");
        }
        requirePlain(range, "for a bar of several segments", faults);
    }
    if (range.bars) {
        requireBars(range, faults);
    }
    if (!(range.maxEnergyRatio > 0.0)) {
        faults.add("max energy ratio", range.maxEnergyRatio, "numbers > 0 [E_1]");
    }
    faults.throwIfAny();
    validate(Schedule{range.cells, {{1, 1}}, stopsOf(range)});
    if (!countNumbers(range)) {
        faults.add("the number of schedules", "more than 2^62", "at most 2^62");
    }
    if (range.familiesOnly && range.maxPhases != 1) {
        faults.add("phases", range.maxPhases, "1 where families alone are kept");
    }
    if (range.familiesOnly && range.keepsRefuted) {
        faults.add("families only", true, "false where refuted schedules are kept");
    }
    faults.throwIfAny();
}

std::string textOf(const AtlasRange& range)
{
    const Fraction second = range.secondStop.value_or(Fraction{0, 1});  // 0: there is none
    return fmt::format("{} {} {} {} {} {} {} {} {} {} {}", range.cells, range.maxContact,
                       range.maxFree, range.maxPhases, range.maxEnergyRatio,
                       range.keepsRefuted ? 1 : 0, range.familiesOnly ? 1 : 0, range.gapSign,
                       second.numerator, second.denominator, sceneText(range));
}

AtlasRange rangeOf(std::string_view text)
{
    AtlasRange range;
    std::string_view rest = text;
    const auto take = [&](auto& value) {
        if (!takeNumberBefore(rest, ' ', value)) {
            throw std::invalid_argument(
                fmt::format("range = {}: allowed what textOf writes", text));
        }
    };
    int keepsRefuted = 0;
    int familiesOnly = 0;
    take(range.cells);
    take(range.maxContact);
    take(range.maxFree);
    take(range.maxPhases);
    take(range.maxEnergyRatio);
    take(keepsRefuted);
    take(familiesOnly);
    take(range.gapSign);
    Fraction second{};
    take(second.numerator);
    take(second.denominator);
    if (second.numerator != 0) {
        range.secondStop = second;
    }
    range.keepsRefuted = keepsRefuted != 0;
    range.familiesOnly = familiesOnly != 0;
    readScene(range, rest);
    return range;
}

double period(const AtlasFamily& family)
{
    return static_cast<double>(family.steps) / static_cast<double>(family.cells);
}

double frequencyRatio(const AtlasFamily& family)
{
    return 4.0 * static_cast<double>(family.cells) / static_cast<double>(family.steps);
}

double period(const AtlasEntry& entry)
{
    return static_cast<double>(entry.row.steps) / static_cast<double>(entry.schedule.cells);
}

double frequencyRatio(const AtlasEntry& entry)
{
    return 4.0 * static_cast<double>(entry.schedule.cells) / static_cast<double>(entry.row.steps);
}

AtlasTally& AtlasTally::operator+=(const AtlasTally& other)
{
    decided += other.decided;
    pressing += other.pressing;
    grazing += other.grazing;
    refuted += other.refuted;
    undecided += other.undecided;
    families += other.families;
    return *this;
}

std::int64_t numbersOf(const AtlasRange& range)
{
    return countNumbers(range).value();
}

std::vector<Phase> phasesAt(const AtlasRange& range, std::int64_t number)
{
    const std::int64_t pairs = range.maxContact * range.maxFree;
    const std::int64_t choices = choicesOf(range);
    std::size_t count = 1;
    for (std::int64_t power = choices; number >= power; power *= choices) {
        number -= power;
        ++count;
    }
    std::vector<Phase> phases(count);
    for (std::size_t k = count; k-- > 0; number /= choices) {
        const std::int64_t pair = number % choices % pairs;
        phases[k] = {pair / range.maxFree + 1, pair % range.maxFree + 1,
                     static_cast<Stop>(number % choices / pairs)};
    }
    return phases;
}

}  // namespace signorini
