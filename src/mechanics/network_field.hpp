#pragma once
/// \file
/// Displacements, velocities and strains along the bars of a network, and over a period of a
/// motion.

#include <functional>
#include <span>
#include <vector>

#include "network_simulation.hpp"

namespace signorini {

/// Where each node is at rest [m], in bars of so much length in all that stand end to end.
[[nodiscard]] std::vector<double> placesOf(const Network& network, double length);

/// A place in a row of cells.
struct NetworkPlace {
    std::size_t row = 0;
    double cells = 0.0;  ///< from the left end
};

/// Of each row its ends and what lies evenly between them, so many parts at most and none smaller
/// than a cell.
[[nodiscard]] std::vector<NetworkPlace> placesOfRows(const Network& network, std::int64_t parts);

/// The middles of so many equal parts of all bars, end to end.
[[nodiscard]] std::vector<NetworkPlace> placesAlong(const Network& network, std::size_t parts);

/// Where they are [m].
[[nodiscard]] std::vector<double> positionsOf(const Network& network,
                                              std::span<const NetworkPlace> places, double length);

/// What is seen at places, the shape at rest included.
struct NetworkLook {
    std::vector<double> displacements;  ///< [delta]
    std::vector<double> velocities;     ///< [delta/h], of the cell that ends there
    std::vector<double> strains;        ///< u per cell of speed 1 [delta], likewise
};

/// At an instant, O(M + places): adds to what was seen. Exact on a grid, else means over cells.
/// \pre places row by row.
void look(NetworkLook& seen, const Network& network, const NetworkStart& now,
          std::span<const NetworkPlace> places);

/// Goes through a period of a motion by a simulation that records paths and makes its own
/// decisions; `see` is called at `instants` equal times and the end. \throws std::runtime_error if
/// it does not come back within 1e-6 of its largest wave: only where rounding decides on contacts,
/// or the motion is most unstable.
[[nodiscard]] NetworkSimulation throughPeriod(
    const Network& network, const NetworkStart& start, const NetworkDrive& drive, double period,
    std::int64_t instants, const std::function<void(const NetworkSimulation&)>& see);

}  // namespace signorini
