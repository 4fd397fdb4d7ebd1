#pragma once
/// \file
/// Curves of motions of one schedule and one energy.

#include <functional>
#include <memory>
#include <string>

#include "engine_names.hpp"
#include "parts.hpp"
#include "signorini/continuum.hpp"
#include "watch.hpp"

namespace signorini::answers {

/// --energy or --energy-ratio, and ends that go together. \throws std::invalid_argument
void requireCurve(const Call& call);
/// How a curve is traced, of any bars. \throws std::invalid_argument
void readCurve(const Call& call, auto& options)
{
    call.read("--points", options.points);
    if (call.has("--engine")) {
        options.solver = solverOfEngine(call.text("--engine"), call.called("--engine"));
    }
    call.read("--resolution", options.resolution);
    call.read("--tolerance", options.tolerance);
}
/// One motion of a curve, which it keeps alive.
struct PointOf {
    std::shared_ptr<const Continuum> curve;
    std::shared_ptr<const ContinuumPoint> point;
    std::optional<bool> isExact = {};  ///< of a member

    [[nodiscard]] Physical physical() const;
};

struct ContinuumAnswer {
    std::shared_ptr<const Continuum> curve;
    std::optional<Member> asked = {};  ///< of one lambda

    [[nodiscard]] std::vector<PointOf> points() const;
    [[nodiscard]] std::optional<PointOf> member() const;
};

/// What a call asks of a schedule of a uniform bar, and the state that is meant by one of --from,
/// --to, --direction. \throws std::invalid_argument as requireCurve; as stateOf.
[[nodiscard]] Question<ContinuumAnswer> continuumAsked(
    const Call& call, const Scene& scene, Schedule schedule,
    const std::function<State(const char* option)>& stateOf);

/// Nothing where there is no gap, and so no E_1.
template <typename T>
[[nodiscard]] std::optional<T> whereUnit(const Continuum& curve, std::optional<T> value)
{
    return curve.scene.bar.gap != 0.0 ? value : std::nullopt;
}

/// [J]
[[nodiscard]] double joules(double energyRatio, const Continuum& curve);

/// Of the motions of this energy: no motions have no dimension.
[[nodiscard]] std::optional<std::int64_t> dimensionOf(const Continuum& curve);

void describe(auto& d, Type<PointOf>)
{
    using T = PointOf;
    const auto point = partOf(&T::point);
    d.record("ContinuumPoint", "One motion of a curve.");
    d.key("lambda", "-", "Where on the curve; `parameter` says what it is.",
          point(&ContinuumPoint::lambda));
    d.key("energy", "J > 0", "E, recomputed.",
          [](const T& p) { return joules(p.point->energyRatio, *p.curve); });
    d.key("energy_ratio", "E_1 > 0", "E/E_1, where there is a gap.",
          [](const T& p) { return whereUnit(*p.curve, std::optional(p.point->energyRatio)); });
    d.key("residual", "- >= 0", "The largest of its residuals, recomputed.",
          point(&ContinuumPoint::residual));
    d.key("peak_strain", "-", "Deepest compression.", point(&ContinuumPoint::peakStrain));
    describePhysical(d, &T::physical);
    d.key("exact", "-", "Of a member: is it the curve's own at this lambda, or the nearest point?",
          &T::isExact, When::any);
}

void describe(auto& d, Type<ContinuumAnswer>)
{
    using T = ContinuumAnswer;
    const auto curve = partOf(&T::curve);
    d.record("Continuum", R"(A curve k(lambda) of motions of one schedule and one energy.

A sequence of ContinuumPoint; each was verified before it was kept.
)");
    d.key("status", "-", R"("found", "none" or "undecided".)", curve(&Continuum::status));
    d.key("cells", "- >= 1", "N.", [](const T& a) { return a.curve->schedule.cells; });
    d.key("schedule", "-", "Asked about.", curve(&Continuum::schedule));
    d.key("period", "s > 0", "T.",
          [](const T& a) { return period(a.curve->schedule) * scales(a.curve->scene.bar).time; });
    d.key("period_ratio", "L/c > 0", "c T/L.",
          [](const T& a) { return period(a.curve->schedule); });
    d.key("frequency_ratio", "- > 0", "omega/omega_1.",
          [](const T& a) { return frequencyRatio(a.curve->schedule); });
    d.key("energy", "J > 0", "E asked for.",
          [](const T& a) { return joules(a.curve->energyRatio, *a.curve); });
    d.key("energy_ratio", "E_1 > 0", "E/E_1 asked for, where there is a gap.",
          [](const T& a) { return whereUnit(*a.curve, std::optional(a.curve->energyRatio)); });
    d.key("connected", "-", "Can the ends, or all motions of this energy, be joined?",
          curve(&Continuum::connected));
    d.key("components", "- >= 0", "Of the motions of this energy.", curve(&Continuum::components));
    d.key("dimension", "- >= 0", "Of the motions of this energy.",
          [](const T& a) { return dimensionOf(*a.curve); });
    d.key("energy_ratio_range", "E_1", "(least, most) of the whole set.",
          [](const T& a) { return whereUnit(*a.curve, a.curve->energyRange); });
    d.key("resolution", "sqrt(E/E_1) >= 0", "Largest distance of neighbours.",
          curve(&Continuum::resolution));
    d.key("engine", "-", "Which engine traced it.",
          [](const T& a) { return engineOf(a.curve->solver); });
    d.key("family", "-", R"(E.g. "split pulse".)", curve(&Continuum::family));
    d.key("parameter", "-", "What lambda is.", curve(&Continuum::parameter));
    d.key("reason", "-", "Why there is no motion of this energy.", curve(&Continuum::reason));
    d.key("orbits", "- >= 0", "How many of the points are different motions.",
          curve(&Continuum::orbits));
    d.key("points", "-", "Along the curve.", &T::points);
    describeScene(
        d, [](const T& a) -> const auto& { return a.curve->scene; });
    d.key("member", "-", "That was asked for.", &T::member, When::program);
    d.key(
        "detail", "-", "Why it is not found, or a note.",
        [](const T& a) {
            const std::string& text = a.curve->detail;
            return text.empty() ? std::nullopt : std::optional(text);
        },
        When::any);
}

}  // namespace signorini::answers
