#include "reports.hpp"

#include <fmt/format.h>

#include <cmath>

#include "atlas_coverage.hpp"
#include "printing.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

using answers::AtlasEntryOf;
using answers::AtlasFamilyOf;
using answers::AtlasUnits;
using answers::TwinsOf;

constexpr std::size_t shownRows = 20;

/// " T = 3.5  ω/ω₁ = 1.14286 (0.285714 Hz)  ".
std::string periodText(double period, double frequencyRatio, const AtlasUnits& unit)
{
    const std::string ratio = std::isfinite(unit.frequency)
                                  ? fmt::format("ω/ω₁ = {:<9.6g} ", frequencyRatio * unit.frequency)
                                  : "";
    return fmt::format("T = {:<10.6g} {}({:.6g} Hz)  ", period, ratio, 1.0 / (period * unit.time));
}

std::string energyText(const EnergyRange& energy, const AtlasUnits& unit)
{
    if (!unit.isRatio) {
        return fmt::format("E = {:.8g} J … unbounded or unknown", energy.least);
    }
    if (energy.least == energy.most) {
        return fmt::format("E/E₁ = {:.8g} ({:.6g} J)", energy.least, energy.least * unit.energy);
    }
    if (!std::isfinite(energy.most)) {
        return fmt::format("E/E₁ = {:.8g} … unbounded or unknown (from {:.6g} J)", energy.least,
                           energy.least * unit.energy);
    }
    return fmt::format("E/E₁ = {:.8g} … {:.8g} on this grid ({:.6g} … {:.6g} J)", energy.least,
                       energy.most, energy.least * unit.energy, energy.most * unit.energy);
}

/// "N = 300, (4, 7, 1)".
std::string nameOf(const AtlasFamily& all)
{
    return fmt::format("N = {}, {}", all.cells,
                       all.family ? fmt::format("({}, {}, {})", all.family->order,
                                                all.family->blocks, all.family->contactBlocks)
                                  : "grazing");
}

std::string asText(const AtlasFamilyOf& of, const AtlasUnits& unit)
{
    const AtlasFamily& all = of.value;
    std::string text = fmt::format("{:<24} {}{}, {} of dimension {}", nameOf(all),
                                   periodText(period(all), frequencyRatio(all), unit),
                                   energyText(all.energy, unit), name(all.kind), all.dimension);
    if (of.section) {
        const std::optional<bool> isConnected = of.section->isConnected;
        text += fmt::format(", {} at that energy{}", of.section->dimension,
                            isConnected ? (*isConnected ? ", connected" : ", not connected") : "");
    }
    return text + fmt::format("; {} schedule{}, top ({}, {})\n", all.schedules,
                              all.schedules == 1 ? "" : "s", all.top.contact, all.top.free);
}

std::string nameOf(const AtlasEntry& entry)
{
    return entry.isOfBars ? textOf(spansOf(entry.schedule)) : describe(entry.schedule);
}

std::string asText(const AtlasEntry& entry, const AtlasUnits& unit)
{
    const AtlasRow& row = entry.row;
    const std::string text = fmt::format("{:<34} {}", nameOf(entry),
                                         periodText(period(entry), frequencyRatio(entry), unit));
    if (row.status != Status::found) {
        return text + fmt::format("{}{}\n", name(row.status),
                                  row.reason ? fmt::format(", {}", name(*row.reason)) : "");
    }
    const std::string set =
        row.dimension < 0 ? "" : fmt::format(", {} of dimension {}", name(row.kind), row.dimension);
    return text + fmt::format("{}, {}{}{}\n", energyText(row.energy, unit), name(row.contact), set,
                              row.isCanonical ? ", canonical" : "");
}

std::string asText(const Twins& twins, const AtlasUnits& unit)
{
    const double time = period(twins);
    const double energy = energyRatio(twins);
    std::string text = fmt::format(
        "T = {:.6g} ({:.6g} Hz), {}:", time, 1.0 / (time * unit.time),
        unit.isRatio ? fmt::format("E/E₁ = {:.8g} ({:.6g} J)", energy, energy * unit.energy)
                     : fmt::format("E = {:.8g} J", energy));
    for (const AtlasFamily& all : twins.families) {
        text += fmt::format("  {}", nameOf(all));
    }
    for (const AtlasEntry& entry : twins.schedules) {
        text += fmt::format("  {}", nameOf(entry));
    }
    return text + "\n";
}

/// How many there are, and the first of them.
template <typename Row, typename Print>
std::string listed(const std::vector<Row>& rows, std::string_view one, std::string_view many,
                   Print print)
{
    std::string text = fmt::format("{} {}\n", rows.size(), rows.size() == 1 ? one : many);
    for (std::size_t k = 0; k < rows.size() && k < shownRows; ++k) {
        text += print(rows[k]);
    }
    if (rows.size() > shownRows) {
        text += fmt::format("… {} more; --format json lists all\n", rows.size() - shownRows);
    }
    return text;
}

std::string fieldOf(const Schedule& schedule)
{
    std::string words;
    for (const Phase& phase : schedule.phases) {
        words += fmt::format("{}{} {}", words.empty() ? "" : " ", phase.contact, phase.free);
    }
    return words;
}

