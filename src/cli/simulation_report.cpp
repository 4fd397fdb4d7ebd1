#include "simulation_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "force_report.hpp"
#include "signorini/output.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

std::string asText(const SimulationAnswer& answer, const BarSimulation& simulation)
{
    const Bar bar = firstMaterial(answer.scene);
    const Scales unit = scales(bar);
    const EnergyBalance balance = simulation.balance();
    const double energy = simulation.energyRatio();
    std::string text = fmt::format(
        "{:<12}{:.6g} s ({:.6g} L/c), {} events\n", answer.isComplete ? "simulated" : "interrupted",
        simulation.time() * unit.time, simulation.time(), simulation.events());
    text += fmt::format("contacts    {}, impulse {:.6g} N s in all\n", simulation.contacts().size(),
                        simulation.impulse() * impulseUnit(bar));
    if (answer.settled) {
        const Settled& settled = *answer.settled;
        text += fmt::format(
            "settled     repeats every {} of the excitation: {} contact{}, {:.6g} N s\n",
            settled.periods == 1 ? "period" : fmt::format("{} periods", settled.periods),
            settled.contacts, settled.contacts == 1 ? "" : "s", settled.impulse * impulseUnit(bar));
    } else if (answer.amplitude) {
        text += "settled     no\n";
    }
    text += fmt::format(
        "tip         u = {:.10g} m at the end{}\n", simulation.tip() * unit.displacement,
        simulation.isHeld()
            ? simulation.stop() == Stop::right ? ", at the wall" : ", at the second stop"
            : "");
    text += fmt::format(
        "energy      {:.10g} J{}; work {:.6g} J, dissipated {:.6g} J, "
        "balance off by {:.3g} of the largest\n",
        energy * unit.energy, bar.gap == 0.0 ? "" : fmt::format(" = {:.10g} E₁", energy),
        balance.work * unit.energy, balance.dissipated * unit.energy,
        balance.size > 0.0 ? std::abs(balance.error) / balance.size : 0.0);
    if (simulation.merged() > 0.0) {
        text += fmt::format("merged      faded jumps, at most {:.3g} g of displacement in all\n",
                            simulation.merged());
    }
    return text;
}

std::string asJson(const SimulationAnswer& answer, const BarSimulation& simulation)
{
    const Bar bar = firstMaterial(answer.scene);
    const Scales unit = scales(bar);
    const EnergyBalance balance = simulation.balance();
    const double energy = simulation.energyRatio();
    Json json = newAnswer();
    json.update(Json{{"status", answer.isComplete ? "done" : "interrupted"},
                     {"cells", answer.cells},
                     {"damping", dampingAsJson(answer.damping, bar)},
                     {"excitation", nullptr},
                     {"time", simulation.time() * unit.time},
                     {"time_ratio", simulation.time()},
                     {"contacts", simulation.contacts().size()},
                     {"impulse", simulation.impulse() * impulseUnit(bar)},
                     {"settled", nullptr},
                     {"tip", simulation.tip() * unit.displacement},
                     {"held", simulation.isHeld()},
                     {"energy", energy * unit.energy},
                     {"energy_ratio", bar.gap == 0.0 ? Json() : Json(energy)},
                     {"balance",
                      {{"work", balance.work * unit.energy},
                       {"dissipated", balance.dissipated * unit.energy},
                       {"error", balance.error * unit.energy}}},
                     {"events", simulation.events()},
                     {"pieces", simulation.pieces()},
                     {"merged", simulation.merged() * unit.displacement}});
    addScene(answer.scene, json);
    if (answer.amplitude) {
        json["excitation"] = {{"force", name(answer.excitation.place)},
                              {"amplitude", *answer.amplitude},
                              {"frequency_ratio", answer.frequencyRatio},
                              {"frequency", 1.0 / (answer.period() * unit.time)},
                              {"phase", answer.phase},
                              {"steps", answer.excitation.steps()}};
    }
    if (answer.settled) {
        json["settled"] = {{"periods", answer.settled->periods},
                           {"contacts", answer.settled->contacts},
                           {"impulse", answer.settled->impulse * impulseUnit(bar)}};
    }
    return asLine(json);
}

void writeEvents(const std::string& path, const BarSimulation& simulation, const Bar& bar)
{
    const double second = scales(bar).time;
    const bool hasTwo = simulation.stops().left.has_value();
    TextFile file(path);
    file.write(fmt::format("start,end,impulse,peak_force{}\n", hasTwo ? ",stop" : ""));
    for (const ContactEvent& contact : simulation.contacts()) {
        file.write(fmt::format("{},{},{},{}{}\n", contact.start * second, contact.end * second,
                               contact.impulse * impulseUnit(bar),
                               contact.peakForce * forceUnit(bar),
                               hasTwo ? fmt::format(",{}", name(contact.stop)) : ""));
    }
    file.close();
}

void writeTip(const std::string& path, const BarSimulation& simulation, const Bar& bar)
{
    const Scales unit = scales(bar);
    TextFile file(path);
    file.write("time,displacement\n");
    for (const TipPoint& point : simulation.tipPath()) {
        file.write(
            fmt::format("{},{}\n", point.time * unit.time, point.displacement * unit.displacement));
    }
    file.close();
}

}  // namespace signorini::cli
