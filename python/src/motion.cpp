#include "calls.hpp"

namespace signorini::python {

template <>
inline constexpr std::tuple membersOf<GridMotion>{&GridMotion::state, &GridMotion::schedule,
                                                  &GridMotion::scene, &GridMotion::bar};

/// Motions are made anew of what they are the motions of.
using KeptMode = std::tuple<Mode, Bar, double, double>;
template <>
inline void pass(Writer& to, const ModeAnswer& m)
{
    const KeptMode kept{m.mode, m.bar, m.motion.period(), m.gravity};
    pass(to, kept);
}
template <>
inline ModeAnswer take(Reader& from)
{
    const auto [mode, bar, period, gravity] = take<KeptMode>(from);
    return motionOf(mode, bar, period, gravity);
}
using KeptPolytope = std::tuple<ModePolytope, Bar, ModePoint>;
template <>
inline void pass(Writer& to, const PolytopeAnswer& m)
{
    const KeptPolytope kept{m.polytope, m.bar, m.point};
    pass(to, kept);
}
template <>
inline PolytopeAnswer take(Reader& from)
{
    const auto [polytope, bar, point] = take<KeptPolytope>(from);
    return {polytope, bar, point, ModeMotion(polytope, point)};
}

namespace {

/// Of waves in a cell, 1..N, relative to the first segment.
double speedOf(const std::vector<Segment>& segments, std::int64_t cell)
{
    for (const Segment& segment : segments) {
        if (cell <= segment.cells) {
            return segment.speed / segments.front().speed;
        }
        cell -= segment.cells;
    }
    return 1.0;
}

/// Names what is outside the bar, or never, as the caller gave it.
void requirePlace(double x, double t, double length, const char* unit)
{
    Faults faults;
    if (!(x >= 0.0 && x <= length)) {
        faults.add("x", x, fmt::format("0..{} [{}]", length, unit));
    }
    if (!std::isfinite(t)) {
        faults.add("t", t, "finite numbers");
    }
    faults.throwIfAny();
}

/// The motion of a grid on x [L] and t [L/c].
struct OnGrid {
    const Motion& field;
    double cells;

    double displacement(double x, double t) const
    {
        return field.displacementAt(x * cells, t * cells);
    }
    double velocity(double x, double t) const { return field.velocityAt(x * cells, t * cells); }
    double strain(double x, double t) const { return field.strainAt(x * cells, t * cells); }
    double wallForce(double t) const { return field.wallForceAt(t * cells); }
};

OnGrid fieldOf(const GridMotion& motion)
{
    return {*motion.field(), static_cast<double>(motion.schedule.cells)};
}

/// Of a mode or a polytope.
template <typename Answer>
const ModeMotion& fieldOf(const Answer& answer)
{
    return answer.motion;
}

/// Fields of a T that has a bar: in SI units, or without.
template <typename T>
void addFieldsOf(Record<T>& record, bool isRatio)
{
    using Field = std::remove_cvref_t<decltype(fieldOf(std::declval<const T&>()))>;
    const std::string suffix = isRatio ? "_ratio" : "";
    const auto add = [&](const std::string& name, auto member, double Scales::*unit,
                         const char* what, const char* units) {
        const char* length = isRatio ? "L" : "m";
        const std::string doc = fmt::format(
            "{} [{}] at x [{}] and t [{}], any arrays that NumPy can broadcast together.", what,
            units, length, isRatio ? "L/c" : "s");
        record.can((name + suffix).c_str(), {"x", "t"}, doc.c_str(),
                   [=](const T& motion, const py::object& x, const py::object& t) {
                       const auto& field = fieldOf(motion);
                       const Scales scale =
                           isRatio ? Scales{1.0, 1.0, 1.0, 1.0, 1.0, 1.0} : scales(motion.bar);
                       const double most = isRatio ? 1.0 : motion.bar.length;
                       const auto [places, instants] = stretched(x, t);
                       return py::object(py::vectorize([&](double place, double instant) {
                           requirePlace(place, instant, most, length);
                           return scale.*unit * (field.*member)(place / most, instant / scale.time);
                       })(places, instants));
                   });
    };
    add("displacement", &Field::displacement, &Scales::displacement, "u(x, t)",
        isRatio ? "g" : "m");
    add("velocity", &Field::velocity, &Scales::velocity, "v(x, t)", isRatio ? "c g/L" : "m/s");
    add("strain", &Field::strain, &Scales::strain, "s(x, t), tension > 0,", isRatio ? "g/L" : "-");
    record.can(("wall_force" + suffix).c_str(), {"t"},
               isRatio ? "Force of the tip on the wall [EA g/L] at t [L/c], any array."
                       : "Force of the tip on the wall [N] at t [s], any array; 0 in flight.",
               [isRatio](const T& motion, const py::object& t) {
                   const auto& field = fieldOf(motion);
                   const double time = isRatio ? 1.0 : scales(motion.bar).time;
                   const double unit = isRatio ? 1.0 : forceUnit(motion.bar);
                   return onEach(
                       t, [&](double instant) { return unit * field.wallForce(instant / time); });
               });
}

/// What motions of modes and of polytopes share.
template <typename Answer>
void addMotionOf(py::module_& module)
{
    Record<Answer> record(module);
    record
        .has("amplitude_ratio", "h = |p| [g/L].",
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
                 return onEach(t, [&m](double instant) { return m.motion.incoming(instant); });
             })
        .can("state", {"cells"}, "At t = 0, the means over each of N cells.",
             [](const Answer& m, std::int64_t cells) {
                 return StateOf{std::make_shared<const State>(cellMeans(m.motion, cells)), m.bar};
             });
    addFieldsOf(record, false);
    addFieldsOf(record, true);
}

StateOf stateAt(const GridMotion& m, std::int64_t step)
{
    const Motion& field = *m.field();
    if (step < 0 || step > field.steps()) {
        throwFault("step", step, fmt::format("whole numbers 0..{}", field.steps()));
    }
    auto state = std::make_shared<State>();
    state->a.resize(field.cells());
    state->b.resize(field.cells());
    for (std::int64_t cell = 1; cell <= field.cells(); ++cell) {
        const double v = field.velocity(cell, step);
        const double s = field.strain(cell, step) * speedOf(m.scene.segments, cell);
        state->a[cell - 1] = (v - s) / 2.0;
        state->b[cell - 1] = (v + s) / 2.0;
    }
    return {state, m.bar, m.scene.segments};
}

}  // namespace

