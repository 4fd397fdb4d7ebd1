#include "atlas_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "json.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t shownRows = 20;

Json asJson(const AtlasEntry& entry)
{
    const AtlasRow& row = entry.row;
    Json json{
        {"cells", entry.schedule.cells},    {"schedule", phasesAsJson(entry.schedule.phases)},
        {"period", period(entry.schedule)}, {"frequency_ratio", frequencyRatio(entry.schedule)},
        {"status", name(row.status)},       {"reason", nullptr}};
    if (row.reason) {
        json["reason"] = name(*row.reason);
    }
    json["kernel_dimension"] = row.kernelDimension >= 0 ? Json(row.kernelDimension) : Json();
    if (row.status == Status::found) {
        json["kind"] = name(row.kind);
        json["dimension"] = row.dimension;
        json["contact"] = name(row.contact);
        json["canonical"] = row.isCanonical;
        json["energy_ratio_range"] = {
            row.energy.least, std::isfinite(row.energy.most) ? Json(row.energy.most) : Json()};
    }
    return json;
}

std::string asText(const AtlasEntry& entry)
{
    const AtlasRow& row = entry.row;
    std::string text =
        fmt::format("{:<34} T = {:<10.6g} ω/ω₁ = {:<9.6g} ", describe(entry.schedule),
                    period(entry.schedule), frequencyRatio(entry.schedule));
    if (row.status != Status::found) {
        return text + fmt::format("{}{}\n", name(row.status),
                                  row.reason ? fmt::format(", {}", name(*row.reason)) : "");
    }
    text += row.kind == SetKind::point ? fmt::format("E/E₁ = {:.8g}", row.energy.least)
                                       : fmt::format("E/E₁ = {:.8g} … {}", row.energy.least,
                                                     std::isfinite(row.energy.most)
                                                         ? fmt::format("{:.8g}", row.energy.most)
                                                         : std::string("unbounded or unknown"));
    return text + fmt::format(", {}, {} of dimension {}{}\n", name(row.contact), name(row.kind),
                              row.dimension, row.isCanonical ? ", canonical" : "");
}

std::string asText(const std::vector<AtlasEntry>& entries)
{
    std::string text =
        fmt::format("{} schedule{}\n", entries.size(), entries.size() == 1 ? "" : "s");
    for (std::size_t k = 0; k < entries.size() && k < shownRows; ++k) {
        text += asText(entries[k]);
    }
    if (entries.size() > shownRows) {
        text += fmt::format("… {} more; --format json lists all\n", entries.size() - shownRows);
    }
    return text;
}

std::string asText(const std::vector<Twins>& all)
{
    std::string text = fmt::format("{} group{} of different motions of equal T and E\n", all.size(),
                                   all.size() == 1 ? "" : "s");
    for (std::size_t k = 0; k < all.size() && k < shownRows; ++k) {
        const AtlasEntry& first = all[k].front();
        text += fmt::format("T = {:.6g}, E/E₁ = {:.8g}:", period(first.schedule),
                            first.row.energy.least);
        for (const AtlasEntry& entry : all[k]) {
            text += fmt::format("  {}", describe(entry.schedule));
        }
        text += "\n";
    }
    if (all.size() > shownRows) {
        text += fmt::format("… {} more; --format json lists all\n", all.size() - shownRows);
    }
    return text;
}

Json asJson(const std::vector<AtlasEntry>& entries)
{
    Json list = Json::array();
    for (const AtlasEntry& entry : entries) {
        list.push_back(asJson(entry));
    }
    return list;
}

/// null where there is no bound.
Json bound(double value)
{
    return std::isfinite(value) ? Json(value) : Json();
}

std::string describe(const AtlasRange& range)
{
    return fmt::format(
        "N = {}, contact 1..{}, free 1..{}{}{}", range.cells, range.maxContact, range.maxFree,
        range.maxPhases > 1 ? fmt::format(", 1..{} phases", range.maxPhases) : "",
        std::isfinite(range.maxEnergyRatio) ? fmt::format(", E <= {} E₁", range.maxEnergyRatio)
                                            : "");
}

}  // namespace

std::string gapsOf(const AtlasAnswer& answer, std::optional<double> energyRatio)
{
    if (answer.coverage.empty()) {
        return "the database has decided nothing of this: no answer";
    }
    for (const AtlasRun& run : answer.coverage) {
        if (!run.isFinished()) {
            return fmt::format("{} of {} batches of {} are decided: the answer may lack schedules",
                               run.nextBatch, run.batches, describe(run.range));
        }
        if (run.range.maxEnergyRatio < energyRatio.value_or(INFINITY)) {
            return fmt::format("of {} only schedules with motions up to that energy were kept",
                               describe(run.range));
        }
    }
    return {};
}

std::string asText(const AtlasAnswer& answer)
{
    std::string text = answer.isTwins ? asText(answer.groups) : asText(answer.entries);
    for (const AtlasRun& run : answer.coverage) {
        text += fmt::format("decided: {}{}\n", describe(run.range),
                            run.isFinished() ? "" : ", not finished");
    }
    return text;
}

std::string asJson(const AtlasAnswer& answer, bool isComplete)
{
    Json json;
    if (answer.isTwins) {
        json["twins"] = Json::array();
        for (const Twins& group : answer.groups) {
            json["twins"].push_back({{"period", period(group.front().schedule)},
                                     {"energy_ratio", group.front().row.energy.least},
                                     {"schedules", asJson(group)}});
        }
    } else {
        json["schedules"] = asJson(answer.entries);
    }
    json["complete"] = isComplete;
    json["ranges"] = Json::array();
    for (const AtlasRun& run : answer.coverage) {
        json["ranges"].push_back({{"cells", run.range.cells},
                                  {"max_contact", run.range.maxContact},
                                  {"max_free", run.range.maxFree},
                                  {"phases", run.range.maxPhases},
                                  {"max_energy_ratio", bound(run.range.maxEnergyRatio)},
                                  {"finished", run.isFinished()}});
    }
    return json.dump() + "\n";
}

std::string asText(const AtlasRun& run, const std::string& database)
{
    const AtlasTally& tally = run.tally;
    return fmt::format(
        "{:<12}{}: {}\n"
        "decided     {} schedules in {:.3g} s\n"
        "found       {}: {} pressing, {} grazing\n"
        "none        {}{}\n",
        run.isFinished() ? "done" : "interrupted", onOneLine(database), describe(run.range),
        tally.decided, run.seconds, tally.pressing + tally.grazing, tally.pressing, tally.grazing,
        tally.refuted, tally.undecided > 0 ? fmt::format("\nundecided   {}", tally.undecided) : "");
}

std::string asJson(const AtlasRun& run, const std::string& database)
{
    const AtlasTally& tally = run.tally;
    const Json json{{"status", run.isFinished() ? "done" : "interrupted"},
                    {"database", database},
                    {"cells", run.range.cells},
                    {"max_contact", run.range.maxContact},
                    {"max_free", run.range.maxFree},
                    {"phases", run.range.maxPhases},
                    {"max_energy_ratio", bound(run.range.maxEnergyRatio)},
                    {"decided", tally.decided},
                    {"found", tally.pressing + tally.grazing},
                    {"pressing", tally.pressing},
                    {"grazing", tally.grazing},
                    {"refuted", tally.refuted},
                    {"undecided", tally.undecided},
                    {"batches", {run.nextBatch, run.batches}},
                    {"seconds", run.seconds}};
    return json.dump() + "\n";
}

}  // namespace signorini::cli
