#include "forced_find.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>

#include "files.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

/// What is said of a schedule.
struct Answer {
    ForcedSet set;
    Bar bar;
    double amplitudeUnit = 1.0;         ///< [N] or [m]
    std::optional<double> asked;        ///< [N] or [m]
    std::vector<ForcedMotion> motions;  ///< by ascending impulse

    [[nodiscard]] Status status() const
    {
        return set.status == Status::found && motions.empty() ? Status::none : set.status;
    }
    [[nodiscard]] const char* unit() const { return set.forcing.place == Excited::tip ? "N" : "m"; }
    /// Why there is no motion, or no verdict.
    [[nodiscard]] std::string detail() const
    {
        if (set.status != Status::found) {
            return set.detail;
        }
        return motions.empty() ? fmt::format("the motions have amplitudes of {}", amplitudes())
                               : "";
    }
    [[nodiscard]] std::string amplitudes() const
    {
        const double most = set.mostAmplitude * amplitudeUnit;
        return fmt::format("{:.6g} … {} {}", set.leastAmplitude * amplitudeUnit,
                           std::isfinite(most) ? fmt::format("{:.6g}", most) : "∞", unit());
    }
};

std::string asText(const ForcedCondition& condition)
{
    return condition.isContact ? fmt::format("R ≥ 0 in step {}", condition.step)
                               : fmt::format("u(L) ≤ g after step {}", condition.step);
}

std::string asText(const Answer& answer)
{
    const ForcedSet& set = answer.set;
    Text text;
    print(text, "{:<12}{}, ζ = {}, {}{}, ω/ω₁ = {:.10g}\n", name(answer.status()),
          describe(set.schedule), set.damping.ratio,
          set.forcing.place == Excited::tip ? "force on the tip" : "moving base",
          set.forcing.cycles > 1 ? fmt::format(", {} cycles in a period", set.forcing.cycles) : "",
          static_cast<double>(set.forcing.cycles) * frequencyRatio(set.schedule));
    if (set.status == Status::found) {
        print(text, "set         {}, amplitudes {}\n", name(set.kind), answer.amplitudes());
    }
    for (const ForcedMotion& motion : answer.motions) {
        print(
            text,
            "motion      amplitude {:.6g} {}, phase {:.6g} rad, impulse {:.6g} N s, force at most "
            "{:.6g} N, tip down to {:.6g} m, residual {:.2g}\n",
            motion.amplitude * answer.amplitudeUnit, answer.unit(), motion.phase,
            motion.impulse * impulseUnit(answer.bar), motion.peakForce * forceUnit(answer.bar),
            motion.lowest * answer.bar.gap, motion.residual);
    }
    if (set.reason) {
        print(text, "reason      {}\n", name(*set.reason));
    }
    if (!set.conflict.empty()) {
        std::string rows;
        for (const ForcedCondition& condition : set.conflict) {
            rows += (rows.empty() ? "" : ", ") + asText(condition);
        }
        print(text, "proof       u(L, 0) = g contradicts {}; checked with enclosed numbers\n",
              rows);
    }
    if (!answer.detail().empty()) {
        print(text, "why         {}\n", answer.detail());
    }
    return fmt::to_string(text);
}

Json asJson(const ForcedMotion& motion, const Answer& answer)
{
    return {{"schedule", phasesAsJson(motion.schedule.phases)},
            {"amplitude", motion.amplitude * answer.amplitudeUnit},
            {"phase", motion.phase},
            {"impulse", motion.impulse * impulseUnit(answer.bar)},
            {"peak_force", motion.peakForce * forceUnit(answer.bar)},
            {"tip_lowest", motion.lowest * answer.bar.gap},
            {"residual", motion.residual}};
}

