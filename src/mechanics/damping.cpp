#include <cmath>
#include <numbers>

#include "excited_names.hpp"
#include "faults.hpp"
#include "portable.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

double Damping::rho() const
{
    return portable::exp(-std::numbers::pi * ratio);
}

double Damping::eta() const
{
    return portable::tanh(0.5 * std::numbers::pi * ratio);
}

void validate(const Damping& damping)
{
    if (!(damping.ratio >= 0.0 && damping.ratio <= maxDampingRatio)) {
        throwFault("damping ratio", damping.ratio, fmt::format("0..{} [-]", maxDampingRatio));
    }
}

Damping dampingOfRho(double rho)
{
    if (!(rho > 0.0 && rho <= 1.0)) {
        throwFault("rho", rho, "]0, 1] [-]");
    }
    const Damping damping{std::abs(portable::log(rho)) / std::numbers::pi};
    validate(damping);
    return damping;
}

double dashpot(const Damping& damping, const Bar& bar)
{
    return 0.0 + damping.eta() * bar.axialStiffness / bar.waveSpeed;  // no -0
}

std::string_view name(Excited place)
{
    return nameIn(excitedNames, place);
}

double Excitation::force(std::int64_t m) const
{
    return values.empty() || place != Excited::tip ? 0.0
                                                   : values[static_cast<std::size_t>(m % steps())];
}

double Excitation::baseDisplacement(std::int64_t m) const
{
    return values.empty() || place != Excited::base ? 0.0
                                                    : values[static_cast<std::size_t>(m % steps())];
}

double Excitation::baseVelocity(std::int64_t m) const
{
    return (baseDisplacement(m + 1) - baseDisplacement(m)) * stepsPerCrossing;
}

Excitation refined(const Excitation& excitation, std::int64_t factor)
{
    Excitation fine{
        excitation.place, {}, excitation.stepsPerCrossing * static_cast<double>(factor)};
    fine.values.reserve(excitation.values.size() * static_cast<std::size_t>(factor));
    for (std::int64_t m = 0; m < excitation.steps(); ++m) {
        const double value = excitation.values[static_cast<std::size_t>(m)];
        const double moved =
            excitation.place == Excited::base ? excitation.baseDisplacement(m + 1) - value : 0.0;
        for (std::int64_t k = 0; k < factor; ++k) {
            fine.values.push_back(value +
                                  moved * static_cast<double>(k) / static_cast<double>(factor));
        }
    }
    return fine;
}

void validate(const Excitation& excitation)
{
    Faults faults;
    if (excitation.steps() > maxExcitationSteps) {
        faults.add("excitation.values", excitation.steps(),
                   fmt::format("at most {} steps", maxExcitationSteps));
    }
    for (const double value : excitation.values) {
        if (!std::isfinite(value)) {
            faults.add("excitation.values", value, "finite numbers");
            break;
        }
    }
    faults.requirePositive("stepsPerCrossing", excitation.stepsPerCrossing, "-");
    faults.throwIfAny();
}

Excitation excitationOf(const Harmonic& harmonic)
{
    Faults faults;
    faults.requireWhole("steps", harmonic.steps, maxExcitationSteps);
    faults.requirePositive("stepsPerCrossing", harmonic.stepsPerCrossing, "-");
    if (harmonic.cycles < 1 || harmonic.cycles > harmonic.steps / 2) {
        faults.add("cycles", harmonic.cycles,
                   fmt::format("whole numbers 1..{}, half of the steps", harmonic.steps / 2));
    }
    if (!std::isfinite(harmonic.amplitude)) {
        faults.add("amplitude", harmonic.amplitude, "finite numbers");
    }
    if (!std::isfinite(harmonic.phase)) {
        faults.add("phase", harmonic.phase, "finite numbers [rad]");
    }
    faults.throwIfAny();
    Excitation excitation{harmonic.place, {}, harmonic.stepsPerCrossing};
    excitation.values.reserve(static_cast<std::size_t>(harmonic.steps));
    const double offset = harmonic.place == Excited::tip ? 0.5 : 0.0;
    const double angle = 2.0 * std::numbers::pi / static_cast<double>(harmonic.steps);
    for (std::int64_t m = 0; m < harmonic.steps; ++m) {
        // Whole turns are left out exactly.
        const auto part = static_cast<double>(harmonic.cycles * m % harmonic.steps) +
                          offset * static_cast<double>(harmonic.cycles);
        excitation.values.push_back(harmonic.amplitude *
                                    portable::cos(angle * part - harmonic.phase));
    }
    return excitation;
}

Excitation excitationAt(Harmonic harmonic, double frequencyRatio, std::string_view field)
{
    const double cells = harmonic.stepsPerCrossing;
    const double exact = 4.0 * cells / frequencyRatio;
    const double steps = std::round(exact);
    const auto most = static_cast<double>(maxExcitationSteps);
    if (!(steps >= 3.0 && steps <= most)) {
        throwFault(field, frequencyRatio,
                   fmt::format("about {:.3g}..{:.3g} [ω₁] with {} steps in L/c", 4.0 * cells / most,
                               4.0 * cells / 3.0, cells));
    }
    const bool isWhole = std::abs(exact - steps) <= 1e-9 * exact;
    harmonic.cycles = 1;
    harmonic.steps = static_cast<std::int64_t>(steps);
    harmonic.stepsPerCrossing = isWhole ? cells : steps * frequencyRatio / 4.0;
    return excitationOf(harmonic);
}

}  // namespace signorini
