#pragma once
/// \file
/// What `find` says of a schedule, and of a period.

#include <string>

#include "parts.hpp"
#include "proofs.hpp"
#include "signorini/response.hpp"
#include "watch.hpp"

namespace signorini::answers {

/// How a call has a motion looked for: --solver, --objective, --tolerance, --time-limit.
/// \throws std::invalid_argument on a --target without the objective nearest, or the other way.
[[nodiscard]] FindOptions searchAsked(const Call& call);
/// The same of one bar with what is demanded of it but a target.
/// \throws std::invalid_argument on demands that do not go together.
[[nodiscard]] FindOptions findAsked(const Call& call, const Scene& scene);
/// E/E_1 that --energy or --energy-ratio asks for, if one does. \throws std::invalid_argument where
/// that is not finite.
[[nodiscard]] std::optional<double> energyAsked(const Call& call, const Bar& bar);

/// What a motion was to be near.
struct Target {
    std::string how;  ///< it was read
    /// [-], of the motion, in the norm of the energy, relative to the target's.
    std::optional<double> distance;
};

/// Whether the bar stays near a motion, and what was tried.
struct StabilityReport {
    static constexpr bool isDictionary = true;
    Damping damping;
    std::int64_t periods = 0;  ///< waited
    StabilityResult result;
    Bar bar;  ///< whose units the report has
};

/// One disturbance, [m].
struct StabilityTrialOf {
    static constexpr bool isDictionary = true;
    StabilityTrial value;
    double unit = 1.0;  ///< [m]
};

/// An answer about one schedule.
struct FindAnswer {
    PeriodicResult result;
    std::optional<Target> target = {};
    std::vector<StabilityReport> stability = {};  ///< where it was asked for
    /// approachSpeeds() of a motion whose state is not kept.
    std::optional<std::vector<double>> keptSpeeds = {};

