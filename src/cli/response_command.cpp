#include "response_command.hpp"

#include <algorithm>
#include <cmath>

#include "exact_figure.hpp"
#include "exact_report.hpp"
#include "files.hpp"
#include "hints.hpp"
#include "interrupt.hpp"
#include "json.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "response_report.hpp"
#include "response_tables.hpp"
#include "share_work.hpp"
#include "signorini/figures.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

namespace {

std::optional<FrequencyResponse> responseOf(const ResponseRange& range, std::int64_t steps,
                                            bool wantsStability, const Cancel& cancel)
{
    std::optional<FrequencyResponse> response = responseAt(range, steps, cancel);
    if (!response) {
        return std::nullopt;
    }
    StabilityOptions options;
    options.cancel = cancel;
    options.segments = range.segments;
    for (ForcedMotion& motion : response->motions) {
        if (wantsStability) {
            motion.stability = stabilityOf(motion, options).stability;
        }
        motion.state = {};
        motion.excitation.values = {};
    }
    return isRequested(cancel) ? std::nullopt : std::move(response);
}

/// Shares the n of the range among threads; those that were done are kept.
void work(ResponseAnswer& answer, bool wantsStability, std::int64_t threads, const Cancel& cancel,
          const std::function<void(double, double)>& show)
{
    const std::vector<std::int64_t> steps = stepsOf(answer.range);
    std::vector<std::optional<FrequencyResponse>> responses(steps.size());
    // The largest n takes longest and goes first.
    const auto serve = [&](std::size_t at) {
        responses[at] = responseOf(answer.range, steps[at], wantsStability, cancel);
        return responses[at].has_value();
    };
    shareWork(steps.size(), threads, serve, show);
    for (std::optional<FrequencyResponse>& response : responses) {
        if (response) {
            answer.frequencies.push_back(std::move(*response));
        }
    }
    answer.isComplete = answer.frequencies.size() == steps.size();
}

/// Frequencies are in ω₁: where the grid has none so high, hertz may have been meant.
void requireFrequencies(const ResponseRange& range, const Bar& bar)
{
    constexpr double high = 10.0;
    const double unit = 4.0 * static_cast<double>(range.cells * range.cycles);
    const double first = std::max(std::ceil(unit / range.mostFrequencyRatio),
                                  2.0 * static_cast<double>(range.cycles));
    if (range.leastFrequencyRatio < high || first <= std::floor(unit / range.leastFrequencyRatio)) {
        return;
    }
    const double hertz = firstHertz(bar);
    refuse("--from", fmt::format("{}", range.leastFrequencyRatio),
           fmt::format("4NK/n for some whole n, n >= 2K [ω₁]; {0:.6g} looks like Hz: ω₁ is {1:.6g} "
                       "Hz ({2}), so it is --from {3:.6g}",
                       range.leastFrequencyRatio, hertz, sizeOf(bar),
                       range.leastFrequencyRatio / hertz));
}

}  // namespace

