#include "harmonic_motion.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "faults.hpp"
#include "portable.hpp"
#include "stops.hpp"

namespace signorini {

using Complex = HarmonicCase::Complex;

Complex turned(double angle)
{
    return {portable::cos(angle), portable::sin(angle)};
}

double lengthOf(Complex z)
{
    return portable::hypot(z.real(), z.imag());
}

double angleOf(Complex z)
{
    return portable::atan2(z.imag(), z.real());
}

Complex turnOf(std::int64_t part, std::int64_t whole)
{
    return turned(2.0 * std::numbers::pi * static_cast<double>(part % whole) /
                  static_cast<double>(whole));
}

Complex HarmonicCase::place() const
{
    return isForce ? 0.0 : turnOf(cycles * back, 2 * cells);
}

Complex HarmonicCase::inCells(std::int64_t m) const
{
    return turnOf(cycles * m, cells);
}

Complex HarmonicCase::at(double time) const
{
    return turned(omega * time);
}

double HarmonicCase::placeOf(Stop stop) const
{
    return signorini::placeOf(stops, stop).value();
}

HarmonicCase harmonicCase(const Damping& damping, const Harmonic& excitation, const Stops& stops)
{
    validate(damping);
    Faults faults;
    faults.requirePositive("damping ratio", damping.ratio, "-");
    faults.requirePositive("amplitude", excitation.amplitude, "-");
    faults.requireWhole("cycles", excitation.cycles, maxHarmonicCells);
    const double crossing = excitation.stepsPerCrossing;
    if (!(crossing >= 1.0 && crossing <= static_cast<double>(maxCells) &&
          crossing == std::floor(crossing))) {
        faults.add("stepsPerCrossing", crossing, fmt::format("whole numbers 1..{}", maxCells));
    }
    faults.requireWhole("steps", excitation.steps, maxExcitationSteps);
    faults.throwIfAny();
    const std::int64_t back = 2 * static_cast<std::int64_t>(crossing);
    const std::int64_t common = std::gcd(back, excitation.steps);
    faults.requireWhole("steps in lowest terms", excitation.steps / common, maxHarmonicCells);
    faults.requireWhole("stepsPerCrossing in lowest terms", back / common, maxHarmonicCells);
    faults.throwIfAny();
    HarmonicCase given{back / common,
                       excitation.steps / common,
                       excitation.cycles,
                       2.0 * static_cast<double>(common) / static_cast<double>(back),
                       0.0,
                       damping.rho(),
                       excitation.amplitude,
                       excitation.place == Excited::tip,
                       stops};
    given.omega = 2.0 * std::numbers::pi * static_cast<double>(given.cycles) / given.period();
    return given;
}

}  // namespace signorini
