#include "commands.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "exact_figure.hpp"
#include "files.hpp"
#include "given.hpp"
#include "hints.hpp"
#include "progress.hpp"
#include "refined_response.hpp"
#include "reports.hpp"
#include "scene_options.hpp"
#include "share_work.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

namespace {

/// How one call goes through frequencies.
struct Worker {
    const CommonOptions& common;
    bool wantsStability;
    const Cancel& cancel;
    const std::function<void(double, double)>& show;
    bool isComplete = true;

    /// Shares the n of a range among threads; those that were done are kept.
    std::vector<FrequencyResponse> work(const ResponseRange& range)
    {
        const std::vector<std::int64_t> steps = stepsOf(range);
        auto timed = estimate(range, steps);
        // The largest n takes longest and goes first.
        std::vector<FrequencyResponse> all = shareOut(
            steps, common.threads,
            [&](std::int64_t n) {
                return timed && timed->steps == n ? std::move(timed) : make(range, n);
            },
            show);
        isComplete = isComplete && all.size() == steps.size();
        return all;
    }

    /// Without states.
    [[nodiscard]] std::optional<FrequencyResponse> make(const ResponseRange& range,
                                                        std::int64_t steps) const
    {
        auto response = answers::frequencyAt(range, steps, wantsStability, cancel);
        if (response) {
            for (ForcedMotion& motion : response->motions) {
                motion.state = {};
                motion.excitation.values = {};
            }
        }
        return response;
    }

    /// Times one of many, and says how long all will take, where that is long.
    /// \returns that one, if any.
    [[nodiscard]] std::optional<FrequencyResponse> estimate(
        const ResponseRange& range, const std::vector<std::int64_t>& steps) const
    {
        constexpr std::size_t many = 50;
        constexpr double isLong = 5.0;  // [s]
        if (common.quiet || steps.size() < many) {
            return {};
        }
        using Clock = std::chrono::steady_clock;
        const std::size_t middle = steps.size() / 2;
        const auto start = Clock::now();
        std::optional<FrequencyResponse> timed = make(range, steps[middle]);
        const double one = std::chrono::duration<double>(Clock::now() - start).count();
        const double order = range.contacts > 1 ? 4.0 : 2.0;  // of the cost in n
        double all = 0.0;
        for (const std::int64_t n : steps) {
            all += std::pow(static_cast<double>(n) / static_cast<double>(steps[middle]), order);
        }
        const double seconds = one * all / static_cast<double>(common.threads);
        if (seconds > isLong) {
            common.say(fmt::format("{} frequencies, about {} on {} thread{}{}", steps.size(),
                                   timeAsText(seconds), common.threads,
                                   common.threads > 1 ? "s" : "",
                                   common.choosesCells ? "" : "; --cells auto is quicker"));
        }
        return timed;
    }
};

/// The harmonic itself in place of a staircase.
ExitStatus runExact(const Given& given, const CommonOptions& common, const ForceOptions& force,
                    const ResponseRange& asked, const Scene& scene)
{
    constexpr std::array others{"--band", "--stability", "--map", "--map-csv", "--backbone-csv"};
    refuseIf(asked.contacts > 1, "--contacts", given.text("--contacts"),
             "1 with --exact of a uniform bar: what it settles on from rest, with any number of "
             "contacts, is listed anyway");
    if (force.derivative > 0 ||
        std::any_of(others.begin(), others.end(), [&](const char* o) { return given.has(o); })) {
        throw std::invalid_argument(
            "--exact: allowed with --amplitude, --cycles, --yield-stress, --csv and --figure; "
            "it says how disturbances grow by itself");
    }
    const auto forceSteps = given.whole("--force-steps");
    refuseIf(forceSteps && !given.has("--figure"), "--force-steps", given.text("--force-steps"),
             "only with --figure");
    answers::ExactAnswer answer{asked, scene, answers::unitsOf(scene), *force.amplitude, {}, {}};
    answer.yieldStress = yieldStressOf(given, answer.bar);
    Outputs outputs(given, {"--csv", "--figure"});
    const std::vector<std::int64_t> steps = stepsOf(asked);
    watched(common, "frequencies", [&](const answers::Watch& watch) {
        answer.frequencies = shareOut(
            steps, common.threads, [&](std::int64_t n) { return exactAt(asked, n, watch.cancel); },
            watch.show);
        answer.branches = exactBranches(asked, answer.frequencies, watch.cancel);
        answer.isComplete = answer.frequencies.size() == steps.size() && !isRequested(watch.cancel);
    });
    if (answer.isComplete) {
        outputs.put("--csv", writeExactCsv, answer);
        outputs.draw("--figure", [&] {
            ResponseRange coarse = asked;
            coarse.cells = forceSteps.value_or(0);
            return exactFigure(
                answer.frequencies, answer.branches, asked, answer.bar,
                forceSteps ? frequencyResponse(coarse) : std::vector<FrequencyResponse>());
        });
        outputs.commit();
    } else {
        common.say("interrupted; the list is not complete");
    }
    report(common, answer, {}, force.ratio);
    return exitStatusOf(answer.status());
}

/// What does not go together.
void requireTogether(const Given& given, const CommonOptions& common, const ForceOptions& force,
                     const ResponseRange& range)
{
    const bool hasMap = given.has("--map");
    refuseIf(force.derivative > 0 && hasMap, "--map", given.text("--map"),
             "only with --amplitude: at each frequency another displacement is meant");
    refuseIf(!isUniform(range.segments) && given.has("--backbone-csv"),
             "--backbone-csv: allowed of a uniform bar, whose modes are known");
    refuseIf(
        common.choosesCells && (!isUniform(range.segments) || hasMap || given.has("--map-csv")),
        "--cells auto: allowed for a uniform bar, and without --map and --map-csv, which "
        "have one grid");
}

/// Bars in a row, whose words say what is damped, or segments under the harmonic itself.
std::optional<Assembly> barsOf(const Given& given, const CommonOptions& common,
                               const ForceOptions& force)
{
    const auto isDash = [](const AssemblyPart& part) { return part.kind == PartKind::dash; };
    if (common.hasScene()) {
        const Assembly& assembly = common.assembly();
        const bool areBars =
            !barOf(assembly) ||
            (!force.ratio && std::any_of(assembly.parts.begin(), assembly.parts.end(), isDash));
        if (areBars) {
            common.requireOwnDamping();
            return assembly;
        }
    }
    const Scene scene = common.scene();
    if (!given.has("--exact") || isUniform(scene.segments)) {
        return std::nullopt;
    }
    return answers::assemblyOf(scene, common.usualCells(), force.damping());
}

}  // namespace