void ResponseCommand::addTo(CLI::App& command)
{
    force.addTo(command);
    from.addTo(command, "--from", "--from-hertz", "lowest frequency of the excitation, ω/ω₁ (0.5)");
    to.addTo(command, "--to", "--to-hertz", "highest frequency of the excitation, ω/ω₁ (2)");
    addWhole(command, "--cycles", 1, maxForcedSteps / 2, range.cycles, "K",
             "cycles of the excitation in a period of the motion (1)");
    addWhole(command, "--contacts", 1, 2, range.contacts, "K",
             "largest number of contacts in a period (1); 2: also every schedule with two, each at "
             "its own amplitude");
    addWord(command, "--band", "B",
            "largest relative deviation from the amplitude for motions with two contacts (0.05)",
            [this](const std::string& text) {
                band = parsePositive("--band", text, "-");
                if (*band >= 1.0) {
                    refuse("--band", text, "numbers > 0, below 1 [-]");
                }
            });
    addPositive(command, "--yield-stress", "Pa", yieldStress, "PA",
                "say whether the stress exceeds it (needs --young)");
    addFlag(command, "--exact", isExact,
            "the harmonic itself in place of a staircase, contacts of any times: all motions with "
            "one, and what a bar at rest settles on; curves with folds");
    addFlag(command, "--stability", wantsStability, "perturb each motion to test its stability");
    addFile(command, "--csv", csvFile, "write a row for each motion");
    addFigure(command, "--figure", figureFile, "draw impulse and tip against frequency");
    addFigure(command, "--map", mapFile,
              "draw how many motions there are, amplitude against frequency");
    addFile(command, "--map-csv", mapCsvFile,
            "write a row for each schedule that has motions of any amplitude");
    addFile(command, "--backbone-csv", backboneFile,
            "write the free motions of the modes, the curves behind the figure");
    common.addTo(command);
    addFooter(
        command,
        "Of the periods that are n steps of L/(N c): 4 N K/n is the frequency of the excitation in "
        "ω₁.\n--damping, --force and --amplitude are required.\n"
        "--csv: steps n, frequency_ratio ω/ω₁, frequency [Hz], touches (would the bar without a "
        "wall meet it?), linear_peak [m], then of each motion contact, free [steps], phase [rad], "
        "impulse [N s], peak_force [N], tip_lowest [m], stability, amplitude [N or m], "
        "second_contact, second_free [steps], stop, then undecided, the number of schedules at "
        "this "
        "frequency, and contact_time [s], approach_speed [m/s], peak_compression, peak_tension "
        "[-], peak_stress [Pa] of the motion; one row without them where there is no motion. "
        "Contact of all n steps: the tip never leaves the wall.\n"
        "--csv with --exact: steps, frequency_ratio, frequency, touches, linear_peak, motion (0, "
        "1, "
        "... at this frequency), contacts and cycles in its period, contact (0, 1, ...), begin, "
        "end [s], stop, release (pinned: ended by a wave front, or smooth), impulse [N s], "
        "peak_force [N], speed [m/s], phase [rad], growth of disturbances in a period, attracts "
        "(1, 0), residual.\n"
        "--map-csv: steps, frequency_ratio, frequency, contacts (0, 1 or 2), contact, free, "
        "second_contact, second_free, least_amplitude, most_amplitude [N or m]; no largest one: "
        "empty. Schedules in order of contact; an amplitude has as many motions as rows hold it.\n"
        "--backbone-csv: a4, b and family of the mode (t_c = a4 + b T), frequency_ratio and "
        "frequency of the excitation, period_ratio cT/L, energy_ratio E/E₁, impulse, peak_force, "
        "tip_lowest.");
}

