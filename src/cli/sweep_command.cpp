#include "sweep_command.hpp"

#include "commands.hpp"
#include "excited_names.hpp"
#include "journal.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_options.hpp"
#include "scene_report.hpp"

namespace signorini::cli {

namespace {

/// The motions with one contact over the same frequencies, as many periods as there are values;
/// none where no period of the grid lies there, or the response does not know such a bar.
std::vector<FrequencyResponse> exactUnder(const SweepRange& sweep)
{
    ResponseRange range{.cells = static_cast<std::int64_t>(sweep.cells),
                        .damping = sweep.damping,
                        .place = sweep.place,
                        .amplitude = sweep.amplitude,
                        .derivative = sweep.derivative,
                        .leastFrequencyRatio = sweep.least,
                        .mostFrequencyRatio = sweep.most,
                        .stops = sweep.stops,
                        .segments = sweep.segments};
    std::vector<FrequencyResponse> exact;
    if (sweep.over != Swept::frequency || !(sweep.damping.rho() < 1.0)) {
        return exact;
    }
    std::vector<std::int64_t> steps;
    try {
        steps = stepsOf(range);
    } catch (const std::invalid_argument&) {
        return exact;  // the sweep has its own range, which is right
    }
    const auto most = 4 * static_cast<std::size_t>(sweep.points);
    for (std::size_t k = 0; k < steps.size(); k += 1 + steps.size() / most) {
        if (auto response = responseAt(range, steps[k])) {
            exact.push_back(std::move(*response));
        }
    }
    return exact;
}

}  // namespace

SweepCommand::SweepCommand(const Given& words)
    : given(words),
      common(words),
      force(words),
      frequency(words, "--frequency", "--hertz"),
      over(words.named("--over", sweptNames).value_or(Swept::frequency))
{
}

double SweepCommand::end(const char* option, double otherwise, const Bar& bar) const
{
    const std::string twin = fmt::format("{}-hertz", option);
    if (over == Swept::frequency) {
        return FrequencyOption(given, option, twin.c_str()).ratioFor(firstHertz(bar), otherwise);
    }
    refuseIf(given.has(twin.c_str()), twin, given.text(twin), "only with --over frequency");
    const char* unit = answers::unitName(over, force.place.value());
    const std::string text = given.text(option);
    refuseIf(text.empty(), option, "missing", fmt::format("numbers > 0 [{}]", unit));
    return parsePositive(option, text, unit) / answers::unitOf(over, force.place.value(), bar);
}

SweepRange SweepCommand::range(const Scene& scene, const Bar& bar) const
{
    force.requirePlace();
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
    SweepRange range{.over = over,
                     .least = end("--from", 0.5, bar),
                     .most = end("--to", 2.0, bar),
                     .points = given.whole("--points").value_or(101),
                     .periods = given.whole("--periods").value_or(1000),
                     .isCarried = !given.has("--rest"),
                     .cells = static_cast<double>(common.usualCells()),
                     .place = *force.place,
                     .frequencyRatio = frequency.ratioFor(firstHertz(bar), 1.0),
                     .damping = force.damping(),
                     .stops = stopsOf(scene),
                     .segments = scene.segments,
                     .resolution = given.number("--resolve").value_or(0.0) / scales(bar).time};
    range.amplitude = over == Swept::amplitude ? range.least : force.scaledAmplitude(bar);
    range.derivative = force.derivative;
    requireOrder(given, range.least, range.most);
    return range;
}

ExitStatus runSweep(const Given& given)
{
    return SweepCommand(given).run();
}

SweepAnswer SweepCommand::question() const
{
    const Scene scene = common.scene();
    const Bar bar = answers::unitsOf(scene);
    return {range(scene, bar), scene, bar, {}, true, yieldStressOf(given, bar)};
}

SweepAnswer SweepCommand::question(const Network& network) const
{
    common.requireOwnDamping();
    refuseIf(over == Swept::gap || over == Swept::damping, "--over", name(over),
             "frequency|amplitude of a scene of several bars");
    force.requirePlace();
    Faults faults;
    requireExcitable(faults, network, *force.place);
    faults.throwIfAny();
    const Assembly& assembly = common.assembly();
    const Bar bar = answers::unitsOf(assembly, network);
    return {range(bar, bar),
            bar,
            bar,
            {},
            true,
            yieldStressOf(given, bar),
            answers::severalOf(assembly, network)};
}

std::string SweepCommand::questionOf(const SweepAnswer& answer) const
{
    SweepAnswer asked = answer;
    asked.points.clear();
    return fmt::format("{} {} {} {} {} {} {} {} {}", wholeJsonOf(asked).dump(), common.sceneText,
                       common.gravity, asked.range.least, asked.range.most, asked.range.points,
                       asked.range.periods, asked.range.frequencyRatio, asked.range.resolution) +
           (given.has("--up") ? " up" : "") + (given.has("--down") ? " down" : "");
}

ExitStatus SweepCommand::run() const
{
    refuseIf(given.has("--resume") && !given.has("--csv"),
             "--resume: allowed only together with --csv");
    if (common.hasScene() && !barOf(common.assembly())) {
        const Network network = networkOf(common.assembly());
        return run(question(network), &network);
    }
    return run(question(), nullptr);
}

void SweepCommand::write(const SweepAnswer& answer, const Network* network, Outputs& outputs)
{
    const Bar& bar = answer.bar;
    outputs.put("--csv", writeSweepCsv, answer);
    outputs.draw("--figure", [&] {
        return sweepFigure(
            answer.points, answer.range, bar,
            network != nullptr ? std::vector<FrequencyResponse>{} : exactUnder(answer.range));
    });
    outputs.draw("--bifurcation",
                 [&] { return bifurcationFigure(answer.points, answer.range, bar); });
}

ExitStatus SweepCommand::run(SweepAnswer answer, const Network* network) const
{
    std::vector<SweepDirection> directions;
    if (given.has("--up") || !given.has("--down")) {
        directions.push_back(SweepDirection::up);
    }
    if (given.has("--down") || !given.has("--up")) {
        directions.push_back(SweepDirection::down);
    }
    Outputs outputs(given, {"--csv", "--figure", "--bifurcation"});
    answer.require(network);  // nothing is written of what is refused
    const auto [option, from] = typedEnd(given, "--from");
    if (over == Swept::frequency && answer.range.least >= answers::likelyHertz &&
        option == "--from" && !from.ends_with("Hz")) {
        common.say(fmt::format("--from {0} is {0} ω₁; {0} Hz are --from {0}Hz", from));
    }
    std::optional<Journal> journal;
    watched(common, "values", [&](const Cancel& cancel, const auto& show) {
        if (given.has("--csv")) {
            journal.emplace(given.text("--csv"), questionOf(answer), given.has("--resume"));
        }
        answer.points = sweepThrough(answer.range, network, answer.bar, directions,
                                     journal ? &*journal : nullptr, common.threads,
                                     {.cancel = cancel, .show = show});
    });
    answer.isComplete =
        answer.points.size() == directions.size() * static_cast<std::size_t>(answer.range.points);
    if (answer.isComplete) {
        write(answer, network, outputs);
        outputs.commit();
        if (journal) {
            journal->remove();
        }
    } else {
        common.say(fmt::format("interrupted; the list is not complete, and no file was written{}",
                               journal ? "; the same call with --resume continues" : ""));
    }
    network != nullptr ? report(common, answer, common.assembly(), asText(answer))
                       : report(common, answer, {}, force.ratio);
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
