#include "scene.hpp"

#include <pybind11/stl.h>

#include <array>
#include <cmath>

#include "described.hpp"
#include "faults.hpp"
#include "numbers.hpp"
#include "scene_answer.hpp"
#include "scene_figures.hpp"

namespace signorini::python {

namespace {

void addBar(py::module_& module)
{
    const auto record = classOf<Bar>(module, R"(A bar and its wall, in SI units.

Parameters
----------
length : float
    L [m].
wave_speed : float
    c [m/s], sqrt(E/rho).
axial_stiffness : float
    EA [N].
gap : float
    g [m], from the tip at rest to the wall.
young : float, optional
    E [Pa]; turns strain into stress. With `density` and `area` it stands in place of `wave_speed`
    and `axial_stiffness`.
density : float, optional
    rho [kg/m^3].
area : float, optional
    Cross-section [m^2].

Raises
------
ValueError
    If a value is out of its range, or two of them clash.
)");
    using Number = std::optional<Quantity>;
    record->more().def(
        py::init([](const Quantity& length, const Number& waveSpeed, const Number& axialStiffness,
                    const Quantity& gap, const Number& young, const Number& density,
                    const Number& area) {
            Bar bar{.length = quantityOf("length", length),
                    .gap = quantityOf("gap", gap),
                    .young = quantityOf("young", young)};
            if (density || area) {
                if (!young || !density || !area) {
                    throw std::invalid_argument(
                        "young, density, area: allowed only all three together");
                }
                if (waveSpeed || axialStiffness) {
                    throw std::invalid_argument(
                        "young, density, area clash with wave_speed, axial_stiffness: allowed "
                        "one set");
                }
                return barOfMaterial(bar.length, *bar.young, *quantityOf("density", density),
                                     *quantityOf("area", area), bar.gap);
            }
            bar.waveSpeed = quantityOf("wave_speed", waveSpeed).value_or(bar.waveSpeed);
            bar.axialStiffness =
                quantityOf("axial_stiffness", axialStiffness).value_or(bar.axialStiffness);
            validate(bar);
            return bar;
        }),
        py::kw_only(), py::arg("length") = Bar{}.length, py::arg("wave_speed") = py::none(),
        py::arg("axial_stiffness") = py::none(), py::arg("gap") = Bar{}.gap,
        py::arg("young") = py::none(), py::arg("density") = py::none(),
        py::arg("area") = py::none());
    for (const auto& [name, unit, doc] :
         {std::tuple("energy_unit", &Scales::energy,
                     "E_1 = EA g^2/(2L) [J]: the unit of every `energy_ratio`."),
          std::tuple("time_unit", &Scales::time,
                     "L/c [s]: the unit of every `period_ratio` and other times."),
          std::tuple("strain_unit", &Scales::strain, "g/L [-]: the unit of waves and strains."),
          std::tuple("velocity_unit", &Scales::velocity, "c g/L [m/s]: the unit of velocities."),
          std::tuple("displacement_unit", &Scales::displacement,
                     "g [m]: the unit of displacements.")}) {
        record->has(name, doc, [unit = unit](const Bar& bar) { return scales(bar).*unit; });
    }
    record->has("force_unit", "EA g/L [N]: the unit of forces.", &forceUnit)
        .has("impulse_unit", "EA g/c [N s]: the unit of impulses.", &impulseUnit)
        .has("frequency_unit", "omega_1/(2 pi) = c/(4L) [Hz]: the unit of `frequency_ratio`.",
             [](const Bar& bar) { return 0.25 / scales(bar).time; });
}

void addWholeScene(py::module_& module)
{
    const auto segment = classOf<Segment>(module, R"(Equal cells of one material of a stepped bar.

Parameters
----------
cells : int
    A wave crosses each in the same time.
impedance, speed : float
    Relative to the first segment.
dashpot : float
    At the joint after it, relative to the first impedance.
)");
    segment->more().def(
        py::init([](std::int64_t cells, double impedance, double speed, double dashpot) {
            return Segment{cells, impedance, speed, dashpot};
        }),
        py::arg("cells"), py::arg("impedance") = 1.0, py::arg("speed") = 1.0,
        py::arg("dashpot") = 0.0);
    const auto scene = classOf<Scene>(module, R"(A bar, its stops, and what it is made of.

Parameters
----------
bar : Bar, optional
    The first segment's material; its gap may be 0, or negative: pressed at rest.
second_stop : float, optional
    h [m]: a stop at u(L) = -h.
segments : list of Segment, optional
    Clamp first; a uniform bar without.

Raises
------
ValueError
    If a value is out of its range.
)");
    scene->more()
        .def(py::init([](const Bar& bar, const std::optional<Quantity>& secondStop,
                         const std::vector<Segment>& segments) {
                 Scene made(bar, quantityOf("second_stop", secondStop), segments);
                 validate(made);
                 return made;
             }),
             py::arg("bar") = Bar{}, py::arg("second_stop") = py::none(),
             py::arg("segments") = std::vector<Segment>{})
        .def_static(
            "of_pieces",
            [](const std::vector<std::array<Quantity, 4>>& pieces, const Quantity& gap,
               const std::optional<Quantity>& secondStop, std::int64_t cells) {
                std::vector<BarPiece> list;
                for (const auto& [length, young, density, area] : pieces) {
                    list.push_back({quantityOf("length", length), quantityOf("young", young),
                                    quantityOf("density", density), quantityOf("area", area)});
                }
                PiecedBar made = barOfPieces(list, quantityOf("gap", gap), cells);
                made.scene.secondStop = quantityOf("second_stop", secondStop);
                validate(made.scene);
                return std::pair(made.scene, made.rounding);
            },
            R"(A stepped bar as a drawing has it, on cells with whole travel times.

Impedances, speeds and the time through all pieces are kept, lengths are rounded.

Parameters
----------
pieces : list of (length [m], young [Pa], density [kg/m^3], area [m^2])
    Clamp first.
gap : float
    [m], from the tip at rest to the wall.
second_stop : float, optional
    h [m]: a stop at u(L) = -h.
cells : int
    At most, of all pieces.

Returns
-------
(Scene, float)
    The scene, and how far a length was rounded at most, relative.

Raises
------
ValueError
    If a value is out of its range; the message names the piece.
)",
            py::arg("pieces"), py::kw_only(), py::arg("gap") = Bar{}.gap,
            py::arg("second_stop") = py::none(), py::arg("cells") = 300)
        .def("_figure",
             [](const Scene& of) {
                 Assembly assembly = answers::assemblyOf(of, usualCells, {});
                 std::erase_if(assembly.parts, [](const AssemblyPart& part) {
                     return part.kind == PartKind::driven || part.kind == PartKind::shaken;
                 });
                 return asJson(sceneFigure(assembly));
             })
        .def_readonly("second_stop", &Scene::secondStop, "h [m], or None.");
}

void addSchedule(py::module_& module)
{
    Record<Schedule> record(module, "Schedule", R"(Contacts and flights of one period, in steps.

A sequence of pairs (n_c, n_f), equal to any other such sequence.

Parameters
----------
*steps : int, or pairs of int
    n_c, n_f of each phase in turn: ``Schedule(150, 900)``, ``Schedule((1, 12), (3, 12), cells=4)``.
cells : int
    N, cells of the bar.

Raises
------
ValueError
    If a number is out of its range.
)");
    record
        .key(
            "cells", [](const Schedule& s) { return s.cells; }, "N, cells of the bar.")
        .key(
            "phases", [](const Schedule& s) { return asPython(s.phases); },
            "[(n_c, n_f), ...], contact and free steps.")
        .has("steps", "n, all steps of a period.", [](const Schedule& s) { return steps(s); })
        .has("period_ratio", "c T/L = n/N.", [](const Schedule& s) { return period(s); })
        .has("frequency_ratio", "omega/omega_1 = 4N/n.",
             [](const Schedule& s) { return frequencyRatio(s); })
        .has("_text", "For people.", [](const Schedule& s) { return describe(s); });
    record.more().def(py::init([](const py::args& words, std::optional<std::int64_t> cells) {
                          return scheduleOf(words, cells);
                      }),
                      py::arg("cells") = py::none());
}

}  // namespace

