#include "motion.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "faults.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

template <>
inline constexpr bool isKept<GridMotion> = true;
template <>
inline void put(Writer& to, const GridMotion& m)
{
    put(to, m.state);
    put(to, m.schedule);
    put(to, m.scene);
}
template <>
inline GridMotion take(Reader& from)
{
    auto state = take<std::shared_ptr<const State>>(from);
    const auto schedule = take<Schedule>(from);
    return {std::move(state), schedule, take<Scene>(from)};
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
[[noreturn]] void refusePlace(double x, double t, double length, const char* unit)
{
    Faults faults;
    if (!(x >= 0.0 && x <= length)) {
        faults.add("x", x, fmt::format("0..{} [{}]", length, unit));
    }
    if (!std::isfinite(t)) {
        faults.add("t", t, "finite numbers");
    }
    faults.throwIfAny();
    throw std::logic_error("a place on the bar was refused");
}

/// The motion of a grid on x [L] and t [L/c].
struct OnGrid {
    const Motion& field;
    double cells;

    explicit OnGrid(const GridMotion& motion)
        : field(*motion.field()), cells(static_cast<double>(field.cells()))
    {
    }
    double displacement(double x, double t) const
    {
        return field.displacementAt(x * cells, t * cells);
    }
    double velocity(double x, double t) const { return field.velocityAt(x * cells, t * cells); }
    double strain(double x, double t) const { return field.strainAt(x * cells, t * cells); }
    double wallForce(double t) const { return field.wallForceAt(t * cells); }
};

/// The same for a mode or a polytope.
struct OnNoGrid {
    const ModeMotion& motion;

    template <typename Answer>
    explicit OnNoGrid(const Answer& answer) : motion(answer.motion)
    {
    }
    double displacement(double x, double t) const { return motion.displacement(x, t); }
    double velocity(double x, double t) const { return motion.velocity(x, t); }
    double strain(double x, double t) const { return motion.strain(x, t); }
    double wallForce(double t) const { return motion.wallForce(t); }
};

/// Fields of a `Field` made from a `T` that has a bar: in SI units, and without.
template <typename T, typename Field, typename Class>
void addFieldsOf(Class& shown)
{
    const auto both = [&shown](const char* name, auto member, auto unitOf, const char* what,
                               const char* unit, const char* ratioUnit) {
        const auto on = [member](const T& motion, const py::object& x, const py::object& t,
                                 double length, double time, double one, const char* lengthUnit) {
            const Field field(motion);
            return Grid(x, t).of([&](double place, double instant) {
                if (!(place >= 0.0 && place <= length && std::isfinite(instant))) {
                    refusePlace(place, instant, length, lengthUnit);
                }
                return one * (field.*member)(place / length, instant / time);
            });
        };
        shown.def(
            name,
            [on, unitOf](const T& motion, const py::object& x, const py::object& t) {
                const Scales scale = scales(motion.bar);
                return on(motion, x, t, motion.bar.length, scale.time, unitOf(scale), "m");
            },
            py::arg("x"), py::arg("t"),
            fmt::format("{} [{}] at x [m] and t [s], any arrays that NumPy can broadcast together.",
                        what, unit)
                .c_str());
        shown.def((std::string(name) + "_ratio").c_str(),
                  [on](const T& motion, const py::object& x, const py::object& t) {
                      return on(motion, x, t, 1.0, 1.0, 1.0, "L");
                  },
                  py::arg("x"), py::arg("t"),
                  fmt::format("{} [{}] at x [L] and t [L/c], any arrays that NumPy can broadcast "
                              "together.",
                              what, ratioUnit)
                      .c_str());
    };
    both(
        "displacement", &Field::displacement, [](const Scales& s) { return s.displacement; },
        "u(x, t)", "m", "g");
    both(
        "velocity", &Field::velocity, [](const Scales& s) { return s.velocity; }, "v(x, t)", "m/s",
        "c g/L");
    both(
        "strain", &Field::strain, [](const Scales& s) { return s.strain; }, "s(x, t), tension > 0,",
        "-", "g/L");
    shown.def(
        "wall_force",
        [](const T& motion, const py::object& t) {
            const Field field(motion);
            const double time = scales(motion.bar).time;
            const double unit = forceUnit(motion.bar);
            return Grid(py::float_(0.0), t).of([&](double, double instant) {
                return unit * field.wallForce(instant / time);
            });
        },
        py::arg("t"), "Force of the tip on the wall [N] at t [s], any array; 0 in flight.");
    shown.def(
        "wall_force_ratio",
        [](const T& motion, const py::object& t) {
            const Field field(motion);
            return Grid(py::float_(0.0), t).of([&](double, double instant) {
                return field.wallForce(instant);
            });
        },
        py::arg("t"), "Force of the tip on the wall [EA g/L] at t [L/c], any array.");
}

void addGridMotion(py::module_& module)
{
    Record<GridMotion> record(module, "Motion", R"(What a bar does over one period.

The fields are exact at any place and time: waves are constant on each cell and step.

Parameters
----------
state : State
    At the start of the first contact, with the bar that gives it units.
schedule : Schedule
    That it follows.
scene : Scene, optional
    Where there is more than a uniform bar at a wall. Of a stepped bar x counts the time that waves
    need, as lengths of its first material.

Raises
------
ValueError
    If state and schedule do not have the same cells.
)");
    const auto instants = [](const GridMotion& motion) { return motion.field()->steps(); };
    auto& shown = record.more();
    shown
        .def(py::init([](const StateOf& state, const Schedule& schedule,
                         const std::optional<Scene>& scene) {
                 GridMotion motion{state.value, schedule, scene.value_or(Scene(state.bar))};
                 (void)motion.field();
                 return motion;
             }),
             py::arg("state"), py::arg("schedule"), py::arg("scene") = py::none())
        .def("_frames",
             [](const GridMotion& m, std::int64_t most) {
                 const Motion& field = *m.field();
                 return framesOf(MotionSamples(field, m.scene, field.steps() + 1), most);
             })
        .def(
            "_figure",
            [](const GridMotion& m) { return asJson(motionFigure(*m.state, m.schedule, m.scene)); })
        .def_property_readonly(
            "bar", [](const GridMotion& m) { return m.bar; }, "Its units.")
        .def_property_readonly(
            "scene", [](const GridMotion& m) { return m.scene; }, "Where it happens.")
        .def_property_readonly(
            "schedule", [](const GridMotion& m) { return m.schedule; }, "That it follows.")
        .def_property_readonly(
            "state",
            [](const GridMotion& m) {
                return StateOf{m.state, m.bar, m.scene.segments};
            },
            "At t = 0.")
        .def_property_readonly(
            "cells", [](const GridMotion& m) { return m.schedule.cells; }, "N.")
        .def_property_readonly(
            "steps", instants,
            "n, steps after which the motion is back at its start: those of the schedule, less "
            "what long flights only repeat.")
        .def_property_readonly(
            "period", [](const GridMotion& m) { return period(m.schedule) * scales(m.bar).time; },
            "T of the schedule [s].")
        .def_property_readonly(
            "period_ratio", [](const GridMotion& m) { return period(m.schedule); },
            "T of the schedule [L/c].")
        .def_property_readonly(
            "p",
            [](const GridMotion& m) {
                const std::span<const double> p = m.field()->arriving();
                return view(p.data(), p.size(), m.field());
            },
            "p_0 ... p_{n-1}, the wave arriving at the tip in each step [g/L]; read-only, no copy.")
        .def_property_readonly(
            "t",
            [instants](const GridMotion& m) {
                const double step = scales(m.bar).time / static_cast<double>(m.schedule.cells);
                return filled(instants(m) + 1,
                              [step](std::int64_t k) { return static_cast<double>(k) * step; });
            },
            "t_0 ... t_n [s].")
        .def_property_readonly(
            "x",
            [](const GridMotion& m) {
                const double cell = m.bar.length / static_cast<double>(m.schedule.cells);
                return filled(m.schedule.cells + 1,
                              [cell](std::int64_t k) { return static_cast<double>(k) * cell; });
            },
            "x_0 ... x_N [m], clamp to tip.")
        .def_property_readonly(
            "tip",
            [instants](const GridMotion& m) {
                const Motion& field = *m.field();
                const double unit = scales(m.bar).displacement;
                return filled(instants(m) + 1, [&](std::int64_t k) {
                    return unit * field.displacement(field.cells(), k);
                });
            },
            "u(L, t) at t_0 ... t_n [m]; straight between.")
        .def_property_readonly(
            "tip_ratio",
            [instants](const GridMotion& m) {
                const Motion& field = *m.field();
                return filled(instants(m) + 1,
                              [&](std::int64_t k) { return field.displacement(field.cells(), k); });
            },
            "u(L, t) at t_0 ... t_n [g].")
        .def_property_readonly(
            "force",
            [instants](const GridMotion& m) {
                const Motion& field = *m.field();
                const double unit = forceUnit(m.bar);
                return filled(instants(m),
                              [&](std::int64_t k) { return unit * field.wallForce(k); });
            },
            "Force of the tip on the wall in steps 0 ... n-1 [N].")
        .def_property_readonly(
            "force_ratio",
            [instants](const GridMotion& m) {
                const Motion& field = *m.field();
                return filled(instants(m), [&](std::int64_t k) { return field.wallForce(k); });
            },
            "Force of the tip on the wall in steps 0 ... n-1 [EA g/L].")
        .def(
            "state_at",
            [](const GridMotion& m, std::int64_t step) {
                const Motion& field = *m.field();
                if (step < 0 || step > field.steps()) {
                    Faults faults;
                    faults.add("step", step, fmt::format("whole numbers 0..{}", field.steps()));
                    faults.throwIfAny();
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
                return StateOf{state, m.bar, m.scene.segments};
            },
            py::arg("step"), "The state right after t_m.")
        .def("__repr__", [](const GridMotion& m) {
            return fmt::format("Motion({}, period_ratio={:.10g})", describe(m.schedule),
                               period(m.schedule));
        });
    addFieldsOf<GridMotion, OnGrid>(shown);
}

}  // namespace

const std::shared_ptr<const Motion>& GridMotion::field() const
{
    if (!field_) {
        field_ = scene.segments.empty()
                     ? std::make_shared<const Motion>(*state, schedule)
                     : std::make_shared<const Motion>(*state, schedule, scene.segments);
    }
    return field_;
}

std::vector<std::string> framesOf(const MotionSamples& samples, std::int64_t most)
{
    std::vector<std::string> frames;
    for (const FigureData& frame :
         motionFrames(samples, static_cast<std::size_t>(std::max<std::int64_t>(most, 1)))) {
        frames.push_back(asJson(frame));
    }
    return frames;
}

void addModeFields(py::class_<ModeAnswer, std::shared_ptr<ModeAnswer>>& shown)
{
    addFieldsOf<ModeAnswer, OnNoGrid>(shown);
}

void addModeFields(py::class_<PolytopeAnswer, std::shared_ptr<PolytopeAnswer>>& shown)
{
    addFieldsOf<PolytopeAnswer, OnNoGrid>(shown);
}

void addMotion(py::module_& module)
{
    addGridMotion(module);
}

}  // namespace signorini::python
