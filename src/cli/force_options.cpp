#include "force_options.hpp"

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
}

double ForceOptions::scaledAmplitude(const Bar& bar) const
{
    constexpr double largest = 1e100;  // so that energies are numbers
    const double unit = answers::amplitudeUnit(place.value(), bar);
    const double scaled = amplitude.value() / unit;
    if (!(scaled >= 1.0 / largest && scaled <= largest)) {
        refuse("--amplitude", fmt::format("{}", *amplitude),
               fmt::format("{:.3g}..{:.3g} [{}]", unit / largest, unit * largest,
                           place == Excited::tip ? "N" : "m"));
    }
    return scaled;
}

}  // namespace signorini::cli
