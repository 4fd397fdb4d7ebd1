#include "continuum.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "continuum_answer.hpp"
#include "described.hpp"
#include "engine_names.hpp"
#include "faults.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "signorini/continuum.hpp"
#include "signorini/figures.hpp"

namespace signorini::python {

namespace {

using answers::ContinuumAnswer;
using answers::PointOf;

}  // namespace

template <>
struct Members<PointOf> {
    static constexpr auto list = std::tuple{&PointOf::curve, &PointOf::point, &PointOf::isExact};
};
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

Trace traceOf(const std::optional<StateOf>& start, const std::optional<StateOf>& to,
              const std::optional<StateOf>& direction, std::optional<std::uint64_t> seed,
              bool sample)
{
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

ContinuumAnswer continuum(const py::tuple& words, std::optional<std::int64_t> cells,
                          const Scene& scene, std::optional<double> energyRatio,
                          std::optional<double> energy, std::int64_t points,
                          const std::optional<StateOf>& start, const std::optional<StateOf>& to,
                          const std::optional<StateOf>& direction,
                          std::optional<std::uint64_t> seed, bool sample, const std::string& engine,
                          std::optional<double> strainLimit, double resolution, double tolerance,
                          const py::object& progress)
{
    const Schedule schedule = scheduleOf(words, cells);
    if (energyRatio.has_value() == energy.has_value()) {
        throw std::invalid_argument("energy, energy_ratio: allowed exactly one of them");
    }
    const double ratio = energyRatio ? *energyRatio : ratioOf(*energy, scene.bar);
    ContinuumOptions options;
    options.scene = scene;
    options.points = points;
    options.trace = traceOf(start, to, direction, seed, sample);
    options.solver = solverOfEngine(engine);
    options.strainLimit = strainLimit.value_or(options.strainLimit);
    options.resolution = resolution;
    options.tolerance = tolerance;
    return patiently(
        [=](const Wires& wires) mutable {
            options.cancel = wires.cancel;
            options.progress = wires.progress;
            return ContinuumAnswer{
                std::make_shared<const Continuum>(traceContinuum(schedule, ratio, options))};
        },
        progress);
}

}  // namespace

void addContinuum(py::module_& module)
{
    addPoint(module);
    addCurve(module);
    module.def("continuum", &continuum);
}

}  // namespace signorini::python
