#pragma once
/// \file
/// Curves of motions of one schedule of bars in a row, and one energy.

#include <memory>

#include "engine_names.hpp"
#include "network_continuum.hpp"
#include "scene_find_answer.hpp"

namespace signorini::answers {

/// A curve, and what gives it units.
struct SceneCurve {
    SceneSchedule schedule;
    NetworkContinuum curve;
    std::optional<double> unit;              ///< E_1 [Z_1 delta^2/h], if there is one
    std::optional<double> strainLimit = {};  ///< [-], asked for

    [[nodiscard]] double joules(double energy) const { return energy * schedule.scales.energy(); }
    /// E/E_1
    [[nodiscard]] std::optional<double> ratio(double energy) const
    {
        return unit ? std::optional(energy / *unit) : std::nullopt;
    }
};

/// One motion of a curve, which it keeps alive.
struct SceneCurvePoint {
    std::shared_ptr<const SceneCurve> of;
    std::size_t number = 0;  ///< from 0

    [[nodiscard]] const NetworkCurvePoint& point() const { return of->curve.points.at(number); }
    [[nodiscard]] SceneStrains strains() const;
};

struct SceneContinuumAnswer {
    std::shared_ptr<const SceneCurve> of;
    std::optional<std::size_t> asked = {};  ///< the number of the point that was asked for

    [[nodiscard]] const NetworkContinuum& curve() const { return of->curve; }
    [[nodiscard]] std::vector<SceneCurvePoint> points() const;
    [[nodiscard]] std::optional<SceneCurvePoint> member() const;
    /// Where there is no motion of this energy: none has less than it proves.
    [[nodiscard]] std::optional<SceneFloor> certificate() const;
};

/// Energy in units of the network. \throws as `traceContinuum`.
[[nodiscard]] SceneContinuumAnswer continuumOf(const Assembly& assembly, const Network& network,
                                               const std::vector<ContactSpan>& schedule,
                                               double energy, const NetworkCurveOptions& options);

template <typename D>
void describe(D& d, Type<SceneCurvePoint>)
{
    using T = SceneCurvePoint;
    d.record("SceneContinuumPoint", "One motion of a curve of motions of bars.");
    d.key("lambda", "-", "Where on the curve; `parameter` says what it is.",
          [](const T& p) { return p.point().lambda; });
    d.key("energy", "J > 0", "E, recomputed.",
          [](const T& p) { return p.of->joules(p.point().energy); });
    d.key("energy_ratio", "- > 0", "E/E_1 of the scene; none where a bar drifts, or a gap is 0.",
          [](const T& p) { return p.of->ratio(p.point().energy); });
    d.key("residual", "- >= 0", "The largest of its residuals, recomputed.",
          [](const T& p) { return p.point().residuals.worst(); });
    d.key("peak_strain", "- >= 0", "Deepest compression.",
          [](const T& p) { return p.strains().compression; });
    d.key("strains", "-", "In a period.", &T::strains);
    d.key("contacts", "-", "[dict, ...]: each contact with its forces.",
          [](const T& p) { return contactsOf(p.of->schedule, &p.point().residuals); });
}

template <typename D>
void describe(D& d, Type<SceneContinuumAnswer>)
{
    using T = SceneContinuumAnswer;
    d.record("SceneContinuum", R"(A curve of motions of one schedule of bars, and one energy.

Each of its points was verified before it was kept.
)");
    d.key("status", "-", R"("found", "none" or "undecided".)",
          [](const T& a) { return a.curve().status; });
    describeSchedule(d, [](const T& a) -> const SceneSchedule& { return a.of->schedule; });
    d.key("energy", "J > 0", "E asked for.",
          [](const T& a) { return a.of->joules(a.curve().energy); });
    d.key("energy_ratio", "- > 0", "E/E_1 of the scene; none where a bar drifts, or a gap is 0.",
          [](const T& a) { return a.of->ratio(a.curve().energy); });
    d.key("energy_ratio_proved", "- >= 0", "No motion of the schedule has less.",
          [](const T& a) { return a.of->ratio(a.curve().known.provedEnergy); });
    d.key("connected", "-", "Can the ends, or all motions of this energy, be joined?",
          [](const T& a) { return a.curve().connected; });
    d.key("dimension", "- >= 0", "Of the motions of this energy.",
          [](const T& a) { return a.curve().dimension; });
    d.key("resolution", "sqrt(E) >= 0", "Largest distance of neighbours.",
          [](const T& a) { return a.curve().resolution; });
    d.key("engine", "-", "Which engine traced it.",
          [](const T& a) { return engineOf(a.curve().solver); });
    d.key("family", "-", R"(E.g. "path between two members".)",
          [](const T& a) { return a.curve().family; });
    d.key("parameter", "-",
          "What lambda is; an arc length in the root of E_1, or of E where there is none.",
          [](const T& a) { return a.curve().parameter; });
    d.key(
        "strain_limit", "- > 0", "Of all motions, if any.",
        [](const T& a) { return a.of->strainLimit; }, When::any);
    d.key("points", "-", "Along the curve.", &T::points);
    d.key("member", "-", "That was asked for.", &T::member, When::program);
    d.key("certificate", "-", "No motion has less energy.", &T::certificate);
    d.key("detail", "-", "Why it is not found, or a note.",
          [](const T& a) { return a.curve().detail; });
}

}  // namespace signorini::answers
