#include "calls.hpp"

#include <pybind11/eigen.h>

#include "scene_figures.hpp"
#include "scene_simulation_answer.hpp"
#include "simulation_answer.hpp"
#include "state_table.hpp"

namespace signorini::python {

namespace {

/// Waves off any grid, and their units.
using WavesOf = Of<Waves>;

/// All that happened in a simulation, and the waves at its end.
struct Seen {
    Waves waves = {};
    std::vector<ContactEvent> contacts = {};
    std::vector<TipPoint> path = {};
};
using Simulated = With<SimulationAnswer, Seen>;

void addWaves(py::module_& module)
{
    Record<WavesOf> record(module, "Waves", "A state off any grid: two waves in pieces.");
    const auto durations = [](std::vector<Piece> Waves::*wave) {
        return [wave](const std::shared_ptr<WavesOf>& w) -> py::object {
            return view(w->value.*wave, &Piece::duration, w) / py::float_(w->value.crossing);
        };
    };
    const auto values = [](std::vector<Piece> Waves::*wave) {
        return [wave](const std::shared_ptr<WavesOf>& w) {
            return view(w->value.*wave, &Piece::value, w);
        };
    };
    record.has("a", "Right-going, tip first [g/L]; no copy.", values(&Waves::a))
        .has("b", "Left-going, base first [g/L]; no copy.", values(&Waves::b))
        .has("a_duration", "Of each piece [L/c].", durations(&Waves::a))
        .has("b_duration", "Of each piece [L/c].", durations(&Waves::b))
        .has("bar", "Its units.", &WavesOf::bar)
        .both("energy", "energy_unit", "E [J].", "E/E_1.",
              [](const WavesOf& w) { return energyRatio(w.value); })
        .can("stretching", {"cells"}, "u(x_i) - u(0) at x_0 ... x_N [m].",
             [](const WavesOf& w, std::int64_t cells) {
                 if (cells < 1 || cells > mostCells) {
                     throwFault("cells", cells, fmt::format("whole numbers 1..{}", mostCells));
                 }
                 return Eigen::VectorXd(scales(w.bar).displacement * stretching(w.value, cells));
             });
}

void addSimulated(py::module_& module)
{
    Record<Simulated> record(module);
    const auto add = [&record](const char* name, const char* unit, const char* doc,
                               const char* ratio, auto member, auto list) {
        record.both(name, unit, doc, ratio, [=](const std::shared_ptr<Simulated>& s) {
            return view(s->more.*list, member, s);  // no copy
        });
    };
    using Contact = ContactEvent;
    const auto contact = [&add](const char* name, const char* unit, const char* doc,
                                const char* ratio, double Contact::*member) {
        add(name, unit, doc, ratio, member, &Seen::contacts);
    };
    contact("contact_start", "time_unit", "[s], shape (contacts,).", "[L/c]", &Contact::start);
    contact("contact_end", "time_unit", "[s]", "[L/c]", &Contact::end);
    contact("contact_impulse", "impulse_unit", "[N s]", "[EA g/c]", &Contact::impulse);
    contact("contact_peak_force", "force_unit", "[N]", "[EA g/L]", &Contact::peakForce);
    contact("contact_mean_force", "force_unit", "Largest mean over the resolution [N].", "[EA g/L]",
            &Contact::meanForce);
    contact("contact_speed", "velocity_unit", "With which the tip came to the stop [m/s].",
            "[c g/L]", &Contact::speed);
    contact("contact_energy", "energy_unit", "Of the waves that the stop sent back [J].", "[E_1]",
            &Contact::energy);
    add("tip_time", "time_unit", "Instants of the path of the tip [s]; straight between.", "[L/c]",
        &TipPoint::time, &Seen::path);
    add("tip_displacement", "displacement_unit", "u(L) at these instants [m].", "[g]",
        &TipPoint::displacement, &Seen::path);
    record
        .has("contact_stop", "[\"right\" or \"left\", ...], which stop was touched.",
             [](const Simulated& s) { return mapped(s.more.contacts, &ContactEvent::stop); })
        .has("waves", "At the end: a Waves, from which another simulation can go on.",
             [](const Simulated& s) {
                 return WavesOf{s.more.waves, s.scene.bar};
             })
        .draws([](const Simulated& s) {
            const double period = s.drive ? s.drive->period / scales(s.scene.bar).time : 0.0;
            return simulationFigure(
                {s.time, stopsOf(s.scene), s.more.path, s.more.contacts, period}, s.scene.bar,
                true);
        });
}

/// Where it starts: at rest, from a state, or from waves.
Waves startOf(const Asked& asked, std::optional<std::int64_t> cells, const Stops& stops,
              const std::function<Excitation(double)>& drivenBy)
{
    const py::object start = asked.object("start");
    if (start.is_none()) {
        const auto grid = static_cast<double>(cells.value_or(usualCells));
        return wavesAtRest(grid, stops, drivenBy(grid).baseDisplacement(0));
    }
    if (py::isinstance<WavesOf>(start)) {
        return py::cast<const WavesOf&>(start).value;
    }
    return wavesOf(*asked.get<StateOf>("start").value);
}

Simulated simulate(const Asked& asked)
{
    requireWhole(asked, false);
    SimulationAnswer answer{.scene = asked.scene(), .damping = asked.damping()};
    const Bar units = answer.scene.bar;
    if (asked.has("frequency")) {
        answer.drive = driveAsked(asked, firstHertz(units), asked.place());
    }
    const auto cells = asked.maybe<std::int64_t>("cells");
    const auto drivenBy = [&](double grid) {
        return answer.drive ? answer.drive->excitation(units, grid)
                            : Excitation{.stepsPerCrossing = grid};
    };
    const Waves start = startOf(asked, cells, stopsOf(answer.scene), drivenBy);
    const Excitation driving = drivenBy(cells ? static_cast<double>(*cells) : start.crossing);
    FollowedBar bar = started(std::move(answer), start, driving,
                              {asked.maybe<double>("time"), asked.maybe<std::int64_t>("periods"),
                               asked.maybe<double>("resolve"), asked.get<bool>("tip")});
    return patiently(asked, [bar = std::move(bar)](const Watch& watch) mutable {
        bar.follow(watch);
        const BarSimulation& done = bar.simulation;
        return Simulated{bar.answer, {done.waves(), done.contacts(), done.tipPath()}};
    });
}

/// What contacts did, in SI units, and the picture of a simulation.
struct SeenInBars {
    std::vector<NetworkContactEvent> pushes = {};
    std::string figure = {};  ///< empty: no paths were recorded
};
using SimulatedBars = With<SceneSimulationAnswer, SeenInBars>;

NetworkStart startOf(const Asked& asked, const Network& network, double base)
{
    if (const auto file = asked.maybe<std::string>("start")) {
        return readStateTable(*file, network);
    }
    const py::object given = asked.object("velocity");
    if (given.is_none()) {
        return startAtRest(network, base);
    }
    std::vector<double> speeds;
    for (const py::handle& speed : given) {
        speeds.push_back(quantityOf("velocity", py::cast<Quantity>(speed)));
    }
    return answers::startOf(network, std::move(speeds));
}

SimulatedBars simulateBars(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const Network network = networkOf(assembly);
    requireWhole(asked, true);
    const SceneDrive drive = driveAsked(asked, network);
    const bool recordsPaths = asked.get<bool>("tip");
    FollowedBars bars(asked, assembly, network, drive, startOf(asked, network, drive.moved.base),
                      recordsPaths);
    return patiently(asked, [bars = std::move(bars), recordsPaths](const Watch& watch) mutable {
        bars.follow(watch);
        const NetworkSimulation& done = bars.simulation;
        return SimulatedBars{
            bars.answer,
            {contactsOf(done), recordsPaths ? asJson(simulationFigure(done)) : std::string()}};
    });
}

void addSimulatedBars(py::module_& module)
{
    using Push = NetworkContactEvent;
    Record<SimulatedBars> record(module);
    for (const auto& [name, member, doc] :
         {std::tuple("contact_start", &Push::start, "[s], shape (times pressed,)."),
          std::tuple("contact_end", &Push::end, "[s]"),
          std::tuple("contact_impulse", &Push::impulse, "[N s]"),
          std::tuple("contact_peak_force", &Push::peakForce, "[N]"),
          std::tuple("contact_speed", &Push::speed, "With which it closed [m/s].")}) {
        record.has(name, doc, [member = member](const std::shared_ptr<SimulatedBars>& s) {
            return view(s->more.pushes, member, s);
        });
    }
    record.has("contact_number", "Which contact, from 1.", [](const SimulatedBars& s) {
        return mapped(s.more.pushes, [](const Push& push) { return push.contact + 1; });
    });
    record.draws([](const SimulatedBars& s) { return s.more.figure; });
}

}  // namespace

void addSimulate(py::module_& module)
{
    addWaves(module);
    addClasses<Drive, SettledOn, Balance>(module);
    addSimulated(module);
    addSimulatedBars(module);
    module.def("simulate", &simulate);
    module.def("simulate_bars", &simulateBars);
}

}  // namespace signorini::python
