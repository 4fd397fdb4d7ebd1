#pragma once
/// \file
/// Pictures of scenes and of what networks do.

#include <string>

#include "signorini/assembly.hpp"
#include "signorini/figures.hpp"

namespace signorini {

class NetworkSimulation;

/// Draws a scene: bars as long as they are and as high as their impedance says, gaps not to scale,
/// contacts with their numbers. \throws std::invalid_argument on an assembly that is no scene;
/// BackendUnavailable, FileError as the other figures.
void drawScene(const Assembly& assembly, FigureFormat format, const std::string& path);

/// Draws what a simulation saw at each contact, up to six: the two faces, or the face and its stop,
/// over the last stretch of time; where it pressed is marked. \throws std::invalid_argument if the
/// paths were not recorded; BackendUnavailable, FileError.
void drawSimulation(const NetworkSimulation& simulation, FigureFormat format,
                    const std::string& path);

}  // namespace signorini
