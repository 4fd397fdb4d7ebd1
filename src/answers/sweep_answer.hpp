#pragma once
/// \file
/// What a bar settled on at the values of a sweep.

#include "call.hpp"
#include "parts.hpp"
#include "scene_answer.hpp"
#include "signorini/sweep.hpp"

namespace signorini::answers {

/// One value, and its units.
struct SweepPointOf {
    SweepPoint value;
    Swept over = Swept::frequency;
    Excited place = Excited::tip;
    Bar bar;

    /// What was varied, in its unit.
    [[nodiscard]] double given() const;
    /// Largest |stress| [Pa], where Young's modulus is known.
    [[nodiscard]] std::optional<double> stress() const;
};

/// What one unit of a sweep's numbers is: ω₁, N or m, m, -.
[[nodiscard]] double unitOf(Swept over, Excited place, const Bar& bar);
/// "omega_1", "N" or "m", "m", "-": the unit in which the ends of a range are given.
[[nodiscard]] const char* unitName(Swept over, Excited place);

/// The outcome of one call.
struct SweepAnswer {
    SweepRange range;
    Scene scene;
    Bar bar;  ///< what units mean: of the first material
    std::vector<SweepPoint> points;
    bool isComplete = true;
    std::optional<double> yieldStress = {};   ///< [Pa], the stress is compared with it
    std::optional<SeveralBars> several = {};  ///< in place of scene, if there is more than one bar

    [[nodiscard]] Ending status() const { return isComplete ? Ending::done : Ending::interrupted; }
    [[nodiscard]] std::vector<SweepPointOf> listed() const;
    /// Of the bar, or of what `network` is: \throws std::invalid_argument on a range that is none,
    /// before anything is followed or written.
    void require(const Network* network) const;
};

/// What is asked of a bar, or of what a network is: without points. Of several bars the bar of the
/// answer has its units, and as its first frequency that of the scene; `cells` where they do not
/// say. \throws std::invalid_argument on options that are missing or do not go together.
[[nodiscard]] SweepAnswer sweepAsked(const Call& call, const Scene& scene, std::int64_t cells);
[[nodiscard]] SweepAnswer sweepAsked(const Call& call, const Assembly& assembly,
                                     const Network& network, std::int64_t cells);

void describe(auto& d, Type<SweepPointOf>)
{
    using T = SweepPointOf;
    using P = SweepPoint;
    const auto ends = [](auto list, auto unit) {
        return [=](const T& p) {
            const auto& [low, high] = p.value.*list;
            return std::tuple(low * unit(p.bar), high * unit(p.bar));
        };
    };
    const auto ifSettled =
        ifThere([](const T& p) -> const auto& { return p.value.settling.settled; });
    d.record("SweepPoint", "What the bar does at one value of a sweep.");
    d.key("value", "omega_1, N, m or -", "Of what is varied.", &T::given);
    d.key("direction", "-", R"("up" or "down".)", ofValue(&P::direction));
    d.key("frequency", "Hz > 0", "Of the excitation.",
          [](const T& p) { return p.value.frequencyRatio / 4.0 / scales(p.bar).time; });
    d.key("periods", "- >= 1", "Of the excitation, after which all is as before.",
          ifSettled(&Settled::periods));
    d.key("residual", "- >= 0",
          "Bound of the distance to a motion that repeats itself, in its own size.",
          ifSettled(&Settled::residual));
    d.key("why", "-", "Where it has not settled, what it does instead.", [](const T& p) {
        return p.value.settling.settled ? std::nullopt : std::optional(p.value.settling.why);
    });
    d.key("watched", "- >= 1", "Periods of the excitation that were simulated.",
          ofValue(&P::watched));
    d.key("contacts", "- >= 0", "In a period of the excitation, on average.",
          ofValue(&P::meanContacts));
    d.key("contacts_range", "- >= 0", "Fewest and most in a period of the excitation.",
          ends(&P::contacts, [](const Bar&) { return std::int64_t{1}; }));
    d.key("impulse", "N s >= 0", "In a period of the excitation, on average.",
          ofValue(&P::meanImpulse, &impulseUnit));
    d.key("impulse_range", "N s >= 0", "Least and most in a period of the excitation.",
          ends(&P::impulse, &impulseUnit));
    d.key("impulses", "N s >= 0", "Of single contacts, in their order.", [](const T& p) {
        std::vector<double> all = p.value.impulses;
        for (double& one : all) {
            one *= impulseUnit(p.bar);
        }
        return all;
    });
    d.key("mean_force", "N >= 0", "Largest mean of the wall's push over the resolution.",
          ofValue(&P::meanForce, &forceUnit));
    d.key("tip_lowest", "m", "min u(L, t).",
          ofValue([](const P& p) { return p.tip[0]; }, &Scales::displacement));
    d.key("tip_highest", "m", "max u(L, t).",
          ofValue([](const P& p) { return p.tip[1]; }, &Scales::displacement));
    d.key("peak_strain", "- >= 0", "max |s| over all x and t.",
          ofValue(&P::strain, &Scales::strain));
    d.key("peak_stress", "Pa >= 0", "Largest |stress|, where Young's modulus is known.",
          &T::stress);
}

void describe(auto& d, Type<SweepAnswer>)
{
    using T = SweepAnswer;
    const auto range = partOf(&T::range);
    d.record("Sweep", "What a bar settles on while one number is varied, the state carried over.");
    d.key("status", "-", R"("done", or "interrupted".)", &T::status);
    describeSceneOrBars<T>(d);
    d.key("over", "-", R"(What is varied: "frequency", "amplitude", "gap" or "damping".)",
          range(&SweepRange::over));
    d.key(
        "damping", "-", "A dashpot, unless it is varied.",
        [](const T& s) {
            const bool isVaried = s.range.over == Swept::damping;
            return s.several  ? std::optional<std::optional<Of<Damping>>>()
                   : isVaried ? std::optional(std::optional<Of<Damping>>())
                              : std::optional(std::optional(Of<Damping>{s.range.damping, s.bar}));
        },
        When::any);
    d.key("force", "-", R"(What is excited: "tip" or "base".)", range(&SweepRange::place));
    d.key("amplitude", "N, m, m/s or m/s^2 > 0", "Of the excitation, unless it is varied.",
          [](const T& s) {
              return s.range.over == Swept::amplitude
                         ? std::nullopt
                         : std::optional(s.range.amplitude *
                                         amplitudeUnit(s.range.place, s.bar, s.range.derivative));
          });
    d.key("amplitude_of", "-",
          R"(Whose: "force", or of the base "displacement", "velocity" or "acceleration".)",
          [](const T& s) { return amplitudeOf(s.range.place, s.range.derivative); });
    d.key("cells", "- >= 1", "Steps of the excitation in L/c, nearly.",
          [](const T& s) { return static_cast<std::int64_t>(s.range.cells); });
    d.key("carried", "-", "Is the state carried over, or is each value a start at rest?",
          range(&SweepRange::isCarried));
    d.key("yield_stress", "Pa > 0", "The stress is compared with it.", &T::yieldStress);
    d.key("points", "-", "[SweepPoint, ...], each direction in the order in which it went.",
          &T::listed);
}

}  // namespace signorini::answers
