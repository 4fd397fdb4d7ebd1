#include "calls.hpp"

namespace signorini::answers {

using python::GridMotion;
template <>
inline constexpr std::tuple membersOf<GridMotion>{&GridMotion::state, &GridMotion::schedule,
                                                  &GridMotion::scene, &GridMotion::bar};

}  // namespace signorini::answers

namespace signorini::python {

// Motions are made anew of what they are the motions of.
void pass(Pickler& to, const ModeAnswer& m)
{
    const double period = m.motion.period();
    const auto kept = std::tie(m.mode, m.bar, period, m.gravity);
    pass(to, kept);
}
ModeAnswer made(Unpickler& from, Type<ModeAnswer>)
{
    const auto [mode, bar, period, gravity] = take<std::tuple<Mode, Bar, double, double>>(from);
    return motionOf(mode, bar, period, gravity);
}
void pass(Pickler& to, const PolytopeAnswer& m)
{
    const auto kept = std::tie(m.polytope, m.bar, m.point);
    pass(to, kept);
}
PolytopeAnswer made(Unpickler& from, Type<PolytopeAnswer>)
{
    const auto [polytope, bar, point] = take<std::tuple<ModePolytope, Bar, ModePoint>>(from);
    return {polytope, bar, point, ModeMotion(polytope, point)};
}

namespace {

/// Fields [g/L ...] of which the package makes methods, at places and instants in which the bar has
/// a length of its cells, or of 1, and waves cross it in as much.
template <typename T, typename Of, typename Field>
void addFieldsOf(Record<T>& record, Of fieldOf, double (Field::*displacement)(double, double) const,
                 double (Field::*velocity)(double, double) const,
                 double (Field::*strain)(double, double) const,
                 double (Field::*wallForce)(double) const)
{
    const auto add = [&](const char* name, auto valueOf) {
        record.can(name, "", [=](const T& motion, const Numbers& x, const Numbers& t) {
            const Field& field = std::invoke(fieldOf, motion);
            return py::object(py::vectorize([&](double place, double instant) {
                return valueOf(field, place, instant);
            })(x, t));
        });
    };
    add("_displacement", std::mem_fn(displacement));
    add("_velocity", std::mem_fn(velocity));
    add("_strain", std::mem_fn(strain));
    add("_wall_force", [=](const Field& of, double, double t) { return (of.*wallForce)(t); });
}

/// What motions of modes and of polytopes share.
template <typename Answer>
void addMotionOf(py::module_& module)
{
    Record<Answer> record(module);
    record
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
    addFieldsOf(record, &Answer::motion, &ModeMotion::displacement, &ModeMotion::velocity,
                &ModeMotion::strain, &ModeMotion::wallForce);
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
        .can("state_at", {"step"}, "The state right after t_m.",
             [](const GridMotion& m, std::int64_t step) {
                 auto state = std::make_shared<const State>(m.field()->stateAt(step));
                 return StateOf{std::move(state), m.bar, m.scene.segments};
             });
    addFieldsOf(
        record, [](const GridMotion& m) -> const Motion& { return *m.field(); },
        &Motion::displacementAt, &Motion::velocityAt, &Motion::strainAt, &Motion::wallForceAt);
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
