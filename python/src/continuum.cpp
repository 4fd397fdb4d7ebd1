#include "continuum.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "engine_names.hpp"
#include "faults.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "signorini/continuum.hpp"

namespace signorini::python {

namespace {

using Shared = std::shared_ptr<Continuum>;

/// One motion of a curve, which it keeps alive.
struct PointOf {
    std::shared_ptr<const Continuum> curve;
    std::shared_ptr<const ContinuumPoint> point;
    std::optional<bool> isExact = {};
};

}  // namespace

template <>
struct Members<PointOf> {
    static constexpr auto list = std::tuple{&PointOf::curve, &PointOf::point, &PointOf::isExact};
};

namespace {

PointOf pointOf(const Shared& curve, std::size_t at)
{
    return {curve, std::shared_ptr<const ContinuumPoint>(curve, &curve->points[at])};
}

Physical physicalOf(const PointOf& p)
{
    return signorini::physicalOf(extremesOf(p.point->state, p.curve->schedule), p.curve->scene.bar);
}

/// Without a gap there is no E_1.
bool hasUnit(const Continuum& curve)
{
    return curve.scene.bar.gap != 0.0;
}

/// No motions have no dimension.
bool hasDimension(const Continuum& curve)
{
    return curve.dimension >= 0 && curve.components != 0;
}

/// One number of each point.
template <typename Get>
auto column(Get get)
{
    return [get](const Continuum& curve) {
        return filled(static_cast<std::int64_t>(curve.points.size()), [&](std::int64_t k) {
            return get(curve.points[static_cast<std::size_t>(k)]);
        });
    };
}

void addPoint(py::module_& module)
{
    Record<PointOf> record(module, "ContinuumPoint", "One motion of a curve.");
    record
        .key(
            "lambda", [](const PointOf& p) { return p.point->lambda; },
            "Where on the curve; `parameter` says what it is.")
        .key(
            "energy",
            [](const PointOf& p) {
                return p.point->energyRatio * scales(p.curve->scene.bar).energy;
            },
            "E [J], recomputed.")
        .key(
            "energy_ratio",
            [](const PointOf& p) {
                return hasUnit(*p.curve) ? py::cast(p.point->energyRatio) : py::object(py::none());
            },
            "E/E_1; None without a gap.")
        .key(
            "residual", [](const PointOf& p) { return p.point->residual; },
            "The largest of its residuals, recomputed.")
        .key(
            "peak_strain", [](const PointOf& p) { return p.point->peakStrain; },
            "Deepest compression [-].")
        .key("physical", &physicalOf, "What can be measured, in SI units: a Physical.")
        .key(
            "admissible", [](const PointOf& p) { return physicalOf(p).isAdmissible(); },
            "Is s > -1 everywhere?")
        .keyIfAny(
            "exact", [](const PointOf& p) { return orNone(p.isExact); },
            "Of a member: is it the curve's own at this lambda, or the nearest point?");
    record.more()
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
                "ContinuumPoint(lambda={:.6g}, energy_ratio={:.10g}, "
                "peak_strain={:.6g})",
                p.point->lambda, p.point->energyRatio, p.point->peakStrain);
        });
}

