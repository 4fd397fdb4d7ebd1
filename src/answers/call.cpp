#include "call.hpp"

#include <array>
#include <numbers>

#include "excited_names.hpp"
#include "options.hpp"

namespace signorini::answers {

namespace {

/// Of the base's displacement, velocity, acceleration.
constexpr std::array amplitudeNames{"--amplitude", "--amplitude-velocity",
                                    "--amplitude-acceleration"};

}  // namespace

void refuse(std::string_view name, std::string_view text, std::string_view allowed)
{
    if (text == "missing") {
        throw std::invalid_argument(fmt::format("{} is missing: allowed {}", name, allowed));
    }
    throwFault(name, text.empty() ? "''" : text, allowed);
}

void refuseIf(bool isWrong, std::string_view name, std::string_view text, std::string_view allowed)
{
    if (isWrong) {
        refuse(name, text, allowed);
    }
}

void refuseIf(bool isWrong, std::string_view sentence)
{
    if (isWrong) {
        throw std::invalid_argument(std::string(sentence));
    }
}

std::pair<std::string, std::string> Call::period() const
{
    std::pair<std::string, std::string> asked;
    for (const char* option : {"--period", "--frequency", "--hertz"}) {
        if (has(option)) {
            refuseIf(!asked.first.empty(), "--period, --frequency, --hertz: allowed one of them");
            asked = {called(option), text(option)};
        }
    }
    if (const auto hertz = number("--hertz")) {
        asked.second = fmt::format("{}", *hertz);
    } else if (const auto& [option, word] = asked;
               option == called("--frequency") && word.ends_with("Hz")) {
        asked = {called("--hertz"), fmt::format("{}", parsePositive(option, word, "Hz"))};
    }
    return asked;
}

std::string looksLikeHertz(const Call& call, std::string_view option, double ratio, double hertz,
                           const std::string& size)
{
    return ratio < likelyHertz
               ? ""
               : fmt::format(
                     "; {0:.6g} looks like Hz: ω₁ is {1:.6g} Hz ({2}), so it is {3}, or {4}", ratio,
                     hertz, size, call.with(option, fmt::format("{:.6g}Hz", ratio)),
                     call.with(option, fmt::format("{:.6g}", ratio / hertz)));
}

ForceOptions::ForceOptions(const Call& call)
    : ratio(call.number("--damping")), place(call.named("--force", excitedNames))
{
    for (int order = 0; const char* name : amplitudeNames) {
        if (call.has(name)) {
            refuseIf(amplitude.has_value(), name, call.text(name),
                     "one amplitude: --amplitude, its velocity or its acceleration");
            refuseIf(order > 0 && place == Excited::tip, name, call.text(name),
                     "only with --force base");
            const char* unit = place ? amplitudeUnitName(*place, order) : "N or m";
            amplitude = order == 0 ? parsePositive(name, call.text(name), unit) : call.number(name);
            derivative = order;
        }
        ++order;
    }
}

void ForceOptions::requireDamping() const
{
    refuseIf(!ratio, "--damping", "missing", fmt::format("numbers 0..{} [-]", maxDampingRatio));
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

std::optional<double> yieldStressOf(const Call& call, const Bar& bar)
{
    const auto yieldStress = call.number("--yield-stress");
    refuseIf(yieldStress && !bar.young, "--yield-stress", call.text("--yield-stress"),
             "with one modulus for all of the bar: it requires --young, --density and --area, or "
             "--segments-file");
    return yieldStress;
}

void requireOneEnergy(const Call& call)
{
    refuseIf(call.has("--energy") && call.has("--energy-ratio"),
             "--energy clashes with --energy-ratio: allowed one of them");
}

Bar barAsked(const Call& call, bool mayHaveModulusAlone)
{
    Bar bar;
    call.read("--length", bar.length);
    call.read("--gap", bar.gap);
    bar.young = call.number("--young");
    const auto density = call.number("--density");
    const auto diameter = call.number("--diameter");
    const auto area = diameter ? std::optional(0.25 * std::numbers::pi * *diameter * *diameter)
                               : call.number("--area");
    refuseIf(diameter && call.has("--area"), "--area clashes with --diameter: allowed one of them");
    if (!density && !area && (mayHaveModulusAlone || !bar.young)) {
        call.read("--wave-speed", bar.waveSpeed);
        call.read("--axial-stiffness", bar.axialStiffness);
        validate(bar);
        return bar;
    }
    refuseIf(call.has("--wave-speed") || call.has("--axial-stiffness"),
             "--young/--density/--area clash with --wave-speed/--axial-stiffness: allowed one set");
    refuseIf(!bar.young || !density || !area,
             "--young, --density, --area: allowed only all three together");
    return barOfMaterial(bar.length, *bar.young, *density, *area, bar.gap);
}

FrequencyOption::FrequencyOption(const Call& call, const char* name, const char* twin)
    : hertz(call.number(twin))
{
    const std::string text = call.text(name);
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

std::pair<std::string, std::string> givenEnd(const Call& call, const char* name)
{
    const std::string twin = fmt::format("{}-hertz", name);
    return call.has(twin.c_str()) ? std::pair(twin, call.text(twin))
                                  : std::pair(std::string(name), call.text(name));
}

void requireOrder(const Call& call, double least, double most)
{
    if (least > most) {
        const auto [low, from] = givenEnd(call, "--from");
        const auto [high, to] = givenEnd(call, "--to");
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

}  // namespace signorini::answers
