#pragma once
/// \file
/// What is said of a schedule that is damped and forced.

#include <functional>

#include "call.hpp"
#include "parts.hpp"
#include "proofs.hpp"
#include "signorini/response.hpp"

namespace signorini::answers {

/// One motion, what gives it units, and its segments.
struct ForcedMotionOf {
    ForcedMotion value;
    Bar bar;
    bool isOfResponse = false;  ///< or of one schedule: other keys
    std::vector<Segment> segments = {};

    /// [N] or [m], of the excitation.
    [[nodiscard]] double amplitude() const
    {
        return value.amplitude * amplitudeUnit(value.excitation.place, bar);
    }
    [[nodiscard]] Physical physical() const { return physicalOf(value.extremes, bar); }
    /// Does the bar stay near it? Always of a response, else if it was tried; nothing: unclear.
    [[nodiscard]] std::optional<std::optional<bool>> stable() const;
};

/// What is known of a schedule.
struct ForcedAnswer {
    ForcedSet set;
    Scene scene;
    Bar bar;                              ///< whose scales the answer has
    std::optional<double> asked;          ///< [N] or [m]
    std::vector<ForcedMotionOf> motions;  ///< by ascending impulse
    /// Where the set has motions, but none of the amplitude.
    std::optional<AmplitudeExclusion> exclusion = {};

