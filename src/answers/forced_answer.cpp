#include "forced_answer.hpp"

#include <fmt/format.h>

#include "stepped_bar.hpp"
#include "stops.hpp"

namespace signorini::answers {

namespace {

/// Adds the motions of the amplitude asked for, or the one of the least. \returns is there none?
bool lacksMotions(ForcedAnswer& answer, auto least, auto ofAmplitude)
{
    if (answer.set.status != Status::found) {
        return false;
    }
    const auto motions = answer.asked ? ofAmplitude(*answer.asked / answer.unit())
                                      : std::vector<ForcedMotion>{least()};
    for (const ForcedMotion& motion : motions) {
        answer.motions.push_back({motion, answer.bar});
    }
    return motions.empty();
}

}  // namespace

ForcedAnswer answerOf(ForcedSet set, const Scene& scene, std::optional<double> asked,
                      int derivative)
{
    ForcedAnswer answer{std::move(set), scene, unitsOf(scene), asked, {}};
    if (asked && derivative > 0) {
        const Schedule& schedule = answer.set.schedule;
        const double ratio = 4.0 * static_cast<double>(schedule.cells) *
                             static_cast<double>(answer.set.forcing.cycles) /
                             static_cast<double>(steps(schedule));
        answer.asked = displacementAt(ratio * (0.25 / scales(answer.bar).time), *asked, derivative);
    }
    const auto ofAmplitude = [&](double size) { return motionsOfAmplitude(answer.set, size); };
    if (lacksMotions(
            answer, [&] { return leastAmplitudeMotion(answer.set); }, ofAmplitude)) {
        answer.exclusion = exclusionOf(answer.set, *answer.asked / answer.unit());
    }
    return answer;
}

Question<ForcedAnswer> forcedAsked(const Call& call, const Scene& scene, const Schedule& schedule)
{
    const ForceOptions force(call);
    force.requireDamping();
    force.requirePlace();
    refuseIf(canRest(schedule.phases, schedule.stops) && !force.amplitude, "--amplitude", "missing",
             "numbers > 0 [N or m]: without a gap motions are as small as one likes");
    const Forcing forcing{*force.place, call.whole("--cycles").value_or(1), {}};
    ForcedLimits limits;
    call.read("--strain-limit", limits.strain);
    limits.strain /= scales(unitsOf(scene)).strain;
    return tried<ForcedAnswer>(call, steps(schedule), [=](const Watch&) {
        return answerOf(forcedMotions(schedule, force.damping(), forcing, limits, scene.segments),
                        scene, force.amplitude, force.derivative);
    });
}

Motion fieldOf(const ForcedMotion& motion, const std::vector<Segment>& segments)
{
    const std::vector<Segment> uniform{{.cells = motion.schedule.cells}};
    return {motion.state, motion.schedule, segments.empty() ? uniform : segments, motion.damping,
            motion.excitation};
}

void tryStability(ForcedMotion& motion, const std::vector<Segment>& segments, const Cancel& cancel)
{
    StabilityOptions options;
    options.cancel = cancel;
    options.segments = segments;
    motion.stability = stabilityOf(motion, options).stability;
}

void tryStability(ForcedAnswer& answer, const Cancel& cancel)
{
    for (ForcedMotionOf& motion : answer.motions) {
        tryStability(motion.value, answer.scene.segments, cancel);
    }
}

std::optional<std::optional<bool>> ForcedMotionOf::stable() const
{
    if (!isOfResponse && !value.stability) {
        return std::nullopt;
    }
    const Stability seen = value.stability.value_or(Stability::unclear);
    return std::optional<bool>(
        seen == Stability::unclear ? std::nullopt : std::optional(seen == Stability::attracts));
}

Status ForcedAnswer::status() const
{
    return !exclusion ? set.status : exclusion->isCertain ? Status::none : Status::undecided;
}

const char* ForcedAnswer::unitName() const
{
    return set.forcing.place == Excited::tip ? "N" : "m";
}

std::string ForcedAnswer::amplitudes() const
{
    const double most = set.mostAmplitude * unit();
    return fmt::format("{:.6g} … {} {}", set.leastAmplitude * unit(),
                       std::isfinite(most) ? fmt::format("{:.6g}", most) : "∞", unitName());
}

std::optional<std::string> ForcedAnswer::detail() const
{
    if (set.status != Status::found) {
        return set.detail.empty() ? std::nullopt : std::optional(set.detail);
    }
    if (!exclusion) {
        return std::nullopt;
    }
    return fmt::format(
        "the motions have amplitudes of {}{}", amplitudes(),
        exclusion->isCertain ? "" : "; that none has this one was computed, not proved");
}

std::optional<Reason> ForcedAnswer::reason() const
{
    return exclusion && exclusion->isCertain ? Reason::constraints : set.reason;
}

std::optional<double> ForcedAnswer::amplitude() const
{
    return motions.empty() ? asked : motions.back().amplitude();
}

std::optional<ForcedProof> proofOf(const ForcedAnswer& answer)
{
    if (answer.status() == Status::undecided || !answer.motions.empty()) {
        return std::nullopt;
    }
    const auto& exclusion = answer.exclusion;
    const auto proof = [&](const char* kind, bool isVerified, const auto& of) {
        return answer.set.isOfNetwork()
                   ? ForcedProof{kind, isVerified, of.conflict, "network", of.cuts}
                   : ForcedProof{kind, isVerified, of.conflict};
    };
    return exclusion ? proof("amplitude-range", exclusion->isCertain, *exclusion)
                     : proof("forced", isCertain(answer.set), answer.set);
}

}  // namespace signorini::answers