double ratioOf(double energy, const Bar& bar)
{
    const double ratio = energy / scales(bar).energy;
    Faults faults;
    faults.requirePositive("energy", energy, "J");
    if (std::isfinite(energy) && !std::isfinite(ratio)) {
        faults.add("energy", energy, "what is finite in E_1");
    }
    faults.throwIfAny();
    return ratio;
}

/// "left" or "right".
Stop stopOf(const py::handle& value)
{
    const auto word = py::cast<std::string>(py::str(value));
    if (word != name(Stop::left) && word != name(Stop::right)) {
        Faults faults;
        faults.add("stop", word, "left|right");
        faults.throwIfAny();
    }
    return word == name(Stop::left) ? Stop::left : Stop::right;
}

std::int64_t wholeOf(const py::handle& value, const char* name)
{
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!index) {
        PyErr_Clear();
        throw py::type_error(fmt::format("{} = {}: allowed whole numbers", name,
                                         shortened(py::cast<std::string>(py::repr(value)))));
    }
    int overflow = 0;
    const long long whole = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
    if (overflow != 0) {
        throw std::invalid_argument(
            fmt::format("{} = {} is out of range: allowed whole numbers 1..{}", name,
                        shortened(py::cast<std::string>(py::str(index))), maxSteps));
    }
    return whole;
}

