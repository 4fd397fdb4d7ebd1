#include "calls.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "asked.hpp"
#include "continuum_answer.hpp"
#include "described.hpp"
#include "engine_names.hpp"
#include "motion.hpp"
#include "patience.hpp"
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

py::list pointsOf(const ContinuumAnswer& answer)
{
    return asPython(answer.points());
}

/// One number of each point.
template <typename Get>
auto column(Get get)
{
    return [get](const ContinuumAnswer& answer) {
        const std::vector<ContinuumPoint>& points = answer.curve->points;
        return filled(static_cast<std::int64_t>(points.size()),
                      [&](std::int64_t k) { return get(points[static_cast<std::size_t>(k)]); });
    };
}

void addPoint(py::module_& module)
{
    classOf<PointOf>(module)
        ->more()
        .def_property_readonly(
            "state",
            [](const PointOf& p) {
                return StateOf{std::shared_ptr<const State>(p.point, &p.point->state),
                               p.curve->scene.bar};
            },
            "At t = 0: a State.")
        .def_property_readonly(
            "motion",
            [](const PointOf& p) {
                return GridMotion{std::shared_ptr<const State>(p.point, &p.point->state),
                                  p.curve->schedule, p.curve->scene};
            },
            "The field over one period: a Motion.")
        .def("__repr__", [](const PointOf& p) {
            return fmt::format(
                "ContinuumPoint(lambda={:.6g}, E = {}, peak_strain={:.6g})", p.point->lambda,
                energyAsText(p.point->energyRatio, p.curve->scene.bar), p.point->peakStrain);
        });
}

void addCurve(py::module_& module)
{
    classOf<ContinuumAnswer>(module)
        ->more()
        .def_property_readonly("lambda_", column([](const auto& p) { return p.lambda; }),
                               "Of each point, shape (points,).")
        .def_property_readonly("peak_strain", column([](const auto& p) { return p.peakStrain; }),
                               "Of each point [-].")
        .def_property_readonly("residual", column([](const auto& p) { return p.residual; }),
                               "Of each point.")
        .def(
            "member",
            [](const ContinuumAnswer& c, double lambda) {
                return *ContinuumAnswer{c.curve, memberAt(*c.curve, lambda)}.member();
            },
            py::arg("lambda_"),
            "The motion at a lambda: exact for the split pulse, else the nearest point. ValueError "
            "out of range.")
        .def("_figure", [](const ContinuumAnswer& c) { return asJson(continuumFigure(*c.curve)); })
        .def("__len__", [](const ContinuumAnswer& c) { return c.curve->points.size(); })
        .def("__iter__", [](const ContinuumAnswer& c) { return py::iter(pointsOf(c)); })
        .def("__getitem__", [](const ContinuumAnswer& c,
                               const py::object& at) { return py::object(pointsOf(c)[at]); })
        .def("__repr__", [](const ContinuumAnswer& answer) {
            const Continuum& c = *answer.curve;
            return fmt::format("Continuum({}, {}, E = {}, {} points, {} orbits{})", name(c.status),
                               describe(c.schedule), energyAsText(c.energyRatio, c.scene.bar),
                               c.points.size(), c.orbits, c.detail.empty() ? "" : ": " + c.detail);
        });
}

Trace traceOf(const Asked& asked)
{
    const auto start = asked.maybe<StateOf>("start");
    const auto to = asked.maybe<StateOf>("to");
    const auto direction = asked.maybe<StateOf>("direction");
    const auto seed = asked.maybe<std::uint64_t>("seed");
    const bool sample = asked.get<bool>("sample");
    if (start.has_value() != (to.has_value() != direction.has_value()) ||
        (to.has_value() && direction.has_value())) {
        throw std::invalid_argument("start: allowed only together with one of to and direction");
    }
    if (!start) {
        return sample ? Trace(trace::Sample{seed.value_or(trace::Sample{}.seed)})
               : seed ? Trace(trace::RandomPath{*seed})
                      : Trace(trace::SplitPulse{});
    }
    if (seed || sample) {
        throw std::invalid_argument("seed and sample clash with start: allowed one of them");
    }
    if (to) {
        return trace::Path{*start->value, *to->value};
    }
    return trace::Walk{*start->value, *direction->value};
}

ContinuumAnswer continuum(const Asked& asked)
{
    const Schedule schedule = asked.schedule();
    const auto energyRatio = asked.maybe<double>("energy_ratio");
    const auto energy = asked.maybe<double>("energy");
    if (energyRatio.has_value() == energy.has_value()) {
        throw std::invalid_argument("energy, energy_ratio: allowed exactly one of them");
    }
    ContinuumOptions options;
    options.scene = asked.scene();
    const double ratio = energyRatio ? *energyRatio : ratioOf(*energy, options.scene.bar);
    options.points = asked.get<std::int64_t>("points");
    options.trace = traceOf(asked);
    options.solver = solverOfEngine(asked.get<std::string>("engine"));
    options.strainLimit = asked.maybe<double>("strain_limit").value_or(options.strainLimit);
    options.resolution = asked.get<double>("resolution");
    options.tolerance = asked.get<double>("tolerance");
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
