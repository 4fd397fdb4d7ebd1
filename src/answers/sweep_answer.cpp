#include "sweep_answer.hpp"

#include "excited_names.hpp"
#include "network_sweep.hpp"

namespace signorini::answers {

namespace {

/// One end of the range, in units of the bar.
double endOf(const Call& call, const char* option, double otherwise, const SweepRange& range,
             const Bar& bar)
{
    const std::string twin = fmt::format("{}-hertz", option);
    if (range.over == Swept::frequency) {
        return FrequencyOption(call, option, twin.c_str()).ratioFor(firstHertz(bar), otherwise);
    }
    refuseIf(call.has(twin), twin, call.text(twin), "only with --over frequency");
    const char* unit = unitName(range.over, range.place);
    const std::string text = call.text(option);
    refuseIf(text.empty(), option, "missing", fmt::format("numbers > 0 [{}]", unit));
    return parsePositive(option, text, unit) / unitOf(range.over, range.place, bar);
}

/// What does not go together.
void requireTogether(const ForceOptions& force, const FrequencyOption& frequency, Swept over,
                     const Scene& scene)
{
    if (force.amplitude.has_value() == (over == Swept::amplitude)) {
        refuse("--amplitude", force.amplitude ? fmt::format("{}", *force.amplitude) : "missing",
               force.amplitude ? "only where another number is varied"
                               : "finite numbers > 0 [N or m]");
    }
    refuseIf(frequency.isGiven() && over == Swept::frequency,
             "--frequency, --hertz: allowed only where another number is varied: --over");
    refuseIf(!frequency.isGiven() && over != Swept::frequency, "--frequency", "missing",
             "numbers > 0 [ω₁]");
    if (force.ratio && over == Swept::damping) {
        refuse("--damping", fmt::format("{}", *force.ratio), "only where another number is varied");
    }
    if (over == Swept::gap && !(scene.bar.gap > 0.0)) {
        refuse("--gap", fmt::format("{}", scene.bar.gap), "numbers > 0 [m] with --over gap");
    }
}

SweepRange rangeOf(const Call& call, const Scene& scene, const Bar& bar, std::int64_t cells)
{
    const ForceOptions force(call);
    const FrequencyOption frequency(call, "--frequency", "--hertz");
    force.requirePlace();
    SweepRange range{.over = call.named("--over", sweptNames).value_or(Swept::frequency),
                     .points = call.whole("--points").value_or(101),
                     .periods = call.whole("--periods").value_or(1000),
                     .isCarried = !call.has("--rest"),
                     .cells = static_cast<double>(cells),
                     .place = *force.place,
                     .frequencyRatio = frequency.ratioFor(firstHertz(bar), 1.0),
                     .damping = force.damping(),
                     .stops = stopsOf(scene),
                     .segments = scene.segments,
                     .resolution = call.number("--resolve").value_or(0.0) / scales(bar).time};
    requireTogether(force, frequency, range.over, scene);
    range.least = endOf(call, "--from", 0.5, range, bar);
    range.most = endOf(call, "--to", 2.0, range, bar);
    range.amplitude = range.over == Swept::amplitude ? range.least : force.scaledAmplitude(bar);
    range.derivative = force.derivative;
    requireOrder(call, range.least, range.most);
    return range;
}

}  // namespace

SweepAnswer sweepAsked(const Call& call, const Scene& scene, std::int64_t cells)
{
    const Bar bar = unitsOf(scene);
    return {rangeOf(call, scene, bar, cells), scene, bar, {}, true, yieldStressOf(call, bar)};
}

SweepAnswer sweepAsked(const Call& call, const Assembly& assembly, const Network& network,
                       std::int64_t cells)
{
    const auto over = call.named("--over", sweptNames);
    refuseIf(over == Swept::gap || over == Swept::damping, "--over", call.text("--over"),
             "frequency|amplitude of a scene of several bars");
    const ForceOptions force(call);
    force.requirePlace();
    Faults faults;
    requireExcitable(faults, network, *force.place);
    faults.throwIfAny();
    const Bar bar = unitsOf(assembly, network);
    return {rangeOf(call, bar, bar, cells), bar, bar, {}, true, yieldStressOf(call, bar),
            severalOf(assembly, network)};
}

double unitOf(Swept over, Excited place, const Bar& bar)
{
    switch (over) {
        case Swept::amplitude:
            return amplitudeUnit(place, bar);
        case Swept::gap:
            return scales(bar).displacement;
        case Swept::frequency:
        case Swept::damping:
            return 1.0;
    }
    return 1.0;
}

const char* unitName(Swept over, Excited place)
{
    switch (over) {
        case Swept::frequency:
            return "omega_1";
        case Swept::amplitude:
            return amplitudeUnitName(place);
        case Swept::gap:
            return "m";
        case Swept::damping:
            return "-";
    }
    return "-";
}

double SweepPointOf::given() const
{
    return value.value * unitOf(over, place, bar);
}

std::optional<double> SweepPointOf::stress() const
{
    return bar.young ? std::optional(value.strain * scales(bar).strain * *bar.young) : std::nullopt;
}

std::vector<SweepPointOf> SweepAnswer::listed() const
{
    std::vector<SweepPointOf> all;
    for (const SweepPoint& point : points) {
        all.push_back({point, range.over, range.place, bar});
    }
    return all;
}

void SweepAnswer::require(const Network* network) const
{
    (void)valuesOf(range);
    if (network != nullptr) {
        NetworkSweep{*network, bar, range}.require();
    }
}

}  // namespace signorini::answers