Schedule scheduleOf(const py::tuple& words, std::optional<std::int64_t> cells)
{
    if (words.size() == 1 && py::isinstance<Schedule>(words[0])) {
        const auto schedule = py::cast<Schedule>(words[0]);
        if (cells && *cells != schedule.cells) {
            throw std::invalid_argument(
                fmt::format("cells = {} clashes with those of the schedule: allowed {}", *cells,
                            schedule.cells));
        }
        return schedule;
    }
    Schedule schedule{cells.value_or(usualCells), {}};
    std::vector<std::int64_t> steps;
    std::vector<Stop> stops;
    for (const py::handle& word : words) {
        if (py::isinstance<py::sequence>(word) && !py::isinstance<py::str>(word)) {
            const auto pair = py::reinterpret_borrow<py::sequence>(word);
            if (pair.size() < 2 || pair.size() > 3 || steps.size() % 2 != 0) {
                throw std::invalid_argument(
                    "n_c, n_f, ...: allowed pairs of contact and free steps, with \"left\" those "
                    "on "
                    "the second stop");
            }
            steps.push_back(wholeOf(pair[0], "n_c"));
            steps.push_back(wholeOf(pair[1], "n_f"));
            stops.push_back(pair.size() == 3 ? stopOf(pair[2]) : Stop::right);
        } else {
            steps.push_back(wholeOf(word, steps.size() % 2 == 0 ? "n_c" : "n_f"));
            stops.resize(steps.size() / 2, Stop::right);
        }
    }
    if (steps.empty() || steps.size() % 2 != 0) {
        throw std::invalid_argument(fmt::format(
            "n_c, n_f, ... = {} step counts is out of range: allowed an even number of them, at "
            "least 2",
            steps.size()));
    }
    for (std::size_t k = 0; k < steps.size(); k += 2) {
        schedule.phases.push_back({steps[k], steps[k + 1], stops[k / 2]});
    }
    // Where the stops are is the scene's to say.
    Schedule anywhere = schedule;
    anywhere.stops.left = Fraction{1, 1};
    validate(anywhere);
    return schedule;
}

void addScene(py::module_& module)
{
    addBar(module);
    addWholeScene(module);
    addSchedule(module);
    addState(module);
}

}  // namespace signorini::python
