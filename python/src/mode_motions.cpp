#include <pybind11/stl.h>

#include "faults.hpp"
#include "lists.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

namespace {

/// Keys that the motions of a mode and of a polytope share; `energy` is E/E_1.
template <typename Answer, typename Energy>
void addTimes(Record<Answer>& record, Energy energy)
{
    record
        .key(
            "period", [](const Answer& m) { return m.motion.period() * scales(m.bar).time; },
            "T [s].")
        .key(
            "period_ratio", [](const Answer& m) { return m.motion.period(); }, "T [L/c].")
        .key(
            "frequency",
            [](const Answer& m) { return 1.0 / (m.motion.period() * scales(m.bar).time); }, "[Hz]")
        .key(
            "frequency_ratio", [](const Answer& m) { return 4.0 / m.motion.period(); },
            "omega/omega_1.")
        .key(
            "contact_time",
            [](const Answer& m) { return m.motion.contactTime() * scales(m.bar).time; },
            "Of all contacts together [s].")
        .key(
            "contact_time_ratio", [](const Answer& m) { return m.motion.contactTime(); },
            "Of all contacts together [L/c].")
        .key(
            "energy", [energy](const Answer& m) { return energy(m) * scales(m.bar).energy; }, "[J]")
        .key("energy_ratio", energy, "E/E_1.");
}

template <typename Answer>
void addRest(Record<Answer>& record)
{
    const auto physical = [](const Answer& m) { return physicalOf(m.motion.extremes(), m.bar); };
    record.key("physical", physical, "What can be measured, in SI units: a Physical.")
        .key(
            "admissible", [physical](const Answer& m) { return physical(m).isAdmissible(); },
            "Is s > -1 everywhere?");
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
    Record<ModeAnswer> record(module, "ModeMotion",
                              R"(The motion of a mode at one period, on no grid.

t = 0 is the start of contact; at jumps velocity and strain take the value right after them.
)");
    record
        .key(
            "status", [](const ModeAnswer&) { return nameOf(Status::found); }, "\"found\".")
        .key(
            "bar", [](const ModeAnswer& m) { return m.bar; }, "Its units.")
        .key(
            "mode",
            [](const ModeAnswer& m) {
                return Of<Mode>{m.mode, m.bar};
            },
            "That it is of.");
    addTimes(record, [](const ModeAnswer& m) { return energyRatio(m.mode, m.motion.period()); });
    record.key(
        "jumps",
        [](const ModeAnswer& m) {
            py::list list;
            for (const ModeJump& jump : jumps(m.mode)) {
                list.append(py::make_tuple(2 * jump.k, -jump.turns));
            }
            return list;
        },
        "[(k, turns), ...]: p changes its sign at k + turns T.");
    addRest(record);
    record.more()
        .def(py::pickle(
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
    addModeFields(record.more());
}

/// [(start, end), ...] in a unit of time.
py::list contactsOf(const PolytopeAnswer& m, double unit)
{
    py::list list;
    for (const auto& [start, end] : m.motion.contacts()) {
        list.append(py::make_tuple(start * unit, end * unit));
    }
    return list;
}

void addPolytopeMotion(py::module_& module)
{
    Record<PolytopeAnswer> record(module, "PolytopeMotion",
                                  R"(A motion with several contacts in a period, on no grid.

t = 0 is the start of the first contact; at jumps velocity and strain take the value right after
them.
)");
    record
        .key(
            "bar", [](const PolytopeAnswer& m) { return m.bar; }, "Its units.")
        .key(
            "polytope",
            [](const PolytopeAnswer& m) {
                return Of<ModePolytope>{m.polytope, m.bar};
            },
            "That it is of.");
    addTimes(record,
             [](const PolytopeAnswer& m) { return energyRatio(m.polytope, m.motion.period()); });
    record
        .key(
            "contacts", [](const PolytopeAnswer& m) { return contactsOf(m, scales(m.bar).time); },
            "[(start, end), ...] [s].")
        .key(
            "contacts_ratio", [](const PolytopeAnswer& m) { return contactsOf(m, 1.0); },
            "[(start, end), ...] [L/c].");
    addRest(record);
    record.more()
        .def(py::pickle(
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
    addModeFields(record.more());
}

}  // namespace

void addModeMotions(py::module_& module)
{
    addModeMotion(module);
    addPolytopeMotion(module);
}

}  // namespace signorini::python
