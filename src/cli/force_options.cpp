#include "force_options.hpp"

#include <array>

#include "excited_names.hpp"
#include "parts.hpp"

namespace signorini::cli {

void ForceOptions::addTo(CLI::App& command)
{
    addWord(command, "--damping", "ZETA", "damping ratio of the first mode, a dashpot at the tip",
            [this](const std::string& text) {
                const std::string range = fmt::format("numbers 0..{} [-]", maxDampingRatio);
                const double value = parseReal("--damping", text, "-");
                if (!(value >= 0.0 && value <= maxDampingRatio)) {
                    refuse("--damping", text, range);
                }
                ratio = value;
            });
    addName(command, "--force", excitedNames, place,
            "a harmonic force on the tip, or a moving base");
    // Behind --force: options are read in the order in which they are declared.
    addWord(command, "--amplitude", "A", "of the force in newtons, or of the base in metres",
            [this](const std::string& text) {
                const char* unit = !place ? "N or m" : place == Excited::tip ? "N" : "m";
                amplitude = parsePositive("--amplitude", text, unit);
            });
    const auto addDerivative = [&](int order, const char* name, const char* unit,
                                   const char* help) {
        addWord(command, name, "A", help, [this, order, name, unit](const std::string& text) {
            if (amplitude) {
                refuse(name, text, "one amplitude: --amplitude, its velocity or its acceleration");
            }
            if (place == Excited::tip) {
                refuse(name, text, "it only with --force base");
            }
            amplitude = parsePositive(name, text, unit);
            derivative = order;
        });
    };
    addDerivative(1, "--amplitude-velocity", "m/s", "or of the velocity of the base");
    addDerivative(2, "--amplitude-acceleration", "m/s^2", "or of the acceleration of the base");
}

void FrequencyOption::addTo(CLI::App& command, const char* name, const char* twin, const char* help)
{
    const auto requireFirst = [this, name, twin](const std::string& text) {
        if (isGiven()) {
            refuse(name, text, fmt::format("it without {}: both are one frequency", twin));
        }
    };
    addWord(command, name, "W", help, [this, name, requireFirst](const std::string& text) {
        requireFirst(text);
        (text.ends_with("Hz") ? hertz : ratio) =
            parsePositive(name, text, text.ends_with("Hz") ? "Hz" : "omega_1");
    });
    addWord(command, twin, "F", "the same in Hz",
            [this, twin, requireFirst](const std::string& text) {
                requireFirst(text);
                hertz = parsePositive(twin, text, "Hz");
            });
}

double FrequencyOption::ratioFor(double firstHertz, double otherwise) const
{
    return hertz ? *hertz / firstHertz : ratio.value_or(otherwise);
}

double firstHertz(const Bar& bar)
{
    return 0.25 / scales(bar).time;
}

double ForceOptions::scaledAmplitude(const Bar& bar) const
{
    constexpr double largest = 1e100;  // so that energies are numbers
    const double unit = amplitudeUnit(place.value(), bar, derivative);
    const double scaled = amplitude.value() / unit;
    if (!(scaled >= 1.0 / largest && scaled <= largest)) {
        constexpr std::array names{"--amplitude", "--amplitude-velocity",
                                   "--amplitude-acceleration"};
        refuse(names.at(static_cast<std::size_t>(derivative)), fmt::format("{}", *amplitude),
               fmt::format("{:.3g}..{:.3g} [{}]", unit / largest, unit * largest,
                           amplitudeUnitName(*place, derivative)));
    }
    return scaled;
}

ForceOptions ForceOptions::at(double frequencyRatio, double firstHertz) const
{
    ForceOptions displaced = *this;
    if (derivative > 0) {
        displaced.amplitude =
            displacementAt(frequencyRatio * firstHertz, amplitude.value(), derivative);
        displaced.derivative = 0;
    }
    return displaced;
}

}  // namespace signorini::cli
