#include "calls.hpp"

#include <pybind11/eigen.h>

#include <array>

#include "contact_spans.hpp"
#include "scene_answer.hpp"
#include "scene_figures.hpp"
#include "state_table.hpp"

namespace signorini::python {

namespace {

void addBar(py::module_& module)
{
    Record<Bar> record(module);
    record.more().def(py::init([](const py::kwargs& given) {
        const Bar bar = barAsked(Asked(given), true);
        warnIf(bar.young && *bar.young < softestModulus,
               "young is softer than rubber: GPa are \"210GPa\"");
        return bar;
    }));
}

void addWholeScene(py::module_& module)
{
    Record<Segment> segment(module);
    segment.more().def(py::init<std::int64_t, double, double, double>(), py::arg("cells"),
                       py::arg("impedance") = 1.0, py::arg("speed") = 1.0,
                       py::arg("dashpot") = 0.0);
    Record<SceneOf> scene(module);
    scene
        .drawsScene([](const SceneOf& of) {
            Assembly assembly =
                of.more.empty() ? assemblyOf(of, usualCells, {}) : assemblyIn(of.more, of.bar);
            if (!of.more.empty()) {
                return assembly;
            }
            std::erase_if(assembly.parts, [](const AssemblyPart& part) {
                return part.kind == PartKind::driven || part.kind == PartKind::shaken;
            });
            return assembly;
        })
        .more()
        .def(py::init([](const Bar& bar, const std::optional<Quantity>& secondStop,
                         const std::vector<Segment>& segments) {
                 SceneOf made{{bar, quantityOf("second_stop", secondStop), segments}, {}};
                 validate(made);
                 return made;
             }),
             py::arg("bar") = Bar{}, py::arg("second_stop") = py::none(),
             py::arg("segments") = std::vector<Segment>{})
        .def(py::init([](const std::string& words, const Bar& bar) {
                 (void)assemblyIn(words, bar);
                 return SceneOf{bar, words};
             }),
             py::arg("words"), py::arg("bar") = Bar{})
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
    record.key("cells", "-", "N, cells of the bar.", &Schedule::cells);
    record.key("phases", "-", "[(n_c, n_f), ...], contact and free steps.", &Schedule::phases);
    record.has("steps", "n, all steps of a period.", [](const Schedule& s) { return steps(s); })
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

std::shared_ptr<const State> stateOf(const Numbers& a, const Numbers& b)
{
    refuseIf(
        a.ndim() != 1 || b.ndim() != 1 || a.size() != b.size() || a.size() == 0,
        fmt::format("a, b = arrays of {} and {} values in {} and {} dimensions: allowed two of "
                    "one length >= 1 in one dimension",
                    a.size(), b.size(), a.ndim(), b.ndim()));
    auto state = std::make_shared<State>();
    state->a = Eigen::VectorXd::Map(a.data(), a.size());
    state->b = Eigen::VectorXd::Map(b.data(), b.size());
    refuseIf(!state->a.allFinite() || !state->b.allFinite(),
             "a, b = values that are not finite: allowed finite numbers");
    return state;
}

py::array_t<double> waveOf(const StateOf& s, Eigen::VectorXd State::*wave)
{
    const Eigen::VectorXd& values = (*s.value).*wave;
    return view(values.data(), static_cast<std::size_t>(values.size()), s.value);
}

StateOf finer(const StateOf& s, std::int64_t factor)
{
    const std::int64_t most = mostCells / s.value->cells();
    if (factor < 1 || factor > most) {
        throwFault("factor", factor, fmt::format("whole numbers 1..{}", most));
    }
    StateOf fine{std::make_shared<const State>(refined(*s.value, factor)), s.bar, s.segments};
    for (Segment& segment : fine.segments) {
        segment.cells *= factor;
    }
    return fine;
}

void addState(py::module_& module)
{
    Record<StateOf> record(module, "State",
                           "The state of the bar at one instant: two waves. Cell i of N is "
                           "x_{i-1} < x < x_i = i L/N.");
    record
        .both("velocity", "velocity_unit", "v on each cell [m/s].",
              "v on each cell [c g/L], a + b.", [](const StateOf& s) { return velocity(*s.value); })
        .both("strain", "strain_unit", "s on each cell [-], tension > 0.",
              "s on each cell [g/L], b - a over its relative speed.",
              [](const StateOf& s) {
                  return s.segments.empty() ? strain(*s.value) : strain(*s.value, s.segments);
              })
        .both("displacement", "displacement_unit", "u at x_1 ... x_N [m].", "u at x_1 ... x_N [g].",
              [](const StateOf& s) { return displacement(*s.value); })
        .both("energy", "energy_unit", "E [J].", "E/E_1.",
              [](const StateOf& s) { return energyRatio(*s.value, s.segments); })
        .has("cells", "N.", [](const StateOf& s) { return s.value->cells(); })
        .has("bar", "Its units.", &StateOf::bar)
        .has("segments", "[Segment, ...]; none of a uniform bar.", &StateOf::segments)
        .has("a", "Right-going wave r_1 on each cell [g/L]; read-only, no copy.",
             [](const StateOf& s) { return waveOf(s, &State::a); })
        .has("b", "Left-going wave r_2 on each cell [g/L]; read-only, no copy.",
             [](const StateOf& s) { return waveOf(s, &State::b); })
        .can("refined", {"factor"}, "The same state on `factor` times as many cells.", &finer)
        .can("write", {"path"},
             "Writes the file that ``signorini find --state`` writes. OSError if it cannot be "
             "written.",
             [](const StateOf& s, const std::string& path) {
                 OutputFiles files;
                 if (haveOneSpeed(s.segments)) {
                     writeStateCsv(files.stage(path), *s.value, s.bar);
                 } else {  // its nodes are on no even grid
                     const double tip = (s.value->b - s.value->a).mean();
                     writeStateTable(files.stage(path), wavesOf(*s.value), tip, s.bar);
                 }
                 files.commit();
             });
    record.more()
        .def(py::init([](const py::object& a, const py::object& b, const std::optional<Bar>& bar,
                         const std::vector<Segment>& segments) {
                 StateOf state{stateOf(numbersOf(a, "a"), numbersOf(b, "b")), bar.value_or(Bar{}),
                               segments};
                 if (!segments.empty()) {
                     requireCells(steppedBar(segments), state.value->cells());
                 }
                 return state;
             }),
             py::arg("a"), py::arg("b"), py::arg("bar") = py::none(),
             py::arg("segments") = std::vector<Segment>{})
        .def_static(
            "read",
            [](const std::string& path, const std::optional<Bar>& bar, std::int64_t cells) {
                const Bar units = bar.value_or(Bar{});
                return StateOf{
                    std::make_shared<const State>(readState(path, units, cells).state), units, {}};
            },
            py::arg("path"), py::arg("bar") = py::none(), py::arg("cells") = usualCells,
            "A state from a file: one that `write` wrote, or measurements, put onto so many cells.")
        .def("__len__", [](const StateOf& s) { return s.value->cells(); });
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
    module.def("words_of", [](const Asked& asked) {
        const Scene scene = asked.scene();
        const auto cells = asked.maybe<std::int64_t>("cells");
        if (cells && !scene.segments.empty()) {
            requireCells(steppedBar(scene.segments), *cells);
        }
        return textOf(assemblyOf(scene, cells.value_or(usualCells), asked.damping()).parts);
    });
    addSchedule(module);
    addState(module);
}

}  // namespace signorini::python
