#include "calls.hpp"

#include "faults.hpp"
#include "mapped.hpp"
#include "motion.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"

namespace signorini::python {

namespace {

using answers::FamilyOf;
using answers::ModeOf;
using answers::withUnits;

void addFamily(py::module_& module)
{
    classOf<FamilyOf>(module)
        ->has("bar", "Its units.", &FamilyOf::bar)
        .can("schedule", {"cells"}, "That has the whole set on N cells. ValueError unless w | 2N.",
             [](const FamilyOf& f, std::int64_t cells) {
                 return signorini::scheduleOf(f.value, cells);
             });
}

void addMode(py::module_& module)
{
    classOf<ModeOf>(module)
        ->has("bar", "Its units.", &ModeOf::bar)
        .has("kappa", "E/E_1 = 1/(kappa T - mu)^2.", [](const ModeOf& m) { return m.value.kappa; })
        .has("mu", "See kappa.", [](const ModeOf& m) { return m.value.mu; })
        .can("energy_ratio", {"period_ratio"},
             "E/E_1 at T [L/c], any array. ValueError outside the interval.",
             [](const ModeOf& m, const py::object& periods) {
                 return onPeriods(periods, [&m](double t) { return energyRatio(m.value, t); });
             })
        .can("contact_time_ratio", {"period_ratio"},
             "t_c [L/c] at T [L/c], any array. ValueError as above.",
             [](const ModeOf& m, const py::object& periods) {
                 return onPeriods(periods, [&m](double t) { return contactTime(m.value, t); });
             })
        .can("schedule", {"cells", "steps"}, "Of the motion with T = steps/cells L/c.",
             [](const ModeOf& m, std::int64_t cells, std::int64_t steps) {
                 return signorini::scheduleOf(m.value, cells, steps);
             })
        .can("families", {"max_order"}, "Those of order w <= max_order that stand on it.",
             [](const ModeOf& m, std::int64_t maxOrder) {
                 return withUnits(familiesOf(m.value, maxOrder), m.bar);
             })
        .more()
        .def(
            "motion",
            [](const ModeOf& m, double period, double gravity) {
                return answers::motionOf(m.value, m.bar, period, gravity);
            },
            py::arg("period_ratio"), py::arg("gravity") = 0.0,
            "At T [L/c], a ModeMotion; with the shape at rest under the gravity [m/s^2] that left "
            "the gap. ValueError outside the interval.");
}

std::vector<FamilyOf> families(const Asked& asked)
{
    const auto maxOrder = asked.get<std::int64_t>("max_order");
    const Bar bar = asked.bar();
    FamilyBounds bounds;
    bounds.maxEnergyRatio = asked.maybe<double>("max_energy_ratio").value_or(bounds.maxEnergyRatio);
    bounds.gapSign = stopsOf(bar).right;
    return patiently(
        [=](const Wires& wires) mutable {
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

/// Those with one contact, or what several fill.
py::object modes(const Asked& asked)
{
    const Bar bar = asked.bar();
    const auto phases = asked.get<std::int64_t>("phases");
    ModeBounds bounds{.maxOrder = asked.get<std::int64_t>("max_order"),
                      .maxPeriod = asked.get<double>("max_period_ratio"),
                      .maxEnergyRatio = asked.get<double>("max_energy_ratio"),
                      .gapSign = phases == 1 ? answers::gapSignOfModes(bar) : stopsOf(bar).right};
    const auto listed = [&](auto search) {
        return py::cast(patiently(
            [=](const Wires& wires) mutable {
                bounds.cancel = wires.cancel;
                bounds.progress = wires.progress;
                return withUnits(search(bounds), bar);
            },
            asked.progress()));
    };
    return phases == 1 ? listed(&findModes)
                       : listed([phases](const ModeBounds& b) { return findPolytopes(phases, b); });
}

ModeOf mode(const Asked& asked)
{
    const auto a4 = asked.get<std::int64_t>("a4");
    const auto b = asked.get<std::int64_t>("b");
    const Bar bar = asked.bar();
    const std::optional<Mode> found = a4 > 0 && a4 % 4 == 0 && b < 0
                                          ? findMode(a4 / 4, b, answers::gapSignOfModes(bar))
                                          : std::nullopt;
    if (!found) {
        throwFault("a4, b", fmt::format("{}, {}", a4, b),
                   "multiples of 4 and negative odd numbers that modes() lists: there is no other "
                   "mode");
    }
    return {*found, bar};
}

std::string familiesAsFigure(const std::vector<FamilyOf>& rows)
{
    return asJson(familiesFigure(mapped(rows, &FamilyOf::value), rows.back().value.order, true));
}

std::string polytopesAsFigure(const std::vector<answers::PolytopeOf>& rows, double top)
{
    FrequencyEnergyOptions drawing{.maxEnergyRatio = top};
    if (!rows.empty()) {
        drawing.bar = rows.front().bar;
    }
    return asJson(polytopesFigure(mapped(rows, &answers::PolytopeOf::value), drawing));
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
    addCall(module, "about_rest", [](const Asked& asked) {
        return aboutRest(asked.bar(), asked.get<double>("gravity")).bar;
    });
    module.def("families_figure", &familiesAsFigure);
    module.def("polytopes_figure", &polytopesAsFigure);
    module.def("frequency_energy_figure", &planeAsFigure);
    addCall(module, "modes", &modes);
    addCall(module, "mode", &mode);
}

}  // namespace signorini::python