void addCurve(py::module_& module)
{
    Record<Continuum> record(module, "Continuum",
                             R"(A curve k(lambda) of motions of one schedule and one energy.

A sequence of ContinuumPoint; each was verified before it was kept.
)");
    record
        .key(
            "status", [](const Continuum& c) { return nameOf(c.status); },
            "\"found\", \"none\" or \"undecided\".")
        .key(
            "cells", [](const Continuum& c) { return c.schedule.cells; }, "N.")
        .key(
            "schedule", [](const Continuum& c) { return c.schedule; }, "Asked about.")
        .key(
            "bar", [](const Continuum& c) { return c.scene.bar; }, "Asked about.")
        .key(
            "stops", [](const Continuum& c) { return stopsIn(c.scene); },
            "[{\"side\", \"place\" [m]}, ...].")
        .key(
            "segments", [](const Continuum& c) { return c.scene.segments; },
            "[], as a stepped bar has no continua.")
        .key(
            "static_force", [](const Continuum& c) { return staticForce(c.scene); },
            "What the bar at rest presses on the wall with [N].")
        .key(
            "period",
            [](const Continuum& c) { return period(c.schedule) * scales(c.scene.bar).time; },
            "T [s].")
        .key(
            "period_ratio", [](const Continuum& c) { return period(c.schedule); }, "c T/L.")
        .key(
            "frequency_ratio", [](const Continuum& c) { return frequencyRatio(c.schedule); },
            "omega/omega_1.")
        .key(
            "energy", [](const Continuum& c) { return c.energyRatio * scales(c.scene.bar).energy; },
            "E asked for [J].")
        .key(
            "energy_ratio",
            [](const Continuum& c) {
                return hasUnit(c) ? py::cast(c.energyRatio) : py::object(py::none());
            },
            "E/E_1 asked for; None without a gap.")
        .key(
            "connected", [](const Continuum& c) { return orNone(c.connected); },
            "Can the ends, or all motions of this energy, be joined?")
        .key(
            "components", [](const Continuum& c) { return orNone(c.components); },
            "Of the motions of this energy.")
        .key(
            "dimension",
            [](const Continuum& c) {
                return hasDimension(c) ? py::cast(c.dimension) : py::object(py::none());
            },
            "Of the motions of this energy.")
        .key(
            "energy_ratio_range",
            [](const Continuum& c) {
                return hasUnit(c)
                           ? orNone(c.energyRange, [](const EnergyRange& r) { return boundsOf(r); })
                           : py::object(py::none());
            },
            "(least, most) E/E_1 of the whole set.")
        .key(
            "resolution", [](const Continuum& c) { return orNone(c.resolution); },
            "Largest distance of neighbours [sqrt(E/E_1)].")
        .key(
            "engine", [](const Continuum& c) { return py::str(engineOf(c)); }, "Who traced.")
        .key(
            "family", [](const Continuum& c) { return c.family; }, "E.g. \"split pulse\".")
        .key(
            "parameter", [](const Continuum& c) { return nameOf(c.parameter); }, "What lambda is.")
        .key(
            "reason",
            [](const Continuum& c) { return orNone(c.reason, [](Reason r) { return nameOf(r); }); },
            "Why there is no motion of this energy.")
        .key(
            "orbits", [](const Continuum& c) { return c.orbits; },
            "How many of the points are different motions.")
        .key(
            "points",
            [](const Shared& c) {
                py::list list;
                for (std::size_t k = 0; k < c->points.size(); ++k) {
                    list.append(pointOf(c, k));
                }
                return list;
            },
            "[ContinuumPoint, ...].")
        .keyIfAny(
            "detail",
            [](const Continuum& c) {
                return c.detail.empty() ? py::object(py::none()) : py::str(c.detail);
            },
            "Why it is not found, or a note.");
    record.more()
        .def_property_readonly("lambda_", column([](const auto& p) { return p.lambda; }),
                               "Of each point, shape (points,).")
        .def_property_readonly("peak_strain", column([](const auto& p) { return p.peakStrain; }),
                               "Of each point [-].")
        .def_property_readonly("residual", column([](const auto& p) { return p.residual; }),
                               "Of each point.")
        .def(
            "member",
            [](const Shared& c, double lambda) {
                Member member = memberAt(*c, lambda);
                return PointOf{c, std::make_shared<const ContinuumPoint>(std::move(member.point)),
                               member.isExact};
            },
            py::arg("lambda_"),
            "The motion at a lambda: exact for the split pulse, else the nearest point. ValueError "
            "out of range.")
        .def("__len__", [](const Continuum& c) { return c.points.size(); })
        .def("__getitem__",
             [](const Shared& c, std::int64_t at) {
                 const auto count = static_cast<std::int64_t>(c->points.size());
                 const std::int64_t place = at < 0 ? at + count : at;
                 if (place < 0 || place >= count) {
                     throw py::index_error("no such point");
                 }
                 return pointOf(c, static_cast<std::size_t>(place));
             })
        .def("__repr__", [](const Continuum& c) {
            return fmt::format("Continuum({}, {}, E = {:.6g} E_1, {} points, {} orbits{})",
                               name(c.status), describe(c.schedule), c.energyRatio, c.points.size(),
                               c.orbits, c.detail.empty() ? "" : ": " + c.detail);
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

Continuum continuum(const py::tuple& words, std::optional<std::int64_t> cells, const Scene& scene,
                    std::optional<double> energyRatio, std::optional<double> energy,
                    std::int64_t points, const std::optional<StateOf>& start,
                    const std::optional<StateOf>& to, const std::optional<StateOf>& direction,
                    std::optional<std::uint64_t> seed, bool sample, const std::string& engine,
                    std::optional<double> strainLimit, double resolution, double tolerance,
                    const py::object& progress)
{
    const Schedule schedule = scheduleOf(words, cells);
    if (energyRatio.has_value() == energy.has_value()) {
        throw std::invalid_argument("energy, energy_ratio: allowed exactly one of them");
    }
    const double ratio = energyRatio ? *energyRatio : *energy / scales(scene.bar).energy;
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
            return traceContinuum(schedule, ratio, options);
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