    [[nodiscard]] Status status() const;
    /// What an amplitude of 1 is [N] or [m].
    [[nodiscard]] double unit() const { return amplitudeUnit(set.forcing.place, bar); }
    /// "N" or "m".
    [[nodiscard]] const char* unitName() const;
    /// "1 … 2 N", of the motions of the schedule.
    [[nodiscard]] std::string amplitudes() const;
    /// Why there is no motion, or no verdict.
    [[nodiscard]] std::optional<std::string> detail() const;
    [[nodiscard]] std::optional<Reason> reason() const;
    /// [N] or [m], of the last motion, or asked for.
    [[nodiscard]] std::optional<double> amplitude() const;
};

/// The motions of an amplitude [N] or [m], or of a derivative [m/s], [m/s^2]; if none is asked for
/// the one of the least.
[[nodiscard]] ForcedAnswer answerOf(ForcedSet set, const Scene& scene, std::optional<double> asked,
                                    int derivative = 0);

/// What a call asks of a schedule. \throws std::invalid_argument on options that are missing.
[[nodiscard]] Question<ForcedAnswer> forcedAsked(const Call& call, const Scene& scene,
                                                 const Schedule& schedule);

/// What a bar of such segments does over one period.
[[nodiscard]] Motion fieldOf(const ForcedMotion& motion, const std::vector<Segment>& segments);

/// Starts beside each motion.
void tryStability(ForcedAnswer& answer, const Cancel& cancel);
/// The same of one, of a bar of such segments.
void tryStability(ForcedMotion& motion, const std::vector<Segment>& segments, const Cancel& cancel);

/// Kind and undamped waves of a set.
struct ForcedSetPart {
    static constexpr bool isDictionary = true;
    ForcedKind kind = ForcedKind::empty;
    std::int64_t freeWaves = 0;
};

/// Why there is no motion, or none of an amplitude.
struct ForcedProof {
    static constexpr bool isDictionary = true;
    const char* kind;
    bool isVerified;
    std::vector<ForcedCondition> conditions;
    std::optional<const char*> rows = {};               ///< of a network
    std::optional<std::vector<EnergyFloor>> cuts = {};  ///< of a network
};
[[nodiscard]] std::optional<ForcedProof> proofOf(const ForcedAnswer& answer);

template <>
inline constexpr bool isDictionary<ForcedCondition> = true;

void describe(auto& d, Type<ForcedCondition>)
{
    d.record("ForcedCondition", "A condition on the motion in one step.");
    d.key("rule", "-", "What has to hold.", &ForcedCondition::rule);
    d.key("step", "- >= 0", "From the start of the first contact.", &ForcedCondition::step);
}

void describe(auto& d, Type<ForcedProof>)
{
    d.record("ForcedProof", "Conditions that contradict each other.");
    d.key("kind", "-", R"("forced", or "amplitude-range": of motions, but none of the amplitude.)",
          &ForcedProof::kind);
    d.key("verified", "-", "Verified independently, rounding included.", &ForcedProof::isVerified);
    d.key("conditions", "-", "With u(L, 0) = g they cannot all hold.", &ForcedProof::conditions);
    d.key("rows", "-",
          R"("network": of segments that differ, or a limit on strain beside a moving base.)",
          &ForcedProof::rows, When::any);
    d.key("cuts", "-", "Of these: multipliers that leave no excitation.", &ForcedProof::cuts,
          When::any);
}

void describe(auto& d, Type<ForcedSetPart>)
{
    d.record("ForcedSetPart", "What the motions of a schedule look like.");
    d.key("kind", "-", "Their shape.", &ForcedSetPart::kind);
    d.key("free_waves", "- >= 0", "Classes of steps whose waves nothing damps.",
          &ForcedSetPart::freeWaves);
}

void describe(auto& d, Type<ForcedMotionOf>)
{
    using T = ForcedMotionOf;
    const auto physical = partOf(&T::physical);
    d.record("ForcedMotion", "One forced, damped motion.");
    d.key("schedule", "-", "Contact and flight.", ofValue(&ForcedMotion::schedule));
    d.key("amplitude", "N or m >= 0", "Of the excitation.", &T::amplitude);
    d.key("phase", "rad", "Of the excitation at the start of contact.",
          ofValue(&ForcedMotion::phase));
    d.key("impulse", "N s >= 0", "In a period.", physical(&Physical::impulse));
    d.key("peak_force", "N >= 0", "Of the tip on the wall.", physical(&Physical::peakForce));
    d.key("tip_lowest", "m", "min u(L, t).", physical(&Physical::tipLowest));
    describePhysical(d, &T::physical);
    d.key("residual", "- >= 0", "The worst that was seen walking along it; relative.",
          ofValue(&ForcedMotion::residual));
    d.key("stable", "-", "Does the bar stay near it? Nothing: not tried, or unclear.", &T::stable,
          When::any);
    const auto ratio = [&d](const char* name, const char* sentence, double Extremes::*extreme) {
        d.key(
            name, "-", sentence, [extreme](const T& m) { return m.value.extremes.*extreme; },
            When::attribute);
    };
    ratio("impulse_ratio", "[EA g/c] a period.", &Extremes::impulse);
    ratio("peak_force_ratio", "[EA g/L]", &Extremes::peakForce);
    ratio("tip_lowest_ratio", "[g]", &Extremes::lowestTip);
}

/// What was asked.
void describeForcing(auto& d)
{
    using T = ForcedAnswer;
    const auto set = partOf(&T::set);
    const auto forcing = partOf([](const T& a) -> const auto& { return a.set.forcing; });
    d.key("status", "-", R"("found", "none" or "undecided".)", &T::status);
    d.key("cells", "- >= 1", "N.", [](const T& a) { return a.set.schedule.cells; });
    d.key("schedule", "-", "Asked about.", set(&ForcedSet::schedule));
    d.key("damping", "-", "A dashpot.", [](const T& a) {
        return Of<Damping>{a.set.damping, a.bar};
    });
    d.key("force", "-", "What is excited.", forcing(&Forcing::place));
    d.key("cycles", "- >= 1", "Of the excitation in a period.", forcing(&Forcing::cycles));
    d.key("period", "s > 0", "T.",
          [](const T& a) { return period(a.set.schedule) * scales(a.bar).time; });
    d.key("period_ratio", "L/c > 0", "c T/L.", [](const T& a) { return period(a.set.schedule); });
    d.key("frequency_ratio", "- > 0", "omega/omega_1 of the excitation.", [](const T& a) {
        return static_cast<double>(a.set.forcing.cycles) * frequencyRatio(a.set.schedule);
    });
}

void describe(auto& d, Type<ForcedAnswer>)
{
    using T = ForcedAnswer;
    d.record("ForcedResult", "What is known of a schedule that is damped and forced.");
    describeForcing(d);
    d.key("solution_set", "-", "What its motions look like.", [](const T& a) {
        return ForcedSetPart{a.set.kind, a.set.freeWaves};
    });
    d.key("strain_limit", "- > 0", "Of all motions, if any.",
          [](const T& a) { return known(a.set.limits.strain * scales(a.bar).strain); });
    d.key("amplitude", "N or m", "Of the last motion, or asked for.", &T::amplitude);
    d.key("amplitude_range", "N or m", "(least, most) that have a motion; nothing: without end.",
          [](const T& a) {
              const EnergyRange range{a.set.leastAmplitude * a.unit(),
                                      a.set.mostAmplitude * a.unit()};
              return a.set.status == Status::found ? std::optional(range) : std::nullopt;
          });
    d.key("phase", "rad", "Of the last motion.", [](const T& a) {
        return a.motions.empty() ? std::nullopt : std::optional(a.motions.back().value.phase);
    });
    d.key("motions", "-", "By ascending impulse.", &T::motions, When::found);
    d.key("reason", "-", "Why there is none.", &T::reason, When::none);
    d.key("certificate", "-", "The proof that there is none.", &proofOf, When::none);
    describeScene(d, &T::scene);
    d.key("detail", "-", "Why it is not decided, or which amplitudes have motions.", &T::detail,
          When::undecided);
}

}  // namespace signorini::answers
