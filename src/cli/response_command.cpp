#include "response_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "signorini/figures.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

/// The outcome of one call.
struct Answer {
    ResponseRange range;
    Bar bar;
    double amplitude = 0.0;                      ///< [N] or [m]
    std::vector<FrequencyResponse> frequencies;  ///< motions without their states
    bool isComplete = true;

    [[nodiscard]] std::size_t motions() const
    {
        std::size_t count = 0;
        for (const FrequencyResponse& response : frequencies) {
            count += response.motions.size();
        }
        return count;
    }
    [[nodiscard]] std::int64_t undecided() const
    {
        std::int64_t count = 0;
        for (const FrequencyResponse& response : frequencies) {
            count += response.undecided;
        }
        return count;
    }
};

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
void work(Answer& answer, bool wantsStability, std::int64_t threads, const Cancel& cancel,
          const std::function<void(double, double)>& show)
{
    const std::vector<std::int64_t> steps = stepsOf(answer.range);
    std::vector<std::optional<FrequencyResponse>> responses(steps.size());
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> isOver = false;
    std::size_t done = 0;
    std::exception_ptr trouble;
    std::mutex mutex;
    const auto serve = [&] {
        try {
            for (std::size_t k = next++; k < steps.size() && !isOver; k = next++) {
                // The largest n takes longest and goes first.
                const std::size_t at = steps.size() - 1 - k;
                responses[at] = responseOf(answer.range, steps[at], wantsStability, cancel);
                isOver = isOver || !responses[at];
                const std::lock_guard<std::mutex> lock(mutex);
                show(static_cast<double>(++done), static_cast<double>(steps.size()));
            }
        } catch (...) {
            isOver = true;
            const std::lock_guard<std::mutex> lock(mutex);
            trouble = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    for (std::int64_t k = 1; k < std::min(threads, static_cast<std::int64_t>(steps.size())); ++k) {
        others.emplace_back(serve);
    }
    serve();
    for (std::thread& other : others) {
        other.join();
    }
    if (trouble) {
        std::rethrow_exception(trouble);
    }
    for (std::optional<FrequencyResponse>& response : responses) {
        if (response) {
            answer.frequencies.push_back(std::move(*response));
        }
    }
    answer.isComplete = answer.frequencies.size() == steps.size();
}

std::string_view word(const ForcedMotion& motion)
{
    return motion.stability ? name(*motion.stability) : std::string_view();
}

std::string asText(const Answer& answer)
{
    const ResponseRange& range = answer.range;
    Text text;
    print(text,
          "{} motions with one contact phase at {} frequencies: N = {}, ζ = {}, {} of amplitude {} "
          "{}{}{}\n",
          answer.motions(), answer.frequencies.size(), range.cells, range.damping.ratio,
          range.place == Excited::tip ? "force on the tip" : "base", answer.amplitude,
          range.place == Excited::tip ? "N" : "m",
          range.cycles > 1 ? fmt::format(", {} cycles in a period", range.cycles) : "",
          answer.isComplete ? "" : ": interrupted, the list is not complete");
    if (answer.undecided() > 0) {
        print(text, "undecided   {} schedules\n", answer.undecided());
    }
    print(text, "\n{:<8}{:<12}{:<14}{:<14}{:<12}{:<14}{:<14}{}\n", "n", "ω/ω₁", "linear u/g",
          "(n_c, n_f)", "phase", "impulse N s", "peak N", "stability");
    for (const FrequencyResponse& response : answer.frequencies) {
        const std::string begin = fmt::format("{:<8}{:<12.6g}{:<14.6g}", response.steps,
                                              response.frequencyRatio, response.linearPeak);
        if (response.motions.empty()) {
            print(text, "{}{}\n", begin, response.touches ? "none" : "none: stays clear");
        }
        for (const ForcedMotion& motion : response.motions) {
            const Phase& phase = motion.schedule.phases.front();
            print(text, "{}{:<14}{:<12.5f}{:<14.6g}{:<14.6g}{}\n", begin,
                  fmt::format("({}, {})", phase.contact, phase.free), motion.phase,
                  motion.impulse * impulseUnit(answer.bar),
                  motion.peakForce * forceUnit(answer.bar), word(motion));
        }
    }
    return fmt::to_string(text);
}

Json asJson(const FrequencyResponse& response, const Bar& bar)
{
    const Scales unit = scales(bar);
    Json json{{"steps", response.steps},
              {"frequency_ratio", response.frequencyRatio},
              {"frequency", response.frequencyRatio / 4.0 / unit.time},
              {"touches", response.touches},
              {"linear_peak", response.linearPeak * unit.displacement},
              {"undecided", response.undecided},
              {"motions", Json::array()}};
    for (const ForcedMotion& motion : response.motions) {
        Json one{{"schedule", phasesAsJson(motion.schedule.phases)},
                 {"phase", motion.phase},
                 {"impulse", motion.impulse * impulseUnit(bar)},
                 {"peak_force", motion.peakForce * forceUnit(bar)},
                 {"tip_lowest", motion.lowest * unit.displacement},
                 {"residual", motion.residual},
                 {"stable", nullptr}};
        if (motion.stability.value_or(Stability::unclear) != Stability::unclear) {
            one["stable"] = *motion.stability == Stability::attracts;
        }
        json["motions"].push_back(std::move(one));
    }
    return json;
}

std::string asJson(const Answer& answer, Status status)
{
    const ResponseRange& range = answer.range;
    Json json = newAnswer();
    json.update(
        Json{{"status", name(status)},
             {"cells", range.cells},
             {"bar", barAsJson(answer.bar)},
             {"damping", dampingAsJson(range.damping, answer.bar)},
             {"force", name(range.place)},
             {"amplitude", answer.amplitude},
             {"cycles", range.cycles},
             {"frequency_ratio_range", {range.leastFrequencyRatio, range.mostFrequencyRatio}},
             {"complete", answer.isComplete},
             {"frequencies", Json::array()}});
    for (const FrequencyResponse& response : answer.frequencies) {
        json["frequencies"].push_back(asJson(response, answer.bar));
    }
    return asLine(json);
}

/// A row for each motion, and one for each frequency without any.
void writeCsv(const std::string& path, const Answer& answer)
{
    const Scales unit = scales(answer.bar);
    TextFile file(path);
    file.write(
        "steps,frequency_ratio,frequency,touches,linear_peak,contact,free,phase,impulse,"
        "peak_force,tip_lowest,stability\n");
    for (const FrequencyResponse& response : answer.frequencies) {
        const std::string begin =
            fmt::format("{},{},{},{},{}", response.steps, response.frequencyRatio,
                        response.frequencyRatio / 4.0 / unit.time, response.touches ? 1 : 0,
                        response.linearPeak * unit.displacement);
        if (response.motions.empty()) {
            file.write(begin + ",,,,,,,\n");
        }
        for (const ForcedMotion& motion : response.motions) {
            const Phase& phase = motion.schedule.phases.front();
            file.write(fmt::format("{},{},{},{},{},{},{},{}\n", begin, phase.contact, phase.free,
                                   motion.phase, motion.impulse * impulseUnit(answer.bar),
                                   motion.peakForce * forceUnit(answer.bar),
                                   motion.lowest * unit.displacement, word(motion)));
        }
    }
    file.close();
}

Status statusOf(const Answer& answer)
{
    const bool isEmpty = answer.motions() == 0 && answer.undecided() > 0;
    return answer.isComplete && !isEmpty ? Status::found : Status::undecided;
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
    command.add_option("--csv", csvFile, "write a row for each motion")->type_name("FILE.csv");
    command
        .add_option("--figure", figureFile,
                    "draw impulse and tip against frequency (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
    command.footer(
        "Of the periods that are n steps of L/(N c): 4 N K/n is the frequency of the excitation in "
        "ω₁.\n--damping, --force and --amplitude are required.");
}

ExitStatus ResponseCommand::run() const
{
    Answer answer{range, common.bar(), 0.0, {}};
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
    answer.range.amplitude = force.scaledAmplitude(answer.bar);
    (void)stepsOf(answer.range);
    if (!figureFile.empty()) {
        (void)figureFormat(figureFile);
    }
    const OutputOption csvOption{"--csv", csvFile};
    const OutputOption figureOption{"--figure", figureFile};
    validateOutputs({csvOption, figureOption});
    OutputFiles files;
    const std::string csv = stage(files, csvOption);
    const std::string figure = stage(files, figureOption);
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
        if (!csv.empty()) {
            forFile("--csv", csvFile, [&] { writeCsv(csv, answer); });
        }
        if (!figure.empty()) {
            forFile("--figure", figureFile, [&] {
                drawResponse(answer.frequencies, answer.range, figureFormat(figureFile), figure);
            });
        }
        files.commit();
    }
    const Status status = statusOf(answer);
    writeOut(common.wantsJson ? asJson(answer, status) : asText(answer));
    return exitStatusOf(status);
}

}  // namespace signorini::cli
