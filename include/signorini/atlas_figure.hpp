#pragma once
/// \file
/// Two pictures of an atlas: where in time motions exist, and with which energy at which frequency.

#include <cstdint>
#include <optional>
#include <string>

#include "signorini/atlas_database.hpp"
#include "signorini/figure.hpp"

namespace signorini {

/// The frequency-energy plot (frequency_energy_figure.hpp) of the schedules found in a database, as
/// bars [E_min, E_max], with the exact modes as curves.
/// \throws FileError, BackendUnavailable.
void drawFrequencyEnergyPlot(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                             FigureFormat format, const std::string& path);

/// The existence map: a dot at (t_c, t_f) = (n_c/N, n_f/N), in L/c, for each schedule of one phase
/// that has motions, coloured by its least energy; grazing ones grey. An atlas without any leaves
/// an empty map. Errors as above.
void drawExistenceMap(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                      FigureFormat format, const std::string& path);

}  // namespace signorini
