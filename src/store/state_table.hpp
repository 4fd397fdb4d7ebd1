#pragma once
/// \file
/// A state off any grid as a table: node, displacement [m], wave, duration [s], velocity [m/s].
///
/// A row is a piece of a wave (node 0), in the order in which it arrives, wave by wave; or the
/// place of a node (wave 0). A bar has the wave that runs to its tip, the one that runs to its
/// base, and these two nodes, base first; so has a network of one row, and others have two waves
/// for each row, then one for each spring and mass (network.hpp).

#include <string>
#include <vector>

#include "network_continuum.hpp"
#include "network_simulation.hpp"
#include "signorini/output.hpp"

namespace signorini {

/// \throws FileError.
void writeStateTable(const std::string& path, const Network& network, const NetworkStart& state);

/// \throws FileError; std::invalid_argument naming line, value and what is allowed.
[[nodiscard]] NetworkStart readStateTable(const std::string& path, const Network& network);

/// Waves on the grid nearest to a state: such a table, or of a bar of one speed any that
/// `readState` knows. \throws as both.
[[nodiscard]] std::vector<double> readNearestWaves(const std::string& path, const Network& network,
                                                   const std::optional<Scene>& bar);

/// The state of a bar. \throws FileError.
void writeStateTable(const std::string& path, const Waves& waves, double tip, const Bar& bar);

/// A row for each motion: lambda, the waves at the start [m/s] in the order of `Network::waves`,
/// and the displacements of the nodes [m]. \throws FileError.
void writeContinuumCsv(const std::string& path, const Network& network,
                       const NetworkContinuum& curve);

class Table;

/// `readState` of output.hpp, the header of the table being read.
[[nodiscard]] StateReading readState(Table& table, const Bar& bar, std::int64_t cells,
                                     std::optional<std::int64_t> mostCells);

/// Such a table, or one of those that `readState` knows: then on its grid, with the base where the
/// displacements of a uniform bar have it.
/// \throws as `readState`.
[[nodiscard]] Waves readWaves(const std::string& path, const Bar& bar, std::int64_t cells,
                              bool isUniform);

}  // namespace signorini
