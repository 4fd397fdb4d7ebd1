#include "force_options.hpp"

#include <array>

#include "excited_names.hpp"
#include "given.hpp"
#include "parts.hpp"

namespace signorini::cli {

namespace {

/// Of the base's displacement, velocity, acceleration.
constexpr std::array amplitudeNames{"--amplitude", "--amplitude-velocity",
                                    "--amplitude-acceleration"};

}  // namespace

ForceOptions::ForceOptions(const Given& given)
    : ratio(given.number("--damping")), place(given.named("--force", excitedNames))
{
    for (int order = 0; const char* name : amplitudeNames) {
        if (given.has(name)) {
            refuseIf(amplitude.has_value(), name, given.text(name),
                     "one amplitude: --amplitude, its velocity or its acceleration");
            refuseIf(order > 0 && place == Excited::tip, name, given.text(name),
                     "only with --force base");
            const char* unit = place ? amplitudeUnitName(*place, order) : "N or m";
            amplitude =
                order == 0 ? parsePositive(name, given.text(name), unit) : given.number(name);
            derivative = order;
        }
        ++order;
    }
}

void ForceOptions::requirePlace() const
{
    refuseIf(!place, "--force", "missing", "tip|base");
}

void ForceOptions::requireAmplitude() const
{
    if (!amplitude) {
        refuse("--amplitude", "missing", "numbers > 0 [N or m]");
    }
}

std::optional<double> yieldStressOf(const Given& given, const Bar& bar)
{
    const auto yieldStress = given.number("--yield-stress");
    refuseIf(yieldStress && !bar.young, "--yield-stress", given.text("--yield-stress"),
             "with one modulus for all of the bar: it requires --young, --density and --area, or "
             "--segments-file");
    return yieldStress;
}

FrequencyOption::FrequencyOption(const Given& given, const char* name, const char* twin)
    : hertz(given.number(twin))
{
    const std::string text = given.text(name);
    refuseIf(!text.empty() && hertz, name, text,
             fmt::format("only without {}: both are one frequency", twin));
    if (text.ends_with("Hz")) {
        hertz = parsePositive(name, text, "Hz");
    } else if (!text.empty()) {
        ratio = parseRatio(name, text, "omega_1");
    }
}

double FrequencyOption::ratioFor(double firstHertz, double otherwise) const
{
    return hertz ? *hertz / firstHertz : ratio.value_or(otherwise);
}

std::pair<std::string, std::string> typedEnd(const Given& given, const char* name)
{
    const std::string twin = fmt::format("{}-hertz", name);
    return given.has(twin.c_str()) ? std::pair(twin, given.text(twin))
                                   : std::pair(std::string(name), given.text(name));
}

void requireOrder(const Given& given, double least, double most)
{
    if (least > most) {
        const auto [low, from] = typedEnd(given, "--from");
        const auto [high, to] = typedEnd(given, "--to");
        refuse(
            low, from.empty() ? fmt::format("{}", least) : from,
            fmt::format("numbers up to {} = {}", high, to.empty() ? fmt::format("{}", most) : to));
    }
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
        refuse(amplitudeNames.at(static_cast<std::size_t>(derivative)),
               fmt::format("{}", *amplitude),
               fmt::format("{:.3g}..{:.3g} [{}]", unit / largest, unit * largest,
                           amplitudeUnitName(*place, derivative)));
    }
    return scaled;
}

ForceOptions ForceOptions::at(double hertz) const
{
    ForceOptions displaced = *this;
    if (derivative > 0) {
        displaced.amplitude = displacementAt(hertz, amplitude.value(), derivative);
        displaced.derivative = 0;
    }
    return displaced;
}

}  // namespace signorini::cli
