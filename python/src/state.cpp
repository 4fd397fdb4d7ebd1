#include <pybind11/stl.h>

#include "arrays.hpp"
#include "described.hpp"
#include "faults.hpp"
#include "scene.hpp"
#include "signorini/output.hpp"
#include "state_table.hpp"
#include "stepped_bar.hpp"

namespace signorini::python {

namespace {

std::shared_ptr<const State> stateOf(const Numbers& a, const Numbers& b)
{
    if (a.ndim() != 1 || b.ndim() != 1 || a.size() != b.size() || a.size() == 0) {
        throw std::invalid_argument(
            fmt::format("a, b = arrays of {} and {} values in {} and {} dimensions: allowed two of "
                        "one length >= 1 in one dimension",
                        a.size(), b.size(), a.ndim(), b.ndim()));
    }
    auto state = std::make_shared<State>();
    state->a = Eigen::VectorXd::Map(a.data(), a.size());
    state->b = Eigen::VectorXd::Map(b.data(), b.size());
    if (!state->a.allFinite() || !state->b.allFinite()) {
        throw std::invalid_argument("a, b = values that are not finite: allowed finite numbers");
    }
    return state;
}

/// One of the library's vectors as an array that is its own.
py::array_t<double> array(const Eigen::VectorXd& values)
{
    return py::array_t<double>(values.size(), values.data());
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

}  // namespace

void addState(py::module_& module)
{
    Record<StateOf> record(module, "State",
                           "The state of the bar at one instant: two waves. Cell i of N is "
                           "x_{i-1} < x < x_i = i L/N.");
    record
        .both("velocity", "velocity_unit", "v on each cell [m/s].",
              "v on each cell [c g/L], a + b.",
              [](const StateOf& s) { return array(velocity(*s.value)); })
        .both(
            "strain", "strain_unit", "s on each cell [-], tension > 0.",
            "s on each cell [g/L], b - a over its relative speed.",
            [](const StateOf& s) {
                return array(s.segments.empty() ? strain(*s.value) : strain(*s.value, s.segments));
            })
        .both("displacement", "displacement_unit", "u at x_1 ... x_N [m].", "u at x_1 ... x_N [g].",
              [](const StateOf& s) { return array(displacement(*s.value)); })
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

}  // namespace signorini::python
