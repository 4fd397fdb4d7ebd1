#include <pybind11/stl.h>

#include "arrays.hpp"
#include "asked.hpp"
#include "calls.hpp"
#include "described.hpp"
#include "motion.hpp"
#include "patience.hpp"

namespace signorini::python {

namespace {

using answers::PolytopeOf;

/// An array with a row for each list; all are of one length.
py::array_t<double> rowsOf(const std::vector<ModePoint>& points, std::size_t columns)
{
    py::array_t<double> array({points.size(), columns});
    double* to = array.mutable_data();
    for (const ModePoint& point : points) {
        to = std::copy(point.arrivals.begin(), point.arrivals.end(), to);
    }
    return array;
}

/// The mean of the corners at one period, where nothing else is asked for.
std::vector<double> middle(const ModePolytope& polytope, double period)
{
    const std::vector<ModePoint> corners = slice(polytope, period);
    std::vector<double> mean(polytope.chains.size() - 1, 0.0);
    for (const ModePoint& corner : corners) {
        for (std::size_t l = 0; l < mean.size(); ++l) {
            mean[l] += corner.arrivals[l] / static_cast<double>(corners.size());
        }
    }
    return mean;
}

PolytopeAnswer motionOf(const PolytopeOf& p, double period,
                        const std::optional<std::vector<double>>& arrivals)
{
    const ModePoint point{period, arrivals ? *arrivals : middle(p.value, period)};
    return {p.value, p.bar, point, ModeMotion(p.value, point)};
}

void addPolytope(py::module_& module)
{
    classOf<PolytopeOf>(module)
        ->more()
        .def_property_readonly(
            "bar", [](const PolytopeOf& p) { return p.bar; }, "Its units.")
        .def_property_readonly(
            "phases", [](const PolytopeOf& p) { return p.value.chains.size(); }, "K.")
        .def(
            "energy_ratio",
            [](const PolytopeOf& p, const py::object& periods) {
                return onPeriods(periods, [&p](double t) { return energyRatio(p.value, t); });
            },
            py::arg("period_ratio"),
            "E/E_1 at T [L/c], any array. ValueError outside the interval.")
        .def(
            "slice",
            [](const PolytopeOf& p, double period) {
                return rowsOf(slice(p.value, period), p.value.chains.size() - 1);
            },
            py::arg("period_ratio"),
            "Arrivals s_2 ... s_K [L/c] at the corners of T [L/c], an array of shape (corners, "
            "K - 1): the motions of this period are their means, ends excluded. ValueError outside "
            "the interval.")
        .def(
            "stretches",
            [](const PolytopeOf& p, double period, const std::vector<double>& arrivals) {
                const auto times = stretches(p.value, {period, arrivals});
                return filled(static_cast<std::int64_t>(times.size()), [&times](std::int64_t k) {
                    return times[static_cast<std::size_t>(k)];
                });
            },
            py::arg("period_ratio"), py::arg("arrivals"),
            "Contact and flight in turn, 2K lengths [L/c]. ValueError unless there are K - 1 "
            "arrivals.")
        .def("motion", &motionOf, py::arg("period_ratio"), py::arg("arrivals") = py::none(),
             "At T and arrivals s_2 ... s_K [L/c], in the middle without: a PolytopeMotion. "
             "ValueError outside.")
        .def(
            "schedules",
            [](const PolytopeOf& p, std::int64_t cells, std::int64_t steps) {
                return schedulesOf(p.value, cells, steps);
            },
            py::arg("cells"), py::arg("steps"),
            "On N cells, of the motions with T = steps/cells L/c, one for each orbit.")
        .def("__hash__",
             [](const PolytopeOf& p) {
                 py::list list;
                 for (const ModeChain& chain : p.value.chains) {
                     list.append(py::make_tuple(chain.k, chain.turns, chain.release));
                 }
                 return py::hash(py::tuple(list));
             })
        .def("__repr__", [](const PolytopeOf& p) {
            std::string chains;
            for (const ModeChain& chain : p.value.chains) {
                chains += fmt::format("{}/{}->{}, ", chain.k, chain.turns, chain.release + 1);
            }
            return fmt::format("ModePolytope({}{}/{} < T < {}/{} L/c, {} free)", chains,
                               p.value.lowest.numerator, p.value.lowest.denominator,
                               p.value.highest.numerator, p.value.highest.denominator,
                               p.value.dimension);
        });
}

std::vector<PolytopeOf> polytopes(const Asked& asked)
{
    const Bar bar = asked.bar();
    const auto phases = asked.get<std::int64_t>("phases");
    ModeBounds bounds{.maxOrder = asked.get<std::int64_t>("max_order"),
                      .maxPeriod = asked.get<double>("max_period_ratio"),
                      .maxEnergyRatio = asked.get<double>("max_energy_ratio"),
                      .gapSign = stopsOf(bar).right};
    return patiently(
        [=](const Wires& wires) mutable {
            bounds.cancel = wires.cancel;
            bounds.progress = wires.progress;
            return answers::withUnits(findPolytopes(phases, bounds), bar);
        },
        asked.progress());
}

std::optional<PolytopeOf> polytope(const Asked& asked)
{
    const Schedule schedule = asked.schedule();
    const Bar bar = asked.bar();
    const auto found = patiently([=](const Wires&) { return polytopeOf(schedule); });
    return found ? std::optional(PolytopeOf{*found, bar}) : std::nullopt;
}

}  // namespace

void addPolytopes(py::module_& module)
{
    classOf<ModeChain>(module);
    addPolytope(module);
    addCall(module, "polytopes", &polytopes);
    addCall(module, "polytope", &polytope);
}

}  // namespace signorini::python
