#include "calls.hpp"

#include "mapped.hpp"
#include "scene_figures.hpp"
#include "scene_simulation_answer.hpp"
#include "signorini/figures.hpp"
#include "state_table.hpp"

namespace signorini::python {

namespace {

using answers::SceneSimulationAnswer;

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
        speeds.push_back(quantityOf("velocity", py::cast<Quantity>(speed)) /
                         network.scales.velocity());
    }
    return startWithSpeeds(network, speeds);
}

SimulatedBars simulateBars(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const Network network = networkOf(assembly);
    answers::SceneDrive drive;
    if (asked.has("force")) {
        const Bar units = answers::unitsOf(assembly, network);
        const double ratio = asked.frequency("frequency", units);
        drive = answers::drivenBy(network, {asked.place(), *asked.displacement(ratio, units), ratio,
                                            asked.get<double>("phase")});
    }
    const double duration = answers::durationOf(network, drive, asked.maybe<double>("time"),
                                                asked.maybe<std::int64_t>("periods"));
    const NetworkStart start = startOf(asked, network, drive.moved.base);
    const bool recordsPaths = asked.get<bool>("tip");
    return patiently(
        [=](const Wires& wires) {
            SimulatedBars answer;
            answer.bars = answers::severalOf(assembly, network);
            answer.drive = drive.told;
            NetworkSimulation simulation =
                answers::simulationOf(network, start, drive, recordsPaths);
            answer.follow(simulation, drive.moved, duration, wires.cancel, wires.progress);
            if (recordsPaths) {
                answer.more.figure = asJson(simulationFigure(simulation));
            }
            answer.more.pushes = answers::contactsOf(simulation);
            return answer;
        },
        asked.progress());
}

}  // namespace

void addSceneSimulation(py::module_& module)
{
    using Push = NetworkContactEvent;
    const auto record = classOf<SimulatedBars>(module);
    for (const auto& [name, member, doc] :
         {std::tuple("contact_start", &Push::start, "[s], shape (times pressed,)."),
          std::tuple("contact_end", &Push::end, "[s]"),
          std::tuple("contact_impulse", &Push::impulse, "[N s]"),
          std::tuple("contact_peak_force", &Push::peakForce, "[N]"),
          std::tuple("contact_speed", &Push::speed, "With which it closed [m/s].")}) {
        record->has(name, doc, [member = member](const std::shared_ptr<SimulatedBars>& s) {
            return view(s->more.pushes, member, s);
        });
    }
    record->has("contact_number", "Which contact, from 1.", [](const SimulatedBars& s) {
        return mapped(s.more.pushes, [](const Push& push) { return push.contact + 1; });
    });
    record->more().def("_figure", [](const SimulatedBars& s) { return s.more.figure; });
    addCall(module, "simulate_bars", &simulateBars);
}

}  // namespace signorini::python
