#include "calls.hpp"

#include "signorini/modes.hpp"

namespace signorini::python {

namespace {

void addFamily(py::module_& module)
{
    Record<FamilyOf>(module).can("schedule", {"cells"},
                                 "That has the whole set on N cells. ValueError unless w | 2N.",
                                 [](const FamilyOf& f, std::int64_t cells) {
                                     return signorini::scheduleOf(f.value, cells);
                                 });
}

/// What modes and polytopes share.
template <typename T>
void addShape(Record<T>& record)
{
    record.can("energy_ratio", {"period_ratio"},
               "E/E_1 at T [L/c], any array. ValueError outside the interval.",
               [](const T& shape, const py::object& periods) {
                   return onEach(periods, [&](double t) { return energyRatio(shape.value, t); });
               });
}

void addMode(py::module_& module)
{
    Record<ModeOf> record(module);
    addShape(record);
    record
        .can("contact_time_ratio", {"period_ratio"},
             "t_c [L/c] at T [L/c], any array. ValueError as above.",
             [](const ModeOf& m, const py::object& periods) {
                 return onEach(periods, [&m](double t) { return contactTime(m.value, t); });
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
                return motionOf(m.value, m.bar, period, gravity);
            },
            py::arg("period_ratio"), py::arg("gravity") = 0.0,
            "At T [L/c], a ModeMotion; with the shape at rest under the gravity [m/s^2] that left "
            "the gap. ValueError outside the interval.");
}

/// The bar that is asked about, at rest under "gravity".
Bar barAtRest(const Asked& asked)
{
    return aboutRest(asked.bar(), asked.maybe<double>("gravity").value_or(0.0)).bar;
}

py::dict families(const Asked& asked)
{
    return dictionaryOf(
        patiently(asked, familiesAsked(asked, barAtRest(asked), asked.get<double>("gravity"))));
}

/// Those with one contact, or what several fill.
py::dict modes(const Asked& asked)
{
    const Bar bar = barAtRest(asked);
    const double gravity = asked.get<double>("gravity");
    const auto phases = asked.get<std::int64_t>("phases");
    return phases == 1
               ? dictionaryOf(patiently(asked, modesAsked(asked, bar, gravity)))
               : dictionaryOf(patiently(asked, polytopesAsked(asked, phases, bar, gravity)));
}

ModeOf mode(const Asked& asked)
{
    const auto a4 = asked.get<std::int64_t>("a4");
    const auto b = asked.get<std::int64_t>("b");
    const Bar bar = barAtRest(asked);
    const std::optional<Mode> found =
        a4 > 0 && a4 % 4 == 0 && b < 0 ? findMode(a4 / 4, b, gapSignOfModes(bar)) : std::nullopt;
    if (!found) {
        throwFault("a4, b", fmt::format("{}, {}", a4, b),
                   "multiples of 4 and negative odd numbers that modes() lists: there is no other "
                   "mode");
    }
    return {*found, bar};
}

FigureData familiesAsFigure(const std::vector<FamilyOf>& rows)
{
    return familiesFigure(mapped(rows, &FamilyOf::value), rows.back().value.order, true);
}

FigureData polytopesAsFigure(const std::vector<PolytopeOf>& rows, double top)
{
    FrequencyEnergyOptions drawing{.maxEnergyRatio = top};
    if (!rows.empty()) {
        drawing.bar = rows.front().bar;
    }
    return polytopesFigure(mapped(rows, &PolytopeOf::value), drawing);
}

FigureData planeAsFigure(std::int64_t maxOrder, double left, double right, double top)
{
    const std::vector<Mode> modes = findModes({.maxEnergyRatio = top});
    const std::vector<Family> families = findFamilies(maxOrder);
    return frequencyEnergyFigure(
        {.modes = modes, .families = families},
        {.maxFrequencyRatio = right, .maxEnergyRatio = top, .leastFrequencyRatio = left});
}

PolytopeAnswer polytopeMotion(const PolytopeOf& p, double period,
                              const std::optional<std::vector<double>>& arrivals)
{
    const ModePoint point = arrivals ? ModePoint{period, *arrivals} : middle(p.value, period);
    return {p.value, p.bar, point, ModeMotion(p.value, point)};
}

void addPolytope(py::module_& module)
{
    Record<PolytopeOf> record(module);
    addShape(record);
    record
        .can("slice", {"period_ratio"},
             "Arrivals s_2 ... s_K [L/c] at the corners of T [L/c], an array of shape (corners, "
             "K - 1): the motions of this period are their means, ends excluded. ValueError "
             "outside the interval.",
             [](const PolytopeOf& p, double period) {
                 return Numbers(py::cast(mapped(slice(p.value, period), &ModePoint::arrivals)));
             })
        .can("stretches", {"period_ratio", "arrivals"},
             "Contact and flight in turn, 2K lengths [L/c]. ValueError unless there are K - 1 "
             "arrivals.",
             [](const PolytopeOf& p, double period, const std::vector<double>& arrivals) {
                 return Numbers(py::cast(stretches(p.value, {period, arrivals})));
             })
        .can("schedules", {"cells", "steps"},
             "On N cells, of the motions with T = steps/cells L/c, one for each orbit.",
             [](const PolytopeOf& p, std::int64_t cells, std::int64_t steps) {
                 return schedulesOf(p.value, cells, steps);
             })
        .more()
        .def("motion", &polytopeMotion, py::arg("period_ratio"), py::arg("arrivals") = py::none(),
             "At T and arrivals s_2 ... s_K [L/c], in the middle without: a PolytopeMotion. "
             "ValueError outside.");
}

std::optional<PolytopeOf> polytope(const Asked& asked)
{
    const Schedule schedule = asked.schedule();
    const Bar bar = asked.bar();
    const auto found = patiently(asked, [=](const Watch&) { return polytopeOf(schedule); });
    return found ? std::optional(PolytopeOf{*found, bar}) : std::nullopt;
}

}  // namespace

void addModes(py::module_& module)
{
    addFamily(module);
    addMode(module);
    addClasses<ModeChain>(module);
    addPolytope(module);
    module.def("families", &families);
    module.def("families_figure", &familiesAsFigure);
    module.def("polytopes_figure", &polytopesAsFigure);
    module.def("frequency_energy_figure", &planeAsFigure);
    module.def("modes", &modes);
    module.def("mode", &mode);
    module.def("polytope", &polytope);
}

}  // namespace signorini::python
