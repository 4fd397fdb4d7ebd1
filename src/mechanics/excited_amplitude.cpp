#include "excited_amplitude.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace signorini {

double displacementOf(double amplitude, int derivative, double frequencyRatio)
{
    const double omega = 0.5 * std::numbers::pi * frequencyRatio;
    return amplitude / std::pow(omega, derivative);
}

double displacementAt(double hertz, double amplitude, int derivative)
{
    return amplitude / std::pow(2.0 * std::numbers::pi * hertz, derivative);
}

double amplitudeUnit(Excited place, const Bar& bar, int derivative)
{
    const Scales unit = scales(bar);
    return place == Excited::tip ? bar.axialStiffness * unit.strain
                                 : unit.displacement / std::pow(unit.time, derivative);
}

const char* amplitudeUnitName(Excited place, int derivative)
{
    constexpr std::array units{"m", "m/s", "m/s^2"};
    return place == Excited::tip ? "N" : units.at(static_cast<std::size_t>(derivative));
}

const char* amplitudeOf(Excited place, int derivative)
{
    constexpr std::array names{"displacement", "velocity", "acceleration"};
    return place == Excited::tip ? "force" : names.at(static_cast<std::size_t>(derivative));
}

}  // namespace signorini
