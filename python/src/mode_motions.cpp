#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "described.hpp"
#include "motion.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

/// Motions are made anew of what they are the motions of.
template <>
inline void put(Writer& to, const ModeAnswer& m)
{
    put(to, m.mode);
    put(to, m.bar);
    put(to, m.motion.period());
}
template <>
inline ModeAnswer take(Reader& from)
{
    const Mode mode = take<Mode>(from);
    const Bar bar = take<Bar>(from);
    return {mode, bar, ModeMotion(mode, take<double>(from))};
}
template <>
inline void put(Writer& to, const PolytopeAnswer& m)
{
    put(to, m.polytope);
    put(to, m.bar);
    put(to, m.point);
}
template <>
inline PolytopeAnswer take(Reader& from)
{
    const auto polytope = take<ModePolytope>(from);
    const Bar bar = take<Bar>(from);
    const auto point = take<ModePoint>(from);
    return {polytope, bar, point, ModeMotion(polytope, point)};
}

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
