#pragma once
/// \file
/// A motion of several bars as its files and moving pictures have it.

#include "network_field.hpp"
#include "network_walk.hpp"
#include "signorini/assembly.hpp"
#include "signorini/output.hpp"

namespace signorini {

/// Places of a file or a picture: of each row so many that all of them are about maxMotionNodes.
[[nodiscard]] std::vector<NetworkPlace> sampledPlaces(const Network& network);

/// One period at these places, row by row; instants are steps where there are no more than
/// `mostInstants`. \throws std::runtime_error as throughPeriod.
[[nodiscard]] MotionSamples samplesOf(const Assembly& assembly, const Network& network,
                                      const NetworkClaim& motion, std::int64_t mostInstants);

}  // namespace signorini
