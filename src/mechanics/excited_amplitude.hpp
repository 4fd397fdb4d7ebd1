#pragma once
/// \file
/// Amplitudes of an excitation: of the force on the tip, or of the base's displacement or one of
/// its derivatives, as shakers are set: 1 velocity, 2 acceleration.

#include "signorini/bar.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// Y [g] of a base of which that derivative has an amplitude in g (c/L)^derivative, at omega =
/// W omega_1, omega_1 = pi c/(2 L).
[[nodiscard]] double displacementOf(double amplitude, int derivative, double frequencyRatio);

/// Y [m] of a base of which that derivative has an amplitude in m/s^derivative, at so many Hz.
[[nodiscard]] double displacementAt(double hertz, double amplitude, int derivative);

/// What an amplitude of 1 is: EA g/L [N], or g (c/L)^derivative [m, m/s, m/s^2].
[[nodiscard]] double amplitudeUnit(Excited place, const Bar& bar, int derivative = 0);
/// "N", "m", "m/s", "m/s^2".
[[nodiscard]] const char* amplitudeUnitName(Excited place, int derivative = 0);
/// "force", "displacement", "velocity", "acceleration".
[[nodiscard]] const char* amplitudeOf(Excited place, int derivative);

}  // namespace signorini