ExitStatus runResponse(const Given& given)
{
    const CommonOptions common(given);
    const ForceOptions force(given);
    if (const auto bars = barsOf(given, common, force)) {
        return respondInBars(given, common, force, *bars);
    }
    ResponseAnswer answer = answers::responseAsked(given, common.scene(), common.usualCells());
    requireTogether(given, common, force, answer.range);
    if (common.choosesCells) {
        answer.range.cells = coarseResponseCells;
    }
    (void)stepsOf(answer.range);
    if (given.has("--exact")) {
        return runExact(given, common, force, answer.range, answer.scene);
    }
    refuseIf(given.has("--force-steps"), "--force-steps", given.text("--force-steps"),
             "only with --exact: without it the force is a staircase of --cells steps");
    Outputs outputs(given, {"--csv", "--map-csv", "--backbone-csv", "--figure", "--map"});
    watched(common, "frequencies", [&](const answers::Watch& watch) {
        Worker worker{common, given.has("--stability"), watch.cancel, watch.show};
        const auto work = [&worker](const ResponseRange& one) { return worker.work(one); };
        answer.frequencies =
            common.choosesCells ? refinedResponse(answer.range, work) : work(answer.range);
        answer.isComplete = worker.isComplete;
    });
    if (answer.isComplete) {
        outputs.put("--csv", writeResponseCsv, answer);
        outputs.put("--map-csv", writeResponseMapCsv, answer);
        outputs.put("--backbone-csv", writeBackboneCsv, answer);
        outputs.draw("--figure",
                     [&] { return responseFigure(answer.frequencies, answer.range, answer.bar); });
        outputs.draw("--map", [&] {
            return responseMapFigure(answer.frequencies, answer.range, answer.bar);
        });
        outputs.commit();
    } else {
        common.say("interrupted; the list is not complete");
    }
    report(common, answer, {}, force.ratio);
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
