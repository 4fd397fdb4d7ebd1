#include "force_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "excited_names.hpp"

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
            "a harmonic force on the tip, or a base that moves");
    addPositive(command, "--amplitude", "N or m", amplitude, "A",
                "of the force in newtons, or of the base in metres");
}

double ForceOptions::scaledAmplitude(const Bar& bar) const
{
    return amplitude.value() / (place == Excited::tip ? forceUnit(bar) : scales(bar).displacement);
}

}  // namespace signorini::cli
