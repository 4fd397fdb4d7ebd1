#include "calls.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "arrays.hpp"
#include "asked.hpp"
#include "described.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"

namespace signorini::python {

namespace {

using answers::FamilyOf;
using answers::ModeOf;
using answers::withUnits;

/// The sign of the gap, as modes and families ask for it.
int gapSign(const Bar& bar)
{
    return stopsOf(bar).right;
}

void addFamily(py::module_& module)
{
    classOf<FamilyOf>(module)
        ->more()
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

void addMode(py::module_& module)
{
    classOf<ModeOf>(module)
        ->more()
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
                return withUnits(familiesOf(m.value, maxOrder), m.bar);
            },
            py::arg("max_order"), "Those of order w <= max_order that stand on it.")
        .def(
            "motion",
            [](const ModeOf& m, double period) {
                return ModeAnswer{m.value, m.bar, ModeMotion(m.value, period)};
            },
            py::arg("period_ratio"), "At T [L/c]: a ModeMotion. ValueError outside the interval.")
        .def("__hash__",
             [](const ModeOf& m) { return py::hash(asPython(answers::contactOf(m.value))); })
        .def("__repr__", [](const ModeOf& m) {
            return fmt::format("Mode(t_c = {} - {} T, {}/{} < T < {}/{} L/c)", 4 * m.value.a,
                               -m.value.b, m.value.lowest.numerator, m.value.lowest.denominator,
                               m.value.highest.numerator, m.value.highest.denominator);
        });
}

std::vector<FamilyOf> families(const Asked& asked)
{
    const auto maxOrder = asked.get<std::int64_t>("max_order");
    const auto maxEnergyRatio = asked.maybe<double>("max_energy_ratio");
    const Bar bar = asked.bar();
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
        asked.progress());
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

std::vector<ModeOf> modes(const Asked& asked)
{
    const Bar bar = asked.bar();
    ModeBounds bounds{.maxOrder = asked.get<std::int64_t>("max_order"),
                      .maxPeriod = asked.get<double>("max_period_ratio"),
                      .maxEnergyRatio = asked.get<double>("max_energy_ratio"),
                      .gapSign = modeSign(bar)};
    return patiently(
        [=](const Wires& wires) mutable {
            bounds.cancel = wires.cancel;
            bounds.progress = wires.progress;
            return withUnits(findModes(bounds), bar);
        },
        asked.progress());
}

ModeOf mode(const Asked& asked)
{
    const auto a4 = asked.get<std::int64_t>("a4");
    const auto b = asked.get<std::int64_t>("b");
    const Bar bar = asked.bar();
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

std::string familiesAsFigure(const std::vector<FamilyOf>& rows)
{
    std::vector<Family> families;
    for (const FamilyOf& row : rows) {
        families.push_back(row.value);
    }
    return asJson(familiesFigure(families, families.back().order, true));
}

std::string planeAsFigure(std::int64_t maxOrder, double left, double right, double top)
{
    const std::vector<Mode> modes = findModes({.maxEnergyRatio = top});
    const std::vector<Family> families = findFamilies(maxOrder);
    return asJson(frequencyEnergyFigure(
        {.modes = modes, .families = families},
        {.maxFrequencyRatio = right, .maxEnergyRatio = top, .leastFrequencyRatio = left}));
}

}  // namespace

void addLists(py::module_& module)
{
    addFamily(module);
    addMode(module);
    addCall(module, "families", &families);
    module.def("families_figure", &familiesAsFigure);
    module.def("frequency_energy_figure", &planeAsFigure);
    addCall(module, "modes", &modes);
    addCall(module, "mode", &mode);
}

}  // namespace signorini::python
