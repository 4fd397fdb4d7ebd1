#include <pybind11/stl.h>

#include "described.hpp"
#include "faults.hpp"
#include "lists.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

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
    record->more()
        .def(pickling<ModeAnswer>(
            [](const ModeAnswer& m) {
                return py::make_tuple(Travel<Mode>::put(m.mode), Travel<Bar>::put(m.bar),
                                      m.motion.period());
            },
            [](const py::tuple& tuple) {
                const Mode mode = Travel<Mode>::get(tuple[0]);
                return ModeAnswer{mode, Travel<Bar>::get(tuple[1]),
                                  ModeMotion(mode, py::cast<double>(tuple[2]))};
            }))
        .def("__repr__", [](const ModeAnswer& m) {
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
    record->more()
        .def(pickling<PolytopeAnswer>(
            [](const PolytopeAnswer& m) {
                return py::make_tuple(Travel<ModePolytope>::put(m.polytope),
                                      Travel<Bar>::put(m.bar), m.point.period,
                                      Travel<std::vector<double>>::put(m.point.arrivals));
            },
            [](const py::tuple& tuple) {
                const auto polytope = Travel<ModePolytope>::get(tuple[0]);
                const ModePoint point{py::cast<double>(tuple[2]),
                                      Travel<std::vector<double>>::get(tuple[3])};
                return PolytopeAnswer{polytope, Travel<Bar>::get(tuple[1]), point,
                                      ModeMotion(polytope, point)};
            }))
        .def("__repr__", [](const PolytopeAnswer& m) {
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
