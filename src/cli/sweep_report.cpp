#include "reports.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "mapped.hpp"
#include "printing.hpp"

namespace signorini::cli {

namespace {

using answers::SweepPointOf;

const char* unitName(const SweepAnswer& answer)
{
    const Swept over = answer.range.over;
    return over == Swept::frequency ? "ω₁"
           : over == Swept::damping ? "(ratio)"
                                    : answers::unitName(over, answer.range.place);
}

/// "1.02 ω₁ (431.2 Hz)", "3 N", "ζ = 0.02".
std::string valueText(const SweepAnswer& answer, double value)
{
    const double given = value * answers::unitOf(answer.range.over, answer.range.place, answer.bar);
    return fmt::format("{:.5g} {}", given, unitName(answer)) +
           (answer.range.over == Swept::frequency
                ? fmt::format(" ({:.6g} Hz)", value / 4.0 / scales(answer.bar).time)
                : "");
}

/// "0.98 ω₁ (490 Hz) … 1.1 ω₁ (550 Hz)" of neighbours, ascending, and how many further bands.
std::string bandsOf(const SweepAnswer& answer, const std::vector<bool>& holds)
{
    const std::vector<double> values = valuesOf(answer.range);
    return bandsText(
        holds.size(), [&](std::size_t k) { return holds[k]; },
        [&](std::size_t first, std::size_t last) {
            return valueText(answer, values[first]) +
                   (last > first ? " … " + valueText(answer, values[last]) : "");
        });
}

/// At which values a point of a direction is like that.
std::vector<bool> where(const SweepAnswer& answer, SweepDirection direction,
                        const std::function<bool(const SweepPoint&)>& isIt)
{
    const std::vector<double> values = valuesOf(answer.range);
    std::vector<bool> holds(values.size());
    for (const SweepPoint& point : answer.points) {
        if (point.direction == direction && isIt(point)) {
            const auto at = std::lower_bound(values.begin(), values.end(), point.value);
            holds[static_cast<std::size_t>(at - values.begin())] = true;
        }
    }
    return holds;
}

/// What a point is counted as: periods and contacts in them; 0 periods where it does not repeat.
std::pair<std::int64_t, std::int64_t> kindOf(const SweepPoint& point)
{
    return point.settling.settled
               ? std::pair(point.settling.settled->periods, point.settling.settled->contacts)
               : std::pair(std::int64_t{0}, std::int64_t{0});
}

void addKinds(const SweepAnswer& answer, SweepDirection direction, Text& text)
{
    constexpr std::size_t most = 12;
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> kinds;
    for (const SweepPoint& point : answer.points) {
        kinds[kindOf(point)] += point.direction == direction ? 1 : 0;
    }
    std::erase_if(kinds, [](const auto& kind) { return kind.second == 0; });
    if (!kinds.empty()) {
        print(text, "{}\n", direction == SweepDirection::up ? "upward" : "downward");
    }
    std::size_t listed = 0;
    for (const auto& [kind, count] : kinds) {
        if (++listed > most) {
            print(text, "  and {} kinds more; see --csv\n", kinds.size() - most);
            break;
        }
        const auto [periods, contacts] = kind;
        const std::string what =
            periods == 0 ? "not seen to repeat itself"
            : contacts == 0
                ? "no contact"
                : fmt::format("{} contact{} in {}", contacts, contacts == 1 ? "" : "s",
                              periods == 1 ? "a period" : fmt::format("{} periods", periods));
        print(text, "  {:<26}{:>6}  {}\n", what, count,
              bandsOf(answer, where(answer, direction, [kind = kind](const SweepPoint& point) {
                          return kindOf(point) == kind;
                      })));
    }
}

/// Values at which the bar does one thing on the way up and another on the way down.
void addHysteresis(const SweepAnswer& answer, Text& text)
{
    constexpr double part = 0.01;
    std::map<double, std::vector<const SweepPoint*>> both;
    double largest = 0.0;
    for (const SweepPoint& point : answer.points) {
        both[point.value].push_back(&point);
        largest = std::max(largest, point.meanImpulse);
    }
    const auto differs = mapped(both, [largest](const auto& at) {
        const auto& points = at.second;
        return points.size() == 2 &&
               std::abs(points[0]->meanImpulse - points[1]->meanImpulse) > part * largest;
    });
    if (std::find(differs.begin(), differs.end(), true) != differs.end()) {
        print(text, "hysteresis  {}: impulses up and down differ\n", bandsOf(answer, differs));
    }
}

void addWorst(const SweepAnswer& answer, Text& text)
{
    const auto worst = [&answer](const std::function<double(const SweepPoint&)>& size) {
        return *std::max_element(answer.points.begin(), answer.points.end(),
                                 [&](const SweepPoint& one, const SweepPoint& other) {
                                     return size(one) < size(other);
                                 });
    };
    const auto line = [&](const char* label, const SweepPoint& point, double value,
                          const char* unit, const std::string& remark = {}) {
        print(text, "{:<12}at most {:.6g} {} at {}, {}{}\n", label, value, unit,
              valueText(answer, point.value), name(point.direction), remark);
    };
    const SweepPoint force = worst([](const SweepPoint& p) { return p.meanForce; });
    line("force", force, force.meanForce * answers::forceUnit(answer.bar),
         "N, averaged over the resolution,");
    const SweepPoint impulse = worst([](const SweepPoint& p) { return p.impulse[1]; });
    line("impulse", impulse, impulse.impulse[1] * answers::impulseUnit(answer.bar),
         "N s per period");
    const SweepPoint strain = worst([](const SweepPoint& p) { return p.strain; });
    const double most = strain.strain * scales(answer.bar).strain;
    if (!answer.bar.young) {
        line("strain", strain, most, "[-]");
        return;
    }
    const double stress = most * *answer.bar.young;
    line("stress", strain, stress, "Pa", yieldText(stress, answer.yieldStress, "at these values"));
}

}  // namespace

std::string asText(const SweepAnswer& answer)
{
    Text text;
    const SweepRange& range = answer.range;
    print(text, "{:<12}{}, {} … {}, {}\n", answer.isComplete ? "sweep" : "interrupted",
          name(range.over), valueText(answer, range.least), valueText(answer, range.most),
          range.isCarried ? "the state carried over" : "from rest at each value");
    print(text, "driven      {}", range.place == Excited::tip ? "tip, by a force" : "base, moving");
    if (range.over != Swept::amplitude) {
        print(text, ", amplitude {:.6g} {}",
              range.amplitude * amplitudeUnit(range.place, answer.bar, range.derivative),
              amplitudeUnitName(range.place, range.derivative));
    }
    if (range.over != Swept::frequency) {
        print(text, ", {:.6g} ω₁ ({:.6g} Hz)", range.frequencyRatio,
              range.frequencyRatio / 4.0 / scales(answer.bar).time);
    }
    print(text, "; N = {:.6g}\n", range.cells);
    addKinds(answer, SweepDirection::up, text);
    addKinds(answer, SweepDirection::down, text);
    addHysteresis(answer, text);
    if (!answer.points.empty()) {
        addWorst(answer, text);
    }
    return fmt::to_string(text);
}

void writeSweepCsv(const std::string& path, const SweepAnswer& answer)
{
    constexpr std::string_view header =
        "value,frequency,direction,periods,residual,watched,contacts,contacts_least,"
        "contacts_most,impulse,impulse_least,impulse_most,mean_force,tip_lowest,tip_highest,"
        "peak_strain,peak_stress";
    const Scales unit = scales(answer.bar);
    const double impulse = answers::impulseUnit(answer.bar);
    writeCsv(path, header, [&](CsvRows& row) {
        for (const SweepPointOf& at : answer.listed()) {
            const SweepPoint& p = at.value;
            const std::optional<Settled>& settled = p.settling.settled;
            row(at.given(), p.frequencyRatio / 4.0 / unit.time, p.direction,
                settled ? std::optional(settled->periods) : std::nullopt,
                settled ? std::optional(settled->residual) : std::nullopt, p.watched,
                p.meanContacts, p.contacts[0], p.contacts[1], p.meanImpulse * impulse,
                p.impulse[0] * impulse, p.impulse[1] * impulse,
                p.meanForce * answers::forceUnit(answer.bar), p.tip[0] * unit.displacement,
                p.tip[1] * unit.displacement, p.strain * unit.strain, at.stress());
        }
    });
}

}  // namespace signorini::cli
