#include "lists.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "arrays.hpp"
#include "faults.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "signorini/modes.hpp"

namespace signorini::python {

namespace {

using FamilyOf = Of<Family>;
using ModeOf = Of<Mode>;

/// (4a, b): t_c = 4a + b T.
py::tuple contactOf(const Mode& mode)
{
    return py::make_tuple(4 * mode.a, mode.b);
}

/// The sign of the gap, as modes and families ask for it.
int gapSign(const Bar& bar)
{
    return stopsOf(bar).right;
}

void addFamily(py::module_& module)
{
    Record<FamilyOf> record(module, "Family", R"(All motions of one period and one contact pattern.

Three whole numbers (w, nu, k) name it, on no grid; on every grid with w | 2N it is one simplex.
)");
    const auto time = [](const FamilyOf& f) { return exactPeriod(f.value).value(); };
    record
        .key(
            "order", [](const FamilyOf& f) { return f.value.order; }, "w, blocks in 2 L/c.")
        .key(
            "nu", [](const FamilyOf& f) { return f.value.blocks; }, "Blocks in a period.")
        .key(
            "contact_blocks", [](const FamilyOf& f) { return f.value.contactBlocks; },
            "k, of them in contact.")
        .key(
            "period_ratio",
            [](const FamilyOf& f) { return py::make_tuple(2 * f.value.blocks, f.value.order); },
            "(2 nu, w): T = 2 nu/w [L/c].")
        .key(
            "contact",
            [](const FamilyOf& f) {
                return py::make_tuple(2 * f.value.contactBlocks, f.value.order);
            },
            "(2k, w): the longest contact [L/c].")
        .key(
            "least_energy_ratio", [](const FamilyOf& f) { return leastEnergy(f.value).value(); },
            "(w/win)^2 [E_1].")
        .key(
            "least_energy_exact", [](const FamilyOf& f) { return pairOf(leastEnergy(f.value)); },
            "The same as (numerator, denominator).")
        .key(
            "least_energy",
            [](const FamilyOf& f) { return leastEnergy(f.value).value() * scales(f.bar).energy; },
            "[J]")
        .key(
            "frequency_ratio", [time](const FamilyOf& f) { return 4.0 / time(f); },
            "omega/omega_1.")
        .key(
            "frequency", [time](const FamilyOf& f) { return 1.0 / (time(f) * scales(f.bar).time); },
            "[Hz]")
        .key(
            "period", [time](const FamilyOf& f) { return time(f) * scales(f.bar).time; }, "[s]")
        .key(
            "mode",
            [](const FamilyOf& f) -> py::object {
                return standsOnMode(f.value) ? contactOf(modeThrough(f.value))
                                             : py::object(py::none());
            },
            "(a4, b) of the mode on whose curve it stands; None at the end of one, without a gap, "
            "and where the tip never leaves the wall.");
    record.more()
        .def_property_readonly(
            "bar", [](const FamilyOf& f) { return f.bar; }, "Its units.")
        .def(
            "schedule",
            [](const FamilyOf& f, std::int64_t cells) {
                return signorini::scheduleOf(f.value, cells);
            },
            py::arg("cells"), "That has the whole set on N cells. ValueError unless w | 2N.")
        .def("__hash__",
             [](const FamilyOf& f) {
                 return py::hash(
                     py::make_tuple(f.value.order, f.value.blocks, f.value.contactBlocks));
             })
        .def("__repr__", [](const FamilyOf& f) {
            return fmt::format(
                "Family(order={}, nu={}, contact_blocks={}, T = {}/{} L/c, E >= "
                "{:.6g} E_1)",
                f.value.order, f.value.blocks, f.value.contactBlocks, 2 * f.value.blocks,
                f.value.order, leastEnergy(f.value).value());
        });
}

/// A function of the period [L/c] on an array of them.
template <typename F>
py::object onPeriods(const py::object& periods, F f)
{
    return Grid(py::float_(0.0), periods).of([f](double, double period) { return f(period); });
}

void addMode(py::module_& module)
{
    Record<ModeOf> record(module, "Mode",
                          R"(One continuous family: a motion for every T in an interval.

t_c = a4 + b T and E/E_1 = 1/(kappa T - mu)^2, T in L/c.
)");
    record
        .key(
            "contact", [](const ModeOf& m) { return contactOf(m.value); },
            "(a4, b): t_c = a4 + b T [L/c].")
        .key(
            "period_range",
            [](const ModeOf& m) {
                return py::make_tuple(pairOf(m.value.lowest), pairOf(m.value.highest));
            },
            "((p, q), (p, q)): p/q < T < p/q [L/c].")
        .key(
            "inverse_sqrt_energy",
            [](const ModeOf& m) { return py::make_tuple(m.value.kappa, m.value.mu); },
            "(kappa, mu): 1/sqrt(E/E_1) = kappa T - mu.")
        .key(
            "family",
            [](const ModeOf& m) -> py::object {
                const std::string text = familyName(m.value);
                return text.empty() ? py::object(py::none()) : py::str(text);
            },
            "\"main\", \"twin 1\", ..., if it has a name.")
        .key(
            "ends",
            [](const ModeOf& m) {
                return py::make_tuple(nameOf(m.value.lowestEnd), nameOf(m.value.highestEnd));
            },
            "Why it ends there.")
        .key(
            "energy_ratio_range", [](const ModeOf& m) { return boundsOf(energyRange(m.value)); },
            "(least, most) E/E_1, neither reached; None: infinite.")
        .key(
            "frequency_range",
            [](const ModeOf& m) {
                const double unit = scales(m.bar).time;
                return py::make_tuple(1.0 / (m.value.highest.value() * unit),
                                      1.0 / (m.value.lowest.value() * unit));
            },
            "(lowest, highest) [Hz].")
        .key(
            "energy_range",
            [](const ModeOf& m) { return boundsOf(energyRange(m.value), scales(m.bar).energy); },
            "(least, most) [J].");
    record.more()
        .def_property_readonly(
            "bar", [](const ModeOf& m) { return m.bar; }, "Its units.")
        .def_property_readonly(
            "kappa", [](const ModeOf& m) { return m.value.kappa; }, "E/E_1 = 1/(kappa T - mu)^2.")
        .def_property_readonly(
            "mu", [](const ModeOf& m) { return m.value.mu; }, "See kappa.")
        .def(
            "energy_ratio",
            [](const ModeOf& m, const py::object& periods) {
                return onPeriods(periods, [&m](double t) { return energyRatio(m.value, t); });
            },
            py::arg("period_ratio"),
            "E/E_1 at T [L/c], any array. ValueError outside the interval.")
        .def(
            "contact_time_ratio",
            [](const ModeOf& m, const py::object& periods) {
                return onPeriods(periods, [&m](double t) { return contactTime(m.value, t); });
            },
            py::arg("period_ratio"), "t_c [L/c] at T [L/c], any array. ValueError as above.")
        .def(
            "schedule",
            [](const ModeOf& m, std::int64_t cells, std::int64_t steps) {
                return signorini::scheduleOf(m.value, cells, steps);
            },
            py::arg("cells"), py::arg("steps"), "Of the motion with T = steps/cells L/c.")
        .def(
            "families",
            [](const ModeOf& m, std::int64_t maxOrder) {
                std::vector<FamilyOf> list;
                for (const Family& family : familiesOf(m.value, maxOrder)) {
                    list.push_back({family, m.bar});
                }
                return list;
            },
            py::arg("max_order"), "Those of order w <= max_order that stand on it.")
        .def(
            "motion",
            [](const ModeOf& m, double period) {
                return ModeAnswer{m.value, m.bar, ModeMotion(m.value, period)};
            },
            py::arg("period_ratio"), "At T [L/c]: a ModeMotion. ValueError outside the interval.")
        .def("__hash__", [](const ModeOf& m) { return py::hash(contactOf(m.value)); })
        .def("__repr__", [](const ModeOf& m) {
            return fmt::format("Mode(t_c = {} - {} T, {}/{} < T < {}/{} L/c)", 4 * m.value.a,
                               -m.value.b, m.value.lowest.numerator, m.value.lowest.denominator,
                               m.value.highest.numerator, m.value.highest.denominator);
        });
}

void addModeMotion(py::module_& module)
{
    Record<ModeAnswer> record(module, "ModeMotion",
                              R"(The motion of a mode at one period, on no grid.

t = 0 is the start of contact; at jumps velocity and strain take the value right after them.
)");
    const auto energy = [](const ModeAnswer& m) { return energyRatio(m.mode, m.motion.period()); };
    const auto physical = [](const ModeAnswer& m) {
        return physicalOf(m.motion.extremes(), m.bar);
    };
    record
        .key(
            "status", [](const ModeAnswer&) { return nameOf(Status::found); }, "\"found\".")
        .key(
            "bar", [](const ModeAnswer& m) { return m.bar; }, "Its units.")
        .key(
            "mode",
            [](const ModeAnswer& m) {
                return ModeOf{m.mode, m.bar};
            },
            "That it is of.")
        .key(
            "period", [](const ModeAnswer& m) { return m.motion.period() * scales(m.bar).time; },
            "T [s].")
        .key(
            "period_ratio", [](const ModeAnswer& m) { return m.motion.period(); }, "T [L/c].")
        .key(
            "frequency",
            [](const ModeAnswer& m) { return 1.0 / (m.motion.period() * scales(m.bar).time); },
            "[Hz]")
        .key(
            "frequency_ratio", [](const ModeAnswer& m) { return 4.0 / m.motion.period(); },
            "omega/omega_1.")
        .key(
            "contact_time",
            [](const ModeAnswer& m) { return m.motion.contactTime() * scales(m.bar).time; },
            "t_c [s].")
        .key(
            "contact_time_ratio", [](const ModeAnswer& m) { return m.motion.contactTime(); },
            "t_c [L/c].")
        .key(
            "energy", [energy](const ModeAnswer& m) { return energy(m) * scales(m.bar).energy; },
            "[J]")
        .key("energy_ratio", energy, "E/E_1.")
        .key(
            "jumps",
            [](const ModeAnswer& m) {
                py::list list;
                for (const ModeJump& jump : jumps(m.mode)) {
                    list.append(py::make_tuple(2 * jump.k, -jump.turns));
                }
                return list;
            },
            "[(k, turns), ...]: p changes its sign at k + turns T.")
        .key("physical", physical, "What can be measured, in SI units: a Physical.")
        .key(
            "admissible", [physical](const ModeAnswer& m) { return physical(m).isAdmissible(); },
            "Is s > -1 everywhere?");
    auto& shown = record.more();
    shown
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
        .def_property_readonly(
            "amplitude_ratio", [](const ModeAnswer& m) { return m.motion.amplitude(); },
            "h = |p| [g/L].")
        .def_property_readonly(
            "jump_times_ratio",
            [](const std::shared_ptr<ModeAnswer>& m) {
                const auto& times = m->motion.jumpTimes();
                return view(times.data(), times.size(), m);
            },
            "Where p changes its sign, ascending [L/c]: the first is t_c; no copy.")
        .def(
            "p",
            [](const ModeAnswer& m, const py::object& t) {
                return Grid(py::float_(0.0), t).of([&m](double, double instant) {
                    return m.motion.incoming(instant);
                });
            },
            py::arg("t_ratio"), "The wave arriving at the tip [g/L] at t [L/c], any array.")
        .def(
            "state",
            [](const ModeAnswer& m, std::int64_t cells) {
                return StateOf{std::make_shared<const State>(cellMeans(m.motion, cells)), m.bar};
            },
            py::arg("cells"), "At t = 0, the means over each of N cells.")
        .def("__repr__", [](const ModeAnswer& m) {
            return fmt::format(
                "ModeMotion(t_c = {} - {} T, period_ratio={:.10g}, "
                "energy_ratio={:.10g})",
                4 * m.mode.a, -m.mode.b, m.motion.period(), energyRatio(m.mode, m.motion.period()));
        });
    addModeMotionFields(shown);
}

std::vector<FamilyOf> families(std::int64_t maxOrder, std::optional<double> maxEnergyRatio,
                               const Bar& bar, const py::object& progress)
{
    return patiently(
        [=](const Wires& wires) {
            FamilyBounds bounds;
            bounds.maxEnergyRatio = maxEnergyRatio.value_or(bounds.maxEnergyRatio);
            bounds.gapSign = gapSign(bar);
            bounds.cancel = wires.cancel;
            std::vector<FamilyOf> list;
            std::int64_t order = 0;
            forEachFamily(maxOrder, bounds, [&](const Family& family) {
                if (std::exchange(order, family.order) < family.order) {
                    wires.progress(static_cast<double>(order), static_cast<double>(maxOrder));
                }
                list.push_back({family, bar});
                return true;
            });
            return list;
        },
        progress);
}

/// The same for modes, which need a gap.
int modeSign(const Bar& bar)
{
    if (bar.gap == 0.0) {
        Faults faults;
        faults.add("gap", 0.0,
                   "a gap > 0 or < 0 [m]: without one modes have a single period each, which "
                   "families lists");
        faults.throwIfAny();
    }
    return gapSign(bar);
}

std::vector<ModeOf> modes(std::int64_t maxOrder, double maxEnergyRatio, double maxPeriod,
                          const Bar& bar, const py::object& progress)
{
    return patiently(
        [=](const Wires& wires) {
            std::vector<ModeOf> list;
            for (const Mode& mode : findModes({.maxOrder = maxOrder,
                                    .maxPeriod = maxPeriod,
                                    .maxEnergyRatio = maxEnergyRatio,
                                    .gapSign = modeSign(bar),
                                    .cancel = wires.cancel,
                                    .progress = wires.progress})) {
                list.push_back({mode, bar});
            }
            return list;
        },
        progress);
}

ModeOf mode(std::int64_t a4, std::int64_t b, const Bar& bar)
{
    const std::optional<Mode> found =
        a4 > 0 && a4 % 4 == 0 && b < 0 ? findMode(a4 / 4, b, modeSign(bar)) : std::nullopt;
    if (!found) {
        throw std::invalid_argument(
            fmt::format("a4, b = {}, {} is out of range: allowed multiples of 4 and negative odd "
                        "numbers that modes() lists: there is no other mode",
                        a4, b));
    }
    return {*found, bar};
}

}  // namespace

void addLists(py::module_& module)
{
    addFamily(module);
    addMode(module);
    addModeMotion(module);
    module.def("families", &families);
    module.def("modes", &modes);
    module.def("mode", &mode);
}

}  // namespace signorini::python
