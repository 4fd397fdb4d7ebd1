#include "forced_report.hpp"

#include <cmath>

#include "force_report.hpp"
#include "report.hpp"
#include "stepped_bar.hpp"
#include "stepped_forced.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

const char* unitOf(const ForcedAnswer& answer)
{
    return answer.set.forcing.place == Excited::tip ? "N" : "m";
}

std::string amplitudesOf(const ForcedAnswer& answer)
{
    const double most = answer.set.mostAmplitude * answer.amplitudeUnit();
    return fmt::format("{:.6g} … {} {}", answer.set.leastAmplitude * answer.amplitudeUnit(),
                       std::isfinite(most) ? fmt::format("{:.6g}", most) : "∞", unitOf(answer));
}

/// Why there is no motion, or no verdict.
std::string detailOf(const ForcedAnswer& answer)
{
    if (answer.set.status != Status::found) {
        return answer.set.detail;
    }
    if (!answer.exclusion) {
        return {};
    }
    return fmt::format(
        "the motions have amplitudes of {}{}", amplitudesOf(answer),
        answer.exclusion->isCertain ? "" : "; that none has this one was computed, not proved");
}

std::string asText(const ForcedCondition& condition)
{
    switch (condition.rule) {
        case ForcedRule::gap:
            return "u(L) at the stop at t = 0";
        case ForcedRule::pressure:
            return fmt::format("a push in step {}", condition.step);
        case ForcedRule::held:
            return fmt::format("a push on average in step {} and every 2N later", condition.step);
        case ForcedRule::secondStop:
            return fmt::format("u(L) ≥ −h after step {}", condition.step);
        case ForcedRule::penetration:
            return fmt::format("u(L) ≤ g after step {}", condition.step);
        case ForcedRule::closure:
            return fmt::format("u(L) at the stop after step {}", condition.step);
        case ForcedRule::work:
            return fmt::format("no work in step {} and every 2N later", condition.step);
        case ForcedRule::strain:
            return fmt::format("the strain limit in step {}", condition.step);
    }
    return {};
}

std::string asText(const std::vector<ForcedCondition>& conflict)
{
    std::string rows;
    for (const ForcedCondition& condition : conflict) {
        rows += (rows.empty() ? "" : ", ") + asText(condition);
    }
    return rows;
}

Json asJson(const std::vector<ForcedCondition>& conflict)
{
    Json rows = Json::array();
    for (const ForcedCondition& condition : conflict) {
        rows.push_back({{"rule", name(condition.rule)}, {"step", condition.step}});
    }
    return rows;
}

/// \pre there is no motion.
Json certificateAsJson(const ForcedAnswer& answer)
{
    if (answer.status() == Status::undecided) {
        return nullptr;
    }
    if (answer.exclusion) {
        return {{"kind", "amplitude-range"},
                {"verified", answer.exclusion->isCertain},
                {"conditions", asJson(answer.exclusion->conflict)}};
    }
    return {{"kind", "forced"},
            {"verified", isCertain(answer.set)},
            {"conditions", asJson(answer.set.conflict)}};
}

}  // namespace

ForcedAnswer answerOf(ForcedSet set, const Scene& scene, std::optional<double> asked)
{
    ForcedAnswer answer{std::move(set), scene, scene.bar, asked, {}};
    if (answer.set.status != Status::found) {
        return answer;
    }
    if (!asked) {
        answer.motions = {leastAmplitudeMotion(answer.set)};
        return answer;
    }
    const double amplitude = *asked / answer.amplitudeUnit();
    answer.motions = motionsOfAmplitude(answer.set, amplitude);
    if (answer.motions.empty()) {
        answer.exclusion = exclusionOf(answer.set, amplitude);
    }
    return answer;
}