    /// Without a gap there is no E_1: nothing but the energy held gives a motion its size.
    [[nodiscard]] bool hasUnit() const { return result.scene.bar.gap != 0.0; }
    /// Why it is undecided, or what the proof says.
    [[nodiscard]] std::optional<std::string> detail() const;
    /// Why there is none.
    [[nodiscard]] std::optional<Reason> reason() const
    {
        return result.absence ? std::optional(result.absence->reason) : std::nullopt;
    }
    /// Of the uniform bar and one wall where no motion has the schedule: one that has some.
    [[nodiscard]] std::optional<Schedule> nearSchedule() const;
    /// E/E_1 of the whole set.
    [[nodiscard]] std::optional<EnergyRange> energies() const;
    /// [m/s], with which the tip met the stop before each phase of `canonical`, where n is at most
    /// Motion::maxKeptValues. O(n).
    [[nodiscard]] std::optional<std::vector<double>> approachSpeeds() const;
};

/// What was found, and if the options have a target, read as `how` says, how far it is.
[[nodiscard]] FindAnswer answerOf(PeriodicResult result, const FindOptions& options,
                                  const std::string& how = {});

/// Starts beside the motion, if there is one: as it is, and with a little damping.
void tryStability(FindAnswer& answer, const Cancel& cancel);

void describe(auto& d, Type<StabilityTrialOf>)
{
    using T = StabilityTrialOf;
    d.record("StabilityTrial", "One disturbance.");
    d.key("size", "-", "Largest change of a wave, relative.",
          [](const T& t) { return t.value.size; });
    d.key("start", "m >= 0", "Of displacements.",
          [](const T& t) { return t.value.start * t.unit; });
    d.key("end", "m >= 0", "Of displacements.", [](const T& t) { return t.value.end * t.unit; });
}

void describe(auto& d, Type<StabilityReport>)
{
    using T = StabilityReport;
    const auto result = partOf(&T::result);
    d.record("StabilityReport", "What became of disturbances.");
    d.key("damping", "-", "That was added.", [](const T& r) {
        return Of<Damping>{r.damping, r.bar};
    });
    d.key("verdict", "-", "Does the bar stay near the motion?",
          result(&StabilityResult::stability));
    d.key("periods", "- >= 1", "Waited.", &T::periods);
    d.key("drift", "m >= 0", "Of the undisturbed motion.",
          [](const T& r) { return r.result.drift * scales(r.bar).displacement; });
    d.key("contacts", "- >= 0", "Of the undisturbed motion.", result(&StabilityResult::contacts));
    d.key("trials", "-", "One for each disturbance.", [](const T& r) {
        std::vector<StabilityTrialOf> trials;
        for (const StabilityTrial& trial : r.result.trials) {
            trials.push_back({trial, scales(r.bar).displacement});
        }
        return trials;
    });
}

/// Where the motion is asked about, and what is known of all motions there.
void describeSet(auto& d)
{
    using T = FindAnswer;
    const auto result = partOf(&T::result);
    const auto ofSet = partOf([](const T& a) -> const auto& { return a.result.set; });
    d.key("status", "-", R"("found", "none" or "undecided".)", result(&PeriodicResult::status));
    d.key("cells", "- >= 1", "N.", [](const T& a) { return a.result.schedule.cells; });
    d.key("schedule", "-", "Asked about.", result(&PeriodicResult::schedule));
    d.key("period", "s > 0", "T.", result(&PeriodicResult::period));
    d.key("period_ratio", "L/c > 0", "c T/L.",
          [](const T& a) { return period(a.result.schedule); });
    d.key("frequency_ratio", "- > 0", "omega/omega_1.", result(&PeriodicResult::frequencyRatio));
    d.key("kernel_dimension", "- >= 0", "dim ker(W - 1), where the route knows it.",
          ofSet(&MotionSet::kernelDimension));
    describeSolutionSet(
        d, [](const T& a) -> const auto& { return a.result.set; });
    d.key("family", "-", "To which it belongs, of one contact that presses.",
          ofSet(&MotionSet::family));
}

void describe(auto& d, Type<FindAnswer>)
{
    using T = FindAnswer;
    using M = FoundMotion;
    const auto ofMotion = ifThere([](const T& a) -> const auto& { return a.result.motion; });
    const auto ofAbsence = ifThere([](const T& a) -> const auto& { return a.result.absence; });
    const auto ofTarget = ifThere(&T::target);
    d.record("Result", R"(What is known of a schedule.

`status` is "found", "none" (proved) or "undecided" (`detail` says why). Times, energies and forces
are in SI units, names that end in ``_ratio`` have none: energies in E_1, periods in L/c,
frequencies in omega_1.
)");
    describeScene(
        d, [](const T& a) -> const auto& { return a.result.scene; });
    describeSet(d);
    d.key("objective", "-", "Which motion of the set this is.",
          [](const T& a) { return a.result.how.objective; });
    d.key("contact", "-", "Is the wall pressed?", ofMotion(&M::contact), When::found);
    d.key("canonical_schedule", "-",
          "[(n_c, n_f), ...] with contact exactly where the wall is pressed.",
          ofMotion(&M::canonical), When::found);
    d.key("approach_speeds", "m/s >= 0",
          "Of the tip as it met the stop before each contact of canonical_schedule, of at most 2e7 "
          "steps.",
          &T::approachSpeeds, When::any);
    d.key("energy", "J > 0", "E.", ofMotion(&M::energy), When::found);
    d.key("energy_ratio", "- > 0", "E/E_1, where there is a gap.",
          [ratio = ofMotion(&M::energyRatio)](const T& a) {
              return a.hasUnit() ? ratio(a) : std::nullopt;
          });
    d.key("energy_ratio_range", "-",
          "(least, most) E/E_1 of the whole set; nothing where unbounded or unknown.",
          &T::energies);
    d.key("energy_section", "-", "The motions of the energy that was held.",
          [](const T& a) { return a.result.set.held; });
    d.key("physical", "-", "What can be measured, in SI units.", ofMotion(&M::physical),
          When::found);
    d.key("admissible", "-", "Is s > -1 everywhere?",
          ofMotion([](const M& m) { return m.physical.isAdmissible(); }), When::found);
    d.key("residuals", "-", "Recomputed independently of the solver.", ofMotion(&M::residuals),
          When::found);
    d.key("reason", "-", "Why there is no motion, in a word.", &T::reason, When::none);
    d.key("near_schedule", "-",
          "Of those with one contact that have motions the one that differs in the fewest steps.",
          &T::nearSchedule, When::any);
    d.key("certificate", "-", "The proof that there is none.", ofAbsence(&Absence::proof),
          When::none);
    describeRoute(
        d, [](const T& a) -> const auto& { return a.result.how; });
    d.key("repetitions", "- >= 1",
          "How often the motion repeats within the period of the schedule.",
          ofMotion(&M::repetitions), When::any);
    d.key("pressing_phases", "-", "For each phase: is the wall pressed at all?",
          ofMotion(&M::pressing), When::any);
    d.key("symmetric", "-", "Two stops: is the second half of the period the first, mirrored?",
          ofMotion(&M::isSymmetric), When::any);
    d.key("peak_strain", "-", "Deepest compression.",
          ofMotion([](const M& m) { return m.physical.peakCompression; }), When::any);
    d.key("target", "-", "How the target came onto the cells.", ofTarget(&Target::how), When::any);
    d.key("distance", "-", "To the target, relative, in the norm of the energy.",
          ofTarget(&Target::distance), When::any);
    d.key("detail", "-", "Why it is undecided, or what the proof says.", &T::detail,
          When::undecided);
    d.key(
        "stability", "-", "Of the motion when it is perturbed, without and with damping.",
        [](const T& a) { return a.stability.empty() ? std::nullopt : std::optional(a.stability); },
        When::any);
}

}  // namespace signorini::answers
