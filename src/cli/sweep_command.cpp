#include "sweep_command.hpp"

#include <cmath>

#include "excited_names.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "share_work.hpp"
#include "signorini/figures.hpp"
#include "sweep_report.hpp"

namespace signorini::cli {

namespace {

/// The unit in which the ends of a range are given.
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

void SweepCommand::addTo(CLI::App& command)
{
    addName(command, "--over", sweptNames, over, "what is varied (frequency)");
    force.addTo(command);
    frequency.addTo(command, "--frequency", "--hertz",
                    "frequency of the excitation, ω/ω₁, where another number is varied");
    addWord(command, "--from", "V", "lowest value: ω/ω₁ (0.5) or Hz, N or m, m, or a ratio",
            [this](const std::string& text) { from = text; });
    addWord(command, "--to", "V", "highest value (2 ω₁)",
            [this](const std::string& text) { to = text; });
    addPositive(command, "--from-hertz", "Hz", fromHertz, "F", "lowest frequency in Hz");
    addPositive(command, "--to-hertz", "Hz", toHertz, "F", "highest frequency in Hz");
    addWhole(command, "--points", 1, maxSweepPoints, points, "M",
             "how many values, at equal distances (101)");
    addFlag(command, "--up", goesUp, "in ascending order only (both)");
    addFlag(command, "--down", goesDown, "in descending order only (both)");
    addWhole(command, "--periods", 1, maxSweepPeriods, periods, "P",
             "how many periods of the excitation at each value, at most (1000)");
    addFlag(command, "--rest", startsAtRest,
            "start at rest at each value, in place of where the one before ended");
    addPositive(command, "--resolve", "s", resolution, "S",
                "merge contacts no further apart, and average forces over S (a step, L/(N c))");
    addPositive(command, "--yield-stress", "Pa", yieldStress, "PA",
                "say whether the stress exceeds it (needs --young)");
    addFile(command, "--csv", csvFile, "write a row for each value and direction");
    addFigure(command, "--figure", figureFile,
              "draw impulse and tip against the value, both directions; over the exact motions "
              "where the frequency is varied");
    addFigure(command, "--bifurcation", bifurcationFile,
              "draw the impulse of each contact against the value");
    common.addTo(command);
    addFooter(command,
              "At each value the bar is followed until it repeats itself after 1 ... 16 periods of "
              "the\nexcitation, or for --periods of them.\n"
              "--csv: value (ω/ω₁, N or m, m, -), frequency [Hz], direction, periods it repeats "
              "after\n(empty: it does not), residual, watched (periods), contacts, contacts_least, "
              "contacts_most,\nimpulse, impulse_least, impulse_most [N s] in a period of the "
              "excitation, mean_force [N] over\n--resolve, tip_lowest, tip_highest [m], "
              "peak_strain [-], peak_stress [Pa].");
}

double SweepCommand::end(const char* option, const std::string& text,
                         const std::optional<double>& hertz, double otherwise, const Bar& bar) const
{
    if (hertz && over != Swept::frequency) {
        refuse(fmt::format("{}-hertz", option), fmt::format("{}", *hertz),
               "it only with --over frequency");
    }
    if (hertz && !text.empty()) {
        refuse(option, text, fmt::format("it without {}-hertz: both are one frequency", option));
    }
    if (hertz) {
        return *hertz / firstHertz(bar);
    }
    if (text.empty() && over != Swept::frequency) {
        refuse(option, "missing",
               fmt::format("numbers > 0 [{}]", unitName(over, force.place.value())));
    }
    if (text.empty()) {
        return otherwise;
    }
    if (over == Swept::frequency && text.ends_with("Hz")) {
        return parsePositive(option, text, "Hz") / firstHertz(bar);
    }
    return parsePositive(option, text, unitName(over, force.place.value())) /
           answers::unitOf(over, force.place.value(), bar);
}

SweepRange SweepCommand::range(const Scene& scene, const Bar& bar) const
{
    if (!force.place) {
        refuse("--force", "missing", "tip|base");
    }
    if (force.amplitude.has_value() == (over == Swept::amplitude)) {
        refuse("--amplitude", force.amplitude ? fmt::format("{}", *force.amplitude) : "missing",
               force.amplitude ? "it only where another number is varied"
                               : "finite numbers > 0 [N or m]");
    }
    if (frequency.isGiven() == (over == Swept::frequency)) {
        refuse("--frequency", frequency.isGiven() ? "given" : "missing",
               over == Swept::frequency ? "it only where another number is varied: --over"
                                        : "numbers > 0 [ω₁]");
    }
    if (force.ratio && over == Swept::damping) {
        refuse("--damping", fmt::format("{}", *force.ratio),
               "it only where another number is varied");
    }
    if (over == Swept::gap && !(scene.bar.gap > 0.0)) {
        refuse("--gap", fmt::format("{}", scene.bar.gap), "numbers > 0 [m] with --over gap");
    }
    SweepRange range{.over = over,
                     .least = end("--from", from, fromHertz, 0.5, bar),
                     .most = end("--to", to, toHertz, 2.0, bar),
                     .points = points,
                     .periods = periods,
                     .isCarried = !startsAtRest,
                     .cells = static_cast<double>(common.usualCells()),
                     .place = *force.place,
                     .frequencyRatio = frequency.ratioFor(firstHertz(bar), 1.0),
                     .damping = force.damping(),
                     .stops = stopsOf(scene),
                     .segments = scene.segments,
                     .resolution = resolution.value_or(0.0) / scales(bar).time};
    range.amplitude = over == Swept::amplitude ? range.least : force.scaledAmplitude(bar);
    range.derivative = force.derivative;
    if (range.most < range.least) {
        refuse("--from", from.empty() ? fmt::format("{}", range.least) : from,
               fmt::format("numbers up to --to = {}", to.empty() ? "2" : to));
    }
    return range;
}

ExitStatus SweepCommand::run() const
{
    const Scene scene = common.scene();
    const Bar bar = answers::unitsOf(scene);
    if (yieldStress && !bar.young) {
        refuse("--yield-stress", fmt::format("{}", *yieldStress),
               "it only with --young, --density and --area, of a uniform bar");
    }
    SweepAnswer answer{range(scene, bar), scene, bar, {}, true, yieldStress};
    std::vector<SweepDirection> directions;
    if (goesUp || !goesDown) {
        directions.push_back(SweepDirection::up);
    }
    if (goesDown || !goesUp) {
        directions.push_back(SweepDirection::down);
    }
    Outputs outputs(
        {{"--csv", csvFile}, {"--figure", figureFile}, {"--bifurcation", bifurcationFile}});
    {
        const Interrupt interrupt;
        Progress progress(!common.quiet, "values");
        answer.points = sweep(
            answer.range, directions, interrupt.cancel(),
            [&progress](double done, double total) { progress.show(done, total); },
            [this](std::size_t count, const auto& serve) {
                shareWork(count, common.threads, serve, {});
            });
    }
    answer.isComplete =
        answer.points.size() == directions.size() * static_cast<std::size_t>(points);
    if (answer.isComplete) {
        outputs.put("--csv", [&](const std::string& path) { writeSweepCsv(path, answer); });
        outputs.put("--figure", [&](const std::string& path) {
            drawFigure(sweepFigure(answer.points, answer.range, bar, exactUnder(answer.range)),
                       figureFormat(figureFile), path);
        });
        outputs.put("--bifurcation", [&](const std::string& path) {
            drawFigure(bifurcationFigure(answer.points, answer.range, bar),
                       figureFormat(bifurcationFile), path);
        });
        outputs.commit();
    } else if (!common.quiet) {
        tell("signorini sweep: interrupted; the list is not complete, and no file was written\n");
    }
    writeOut(common.wantsJson ? asJson(answer) : common.restated({}, force.ratio) + asText(answer));
    return answer.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
