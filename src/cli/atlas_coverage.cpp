#include "atlas_coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace signorini::cli {

namespace {

/// Of the schedules of a range.
std::int64_t longest(const AtlasRange& range)
{
    return range.maxPhases * (range.maxContact + range.maxFree);
}

bool isExactlyOnGrid(const ExactPeriod& period, const AtlasRange& range)
{
    return range.cells % period.denominator == 0 &&
           period.numerator <= longest(range) / (range.cells / period.denominator);
}

/// Has a schedule of the range a frequency between the two?
bool isBetween(double lowest, double highest, const AtlasRange& range)
{
    const double waves = 4.0 * static_cast<double>(range.cells);
    const double guess = std::floor(waves / highest) - 1.0;
    if (guess >= static_cast<double>(longest(range))) {
        return false;
    }
    auto steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(guess));
    while (waves / static_cast<double>(steps) > highest) {
        ++steps;
    }
    return steps <= longest(range) && waves / static_cast<double>(steps) >= lowest;
}

}  // namespace

AtlasCoverage::AtlasCoverage(const AtlasQuestion& question, const std::vector<AtlasRun>& all)
    : question_(question)
{
    std::set<std::int64_t> grids;
    for (const AtlasRun& run : all) {
        grids.insert(run.range.cells);
        if (!question_.cells || run.range.cells == *question_.cells) {
            runs_.push_back(run);
        }
    }
    constexpr std::size_t shown = 8;
    for (const std::int64_t cells : grids) {
        if (grids.size() > shown && cells == *std::next(grids.begin(), shown)) {
            grids_ += ", …";
            break;
        }
        grids_ += fmt::format("{}{}", grids_.empty() ? "N = " : ", ", cells);
    }
}

bool AtlasCoverage::reaches(const AtlasRun& run) const
{
    return question_.period
               ? isExactlyOnGrid(*question_.period, run.range)
               : isBetween(question_.lowestFrequency, question_.highestFrequency, run.range);
}

bool AtlasCoverage::keptIt(const AtlasRun& run) const
{
    return run.range.maxEnergyRatio >= question_.highestEnergy &&
           !(question_.wantsSchedules && run.range.familiesOnly);
}

bool AtlasCoverage::isDecided() const
{
    return std::any_of(runs_.begin(), runs_.end(), [this](const AtlasRun& run) {
        return run.isFinished() && keptIt(run) && reaches(run);
    });
}

std::string AtlasCoverage::gaps() const
{
    if (runs_.empty()) {
        return question_.cells
                   ? fmt::format("the database has decided nothing of N = {}: it holds {}",
                                 *question_.cells, grids_.empty() ? "nothing" : grids_)
                   : "the database has decided nothing of this: no answer";
    }
    if (std::none_of(runs_.begin(), runs_.end(),
                     [this](const AtlasRun& run) { return reaches(run); })) {
        const AtlasRange& range = runs_.front().range;
        const auto cells = static_cast<double>(range.cells);
        return fmt::format(
            "no schedule of such a period is decided: periods are whole multiples of 1/N, {}, up "
            "to {:.6g} L/c",
            question_.cells ? fmt::format("N = {}", range.cells) : grids_,
            static_cast<double>(longest(range)) / cells);
    }
    for (const AtlasRun& run : runs_) {
        if (!run.isFinished()) {
            return fmt::format("{} of {} batches of {} are decided: the answer may lack motions",
                               run.nextBatch, run.batches, describe(run.range));
        }
        if (run.range.maxEnergyRatio < question_.highestEnergy) {
            return fmt::format("of {} only schedules with motions up to that energy were kept",
                               describe(run.range));
        }
        if (!keptIt(run)) {
            return fmt::format("of {} families were kept and no schedules", describe(run.range));
        }
    }
    return {};
}

std::string describe(const AtlasRange& range)
{
    return fmt::format(
        "N = {}, contact 1..{}, free 1..{}{}{}{}{}", range.cells, range.maxContact, range.maxFree,
        range.maxPhases > 1 ? fmt::format(", 1..{} phases", range.maxPhases) : "",
        std::isfinite(range.maxEnergyRatio) ? fmt::format(", E <= {} E₁", range.maxEnergyRatio)
                                            : "",
        range.familiesOnly ? ", families only" : "",
        range.bars               ? ", " + textOf(range.bars->parts)
        : range.segments.empty() ? ""
                                 : ", segments " + sceneText(range));
}

}  // namespace signorini::cli
