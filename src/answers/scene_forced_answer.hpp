#pragma once
/// \file
/// What is known of a schedule of bars in a row that a harmonic excites.

#include "network_forced.hpp"
#include "scene_find_answer.hpp"

namespace signorini::answers {

/// A forced motion, and what was seen of it.
struct SceneForcedMotion {
    double amplitude = 0.0;  ///< [N] or [m]
    double phase = 0.0;      ///< [rad]
    NetworkClaim claim;
    NetworkResiduals residuals;
    std::vector<ContactInPeriod> contacts;
    ScenePhysical physical;
    std::optional<SceneStability> stability = {};  ///< where it was asked for
};

/// What proves that there is none, of any amplitude or of this one.
struct SceneCuts {
    static constexpr bool isDictionary = true;
    bool isOfAmplitude = false;
    std::vector<EnergyFloor> cuts;
};

/// Of a schedule whose driven nodes, or shaken clamps, are excited.
struct SceneForcedAnswer {
    SceneSchedule schedule;
    Forcing forcing;
    std::optional<double> asked;  ///< a displacement of the base [N or m]
    ForcedKind kind = ForcedKind::empty;
    std::int64_t freeWaves = 0;
    std::optional<std::array<double, 2>> range;  ///< of amplitudes [N or m]; no end: infinite
    Status decided = Status::undecided;
    std::string detail;
    std::optional<SceneCuts> cuts;
    std::vector<SceneForcedMotion> motions;

    [[nodiscard]] Status status() const { return decided; }
    [[nodiscard]] const SceneSchedule& followed() const { return schedule; }
    /// Of one motion. \throws std::out_of_range
    [[nodiscard]] const NetworkClaim& claim(std::size_t which) const
    {
        return motions.at(which).claim;
    }
    /// [N] or [m], of the last motion, or asked for.
    [[nodiscard]] std::optional<double> amplitude() const
    {
        return motions.empty() ? asked : std::optional(motions.back().amplitude);
    }
    /// Of the excitation [Hz].
    [[nodiscard]] double frequency() const
    {
        return static_cast<double>(forcing.cycles) / schedule.period();
    }
};

/// The least amplitude, or the motions of the one that a call asks for [N or m, or of a derivative
/// of the base's displacement m/s, m/s^2]. \throws std::invalid_argument on options that are
/// missing; when it is asked, as `forcedScene`.
[[nodiscard]] Question<SceneForcedAnswer> forcedAsked(const Call& call, const BarsAsked& bars);

/// Starts beside each motion.
void tryStability(SceneForcedAnswer& answer, const Cancel& cancel);

void describe(auto& d, Type<SceneCuts>)
{
    using T = SceneCuts;
    d.record("SceneForcedProof", "Multipliers that leave no excitation of bars.");
    d.key("kind", "-", R"("forced": of any amplitude; "amplitude-range": of the one asked for.)",
          [](const T& c) { return c.isOfAmplitude ? "amplitude-range" : "forced"; });
    d.key("verified", "-", "By stepping backwards in time.", [](const T&) { return true; });
    d.key("rows", "-", "What the multipliers refer to.", [](const T&) { return "network"; });
    d.key("cuts", "-", "[dict, ...]: multipliers.", &T::cuts);
}

void describe(auto& d, Type<SceneForcedMotion>)
{
    using T = SceneForcedMotion;
    d.record("SceneForcedMotion", "One forced motion of bars in a row.");
    d.key("amplitude", "N or m >= 0", "Of the excitation.", &T::amplitude);
    d.key("phase", "rad", "Of the excitation at the start.", &T::phase);
    d.key("contacts", "-", "[dict, ...]: each contact, and its forces.", &T::contacts);
    d.key("strains", "-", "In a period.", [](const T& m) { return m.physical.strains; });
    describePhysical(d, &T::physical);
    d.key("residual", "- >= 0", "The worst that was seen walking its waves; relative.",
          [](const T& m) { return m.residuals.worst(); });
    d.key("stability", "-", "Of the motion when it is perturbed.", &T::stability, When::any);
}

void describe(auto& d, Type<SceneForcedAnswer>)
{
    using T = SceneForcedAnswer;
    const auto forcing = partOf(&T::forcing);
    d.record("SceneForcedResult", "What is known of a forced schedule of bars in a row.");
    d.key("status", "-", R"("found", "none" or "undecided".)", &T::status);
    describeSchedule(d, &T::schedule);
    d.key("force", "-", "What is excited: driven nodes (tip), or shaken clamps (base).",
          forcing(&Forcing::place));
    d.key("cycles", "- >= 1", "Of the excitation in a period.", forcing(&Forcing::cycles));
    d.key("frequency", "Hz > 0", "Of the excitation.", &T::frequency);
    d.key("amplitude", "N or m >= 0", "Of the last motion, or asked for.", &T::amplitude);
    describeStrainLimit(d, &T::schedule);
    d.key("kind", "-", "What motions leave of the plane of excitations.", &T::kind);
    d.key("free_waves", "- >= 0", "That nothing damps.", &T::freeWaves);
    d.key("amplitude_range", "N or m >= 0", "Of which there are motions; no end: None.",
          [](const T& a) {
              return a.range ? std::optional(EnergyRange{(*a.range)[0], (*a.range)[1]})
                             : std::nullopt;
          });
    d.key("contacts", "-", "[dict, ...], of the bars.",
          [](const T& a) { return a.schedule.bars.contacts; });
    d.key("phase", "rad", "Of the last motion.", [](const T& a) {
        return a.motions.empty() ? std::nullopt : std::optional(a.motions.back().phase);
    });
    d.key("motions", "-", "The one of least amplitude, or those of the amplitude asked for.",
          &T::motions);
    d.key("certificate", "-", "Of none.", &T::cuts);
    d.key("detail", "-", "Why it is not decided.", &T::detail);
}

}  // namespace signorini::answers