/// \pre there is no motion.
Json certificateAsJson(const ForcedSet& set)
{
    if (set.status == Status::undecided) {
        return nullptr;
    }
    if (set.status == Status::found) {
        return {{"kind", "amplitude-range"},
                {"verified", false},
                {"note", "the range is computed, not checked by other code"}};
    }
    Json rows = Json::array();
    for (const ForcedCondition& condition : set.conflict) {
        rows.push_back({{"contact", condition.isContact}, {"step", condition.step}});
    }
    return {{"kind", "forced"}, {"verified", isCertain(set)}, {"conditions", rows}};
}

std::string asJson(const Answer& answer)
{
    const ForcedSet& set = answer.set;
    Json json = newAnswer();
    json.update(Json{
        {"status", name(answer.status())},
        {"cells", set.schedule.cells},
        {"schedule", phasesAsJson(set.schedule.phases)},
        {"bar", barAsJson(answer.bar)},
        {"damping", dampingAsJson(set.damping, answer.bar)},
        {"force", name(set.forcing.place)},
        {"cycles", set.forcing.cycles},
        {"period", period(set.schedule) * scales(answer.bar).time},
        {"period_ratio", period(set.schedule)},
        {"frequency_ratio", static_cast<double>(set.forcing.cycles) * frequencyRatio(set.schedule)},
        {"solution_set", {{"kind", name(set.kind)}}},
        {"amplitude", answer.asked ? Json(*answer.asked) : Json()},
        {"amplitude_range", nullptr},
        {"phase", nullptr},
        {"motions", Json::array()},
        {"reason", set.reason ? Json(name(*set.reason)) : Json()},
        {"certificate", answer.motions.empty() ? certificateAsJson(set) : Json()}});
    if (set.status == Status::found) {
        // JSON has no infinity: a ray prints null.
        json["amplitude_range"] = {set.leastAmplitude * answer.amplitudeUnit,
                                   set.mostAmplitude * answer.amplitudeUnit};
    }
    for (const ForcedMotion& motion : answer.motions) {
        json["motions"].push_back(asJson(motion, answer));
    }
    if (!answer.motions.empty()) {
        json["amplitude"] = json["motions"].back()["amplitude"];
        json["phase"] = json["motions"].back()["phase"];
    } else if (set.status == Status::found) {
        json["reason"] = name(Reason::constraints);
    }
    if (const std::string detail = answer.detail(); !detail.empty()) {
        json["detail"] = detail;
    }
    return asLine(json);
}

}  // namespace

void ForcedFind::addTo(CLI::App& command)
{
    force.addTo(command);
    addWhole(command, "--cycles", 1, maxForcedSteps / 2, cycles, "K",
             "cycles of the excitation in a period of the motion (1)");
}

ExitStatus ForcedFind::answer(const Schedule& schedule, const CommonOptions& common,
                              const std::string& stateFile) const
{
    if (!force.ratio) {
        refuse("--damping", "missing", fmt::format("numbers 0..{} [-]", maxDampingRatio));
    }
    if (!force.place) {
        refuse("--force", "missing", "tip|base");
    }
    const Bar bar = common.bar();
    validateOutputs({{"--state", stateFile}});
    OutputFiles files;
    const std::string state = stage(files, {"--state", stateFile});

    Answer answer{forcedMotions(schedule, force.damping(), {*force.place, cycles}),
                  bar,
                  *force.place == Excited::tip ? forceUnit(bar) : bar.gap,
                  force.amplitude,
                  {}};
    if (answer.set.status == Status::found) {
        answer.motions = force.amplitude
                             ? motionsOfAmplitude(answer.set, force.scaledAmplitude(bar))
                             : std::vector<ForcedMotion>{leastAmplitudeMotion(answer.set)};
    }
    if (!answer.motions.empty() && !state.empty()) {
        forFile("--state", stateFile,
                [&] { writeStateCsv(state, answer.motions.back().state, bar); });
        files.commit();
    } else if (!state.empty() && !common.quiet) {
        tell("signorini find: no motion to write, so no file was written\n");
    }
    writeOut(common.wantsJson ? asJson(answer) : asText(answer));
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
