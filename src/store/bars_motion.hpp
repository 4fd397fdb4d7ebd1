#pragma once
/// \file
/// A motion of several bars as its files and moving pictures have it.

#include <functional>

#include "network_field.hpp"
#include "network_walk.hpp"
#include "signorini/assembly.hpp"
#include "signorini/output.hpp"

namespace signorini {

/// Places of a file or a picture: of each row so many that all of them are about maxMotionNodes.
[[nodiscard]] std::vector<NetworkPlace> sampledPlaces(const Network& network);

/// Shows a period of a motion: at its start, at so many times that are evenly spread, and at its
/// end; at steps where it has no more of them.
using ShownPeriod = std::function<void(
    std::int64_t instants, const std::function<void(double time, const NetworkStart& now)>& see)>;

/// By a simulation. Keeps references. \throws, when it shows, std::runtime_error as throughPeriod.
[[nodiscard]] ShownPeriod shownPeriod(const Network& network, const NetworkClaim& motion);

/// One period at these places, row by row, at no more than `mostInstants`.
[[nodiscard]] MotionSamples samplesOf(const Assembly& assembly, const Network& network,
                                      const ShownPeriod& motion, std::int64_t mostInstants);

}  // namespace signorini
