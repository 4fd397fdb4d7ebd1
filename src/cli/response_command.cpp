#include "response_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "response_report.hpp"
#include "share_work.hpp"
#include "signorini/figures.hpp"

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

}  // namespace

void ResponseCommand::addTo(CLI::App& command)
{
    force.addTo(command);
    addPositive(command, "--from", "omega_1", range.leastFrequencyRatio, "W",
                "lowest frequency of the excitation, ω/ω₁ (0.5)");
    addPositive(command, "--to", "omega_1", range.mostFrequencyRatio, "W",
                "highest frequency of the excitation, ω/ω₁ (2)");
    addWhole(command, "--cycles", 1, maxForcedSteps / 2, range.cycles, "K",
             "cycles of the excitation in a period of the motion (1)");
    command.add_flag("--stability", wantsStability,
                     "start beside each motion and see whether the bar comes back");
    addFile(command, "--csv", csvFile, "write a row for each motion");
    addFigure(command, "--figure", figureFile, "draw impulse and tip against frequency");
    addFigure(command, "--map", mapFile,
              "draw how many motions there are, amplitude against frequency");
    common.addTo(command);
    command.footer(
        "Of the periods that are n steps of L/(N c): 4 N K/n is the frequency of the excitation in "
        "ω₁.\n--damping, --force and --amplitude are required.");
}

ExitStatus ResponseCommand::run() const
{
    ResponseAnswer answer{range, common.sceneOfOneBar(), 0.0, {}};
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
    if (range.leastFrequencyRatio > range.mostFrequencyRatio) {
        refuse("--from", fmt::format("{}", range.leastFrequencyRatio),
               fmt::format("numbers up to --to = {}", range.mostFrequencyRatio));
    }
    answer.amplitude = *force.amplitude;
    answer.range.cells = common.usualCells();
    answer.range.damping = force.damping();
    answer.range.place = *force.place;
    answer.range.amplitude = force.scaledAmplitude(answer.scene.bar);
    answer.range.stops = stopsOf(answer.scene);
    (void)stepsOf(answer.range);
    Outputs outputs({{"--csv", csvFile}, {"--figure", figureFile}, {"--map", mapFile}});
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
        outputs.put("--figure", [&](const std::string& path) {
            drawResponse(answer.frequencies, answer.range, figureFormat(figureFile), path);
        });
        outputs.put("--map", [&](const std::string& path) {
            drawResponseMap(answer.frequencies, answer.range, figureFormat(mapFile), path);
        });
        outputs.commit();
    }
    const Status status = answer.status();
    writeOut(common.wantsJson ? asJson(answer) : asText(answer));
    return exitStatusOf(status);
}

}  // namespace signorini::cli
