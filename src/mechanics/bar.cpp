#include "signorini/bar.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "faults.hpp"

namespace signorini {

Bar barOfMaterial(double length, double young, double density, double area, double gap)
{
    Faults faults;
    faults.requirePositive("young", young, "Pa");
    faults.requirePositive("density", density, "kg/m^3");
    faults.requirePositive("area", area, "m^2");
    faults.throwIfAny();
    Bar bar{.length = length,
            .waveSpeed = std::sqrt(young / density),
            .axialStiffness = young * area,
            .gap = gap,
            .young = young};
    validate(bar);
    return bar;
}

void validate(const Bar& bar)
{
    Faults faults;
    faults.requirePositive("length", bar.length, "m");
    faults.requirePositive("waveSpeed", bar.waveSpeed, "m/s");
    faults.requirePositive("axialStiffness", bar.axialStiffness, "N");
    faults.requirePositive("gap", bar.gap, "m");
    if (bar.young) {
        faults.requirePositive("young", *bar.young, "Pa");
    }
    faults.throwIfAny();

    const Scales unit = scales(bar);
    // Leaves room for periods of 2^62 steps and energies of any motion.
    constexpr double least = 1e-250;
    constexpr double most = 1e250;
    const auto requireNormal = [&faults](const char* name, double value) {
        if (!(value >= least && value <= most)) {
            faults.add(name, value, "1e-250..1e250",
                       "choose less extreme length, waveSpeed, axialStiffness or gap");
        }
    };
    requireNormal("gap/length", unit.strain);
    requireNormal("waveSpeed*gap/length", unit.velocity);
    requireNormal("length/waveSpeed", unit.time);
    requireNormal("axialStiffness*gap^2/(2*length)", unit.energy);
    requireNormal("pi*waveSpeed/(2*length)", unit.frequency);
    faults.throwIfAny();
}

Scales scales(const Bar& bar)
{
    const double strain = bar.gap / bar.length;
    return {.displacement = bar.gap,
            .strain = strain,
            .velocity = bar.waveSpeed * strain,
            .time = bar.length / bar.waveSpeed,
            .energy = 0.5 * bar.axialStiffness * bar.gap * strain,
            .frequency = std::numbers::pi * bar.waveSpeed / (2.0 * bar.length)};
}

}  // namespace signorini
