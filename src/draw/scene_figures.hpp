#pragma once
/// \file
/// Pictures of scenes and of what networks do, and of studies.

#include "bars_motion.hpp"
#include "scene_continuum_answer.hpp"
#include "scene_response_answer.hpp"
#include "signorini/assembly.hpp"
#include "signorini/figures.hpp"
#include "study_answer.hpp"

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

/// The same over one period of a motion of bars that are so long in all [m]; above it u of all
/// bars. \throws std::runtime_error as throughPeriod.
[[nodiscard]] FigureData periodFigure(const Network& network, const NetworkClaim& motion,
                                      double length);

/// As motionFrames, of bars in a row.
[[nodiscard]] std::vector<FigureData> barsFrames(const Assembly& assembly, const Network& network,
                                                 const ShownPeriod& motion, std::size_t most = 120);

/// A curve of motions: forces of the first two contacts over time and u along the bars at t = 0,
/// each an image with lambda upwards, or the velocity where there is one contact; below u(x, t) of
/// the first, middle and last motion. \throws std::invalid_argument without motions,
/// std::runtime_error as throughPeriod.
[[nodiscard]] FigureData sceneContinuumFigure(const answers::SceneContinuumAnswer& answer);

/// Forces of the contacts over a period, and u along the bars at t = 0, motion after motion.
/// \throws as sceneContinuumFigure.
[[nodiscard]] std::vector<FigureData> sceneContinuumFrames(
    const answers::SceneContinuumAnswer& answer);

/// Largest force and impulse of each motion against the frequency, a look for each contact; where
/// bars do not meet, and where they would and no motion is known. \throws std::invalid_argument
/// without frequencies.
[[nodiscard]] FigureData sceneResponseFigure(const answers::SceneResponse& response);

/// As responseMapFigure, of bars in a row. \throws also of an exact harmonic.
[[nodiscard]] FigureData sceneMapFigure(const answers::SceneResponse& response);

/// A motion of several under a harmonic. Keeps references. \throws, when it shows, as
/// answer.watch.
[[nodiscard]] ShownPeriod shownPeriod(const answers::SceneHarmonicAnswer& answer,
                                      std::size_t motion);

/// A motion over one period: u of all bars, and of the contact that closes how far it is open and
/// its force. \throws std::out_of_range.
[[nodiscard]] FigureData harmonicFigure(const answers::SceneHarmonicAnswer& answer,
                                        std::size_t motion);

/// The worst impulse of each sweep: a field for each amplitude and gap, a panel for each damping
/// ratio; frequencies are written in the fields. In SI units.
/// \throws std::invalid_argument if there is no point.
[[nodiscard]] FigureData studyFigure(const answers::StudyAnswer& answer);

}  // namespace signorini
