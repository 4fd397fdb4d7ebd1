#include "scene.hpp"

#include <pybind11/stl.h>

#include <array>

#include "arrays.hpp"
#include "asked.hpp"
#include "contact_spans.hpp"
#include "described.hpp"
#include "faults.hpp"
#include "scene_answer.hpp"
#include "scene_figures.hpp"
#include "stepped_bar.hpp"

namespace signorini::python {

namespace {

void addBar(py::module_& module)
{
    const auto record = classOf<Bar>(module, "A bar and its wall, in SI units.");
    using Number = std::optional<Quantity>;
    record->more().def(
        py::init([](const Quantity& length, const Number& waveSpeed, const Number& axialStiffness,
                    const Quantity& gap, const Number& young, const Number& density,
                    const Number& area) {
            Bar bar{.length = quantityOf("length", length),
                    .gap = quantityOf("gap", gap),
                    .young = quantityOf("young", young)};
            warnIf(bar.young && *bar.young < answers::softestModulus,
                   "young is softer than rubber: GPa are \"210GPa\"");
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
    const auto segment = classOf<Segment>(module, "Equal cells of one material of a stepped bar.");
    segment->more().def(
        py::init([](std::int64_t cells, double impedance, double speed, double dashpot) {
            return Segment{cells, impedance, speed, dashpot};
        }),
        py::arg("cells"), py::arg("impedance") = 1.0, py::arg("speed") = 1.0,
        py::arg("dashpot") = 0.0);
    const auto scene = classOf<Scene>(module, "A bar, its stops, and what it is made of.");
    scene
        ->drawsScene([](const Scene& of) {
            Assembly assembly = answers::assemblyOf(of, usualCells, {});
            std::erase_if(assembly.parts, [](const AssemblyPart& part) {
                return part.kind == PartKind::driven || part.kind == PartKind::shaken;
            });
            return assembly;
        })
        .more()
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
            R"(A stepped bar as a drawing has it, on at most `cells` cells with whole travel times.

Pieces are (length [m], young [Pa], density [kg/m^3], area [m^2]), clamp first. Impedances, speeds
and the time through all pieces are kept, lengths are rounded: by how much at most, relative, is
returned with the Scene. ValueError names the piece that is out of its range.)",
            py::arg("pieces"), py::kw_only(), py::arg("gap") = Bar{}.gap,
            py::arg("second_stop") = py::none(), py::arg("cells") = 300)
        .def_readonly("second_stop", &Scene::secondStop, "h [m], or None.");
}

void addSchedule(py::module_& module)
{
    Record<Schedule> record(module, "Schedule", "Contacts and flights of one period, in steps.");
    record.key("cells", &Schedule::cells, "N, cells of the bar.")
        .key("phases", &Schedule::phases, "[(n_c, n_f), ...], contact and free steps.")
        .has("steps", "n, all steps of a period.", [](const Schedule& s) { return steps(s); })
        .has("period_ratio", "c T/L = n/N.", [](const Schedule& s) { return period(s); })
        .has("frequency_ratio", "omega/omega_1 = 4N/n.",
             [](const Schedule& s) { return frequencyRatio(s); })
        .has("_text", "For people.", [](const Schedule& s) { return describe(s); })
        .has("_spans", "As of a scene.", [](const Schedule& s) { return textOf(spansOf(s)); });
    record.more().def(py::init([](const py::args& words, std::optional<std::int64_t> cells) {
                          const py::object read =
                              py::module_::import("signorini._words").attr("phases_of");
                          return scheduleOf(read(words), cells);
                      }),
                      py::arg("cells") = py::none());
}

}  // namespace

Schedule scheduleOf(const py::list& phases, std::optional<std::int64_t> cells)
{
    Schedule made{cells.value_or(usualCells), {}};
    for (const py::handle& phase : phases) {
        const auto& [contact, free, isLeft] =
            py::cast<std::tuple<std::int64_t, std::int64_t, bool>>(phase);
        made.phases.push_back({contact, free, isLeft ? Stop::left : Stop::right});
    }
    // Where the stops are is the scene's to say.
    Schedule anywhere = made;
    anywhere.stops.left = Fraction{1, 1};
    validate(anywhere);
    return made;
}

void addScene(py::module_& module)
{
    addBar(module);
    addWholeScene(module);
    addCall(module, "words_of", [](const Asked& asked) {
        const Scene scene = asked.scene();
        const auto cells = asked.maybe<std::int64_t>("cells");
        if (cells && !scene.segments.empty()) {
            requireCells(steppedBar(scene.segments), *cells);
        }
        return textOf(
            answers::assemblyOf(scene, cells.value_or(usualCells), asked.dampingIfGiven()).parts);
    });
    addSchedule(module);
    addState(module);
}

}  // namespace signorini::python