void addMotion(py::module_& module)
{
    Record<GridMotion> record(module, "Motion",
                              "What a bar does over one period: exact at any place and time, for "
                              "waves are constant on each cell and step.");
    record.more().def(
        py::init(
            [](const StateOf& state, const Schedule& schedule, const std::optional<Scene>& scene) {
                GridMotion motion{state.value, schedule, scene.value_or(Scene(state.bar))};
                (void)motion.field();
                return motion;
            }),
        py::arg("state"), py::arg("schedule"), py::arg("scene") = py::none());
    record.draws([](const GridMotion& m) { return motionFigure(*m.state, m.schedule, m.scene); })
        .moves([](const GridMotion& m, std::size_t most) {
            const Motion& field = *m.field();
            return motionFrames(MotionSamples(field, m.scene, field.steps() + 1), most);
        })
        .has("bar", "Its units.", &GridMotion::bar)
        .has("scene", "Where it happens.", &GridMotion::scene)
        .has("schedule", "That it follows.", &GridMotion::schedule)
        .has("state", "At t = 0.", &GridMotion::start)
        .has("cells", "N.", [](const GridMotion& m) { return m.schedule.cells; })
        .has("steps",
             "n, steps after which the motion is back at its start: those of the schedule, less "
             "what long flights only repeat.",
             [](const GridMotion& m) { return m.field()->steps(); })
        .both("period", "time_unit", "T of the schedule [s].", "T of the schedule [L/c].",
              [](const GridMotion& m) { return period(m.schedule); })
        .has("p",
             "p_0 ... p_{n-1}, the wave arriving at the tip in each step [g/L]; read-only, no "
             "copy.",
             [](const GridMotion& m) {
                 const std::span<const double> p = m.field()->arriving();
                 return view(p.data(), p.size(), m.field());
             })
        .both("tip", "displacement_unit", "u(L, t) at t_0 ... t_n [m]; straight between.",
              "u(L, t) at t_0 ... t_n [g].",
              [](const GridMotion& m) {
                  const Motion& field = *m.field();
                  return filled(field.steps() + 1, [&](std::int64_t k) {
                      return field.displacement(field.cells(), k);
                  });
              })
        .both("force", "force_unit", "Force of the tip on the wall in steps 0 ... n-1 [N].",
              "Force of the tip on the wall in steps 0 ... n-1 [EA g/L].",
              [](const GridMotion& m) {
                  const Motion& field = *m.field();
                  return filled(field.steps(), [&](std::int64_t k) { return field.wallForce(k); });
              })
        .can("state_at", {"step"}, "The state right after t_m.", &stateAt);
    addFieldsOf(record, false);
    addFieldsOf(record, true);
    addMotionOf<ModeAnswer>(module);
    addMotionOf<PolytopeAnswer>(module);
}

const std::shared_ptr<const Motion>& GridMotion::field() const
{
    if (!field_) {
        field_ = scene.segments.empty()
                     ? std::make_shared<const Motion>(*state, schedule)
                     : std::make_shared<const Motion>(*state, schedule, scene.segments);
    }
    return field_;
}

}  // namespace signorini::python
