#include "simulate.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "arrays.hpp"
#include "described.hpp"
#include "faults.hpp"
#include "force.hpp"
#include "numbers.hpp"
#include "patience.hpp"
#include "simulation_answer.hpp"

namespace signorini::python {

namespace {

using answers::Drive;

/// Waves off any grid, and their units.
using WavesOf = Of<Waves>;

/// What a simulation came to, and all that happened.
struct Simulated : answers::SimulationAnswer {
    Waves waves;
    std::vector<ContactEvent> contacts;
    std::vector<TipPoint> path;
};

template <typename D>
void describe(D& d, answers::Type<Simulated>)
{
    describe(d, answers::Type<answers::SimulationAnswer>());
}

}  // namespace

SIGNORINI_MEMBERS(Drive, &T::place, &T::amplitude, &T::frequencyRatio, &T::phase, &T::steps,
                  &T::period);
template <>
struct Members<Simulated> {
    using T = Simulated;
    static constexpr auto list =
        std::tuple{&T::scene,    &T::damping,    &T::drive,  &T::cells,        &T::resolution,
                   &T::settling, &T::isComplete, &T::time,   &T::contactCount, &T::impulse,
                   &T::tip,      &T::isHeld,     &T::heldAt, &T::energyRatio,  &T::balance,
                   &T::events,   &T::pieces,     &T::merged, &T::waves,        &T::contacts,
                   &T::path};
};

namespace {

using Shared = std::shared_ptr<Simulated>;

/// A column of a list of structs, times a unit that the bar knows.
template <typename T, typename Unit>
auto column(std::vector<T> Simulated::*list, double T::*member, Unit unit)
{
    return [=](const Simulated& s) {
        const double one = unit(s.scene.bar);
        return filled(static_cast<std::int64_t>((s.*list).size()), [&](std::int64_t k) {
            return one * ((s.*list)[static_cast<std::size_t>(k)].*member);
        });
    };
}

/// The same without units, on the simulation's own memory.
template <typename T>
auto ratios(std::vector<T> Simulated::*list, double T::*member)
{
    return [=](const Shared& s) { return view((*s).*list, member, s); };
}

double second(const Bar& bar)
{
    return scales(bar).time;
}

double speed(const Bar& bar)
{
    return scales(bar).velocity;
}

double joule(const Bar& bar)
{
    return scales(bar).energy;
}

double metre(const Bar& bar)
{
    return scales(bar).displacement;
}

void addWaves(py::module_& module)
{
    Record<WavesOf> record(module, "Waves", "A state off any grid: two waves in pieces.");
    const auto durations = [](std::vector<Piece> Waves::*wave) {
        return [wave](const WavesOf& w) {
            const std::vector<Piece>& pieces = w.value.*wave;
            return filled(static_cast<std::int64_t>(pieces.size()), [&](std::int64_t k) {
                return pieces[static_cast<std::size_t>(k)].duration / w.value.crossing;
            });
        };
    };
    const auto values = [](std::vector<Piece> Waves::*wave) {
        return [wave](const std::shared_ptr<WavesOf>& w) {
            return view(w->value.*wave, &Piece::value, w);
        };
    };
    record.more()
        .def_property_readonly("a", values(&Waves::a), "Right-going, tip first [g/L]; no copy.")
        .def_property_readonly("b", values(&Waves::b), "Left-going, base first [g/L]; no copy.")
        .def_property_readonly("a_duration", durations(&Waves::a), "Of each piece [L/c].")
        .def_property_readonly("b_duration", durations(&Waves::b), "Of each piece [L/c].")
        .def_property_readonly(
            "energy_ratio", [](const WavesOf& w) { return energyRatio(w.value); }, "E/E_1.")
        .def(
            "stretching",
            [](const WavesOf& w, std::int64_t cells) {
                if (cells < 1 || cells > mostCells) {
                    throw std::invalid_argument(
                        fmt::format("cells = {} is out of range: allowed whole numbers 1..{}",
                                    cells, mostCells));
                }
                const Eigen::VectorXd u = stretching(w.value, cells);
                const double unit = scales(w.bar).displacement;
                return filled(u.size(), [&](std::int64_t k) { return unit * u[k]; });
            },
            py::arg("cells"), "u(x_i) - u(0) at x_0 ... x_N [m].")
        .def("__repr__", [](const WavesOf& w) {
            return fmt::format("Waves({} pieces, E = {})", w.value.a.size() + w.value.b.size(),
                               energyAsText(energyRatio(w.value), w.bar));
        });
}

void addSimulated(py::module_& module)
{
    const auto record = classOf<Simulated>(module);
    constexpr auto contacts = &Simulated::contacts;
    constexpr auto path = &Simulated::path;
    record->more()
        .def_property_readonly("contact_start", column(contacts, &ContactEvent::start, second),
                               "[s], shape (contacts,).")
        .def_property_readonly("contact_end", column(contacts, &ContactEvent::end, second), "[s]")
        .def_property_readonly("contact_impulse",
                               column(contacts, &ContactEvent::impulse, impulseUnit), "[N s]")
        .def_property_readonly("contact_peak_force",
                               column(contacts, &ContactEvent::peakForce, forceUnit), "[N]")
        .def_property_readonly("contact_mean_force",
                               column(contacts, &ContactEvent::meanForce, forceUnit),
                               "Largest mean over the resolution [N].")
        .def_property_readonly("contact_speed", column(contacts, &ContactEvent::speed, speed),
                               "With which the tip came to the stop [m/s].")
        .def_property_readonly("contact_energy", column(contacts, &ContactEvent::energy, joule),
                               "Of the waves that the stop sent back [J].")
        .def_property_readonly(
            "contact_stop",
            [](const Simulated& s) {
                py::list stops;
                for (const ContactEvent& contact : s.contacts) {
                    stops.append(nameOf(contact.stop));
                }
                return stops;
            },
            "[\"right\" or \"left\", ...], which stop was touched.")
        .def_property_readonly("contact_start_ratio", ratios(contacts, &ContactEvent::start),
                               "[L/c]; no copy.")
        .def_property_readonly("contact_end_ratio", ratios(contacts, &ContactEvent::end),
                               "[L/c]; no copy.")
        .def_property_readonly("contact_impulse_ratio", ratios(contacts, &ContactEvent::impulse),
                               "[EA g/c]; no copy.")
        .def_property_readonly("contact_peak_force_ratio",
                               ratios(contacts, &ContactEvent::peakForce), "[EA g/L]; no copy.")
        .def_property_readonly("tip_time", column(path, &TipPoint::time, second),
                               "Instants of the path of the tip [s]; straight between.")
        .def_property_readonly("tip_displacement", column(path, &TipPoint::displacement, metre),
                               "u(L) at these instants [m].")
        .def_property_readonly("tip_time_ratio", ratios(path, &TipPoint::time), "[L/c]; no copy.")
        .def_property_readonly("tip_displacement_ratio", ratios(path, &TipPoint::displacement),
                               "[g]; no copy.")
        .def("_figure",
             [](const Simulated& s) {
                 const double period = s.drive ? s.drive->period / scales(s.scene.bar).time : 0.0;
                 return asJson(simulationFigure(
                     {s.time, stopsOf(s.scene), s.path, s.contacts, period}, s.scene.bar, true));
             })
        .def_property_readonly(
            "waves",
            [](const Simulated& s) {
                return WavesOf{s.waves, s.scene.bar};
            },
            "At the end: a Waves, from which another simulation can go on.");
}

Excitation excitationOf(Drive& drive, double cells, const Bar& bar)
{
    Excitation excitation =
        excitationAt({.place = drive.place,
                      .amplitude = drive.amplitude / amplitudeUnit(drive.place, bar),
                      .phase = drive.phase,
                      .stepsPerCrossing = cells},
                     drive.frequencyRatio);
    drive.follow(excitation, bar);
    return excitation;
}

/// Refuses what takes no time, or more than anyone waits for.
void requireLength(std::optional<double> time, std::optional<std::int64_t> periods, double period,
                   const Bar& bar)
{
    constexpr double longest = 1e9;  // [L/c]
    const double most = longest * second(bar);
    Faults faults;
    if (periods && !(*periods >= 1 && static_cast<double>(*periods) * period <= most)) {
        faults.add("periods", *periods,
                   fmt::format("whole numbers 1..{:.6g}, at most {} L/c", std::floor(most / period),
                               longest));
    }
    if (time && !(*time > 0.0 && *time <= most)) {
        faults.add("time", *time, fmt::format("numbers > 0, at most {:.6g} [s]", most));
    }
    faults.throwIfAny();
}

/// Goes on stretch by stretch, and sees whether it repeats itself.
Simulated simulated(Simulated answer, const Excitation& excitation, double total, bool wantsTip,
                    const Wires& wires)
{
    const double crossing = answer.waves.crossing;
    BarSimulation simulation(answer.waves, answer.damping, excitation,
                             {.mergeBelow = {},
                              .recordsTip = wantsTip,
                              .stops = stopsOf(answer.scene),
                              .segments = {},
                              .resolution = answer.resolution});
    const double stretch = stretchOf(excitation, crossing);
    const Followed followed =
        follow(simulation, stretch, answer.drive ? total : total * crossing / stretch, wires.cancel,
               wires.progress);
    answer.settling = answer.drive ? followed.settling : Settling{};
    answer.see(simulation);
    answer.waves = simulation.waves();
    answer.contacts = simulation.contacts();
    answer.path = simulation.tipPath();
    return answer;
}

Simulated simulate(const py::object& start, std::optional<std::int64_t> cells, const Scene& scene,
                   double damping, const std::optional<std::string>& force,
                   std::optional<double> amplitude, int derivative, std::optional<double> frequency,
                   double phase, std::optional<double> time, std::optional<std::int64_t> periods,
                   std::optional<double> resolve, bool tip, const py::object& progress)
{
    Simulated answer;
    if (!scene.segments.empty()) {
        throw std::invalid_argument("segments: allowed only where stepped bars are known: find");
    }
    const Bar& bar = scene.bar;
    answer.scene = scene;
    answer.damping = {damping};
    if (force.has_value() != amplitude.has_value() || force.has_value() != frequency.has_value()) {
        throw std::invalid_argument("force, amplitude, frequency: allowed only all three together");
    }
    if (time.has_value() == periods.has_value() || (periods && !force)) {
        throw std::invalid_argument(
            "time, periods: allowed one of them, and periods only together with force");
    }
    if (resolve) {
        Faults faults;
        faults.requirePositive("resolve", *resolve, "s");
        faults.throwIfAny();
    }
    if (force) {
        answer.drive = Drive{placeOf(*force), displaced(*amplitude, derivative, *frequency, bar),
                             *frequency, phase};
    }
    const auto drivenBy = [&](double grid) {
        return answer.drive ? excitationOf(*answer.drive, grid, bar)
                            : Excitation{.stepsPerCrossing = grid};
    };
    if (start.is_none()) {
        const auto grid = static_cast<double>(cells.value_or(usualCells));
        answer.waves = wavesAtRest(grid, stopsOf(scene), drivenBy(grid).baseDisplacement(0));
    } else if (py::isinstance<WavesOf>(start)) {
        answer.waves = py::cast<const WavesOf&>(start).value;
    } else if (!py::isinstance<StateOf>(start)) {
        throw py::type_error("start: allowed a State, Waves, the name of a file, or None");
    } else {
        answer.waves = wavesOf(*py::cast<const StateOf&>(start).value);
    }
    answer.cells = static_cast<std::int64_t>(answer.waves.crossing);
    const Excitation excitation =
        drivenBy(cells ? static_cast<double>(*cells) : answer.waves.crossing);
    requireLength(time, periods, answer.drive ? answer.drive->period : 0.0, bar);
    answer.resolution = resolve ? *resolve / second(bar) : 1.0 / excitation.stepsPerCrossing;
    const double total = periods        ? static_cast<double>(*periods)
                         : answer.drive ? *time / answer.drive->period
                                        : *time / second(bar);
    return patiently(
        [answer = std::move(answer), excitation, total, tip](const Wires& wires) {
            return simulated(answer, excitation, total, tip, wires);
        },
        progress);
}

}  // namespace

void addSimulate(py::module_& module)
{
    addWaves(module);
    classOf<Drive>(module);
    classOf<Of<Settled>>(module);
    classOf<Of<EnergyBalance>>(module);
    addSimulated(module);
    module.def("simulate", &simulate);
}

}  // namespace signorini::python
