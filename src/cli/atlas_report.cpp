#include "atlas_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "family_section.hpp"
#include "json.hpp"
#include "signorini/output.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t shownRows = 20;

/// null where there is no bound.
Json bound(double value)
{
    return std::isfinite(value) ? Json(value) : Json();
}

/// Of motions that repeat after this time.
void putPeriod(Json& json, double period, double frequencyRatio, const Scales& unit)
{
    json["period"] = period * unit.time;
    json["period_ratio"] = period;
    json["frequency"] = 1.0 / (period * unit.time);
    json["frequency_ratio"] = frequencyRatio;
}

void putEnergy(Json& json, const EnergyRange& energy, const Scales& unit)
{
    json["energy_range"] = {energy.least * unit.energy, bound(energy.most * unit.energy)};
    json["energy_ratio_range"] = {energy.least, bound(energy.most)};
}

Json asJson(const AtlasFamily& all, const std::optional<AtlasPoint>& point, const Scales& unit)
{
    Json json{
        {"id", all.id},  {"cells", all.cells},        {"order", nullptr},
        {"nu", nullptr}, {"contact_blocks", nullptr}, {"schedule", jsonOf(std::vector{all.top})}};
    if (all.family) {
        json["order"] = all.family->order;
        json["nu"] = all.family->blocks;
        json["contact_blocks"] = all.family->contactBlocks;
    }
    putPeriod(json, period(all), frequencyRatio(all), unit);
    json["contact"] = name(all.contact());
    json["kind"] = name(all.kind);
    json["dimension"] = all.dimension;
    putEnergy(json, all.energy, unit);
    json["schedules"] = all.schedules;
    if (point) {
        const FamilySection section = sectionOf(all, point->energyRatio);
        json["dimension_at_energy"] = section.dimension;
        json["connected_at_energy"] = section.isConnected ? Json(*section.isConnected) : Json();
    }
    return json;
}

Json asJson(const AtlasEntry& entry, const Scales& unit)
{
    const AtlasRow& row = entry.row;
    Json json{{"cells", entry.schedule.cells},
              {"schedule", jsonOf(entry.schedule.phases)},
              {"family", entry.family ? Json(*entry.family) : Json()}};
    putPeriod(json, period(entry), frequencyRatio(entry), unit);
    json["status"] = name(row.status);
    json["reason"] = row.reason ? Json(name(*row.reason)) : Json();
    json["kernel_dimension"] = row.kernelDimension >= 0 ? Json(row.kernelDimension) : Json();
    if (row.status == Status::found) {
        json["kind"] = name(row.kind);
        json["dimension"] = row.dimension;
        json["contact"] = name(row.contact);
        json["canonical"] = row.isCanonical;
        putEnergy(json, row.energy, unit);
    }
    return json;
}

/// " T = 3.5  ω/ω₁ = 1.14286 (0.285714 Hz)  ".
std::string periodText(double period, double frequencyRatio, const Scales& unit)
{
    return fmt::format("T = {:<10.6g} ω/ω₁ = {:<9.6g} ({:.6g} Hz)  ", period, frequencyRatio,
                       1.0 / (period * unit.time));
}

