// Decides a range into a database, batch by batch.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "atlas_batches.hpp"
#include "signorini/atlas_database.hpp"

namespace signorini {

namespace {

/// The rows that the batches of a run have left: what was counted, or, where the energy decided
/// what to keep, what they give once more.
AtlasTally rowsLeft(const AtlasRun& run, const Cancel& cancel)
{
    AtlasTally rows = run.tally;
    if (std::isfinite(run.range.maxEnergyRatio)) {
        rows = {};
        std::vector<std::int8_t> signs;
        for (std::int64_t k = 0; k < run.nextBatch && !isRequested(cancel); ++k) {
            const auto batch = decideBatch(run.range, k, signs, cancel);
            for (const AtlasRow& row : batch ? batch->rows : std::vector<AtlasRow>{}) {
                ++(row.status == Status::none         ? rows.refuted
                   : row.status == Status::undecided  ? rows.undecided
                   : row.contact == Contact::pressing ? rows.pressing
                                                      : rows.grazing);
            }
            rows.families += batch ? static_cast<std::int64_t>(batch->families.size()) : 0;
        }
    }
    rows.decided = 0;
    if (!run.range.keepsRefuted) {
        rows.refuted = 0;
    }
    if (run.range.familiesOnly) {
        rows.pressing = rows.grazing = rows.undecided = 0;
    }
    return rows;
}

/// A run that is there already is believed only if its rows are.
void requireRows(const AtlasDatabase& database, const AtlasRun& run, bool isAlone,
                 const Cancel& cancel)
{
    const AtlasTally rows = database.rowsOf(run.range);
    const AtlasTally left = rowsLeft(run, cancel);
    if (isRequested(cancel)) {
        return;
    }
    const auto require = [&run](const char* what, std::int64_t there, std::int64_t wanted) {
        if (there != wanted) {
            throw FileError("run " + std::to_string(run.id),
                            fmt::format("cannot use: it left {} rows of {}, and {} are there: "
                                        "decide its range anew into another file",
                                        wanted, what, there));
        }
    };
    require("schedules that press", rows.pressing, left.pressing);
    require("schedules that graze", rows.grazing, left.grazing);
    require("refuted schedules", rows.refuted, left.refuted);
    require("undecided schedules", rows.undecided, left.undecided);
    // Of other ranges of the same grid there may be more.
    require("families", isAlone ? rows.families : std::min(rows.families, left.families),
            left.families);
}

}  // namespace

AtlasRun beginAtlas(AtlasDatabase& database, const AtlasRange& range, const AtlasOptions& options)
{
    validate(range);
    const std::vector<AtlasRun> runs = database.runs();
    const auto before = std::find_if(runs.begin(), runs.end(),
                                     [&range](const AtlasRun& run) { return run.range == range; });
    if (std::any_of(runs.begin(), runs.end(), [&range](const AtlasRun& run) {
            return stopsOf(run.range) != stopsOf(range);
        })) {
        throw std::invalid_argument(
            "gap, second stop: the database holds ranges of other stops: allowed another file");
    }
    if (std::any_of(runs.begin(), runs.end(), [&range](const AtlasRun& run) {
            return run.range.segments != range.segments || run.range.bars != range.bars;
        })) {
        throw std::invalid_argument(
            fmt::format("{}: the database holds ranges of other {}: allowed another file",
                        range.bars ? "scene" : "segments", range.bars ? "bars" : "segments"));
    }
    if (before == runs.end()) {
        const bool othersWait = std::any_of(runs.begin(), runs.end(),
                                            [](const AtlasRun& run) { return !run.isFinished(); });
        if (options.resume && othersWait) {
            throw std::invalid_argument(
                "resume (--resume): the unfinished run in the database is of another range: "
                "allowed the same bounds and choice of what to keep");
        }
        return database.start(range, options.options);
    }
    if (before->batches != batchesOf(range)) {
        throw FileError("run " + std::to_string(before->id),
                        "cannot use: another version divided the range differently");
    }
    if (!before->isFinished() && !options.resume) {
        throw std::invalid_argument(fmt::format(
            "the database has decided {} of {} batches of this range: allowed only with "
            "resume (--resume), or another file",
            before->nextBatch, before->batches));
    }
    const bool isAlone = std::count_if(runs.begin(), runs.end(), [&range](const AtlasRun& run) {
                             return run.range.cells == range.cells;
                         }) == 1;
    requireRows(database, *before, isAlone, options.cancel);
    return *before;
}

void fillAtlas(AtlasDatabase& database, AtlasRun& run, BatchSource& source,
               std::string_view workers, const AtlasOptions& options)
{
    using Clock = std::chrono::steady_clock;
    constexpr std::size_t most = 256;  // of batches at once
    Clock::time_point last = Clock::now();
    while (std::optional<AtlasBatch> batch = source.next()) {
        // To end a transaction takes as long as to write the rows of ten batches.
        std::vector<AtlasBatch> batches;
        for (; batch; batch = batches.size() < most ? source.ready() : std::nullopt) {
            batches.push_back(*std::move(batch));
        }
        const Clock::time_point here = Clock::now();
        database.write(run, batches, std::chrono::duration<double>(here - last).count(), workers);
        last = here;
        if (options.progress) {
            options.progress(run);
        }
    }
}

AtlasRun buildAtlas(AtlasDatabase& database, const AtlasRange& range, const AtlasOptions& options)
{
    AtlasRun run = beginAtlas(database, range, options);
    LocalBatches source(range, options.threads, options.cancel, run.nextBatch);
    fillAtlas(database, run, source, fmt::format("{} threads", source.threads()), options);
    return run;
}

std::string phasesText(const std::vector<Phase>& phases)
{
    std::string text;
    for (const Phase& phase : phases) {
        text += fmt::format("{}{}{}:{}", text.empty() ? "" : ",",
                            phase.stop == Stop::left ? "L:" : "", phase.contact, phase.free);
    }
    return text;
}

}  // namespace signorini