ExitStatus ResponseCommand::run() const
{
    const Scene scene = common.scene();
    ResponseAnswer answer{range, scene, answers::unitsOf(scene), 0.0, {}};
    answer.range.cells = common.usualCells();
    answer.range.leastFrequencyRatio =
        from.ratioFor(firstHertz(answer.bar), range.leastFrequencyRatio);
    answer.range.mostFrequencyRatio = to.ratioFor(firstHertz(answer.bar), range.mostFrequencyRatio);
    if (answer.range.leastFrequencyRatio <= answer.range.mostFrequencyRatio) {
        requireFrequencies(answer.range, answer.bar);
    }
    if (!force.ratio || !(force.damping().rho() < 1.0)) {
        refuse("--damping", force.ratio ? fmt::format("{}", *force.ratio) : "missing",
               "numbers > 0 [-] with exp(-πζ) < 1");
    }
    if (!force.place) {
        refuse("--force", "missing", "tip|base");
    }
    if (!force.amplitude) {
        refuse("--amplitude", "missing", "finite numbers > 0 [N or m]");
    }
    if (answer.range.leastFrequencyRatio > answer.range.mostFrequencyRatio) {
        refuse("--from", fmt::format("{}", answer.range.leastFrequencyRatio),
               fmt::format("numbers up to --to = {}", answer.range.mostFrequencyRatio));
    }
    if (yieldStress && !answer.bar.young) {
        refuse("--yield-stress", fmt::format("{}", *yieldStress),
               "it only with --young, --density and --area, of a uniform bar");
    }
    answer.yieldStress = yieldStress;
    answer.amplitude = *force.amplitude;
    answer.range.damping = force.damping();
    answer.range.place = *force.place;
    answer.range.amplitude = force.scaledAmplitude(answer.bar);
    answer.range.derivative = force.derivative;
    if (force.derivative > 0 && !mapFile.empty()) {
        refuse("--map", mapFile,
               "it only with --amplitude: at each frequency another displacement is meant");
    }
    answer.range.stops = stopsOf(answer.scene);
    answer.range.segments = scene.segments;
    if (!isUniform(scene.segments) && !backboneFile.empty()) {
        throw std::invalid_argument(
            "--backbone-csv: allowed only for a uniform bar: modes of several segments are not "
            "known");
    }
    if (band && range.contacts < 2) {
        throw std::invalid_argument(
            fmt::format("--band = {}: allowed only together with --contacts 2", *band));
    }
    answer.range.band = band.value_or(range.band);
    (void)stepsOf(answer.range);
    if (isExact) {
        return runExact(answer.range, scene);
    }
    Outputs outputs({{"--csv", csvFile},
                     {"--map-csv", mapCsvFile},
                     {"--backbone-csv", backboneFile},
                     {"--figure", figureFile},
                     {"--map", mapFile}});
    {
        const Interrupt interrupt;
        Progress progress(!common.quiet, "frequencies");
        work(answer, wantsStability, common.threads, interrupt.cancel(),
             [&progress](double done, double total) { progress.show(done, total); });
    }
    if (!answer.isComplete && !common.quiet) {
        tell("signorini response: interrupted; the list is not complete\n");
    }
    if (answer.isComplete) {
        outputs.put("--csv", [&](const std::string& path) { writeResponseCsv(path, answer); });
        outputs.put("--map-csv",
                    [&](const std::string& path) { writeResponseMapCsv(path, answer); });
        outputs.put("--backbone-csv",
                    [&](const std::string& path) { writeBackboneCsv(path, answer); });
        outputs.put("--figure", [&](const std::string& path) {
            drawFigure(responseFigure(answer.frequencies, answer.range, answer.bar),
                       figureFormat(figureFile), path);
        });
        outputs.put("--map", [&](const std::string& path) {
            drawFigure(responseMapFigure(answer.frequencies, answer.range, answer.bar),
                       figureFormat(mapFile), path);
        });
        outputs.commit();
    }
    const Status status = answer.status();
    writeOut(common.wantsJson ? asJson(answer) : common.restated({}, force.ratio) + asText(answer));
    return exitStatusOf(status);
}

ExitStatus ResponseCommand::runExact(const ResponseRange& asked, const Scene& scene) const
{
    if (!isUniform(scene.segments) || force.derivative > 0 || range.contacts > 1 || band ||
        yieldStress || wantsStability || !mapFile.empty() || !mapCsvFile.empty() ||
        !backboneFile.empty()) {
        throw std::invalid_argument(
            "--exact: allowed with --amplitude, --cycles, --csv and --figure, of a uniform bar; "
            "it says how disturbances grow by itself");
    }
    answers::ExactAnswer answer{asked, scene, answers::unitsOf(scene), *force.amplitude, {}, {}};
    Outputs outputs({{"--csv", csvFile}, {"--figure", figureFile}});
    const std::vector<std::int64_t> steps = stepsOf(asked);
    std::vector<std::optional<ExactFrequency>> found(steps.size());
    {
        const Interrupt interrupt;
        Progress progress(!common.quiet, "frequencies");
        shareWork(
            steps.size(), common.threads,
            [&](std::size_t at) {
                found[at] = exactAt(asked, steps[at], interrupt.cancel());
                return found[at].has_value();
            },
            [&progress](double done, double total) { progress.show(done, total); });
        for (std::optional<ExactFrequency>& at : found) {
            if (at) {
                answer.frequencies.push_back(std::move(*at));
            }
        }
        answer.branches = exactBranches(asked, answer.frequencies, interrupt.cancel());
        answer.isComplete =
            answer.frequencies.size() == steps.size() && !isRequested(interrupt.cancel());
    }
    if (answer.isComplete) {
        outputs.put("--csv", [&](const std::string& path) { writeExactCsv(path, answer); });
        outputs.put("--figure", [&](const std::string& path) {
            drawFigure(exactFigure(answer.frequencies, answer.branches, asked, answer.bar),
                       figureFormat(figureFile), path);
        });
        outputs.commit();
    }
    writeOut(common.wantsJson ? asLine(wholeJsonOf(answer))
                              : common.restated({}, force.ratio) + asText(answer));
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