ForcedAnswer answerOf(const SteppedForced& forced, const Scene& scene, std::optional<double> asked)
{
    Bar bar = firstMaterial(scene);
    bar.young.reset();  // it is known of the first segment only
    ForcedAnswer answer{forced.set(), scene, bar, asked, {}};
    if (answer.set.status != Status::found) {
        return answer;
    }
    if (!asked) {
        answer.motions = {forced.leastAmplitude()};
        return answer;
    }
    const double amplitude = *asked / answer.amplitudeUnit();
    answer.motions = forced.ofAmplitude(amplitude);
    if (answer.motions.empty()) {
        answer.exclusion = AmplitudeExclusion{amplitude, {}, false};
    }
    return answer;
}

std::string asText(const ForcedAnswer& answer)
{
    const ForcedSet& set = answer.set;
    Text text;
    print(text, "{:<12}{}, ζ = {}, {}{}, ω/ω₁ = {:.10g}\n", name(answer.status()),
          describe(set.schedule), set.damping.ratio,
          set.forcing.place == Excited::tip ? "force on the tip" : "moving base",
          set.forcing.cycles > 1 ? fmt::format(", {} cycles in a period", set.forcing.cycles) : "",
          static_cast<double>(set.forcing.cycles) * frequencyRatio(set.schedule));
    if (set.status == Status::found) {
        print(text, "set         {}, amplitudes {}\n", name(set.kind), amplitudesOf(answer));
    }
    for (const ForcedMotion& motion : answer.motions) {
        print(text, "motion      amplitude {:.6g} {}, phase {:.6g} rad, residual {:.2g}\n{}",
              motion.amplitude * answer.amplitudeUnit(), unitOf(answer), motion.phase,
              motion.residual, asText(physicalOf(motion.extremes, answer.bar)));
    }
    if (set.reason) {
        print(text, "reason      {}\n", name(*set.reason));
    }
    if (!set.conflict.empty()) {
        print(text, "proof       {} contradicts {}; checked with enclosed numbers\n",
              asText({ForcedRule::gap, 0}), asText(set.conflict));
    }
    if (!detailOf(answer).empty()) {
        print(text, "why         {}\n", detailOf(answer));
    }
    return fmt::to_string(text);
}

std::string asJson(const ForcedAnswer& answer)
{
    const ForcedSet& set = answer.set;
    const double strainLimit = set.limits.strain * scales(answer.bar).strain;
    Json json = newAnswer();
    json.update(Json{
        {"status", name(answer.status())},
        {"cells", set.schedule.cells},
        {"schedule", phasesAsJson(set.schedule.phases)},
        {"damping", dampingAsJson(set.damping, answer.bar)},
        {"force", name(set.forcing.place)},
        {"cycles", set.forcing.cycles},
        {"period", period(set.schedule) * scales(answer.bar).time},
        {"period_ratio", period(set.schedule)},
        {"frequency_ratio", static_cast<double>(set.forcing.cycles) * frequencyRatio(set.schedule)},
        {"solution_set", {{"kind", name(set.kind)}, {"free_waves", set.freeWaves}}},
        {"strain_limit", std::isfinite(strainLimit) ? Json(strainLimit) : Json()},
        {"amplitude", answer.asked ? Json(*answer.asked) : Json()},
        {"amplitude_range", nullptr},
        {"phase", nullptr},
        {"motions", Json::array()},
        {"reason", set.reason ? Json(name(*set.reason)) : Json()},
        {"certificate", answer.motions.empty() ? certificateAsJson(answer) : Json()}});
    addScene(answer.scene, json);
    if (set.status == Status::found) {
        // JSON has no infinity: a ray prints null.
        json["amplitude_range"] = {set.leastAmplitude * answer.amplitudeUnit(),
                                   set.mostAmplitude * answer.amplitudeUnit()};
    }
    for (const ForcedMotion& motion : answer.motions) {
        json["motions"].push_back(asJson(motion, answer.bar));
    }
    if (!answer.motions.empty()) {
        json["amplitude"] = json["motions"].back()["amplitude"];
        json["phase"] = json["motions"].back()["phase"];
    } else if (answer.exclusion && answer.exclusion->isCertain) {
        json["reason"] = name(Reason::constraints);
    }
    if (const std::string detail = detailOf(answer); !detail.empty()) {
        json["detail"] = detail;
    }
    return asLine(json);
}

}  // namespace signorini::cli
