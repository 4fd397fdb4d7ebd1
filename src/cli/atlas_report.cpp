#include "atlas_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "json.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t shownRows = 20;

/// null where there is no bound.
Json bound(double value)
{
    return std::isfinite(value) ? Json(value) : Json();
}

Json asJson(const AtlasEntry& entry, const Scales& unit)
{
    const AtlasRow& row = entry.row;
    Json json{{"cells", entry.schedule.cells},
              {"schedule", phasesAsJson(entry.schedule.phases)},
              {"period", period(entry.schedule) * unit.time},
              {"period_ratio", period(entry.schedule)},
              {"frequency_ratio", frequencyRatio(entry.schedule)},
              {"status", name(row.status)},
              {"reason", nullptr}};
    if (row.reason) {
        json["reason"] = name(*row.reason);
    }
    json["kernel_dimension"] = row.kernelDimension >= 0 ? Json(row.kernelDimension) : Json();
    if (row.status == Status::found) {
        json["kind"] = name(row.kind);
        json["dimension"] = row.dimension;
        json["contact"] = name(row.contact);
        json["canonical"] = row.isCanonical;
        json["energy_range"] = {row.energy.least * unit.energy,
                                bound(row.energy.most * unit.energy)};
        json["energy_ratio_range"] = {row.energy.least, bound(row.energy.most)};
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

Json asJson(const std::vector<AtlasEntry>& entries, const Scales& unit)
{
    Json list = Json::array();
    for (const AtlasEntry& entry : entries) {
        list.push_back(asJson(entry, unit));
    }
    return list;
}

Json groupAsJson(const Twins& group, const Scales& unit)
{
    const AtlasEntry& first = group.front();
    return {{"period", period(first.schedule) * unit.time},
            {"period_ratio", period(first.schedule)},
            {"energy", first.row.energy.least * unit.energy},
            {"energy_ratio", first.row.energy.least},
            {"schedules", asJson(group, unit)}};
}

/// Of the schedules of a range [L/c].
double longestPeriod(const AtlasRange& range)
{
    return static_cast<double>(range.maxPhases * (range.maxContact + range.maxFree)) /
           static_cast<double>(range.cells);
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

bool AtlasAnswer::isUndecided() const
{
    const auto covers = [this](const AtlasRun& run) {
        return run.isFinished() && run.range.maxEnergyRatio >= energyRatio &&
               longestPeriod(run.range) >= shortestPeriod;
    };
    return (isTwins ? groups.empty() : entries.empty()) &&
           std::none_of(coverage.begin(), coverage.end(), covers);
}

std::string gapsOf(const AtlasAnswer& answer)
{
    if (answer.coverage.empty()) {
        return "the database has decided nothing of this: no answer";
    }
    for (const AtlasRun& run : answer.coverage) {
        if (!run.isFinished()) {
            return fmt::format("{} of {} batches of {} are decided: the answer may lack schedules",
                               run.nextBatch, run.batches, describe(run.range));
        }
        if (run.range.maxEnergyRatio < answer.energyRatio) {
            return fmt::format("of {} only schedules with motions up to that energy were kept",
                               describe(run.range));
        }
    }
    const auto isTooShort = [&answer](const AtlasRun& run) {
        return longestPeriod(run.range) < answer.shortestPeriod;
    };
    if (std::all_of(answer.coverage.begin(), answer.coverage.end(), isTooShort)) {
        return fmt::format("no schedule of a period of {:.6g} L/c is decided: only up to {:.6g}",
                           answer.shortestPeriod, longestPeriod(answer.coverage.front().range));
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
    const Scales unit = scales(answer.bar);
    Json json = newAnswer();
    json["bar"] = barAsJson(answer.bar);
    if (answer.isTwins) {
        json["twins"] = Json::array();
        for (const Twins& group : answer.groups) {
            json["twins"].push_back(groupAsJson(group, unit));
        }
    } else {
        json["schedules"] = asJson(answer.entries, unit);
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
    return asLine(json);
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

std::string asJson(const AtlasRun& run, const std::string& database, const Bar& bar)
{
    const AtlasTally& tally = run.tally;
    Json json = newAnswer();
    json.update(Json{{"status", run.isFinished() ? "done" : "interrupted"},
                     {"database", database},
                     {"bar", barAsJson(bar)},
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
                     {"seconds", run.seconds}});
    return asLine(json);
}

}  // namespace signorini::cli