/// What a field of a table says: a schedule in the words that `find` takes.
template <typename Value>
std::string fieldOf(const Value& value)
{
    if constexpr (std::is_enum_v<Value>) {
        return std::string(name(value));
    } else if constexpr (std::is_same_v<Value, bool>) {
        return value ? "1" : "0";
    } else if constexpr (std::is_arithmetic_v<Value>) {
        return fmt::format("{}", value);
    } else {
        return textOf(value);
    }
}

/// Collects the keys of a described record as columns: of a range of energies its least and most.
/// What is not known is empty.
template <typename T>
struct Columns {
    const T& value;
    std::string names = {};
    std::string fields = {};

    explicit Columns(const T& row) : value(row)
    {
        describe(*this, answers::Type<T>());
        names.pop_back();  // the last comma
        fields.pop_back();
    }

    static void record(const char*, const char*) {}
    template <typename Get>
    void key(const char* name, const char*, const char*, Get get,
             answers::When /*when*/ = answers::When::always)
    {
        const auto& got = std::invoke(get, value);
        add(name, &got);
    }

private:
    template <typename Value>
    void add(const std::string& name, const Value* got)
    {
        if constexpr (answers::isA<Value, std::optional>) {
            add(name, got != nullptr && *got ? &**got : nullptr);
        } else if constexpr (std::is_same_v<Value, EnergyRange>) {
            const std::string stem = name.substr(0, name.find("_range"));
            const auto ends = got != nullptr
                                  ? answers::listed(*got)
                                  : std::tuple(std::optional<double>(), std::optional<double>());
            add(stem + "_min", &std::get<0>(ends));
            add(stem + "_max", &std::get<1>(ends));
        } else {
            names += name + ",";
            fields += (got != nullptr ? fieldOf(*got) : "") + ",";
        }
    }
};

}  // namespace

std::string asText(const AtlasAnswer& answer)
{
    const AtlasUnits& unit = answer.units;
    std::string text;
    if (answer.twins) {
        text = listed(*answer.twins, "group of different orbits of equal T and E",
                      "groups of different orbits of equal T and E",
                      [&unit](const TwinsOf& twins) { return asText(twins.value, unit); });
    } else {
        text = listed(*answer.families, "family", "families",
                      [&unit](const AtlasFamilyOf& all) { return asText(all, unit); });
        if (!answer.schedules->empty()) {
            text += listed(*answer.schedules, "schedule", "schedules",
                           [&unit](const AtlasEntryOf& of) { return asText(of.value, unit); });
        }
    }
    for (const AtlasRun& run : answer.runs) {
        text += fmt::format("decided: {}{}\n", describe(run.range),
                            run.isFinished() ? "" : ", not finished");
    }
    return text;
}

std::string asText(const AtlasBuilt& built)
{
    const AtlasRun& run = built.run;
    const AtlasTally& tally = run.tally;
    return fmt::format(
        "{:<12}{}: {}\n"
        "decided     {} schedules in {:.3g} s\n"
        "found       {}: {} pressing, {} grazing{}\n"
        "none        {}{}\n",
        name(built.status()), onOneLine(built.database), describe(run.range), tally.decided,
        run.seconds, tally.pressing + tally.grazing, tally.pressing, tally.grazing,
        run.range.bars ? "" : fmt::format("; {} families on this grid", tally.families),
        tally.refuted, tally.undecided > 0 ? fmt::format("\nundecided   {}", tally.undecided) : "");
}

void writeAtlasCsv(const std::string& path, const AtlasDatabase& atlas,
                   std::optional<std::int64_t> cells, const Bar& bar)
{
    constexpr std::string_view header =
        "cells,order,nu,contact_blocks,contact,contact_steps,free_steps,period_ratio,"
        "frequency_ratio,period,frequency,kind,dimension,energy_ratio_min,energy_ratio_max,"
        "energy_min,energy_max,schedules";
    const Scales unit = scales(bar);
    writeCsv(path, header, [&](CsvRows& row) {
        atlas.forEachFamily(cells, [&](const AtlasFamily& all) {
            const double time = period(all) * unit.time;
            row(all.cells,
                all.family ? fmt::format("{},{},{}", all.family->order, all.family->blocks,
                                         all.family->contactBlocks)
                           : ",,",
                all.contact(), all.top.contact, all.top.free, period(all), frequencyRatio(all),
                time, 1.0 / time, all.kind, all.dimension, all.energy.least, all.energy.most,
                all.energy.least * unit.energy, all.energy.most * unit.energy, all.schedules);
        });
    });
}

void writeSchedulesCsv(
    const std::string& path, const AtlasUnits& units,
    const std::function<void(const std::function<void(const AtlasEntry&)>&)>& forEach)
{
    writeCsv(path, Columns<AtlasEntryOf>({}).names, [&](CsvRows& row) {
        forEach([&](const AtlasEntry& entry) {
            row(Columns<AtlasEntryOf>({entry, units}).fields);
        });
    });
}

}  // namespace signorini::cli
