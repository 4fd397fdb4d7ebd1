#include "calls.hpp"

#include "continuum_answer.hpp"
#include "motion.hpp"
#include "signorini/continuum.hpp"
#include "signorini/figures.hpp"

namespace signorini::python {

namespace {

using answers::ContinuumAnswer;
using answers::PointOf;

}  // namespace

template <>
struct Members<ContinuumAnswer> {
    static constexpr auto list = std::tuple{&ContinuumAnswer::curve};
};

namespace {

/// One number of each point.
auto column(double ContinuumPoint::*member)
{
    return [member](const std::shared_ptr<ContinuumAnswer>& answer) {
        return view(answer->curve->points, member, answer);
    };
}

void addPoint(py::module_& module)
{
    classOf<PointOf>(module)
        ->has("state", "At t = 0: a State.",
              [](const PointOf& p) {
                  return StateOf{{p.point, &p.point->state}, p.curve->scene.bar};
              })
        .has("motion", "The field over one period: a Motion.", [](const PointOf& p) {
            return GridMotion{{p.point, &p.point->state}, p.curve->schedule, p.curve->scene};
        });
}

void addCurve(py::module_& module)
{
    classOf<ContinuumAnswer>(module)
        ->has("lambda_", "Of each point, shape (points,).", column(&ContinuumPoint::lambda))
        .has("peak_strain", "Of each point [-].", column(&ContinuumPoint::peakStrain))
        .has("residual", "Of each point.", column(&ContinuumPoint::residual))
        .can("member", {"lambda_"},
             "The motion at a lambda: exact for the split pulse, else the nearest point. "
             "ValueError out of range.",
             [](const ContinuumAnswer& c, double lambda) {
                 return *ContinuumAnswer{c.curve, memberAt(*c.curve, lambda)}.member();
             })
        .draws([](const ContinuumAnswer& c) { return continuumFigure(*c.curve); });
}

Trace traceOf(const Asked& asked)
{
    const auto start = asked.maybe<StateOf>("start");
    const auto to = asked.maybe<StateOf>("to");
    const auto direction = asked.maybe<StateOf>("direction");
    const auto seed = asked.maybe<std::uint64_t>("seed");
    if (!start) {
        return asked.get<bool>("sample") ? Trace(trace::Sample{seed.value_or(trace::Sample{}.seed)})
               : seed                    ? Trace(trace::RandomPath{*seed})
                                         : Trace(trace::SplitPulse{});
    }
    if (to) {
        return trace::Path{*start->value, *to->value};
    }
    return trace::Walk{*start->value, *direction->value};
}

ContinuumAnswer continuum(const Asked& asked)
{
    const Schedule schedule = asked.schedule();
    ContinuumOptions options;
    options.scene = asked.scene();
    const double ratio = asked.energyRatio(options.scene.bar).value();
    asked.readCurve(options);
    options.trace = traceOf(asked);
    options.strainLimit = asked.maybe<double>("strain_limit").value_or(options.strainLimit);
    return patiently(
        [=](const Wires& wires) mutable {
            options.cancel = wires.cancel;
            options.progress = wires.progress;
            return ContinuumAnswer{
                std::make_shared<const Continuum>(traceContinuum(schedule, ratio, options))};
        },
        asked.progress());
}

}  // namespace

void addContinuum(py::module_& module)
{
    addPoint(module);
    addCurve(module);
    addCall(module, "continuum", &continuum);
}

}  // namespace signorini::python
