#pragma once
/// \file
/// Rows of an atlas read back, each value checked: a database can be edited by anyone.

#include <string_view>

#include "signorini/atlas_database.hpp"
#include "sqlite.hpp"

namespace signorini {

/// Columns of AtlasEntry, in the order `readEntry` expects.
inline constexpr std::string_view entryColumns =
    "SELECT rowid, cells, phases, status, reason, kernel_dimension, kind, dimension, contact, "
    "canonical, energy_ratio_min, energy_ratio_max, steps, period, frequency_ratio "
    "FROM schedules ";

/// Columns of AtlasRun, in the order `readRun` expects.
inline constexpr std::string_view runColumns =
    "SELECT id, cells, max_contact, max_free, phases, max_energy_ratio, keeps_refuted, "
    "batches, next_batch, decided, pressing, grazing, refuted, undecided, seconds FROM runs ";

/// The row the statement stands on. \throws FileError naming row, column and value if no atlas
/// would contain it.
[[nodiscard]] AtlasEntry readEntry(const Statement& s);

/// The same of a run. \throws FileError.
[[nodiscard]] AtlasRun readRun(const Statement& s);

}  // namespace signorini
