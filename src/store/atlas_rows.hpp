#pragma once
/// \file
/// Rows of an atlas read back, each value checked: a database can be edited by anyone.

#include <SQLiteCpp/Statement.h>

#include <string>

#include "signorini/atlas_database.hpp"

namespace signorini {

/// Columns of AtlasEntry, in the order `readEntry` expects.
inline const std::string entryColumns =
    "SELECT rowid, cells, phases, status, reason, kernel_dimension, kind, dimension, contact, "
    "canonical, energy_ratio_min, energy_ratio_max, steps, period, frequency_ratio, family "
    "FROM schedules ";

/// Columns of AtlasFamily, in the order `readFamily` expects.
inline const std::string familyColumns =
    "SELECT id, cells, phases, family_order, nu, contact_blocks, kind, dimension, contact, "
    "schedules, energy_ratio_min, energy_ratio_max, steps, period, frequency_ratio "
    "FROM families ";

/// Columns of AtlasRun, in the order `readRun` expects.
inline const std::string runColumns =
    "SELECT id, cells, max_contact, max_free, phases, max_energy_ratio, keeps_refuted, "
    "batches, next_batch, decided, pressing, grazing, refuted, undecided, seconds, families_only, "
    "families, gap_sign, segments, second_stop FROM runs ";

/// The row the statement stands on. \throws SQLite::Exception naming column and value if no
/// atlas would contain it.
[[nodiscard]] AtlasEntry readEntry(const SQLite::Statement& s);

/// The same of a family.
[[nodiscard]] AtlasFamily readFamily(const SQLite::Statement& s);

/// The same of a run.
[[nodiscard]] AtlasRun readRun(const SQLite::Statement& s);

}  // namespace signorini
