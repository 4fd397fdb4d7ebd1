#pragma once
/// \file
/// What commands say of their answers: words for people, several lines with a final newline, JSON,
/// and tables, of which every writer throws FileError.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "atlas_answer.hpp"
#include "continuum_answer.hpp"
#include "exact_answer.hpp"
#include "json.hpp"
#include "modes_answer.hpp"
#include "question_answer.hpp"
#include "response_answer.hpp"
#include "signorini/atlas_database.hpp"
#include "simulation_answer.hpp"
#include "sweep_answer.hpp"

namespace signorini::cli {

using answers::AtlasAnswer;
using answers::AtlasBuilt;
using answers::ResponseAnswer;
using answers::SimulationAnswer;
using answers::SweepAnswer;

/// What climbing says of an energy.
inline constexpr std::string_view mostFound = ", the most found, not proved the most";

[[nodiscard]] std::string asText(const Physical& physical);
/// The line of a set of motions.
[[nodiscard]] std::string setText(const std::optional<SetKind>& kind, std::int64_t dimension,
                                  const std::optional<std::int64_t>& kernelDimension);
/// By which route, and what that left out.
[[nodiscard]] std::string asText(const Provenance& how);
/// If verbose, also the route that found it.
[[nodiscard]] std::string asText(const answers::FindAnswer& answer, bool isVerbose);
[[nodiscard]] std::string asText(const answers::QuestionAnswer& answer, bool isVerbose);
[[nodiscard]] std::string asText(const answers::ForcedAnswer& answer);
[[nodiscard]] std::string asText(const answers::HarmonicAnswer& answer);
[[nodiscard]] std::string asText(const answers::ContinuumAnswer& answer);
[[nodiscard]] std::string asText(const answers::ModeAnswer& answer);
[[nodiscard]] std::string asText(const answers::ModeList& listing);
[[nodiscard]] std::string asText(const answers::PolytopeList& listing);
/// Where it rattles, the worst values and where.
[[nodiscard]] std::string asText(const ResponseAnswer& answer);
[[nodiscard]] std::string asText(const answers::ExactAnswer& answer);
/// What it settles on where, and the worst values.
[[nodiscard]] std::string asText(const SweepAnswer& answer);
[[nodiscard]] std::string asText(const SimulationAnswer& answer);
[[nodiscard]] std::string asText(const AtlasAnswer& answer);
[[nodiscard]] std::string asText(const AtlasBuilt& built);

/// On what a simulation that is driven settled, 1 of an impulse being so many N s.
[[nodiscard]] std::string asText(const Settling& settling, double impulseUnit);

/// A list of families in pieces: it may be long.
using Write = std::function<void(std::string_view)>;
void writeText(const answers::FamilyList& list, const Write& write);
void writeJson(const answers::FamilyList& list, const Write& write);

/// Writes an answer to standard output: JSON, or the line that restates the bar, with grid and
/// damping where they are part of the question, and the words.
void report(const CommonOptions& common, const auto& answer, std::optional<std::int64_t> grid = {},
            std::optional<double> damping = {})
{
    writeOut(common.wantsJson ? asLine(wholeJsonOf(answer))
                              : common.restated(grid, damping) + asText(answer));
}

/// The runs of neighbours 0 … count - 1 that hold, each as its first and last are called: "a … b, c
/// and 2 more"; empty: none.
[[nodiscard]] std::string bandsText(
    std::size_t count, const std::function<bool(std::size_t)>& holds,
    const std::function<std::string(std::size_t first, std::size_t last)>& called);
/// Of a curve the line of its resolution, and that of a note or a reason; or none.
[[nodiscard]] std::string resolutionText(const std::optional<double>& resolution);
[[nodiscard]] std::string detailText(Status status, const std::string& detail);
/// "attracts; 4 disturbances ... became ... times as large in 300 periods"
[[nodiscard]] std::string stabilityText(const StabilityResult& tried, std::int64_t periods);

/// ": interrupted, the list is not complete", or nothing.
[[nodiscard]] inline const char* unlessComplete(bool isComplete)
{
    return isComplete ? "" : ": interrupted, the list is not complete";
}

/// ": 12 % of the yield stress, no yield at these values", or nothing without a limit. `where`: "at
/// these values" where all that the bars do was seen, "in these motions" where some are listed.
[[nodiscard]] std::string yieldText(double stress, std::optional<double> limit, const char* where);
/// The line of a limit on strain, or none.
[[nodiscard]] std::string limitText(const std::optional<double>& strainLimit);
[[nodiscard]] std::string limitText(const answers::HarmonicLimit& limit);
/// By how much disturbances of a motion under an exact harmonic grow in a period, or what was tried
/// of it; nothing where neither is known.
[[nodiscard]] std::string growthText(const std::optional<double>& growth,
                                     const std::optional<bool>& attracts);

using answers::fractionAsText;
/// factor T - less with its positive term first; the number alone for factor 0.
[[nodiscard]] std::string linearAsText(std::int64_t factor, std::int64_t less);
/// "8 - 3T": the contact time of a mode in L/c.
[[nodiscard]] std::string contactAsText(const Mode& mode);
/// kappa T - mu > 0 with its positive term first.
[[nodiscard]] std::string rootAsText(const Mode& mode);

/// "2/1→2 2/2→1": k/turns and release of each chain, contacts counted from 1.
[[nodiscard]] std::string chainsAsText(const std::vector<ModeChain>& chains);

/// One row a family.
void writeFamiliesCsv(const std::string& path, const answers::FamilyList& list);
/// Motions inside the interval of each mode, evenly in T, with no more than the energy asked for.
void writeModesCsv(const std::string& path, const answers::ModeList& listing);
/// Motions at the corners of slices, evenly in T: how contact and flight may be shared there.
void writePolytopesCsv(const std::string& path, const answers::PolytopeList& listing);
/// The families of all cells, or of those asked for, one row each.
void writeAtlasCsv(const std::string& path, const AtlasDatabase& atlas,
                   std::optional<std::int64_t> cells, const Bar& bar);
/// The schedules that `forEach` visits, one row each, with the columns that JSON has as keys.
void writeSchedulesCsv(
    const std::string& path, const answers::AtlasUnits& units,
    const std::function<void(const std::function<void(const AtlasEntry&)>&)>& forEach);
/// A row for each motion, and one for each frequency without any.
void writeResponseCsv(const std::string& path, const ResponseAnswer& answer);
/// A row for each interval of amplitudes with a motion: without contact, with one, with two.
void writeResponseMapCsv(const std::string& path, const ResponseAnswer& answer);
/// A row for each point of the curves of the modes.
void writeBackboneCsv(const std::string& path, const ResponseAnswer& answer);
/// A row for each contact of each motion, and one for each frequency without any.
void writeExactCsv(const std::string& path, const answers::ExactAnswer& answer);
/// A row for each value and direction.
void writeSweepCsv(const std::string& path, const SweepAnswer& answer);

/// All contacts: start, end [s], impulse [N s], peak force [N], of two stops which, and the largest
/// mean force over the resolution [N], then speed of approach [m/s] and energy that the stop turned
/// over [J].
void writeEvents(const std::string& path, const BarSimulation& simulation, const Bar& bar);

/// The impacts at one contact.
struct Impacts {
    std::string contact;
    std::vector<double> impulse = {};  ///< [N s]
    std::vector<double> speed = {};    ///< [m/s], of approach
    std::vector<double> energy = {};   ///< [J], turned over; empty: not known
};
/// How many there were in so many seconds, and how their numbers are spread: a row for each
/// statistic and each part of a histogram.
void writeImpacts(const std::string& path, std::span<const Impacts> all, double duration);
void writeStatistics(const std::string& path, const BarSimulation& simulation, const Bar& bar);

/// The path of the tip: time [s], displacement [m].
void writeTip(const std::string& path, const BarSimulation& simulation, const Bar& bar);

}  // namespace signorini::cli
