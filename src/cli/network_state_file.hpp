#pragma once
/// \file
/// The state of a network as a table: part, number, right, left, displacement. Cells are numbered
/// from the left and have two waves [m/s]; stubs (springs and masses, from the left) have one, in
/// the column `right`; nodes have a displacement [m].

#include <string>

#include "network_simulation.hpp"

namespace signorini::cli {

/// \throws FileError.
void writeNetworkState(const std::string& path, const Network& network, const NetworkStart& state);

/// \throws FileError; std::invalid_argument naming line, value and what is allowed.
[[nodiscard]] NetworkStart readNetworkState(const std::string& path, const Network& network);

}  // namespace signorini::cli
