#include "calls.hpp"

#include "scene_figures.hpp"
#include "scene_simulation_answer.hpp"
#include "signorini/figures.hpp"
#include "state_table.hpp"

namespace signorini::python {

namespace {

using answers::SceneSimulationAnswer;

/// What a simulation of bars came to, each contact in SI units, and its picture.
struct SimulatedBars : SceneSimulationAnswer {
    std::vector<NetworkContactEvent> pushes;
    std::string figure;  ///< empty: no paths were recorded
};

template <typename D>
void describe(D& d, answers::Type<SimulatedBars>)
{
    describe(d, answers::Type<SceneSimulationAnswer>());
}

template <typename T, typename F>
requires(std::is_same_v<std::remove_const_t<T>, SimulatedBars>) constexpr void withMembers(T& value,
                                                                                           F f)
{
    python::withMembers(baseOf<SceneSimulationAnswer>(value), f);
    f(value.pushes, value.figure);
}

NetworkStart startOf(const Asked& asked, const Network& network)
{
    if (const auto file = asked.maybe<std::string>("start")) {
        return readStateTable(*file, network);
    }
    const py::object given = asked.object("velocity");
    if (given.is_none()) {
        return startAtRest(network);
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
    const NetworkStart start = startOf(asked, network);
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
                answer.figure = asJson(simulationFigure(simulation));
            }
            const NetworkScales& scales = network.scales;
            answer.pushes = simulation.contacts();
            for (NetworkContactEvent& push : answer.pushes) {
                push.start *= scales.time;
                push.end *= scales.time;
                push.impulse *= answer.impulseUnit;
                push.peakForce *= scales.force();
                push.speed *= scales.velocity();
            }
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
            return view(s->pushes, member, s);
        });
    }
    record->has("contact_number", "Which contact, from 1.", [](const SimulatedBars& s) {
        py::list numbers;
        for (const Push& push : s.pushes) {
            numbers.append(push.contact + 1);
        }
        return numbers;
    });
    record->drawsScene([](const SimulatedBars& s) { return s.bars.assembly; })
        .more()
        .def("_figure", [](const SimulatedBars& s) { return s.figure; });
    addCall(module, "simulate_bars", &simulateBars);
}

}  // namespace signorini::python