std::string energyText(const EnergyRange& energy, const Scales& unit)
{
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

std::string asText(const AtlasFamily& all, const std::optional<AtlasPoint>& point,
                   const Scales& unit)
{
    std::string text = fmt::format("{:<24} {}{}, {} of dimension {}", nameOf(all),
                                   periodText(period(all), frequencyRatio(all), unit),
                                   energyText(all.energy, unit), name(all.kind), all.dimension);
    if (point) {
        const FamilySection section = sectionOf(all, point->energyRatio);
        text += fmt::format(
            ", {} at that energy{}", section.dimension,
            section.isConnected ? (*section.isConnected ? ", connected" : ", not connected") : "");
    }
    return text + fmt::format("; {} schedule{}, top ({}, {})\n", all.schedules,
                              all.schedules == 1 ? "" : "s", all.top.contact, all.top.free);
}

std::string asText(const AtlasEntry& entry, const Scales& unit)
{
    const AtlasRow& row = entry.row;
    const std::string text = fmt::format("{:<34} {}", describe(entry.schedule),
                                         periodText(period(entry), frequencyRatio(entry), unit));
    if (row.status != Status::found) {
        return text + fmt::format("{}{}\n", name(row.status),
                                  row.reason ? fmt::format(", {}", name(*row.reason)) : "");
    }
    return text + fmt::format("{}, {}, {} of dimension {}{}\n", energyText(row.energy, unit),
                              name(row.contact), name(row.kind), row.dimension,
                              row.isCanonical ? ", canonical" : "");
}

std::string asText(const Twins& twins, const Scales& unit)
{
    const bool isFamily = !twins.families.empty();
    const double time = isFamily ? period(twins.families[0]) : period(twins.schedules[0]);
    const double energy =
        isFamily ? twins.families[0].energy.least : twins.schedules[0].row.energy.least;
    std::string text = fmt::format("T = {:.6g} ({:.6g} Hz), E/E₁ = {:.8g} ({:.6g} J):", time,
                                   1.0 / (time * unit.time), energy, energy * unit.energy);
    for (const AtlasFamily& all : twins.families) {
        text += fmt::format("  {}", nameOf(all));
    }
    for (const AtlasEntry& entry : twins.schedules) {
        text += fmt::format("  {}", describe(entry.schedule));
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

template <typename Rows, typename Print>
Json listOf(const Rows& rows, Print print)
{
    Json list = Json::array();
    for (const auto& row : rows) {
        list.push_back(print(row));
    }
    return list;
}

Json asJson(const Twins& twins, const Scales& unit)
{
    const bool isFamily = !twins.families.empty();
    const double energy =
        isFamily ? twins.families[0].energy.least : twins.schedules[0].row.energy.least;
    Json json;
    if (isFamily) {
        putPeriod(json, period(twins.families[0]), frequencyRatio(twins.families[0]), unit);
    } else {
        putPeriod(json, period(twins.schedules[0]), frequencyRatio(twins.schedules[0]), unit);
    }
    json["energy"] = energy * unit.energy;
    json["energy_ratio"] = energy;
    json["families"] =
        listOf(twins.families, [&unit](const AtlasFamily& all) { return asJson(all, {}, unit); });
    json["schedules"] =
        listOf(twins.schedules, [&unit](const AtlasEntry& entry) { return asJson(entry, unit); });
    return json;
}

Json asJson(const AtlasRun& run)
{
    return {{"cells", run.range.cells},
            {"max_contact", run.range.maxContact},
            {"max_free", run.range.maxFree},
            {"phases", run.range.maxPhases},
            {"max_energy_ratio", bound(run.range.maxEnergyRatio)},
            {"families_only", run.range.familiesOnly},
            {"finished", run.isFinished()}};
}

}  // namespace

std::string asText(const AtlasAnswer& answer)
{
    const Scales unit = scales(answer.bar);
    std::string text;
    if (answer.isTwins) {
        text = listed(answer.groups, "group of different orbits of equal T and E",
                      "groups of different orbits of equal T and E",
                      [&unit](const Twins& twins) { return asText(twins, unit); });
    } else {
        text = listed(answer.families, "family", "families",
                      [&](const AtlasFamily& all) { return asText(all, answer.point, unit); });
        if (!answer.schedules.empty()) {
            text += listed(answer.schedules, "schedule", "schedules",
                           [&unit](const AtlasEntry& entry) { return asText(entry, unit); });
        }
    }
    for (const AtlasRun& run : answer.coverage.runs()) {
        text += fmt::format("decided: {}{}\n", describe(run.range),
                            run.isFinished() ? "" : ", not finished");
    }
    return text;
}

std::string asJson(const AtlasAnswer& answer)
{
    const Scales unit = scales(answer.bar);
    Json json = newAnswer();
    json["bar"] = jsonOf(answer.bar);
    if (answer.point) {
        json["near"] = {{"frequency", answer.point->frequencyRatio / (4.0 * unit.time)},
                        {"frequency_ratio", answer.point->frequencyRatio},
                        {"energy", answer.point->energyRatio * unit.energy},
                        {"energy_ratio", answer.point->energyRatio},
                        {"within", answer.point->distance}};
    }
    if (answer.isTwins) {
        json["twins"] =
            listOf(answer.groups, [&unit](const Twins& twins) { return asJson(twins, unit); });
    } else {
        json["families"] = listOf(answer.families, [&](const AtlasFamily& all) {
            return asJson(all, answer.point, unit);
        });
        json["schedules"] = listOf(
            answer.schedules, [&unit](const AtlasEntry& entry) { return asJson(entry, unit); });
    }
    json["complete"] = answer.coverage.gaps().empty();
    json["ranges"] =
        listOf(answer.coverage.runs(), [](const AtlasRun& run) { return asJson(run); });
    return asLine(json);
}

std::string asText(const AtlasRun& run, const std::string& database)
{
    const AtlasTally& tally = run.tally;
    return fmt::format(
        "{:<12}{}: {}\n"
        "decided     {} schedules in {:.3g} s\n"
        "found       {}: {} pressing, {} grazing; {} families on this grid\n"
        "none        {}{}\n",
        run.isFinished() ? "done" : "interrupted", onOneLine(database), describe(run.range),
        tally.decided, run.seconds, tally.pressing + tally.grazing, tally.pressing, tally.grazing,
        tally.families, tally.refuted,
        tally.undecided > 0 ? fmt::format("\nundecided   {}", tally.undecided) : "");
}

std::string asJson(const AtlasRun& run, const std::string& database, const Scene& scene)
{
    const AtlasTally& tally = run.tally;
    Json json = newAnswer();
    json.update(Json{{"status", run.isFinished() ? "done" : "interrupted"},
                     {"database", database},
                     {"cells", run.range.cells},
                     {"max_contact", run.range.maxContact},
                     {"max_free", run.range.maxFree},
                     {"phases", run.range.maxPhases},
                     {"max_energy_ratio", bound(run.range.maxEnergyRatio)},
                     {"families_only", run.range.familiesOnly},
                     {"decided", tally.decided},
                     {"found", tally.pressing + tally.grazing},
                     {"pressing", tally.pressing},
                     {"grazing", tally.grazing},
                     {"family_count", tally.families},
                     {"refuted", tally.refuted},
                     {"undecided", tally.undecided},
                     {"batches", {run.nextBatch, run.batches}},
                     {"seconds", run.seconds}});
    json.update(jsonOf(scene));
    return asLine(json);
}

void writeAtlasCsv(const std::string& path, const AtlasDatabase& atlas,
                   std::optional<std::int64_t> cells, const Bar& bar)
{
    const Scales unit = scales(bar);
    TextFile file(path);
    file.write(
        "cells,order,nu,contact_blocks,contact,contact_steps,free_steps,period_ratio,"
        "frequency_ratio,period,frequency,kind,dimension,energy_ratio_min,energy_ratio_max,"
        "energy_min,energy_max,schedules\n");
    atlas.forEachFamily(cells, [&](const AtlasFamily& all) {
        const double time = period(all) * unit.time;
        file.write(fmt::format(
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", all.cells,
            all.family ? fmt::format("{},{},{}", all.family->order, all.family->blocks,
                                     all.family->contactBlocks)
                       : ",,",
            name(all.contact()), all.top.contact, all.top.free, period(all), frequencyRatio(all),
            time, 1.0 / time, name(all.kind), all.dimension, all.energy.least, all.energy.most,
            all.energy.least * unit.energy, all.energy.most * unit.energy, all.schedules));
    });
    file.close();
}

}  // namespace signorini::cli
