#include <pybind11/stl.h>

#include "described.hpp"
#include "lists.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

/// A motion of a mode is made anew of what it is the motion of.
template <>
struct Travel<ModeAnswer> {
    static py::object put(const ModeAnswer& m)
    {
        return py::make_tuple(Travel<Mode>::put(m.mode), Travel<Bar>::put(m.bar),
                              m.motion.period());
    }
    static ModeAnswer get(const py::tuple& held)
    {
        const Mode mode = Travel<Mode>::get(held[0]);
        return {mode, Travel<Bar>::get(held[1]), ModeMotion(mode, py::cast<double>(held[2]))};
    }
    static bool same(const ModeAnswer& m, const ModeAnswer& other)
    {
        return m.mode == other.mode && m.bar == other.bar &&
               m.motion.period() == other.motion.period();
    }
};
template <>
struct Travel<PolytopeAnswer> {
    static py::object put(const PolytopeAnswer& m)
    {
        return py::make_tuple(Travel<ModePolytope>::put(m.polytope), Travel<Bar>::put(m.bar),
                              m.point.period, Travel<std::vector<double>>::put(m.point.arrivals));
    }
    static PolytopeAnswer get(const py::tuple& held)
    {
        const auto polytope = Travel<ModePolytope>::get(held[0]);
        const ModePoint point{py::cast<double>(held[2]), Travel<std::vector<double>>::get(held[3])};
        return {polytope, Travel<Bar>::get(held[1]), point, ModeMotion(polytope, point)};
    }
    static bool same(const PolytopeAnswer& m, const PolytopeAnswer& other)
    {
        return m.polytope == other.polytope && m.bar == other.bar &&
               m.point.period == other.point.period && m.point.arrivals == other.point.arrivals;
    }
};

namespace {

template <typename Answer>
void addRest(Record<Answer>& record)
{
    record.more()
        .def_property_readonly(
            "amplitude_ratio", [](const Answer& m) { return m.motion.amplitude(); },
            "h = |p| [g/L].")
        .def_property_readonly(
            "jump_times_ratio",
            [](const std::shared_ptr<Answer>& m) {
                const auto& times = m->motion.jumpTimes();
                return view(times.data(), times.size(), m);
            },
            "Where p changes its sign, ascending [L/c]: the first is the end of the first contact; "
            "no copy.")
        .def(
            "p",
            [](const Answer& m, const py::object& t) {
                return onPeriods(t, [&m](double instant) { return m.motion.incoming(instant); });
            },
            py::arg("t_ratio"), "The wave arriving at the tip [g/L] at t [L/c], any array.")
        .def(
            "state",
            [](const Answer& m, std::int64_t cells) {
                return StateOf{std::make_shared<const State>(cellMeans(m.motion, cells)), m.bar};
            },
            py::arg("cells"), "At t = 0, the means over each of N cells.");
}

void addModeMotion(py::module_& module)
{
    const auto record = classOf<ModeAnswer>(module);
    addRest(*record);
    record->more().def("__repr__", [](const ModeAnswer& m) {
        return fmt::format(
            "ModeMotion(t_c = {} - {} T, period_ratio={:.10g}, "
            "energy_ratio={:.10g})",
            4 * m.mode.a, -m.mode.b, m.motion.period(), energyRatio(m.mode, m.motion.period()));
    });
    addModeFields(record->more());
}

void addPolytopeMotion(py::module_& module)
{
    const auto record = classOf<PolytopeAnswer>(module);
    addRest(*record);
    record->more().def("__repr__", [](const PolytopeAnswer& m) {
        return fmt::format(
            "PolytopeMotion({} contacts, period_ratio={:.10g}, "
            "energy_ratio={:.10g})",
            m.polytope.chains.size(), m.point.period, energyRatio(m.polytope, m.point.period));
    });
    addModeFields(record->more());
}

}  // namespace

void addModeMotions(py::module_& module)
{
    addModeMotion(module);
    addPolytopeMotion(module);
}

}  // namespace signorini::python
