#include "calls.hpp"

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
    put(to, m.gravity);
}
template <>
inline ModeAnswer take(Reader& from)
{
    const Mode mode = take<Mode>(from);
    const Bar bar = take<Bar>(from);
    const auto period = take<double>(from);
    return answers::motionOf(mode, bar, period, take<double>(from));
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

/// What motions of modes and of polytopes share.
template <typename Answer>
void addMotionOf(py::module_& module)
{
    const auto record = classOf<Answer>(module);
    record
        ->has("amplitude_ratio", "h = |p| [g/L].",
              [](const Answer& m) { return m.motion.amplitude(); })
        .has("jump_times_ratio",
             "Where p changes its sign, ascending [L/c]: the first is the end of the first "
             "contact; no copy.",
             [](const std::shared_ptr<Answer>& m) {
                 const auto& times = m->motion.jumpTimes();
                 return view(times.data(), times.size(), m);
             })
        .can("p", {"t_ratio"}, "The wave arriving at the tip [g/L] at t [L/c], any array.",
             [](const Answer& m, const py::object& t) {
                 return onPeriods(t, [&m](double instant) { return m.motion.incoming(instant); });
             })
        .can("state", {"cells"}, "At t = 0, the means over each of N cells.",
             [](const Answer& m, std::int64_t cells) {
                 return StateOf{std::make_shared<const State>(cellMeans(m.motion, cells)), m.bar};
             });
    addModeFields(*record);
}

void addPolytope(py::module_& module)
{
    classOf<PolytopeOf>(module)
        ->has("bar", "Its units.", &PolytopeOf::bar)
        .has("phases", "K.", [](const PolytopeOf& p) { return p.value.chains.size(); })
        .can("energy_ratio", {"period_ratio"},
             "E/E_1 at T [L/c], any array. ValueError outside the interval.",
             [](const PolytopeOf& p, const py::object& periods) {
                 return onPeriods(periods, [&p](double t) { return energyRatio(p.value, t); });
             })
        .can("slice", {"period_ratio"},
             "Arrivals s_2 ... s_K [L/c] at the corners of T [L/c], an array of shape (corners, "
             "K - 1): the motions of this period are their means, ends excluded. ValueError "
             "outside the interval.",
             [](const PolytopeOf& p, double period) {
                 return rowsOf(slice(p.value, period), p.value.chains.size() - 1);
             })
        .can("stretches", {"period_ratio", "arrivals"},
             "Contact and flight in turn, 2K lengths [L/c]. ValueError unless there are K - 1 "
             "arrivals.",
             [](const PolytopeOf& p, double period, const std::vector<double>& arrivals) {
                 const auto times = stretches(p.value, {period, arrivals});
                 return py::array_t<double>(static_cast<py::ssize_t>(times.size()), times.data());
             })
        .can("schedules", {"cells", "steps"},
             "On N cells, of the motions with T = steps/cells L/c, one for each orbit.",
             [](const PolytopeOf& p, std::int64_t cells, std::int64_t steps) {
                 return schedulesOf(p.value, cells, steps);
             })
        .more()
        .def("motion", &motionOf, py::arg("period_ratio"), py::arg("arrivals") = py::none(),
             "At T and arrivals s_2 ... s_K [L/c], in the middle without: a PolytopeMotion. "
             "ValueError outside.");
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
    addCall(module, "polytope", &polytope);
    addMotionOf<ModeAnswer>(module);
    addMotionOf<PolytopeAnswer>(module);
}

}  // namespace signorini::python
