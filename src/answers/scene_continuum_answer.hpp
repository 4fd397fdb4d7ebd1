#pragma once
/// \file
/// Curves of motions of one schedule of bars in a row, and one energy.

#include <memory>

#include "continuum_answer.hpp"
#include "network_continuum.hpp"
#include "scene_find_answer.hpp"

namespace signorini::answers {

/// A curve, and what gives it units.
struct SceneCurve {
    SceneSchedule schedule;
    NetworkContinuum curve;
};

/// One motion of a curve, which it keeps alive.
struct SceneCurvePoint {
    std::shared_ptr<const SceneCurve> of;
    std::size_t number = 0;  ///< from 0

    [[nodiscard]] const NetworkCurvePoint& point() const { return of->curve.points.at(number); }
    [[nodiscard]] const SceneSchedule& followed() const { return of->schedule; }
    [[nodiscard]] const NetworkClaim& claim(std::size_t = 0) const { return point().motion; }
    [[nodiscard]] ScenePhysical physical() const
    {
        return physicalOf(of->schedule, point().residuals);
    }
    [[nodiscard]] SceneStrains strains() const
    {
        return strainsOf(of->schedule.bars.assembly, of->schedule.scales, point().residuals);
    }
};

struct SceneContinuumAnswer {
    std::shared_ptr<const SceneCurve> of;
    std::optional<std::size_t> asked = {};  ///< the number of the point that was asked for

    [[nodiscard]] const SceneSchedule& schedule() const { return of->schedule; }
    [[nodiscard]] const NetworkContinuum& curve() const { return of->curve; }
    [[nodiscard]] std::vector<SceneCurvePoint> points() const;
    [[nodiscard]] std::optional<SceneCurvePoint> member() const;
    /// Where there is no motion of this energy: none has less than it proves.
    [[nodiscard]] std::optional<SceneFloor> certificate() const;
};

/// What a call asks of a schedule of bars. \throws std::invalid_argument as requireCurve; as
/// WavesOf; when it is asked, as `traceContinuum`.
[[nodiscard]] Question<SceneContinuumAnswer> continuumAsked(const Call& call, const BarsAsked& bars,
                                                            const WavesOf& wavesOf);

void describe(auto& d, Type<SceneCurvePoint>)
{
    using T = SceneCurvePoint;
    const auto point = partOf(&T::point);
    d.record("SceneContinuumPoint", "One motion of a curve of motions of bars.");
    d.key("lambda", "-", "Where on the curve; `parameter` says what it is.",
          point(&NetworkCurvePoint::lambda));
    d.key("energy", "J > 0", "E, recomputed.",
          [](const T& p) { return p.of->schedule.joules(p.point().energy); });
    d.key("energy_ratio", "- > 0", "E/E_1 of the scene; none where a bar drifts, or a gap is 0.",
          [](const T& p) { return p.of->schedule.ratio(p.point().energy); });
    d.key("residual", "- >= 0", "The largest of its residuals, recomputed.",
          [](const T& p) { return p.point().residuals.worst(); });
    d.key("peak_strain", "- >= 0", "Deepest compression.",
          [](const T& p) { return p.strains().compression; });
    d.key("strains", "-", "In a period.", &T::strains);
    describePhysical(d, &T::physical);
    d.key("contacts", "-", "[dict, ...]: each contact with its forces.",
          [](const T& p) { return contactsOf(p.of->schedule, &p.point().residuals); });
}

void describe(auto& d, Type<SceneContinuumAnswer>)
{
    using T = SceneContinuumAnswer;
    const auto curve = partOf(&T::curve);
    d.record("SceneContinuum", R"(A curve of motions of one schedule of bars, and one energy.

Each of its points was verified before it was kept.
)");
    d.key("status", "-", R"("found", "none" or "undecided".)", curve(&NetworkContinuum::status));
    describeSchedule(d, &T::schedule);
    d.key("energy", "J > 0", "E asked for.",
          [](const T& a) { return a.schedule().joules(a.curve().energy); });
    d.key("energy_ratio", "- > 0", "E/E_1 of the scene; none where a bar drifts, or a gap is 0.",
          [](const T& a) { return a.schedule().ratio(a.curve().energy); });
    d.key("energy_ratio_proved", "- >= 0", "No motion of the schedule has less.",
          [](const T& a) { return a.schedule().ratio(a.curve().known.provedEnergy); });
    d.key("connected", "-", "Can the ends, or all motions of this energy, be joined?",
          curve(&NetworkContinuum::connected));
    d.key("dimension", "- >= 0", "Of the motions of this energy.",
          curve(&NetworkContinuum::dimension));
    d.key("resolution", "sqrt(E) >= 0", "Largest distance of neighbours.",
          curve(&NetworkContinuum::resolution));
    d.key("engine", "-", "Which engine traced it.",
          [](const T& a) { return engineOf(a.curve().solver); });
    d.key("family", "-", R"(E.g. "path between two members".)", curve(&NetworkContinuum::family));
    d.key("parameter", "-",
          "What lambda is; an arc length in the root of E_1, or of E where there is none.",
          curve(&NetworkContinuum::parameter));
    describeStrainLimit(d, &T::schedule);
    d.key("points", "-", "Along the curve.", &T::points);
    d.key("member", "-", "That was asked for.", &T::member, When::program);
    d.key("certificate", "-", "No motion has less energy.", &T::certificate);
    d.key("detail", "-", "Why it is not found, or a note.", curve(&NetworkContinuum::detail));
}

}  // namespace signorini::answers
