#include "signorini/bar.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "faults.hpp"
#include "signorini/schedule.hpp"
#include "stepped_bar.hpp"

namespace signorini {

namespace {

/// Of h/|g|: a fraction for it then fits in 64 bits with room for sums over the cells.
constexpr double leastReach = 1e-4;
constexpr double mostReach = 1e4;

}  // namespace

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
    if (!std::isfinite(bar.gap)) {
        faults.add("gap", bar.gap, "finite numbers [m]");
    }
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
    const double displacement = bar.gap == 0.0 ? bar.length : std::abs(bar.gap);
    const double strain = displacement / bar.length;
    return {.displacement = displacement,
            .strain = strain,
            .velocity = bar.waveSpeed * strain,
            .time = bar.length / bar.waveSpeed,
            .energy = 0.5 * bar.axialStiffness * displacement * strain,
            .frequency = std::numbers::pi * bar.waveSpeed / (2.0 * bar.length)};
}

void validate(const Scene& scene)
{
    validate(scene.bar);
    Faults faults;
    if (scene.secondStop) {
        const double reach = *scene.secondStop / scales(scene.bar).displacement;
        faults.requirePositive("secondStop", *scene.secondStop, "m");
        if (!(*scene.secondStop > -scene.bar.gap)) {
            faults.add("secondStop", *scene.secondStop,
                       fmt::format("> -g = {} [m]", -scene.bar.gap));
        } else if (!(reach >= leastReach && reach <= mostReach)) {
            faults.add("secondStop", *scene.secondStop,
                       fmt::format("{}..{} times {}", leastReach, mostReach,
                                   scene.bar.gap == 0.0 ? "the length of the bar" : "the gap"));
        }
    }
    std::size_t number = 0;
    for (const Segment& segment : scene.segments) {
        const std::string which = fmt::format(" of segment {}", ++number);
        faults.requireWhole("cells" + which, segment.cells, maxCells);
        faults.requirePositive("impedance" + which, segment.impedance, "-");
        faults.requirePositive("speed" + which, segment.speed, "-");
        if (!(std::isfinite(segment.dashpot) && segment.dashpot >= 0.0)) {
            faults.add("dashpot" + which, segment.dashpot, "finite and >= 0 [-]");
        }
    }
    faults.throwIfAny();
}

void requireWeight(Faults& faults, double gravity, double length, double waveSpeed)
{
    constexpr double mostStrain = 1e6;
    const double most = mostStrain * waveSpeed / length * waveSpeed;
    if (!std::isfinite(gravity) || (most > 0.0 && std::abs(gravity) > most)) {
        faults.add("gravity", gravity, fmt::format("finite, at most {:.6g} [m/s^2] in size", most));
    }
}

double tipSag(const Bar& bar, double gravity)
{
    const double time = bar.length / bar.waveSpeed;
    return 0.5 * gravity * time * time;
}

Scene aboutRest(const Scene& scene, double gravity)
{
    validate(scene);
    Faults faults;
    requireWeight(faults, gravity, scene.bar.length, scene.bar.waveSpeed);
    faults.throwIfAny();
    const double time = scene.bar.length / scene.bar.waveSpeed;
    const double sag = tipSag(scene.bar, gravity);
    const auto moved = [](double place, double way) {
        constexpr double rounding = 1e-14;
        const double there = place + way;
        return std::abs(there) <= rounding * std::abs(place) ? 0.0 : there;
    };
    Scene sagged = scene;
    sagged.bar.gap = moved(scene.bar.gap, -sag);
    if (scene.secondStop) {
        sagged.secondStop = moved(*scene.secondStop, sag);
    }
    if (sagged.secondStop && !(*sagged.secondStop > 0.0)) {
        throwFault("gravity", gravity,
                   fmt::format("finite and > {} [m/s^2]: the tip rests at no second stop",
                               -2.0 * *scene.secondStop / (time * time)));
    }
    validate(sagged);
    return sagged;
}

double staticForce(const Scene& scene)
{
    const Bar& bar = scene.bar;
    if (!(bar.gap < 0.0)) {
        return 0.0;
    }
    // A segment is cells times speed long, and EA is impedance times speed.
    double length = 0.0;
    double compliance = 0.0;
    for (const Segment& segment : scene.segments) {
        const auto cells = static_cast<double>(segment.cells);
        length += cells * segment.speed / scene.segments.front().speed;
        compliance += cells * scene.segments.front().impedance / segment.impedance;
    }
    const double stiffer = scene.segments.empty() ? 1.0 : length / compliance;
    return -bar.axialStiffness * bar.gap / bar.length * stiffer;
}

}  // namespace signorini
