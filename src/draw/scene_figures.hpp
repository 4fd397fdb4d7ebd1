#pragma once
/// \file
/// Pictures of scenes and of what networks do.

#include <string>

#include "harmonic_network_walk.hpp"
#include "network_walk.hpp"
#include "signorini/assembly.hpp"
#include "signorini/figures.hpp"

namespace signorini {

class NetworkSimulation;

/// A scene: bars as long as they are and as high as their impedance says, gaps not to scale,
/// contacts with their numbers. \throws std::invalid_argument on an assembly that is no
/// scene.
[[nodiscard]] FigureData sceneFigure(const Assembly& assembly);

/// What a simulation saw at each contact, up to six: the two faces, or the face and its stop,
/// over the last stretch of time; where it pressed is marked. \throws std::invalid_argument if the
/// paths were not recorded.
[[nodiscard]] FigureData simulationFigure(const NetworkSimulation& simulation);

/// The same over one period of a motion, which a simulation of its own decisions goes through from
/// its start. \throws std::runtime_error if that does not come back to it within 1e-6: only where
/// rounding decides on contacts, or the motion is most unstable.
[[nodiscard]] FigureData periodFigure(const Network& network, const NetworkClaim& motion);

/// A contact over one period: how far it is open, and its force. \pre a path of some times.
[[nodiscard]] FigureData contactFigure(const std::vector<ContactInstant>& path,
                                       const NetworkScales& scales);

}  // namespace signorini
