#include "simulation_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "json.hpp"
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
                        simulation.impulse() * answers::impulseUnit(bar));
    if (answer.settling.settled) {
        const Settled& settled = *answer.settling.settled;
        text += fmt::format(
            "settled     repeats every {} of the excitation: {} contact{}, {:.6g} N s; residual "
            "{:.2g}\n",
            settled.periods == 1 ? "period" : fmt::format("{} periods", settled.periods),
            settled.contacts, settled.contacts == 1 ? "" : "s",
            settled.impulse * answers::impulseUnit(bar), settled.residual);
    } else if (answer.amplitude) {
        text += fmt::format("settled     no: {}\n", answer.settling.why);
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
        text += fmt::format("merged      faded jumps, at most {:.3g} m of displacement in all\n",
                            simulation.merged() * unit.displacement);
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
                     {"damping", jsonOf(answers::Of<Damping>{answer.damping, bar})},
                     {"excitation", nullptr},
                     {"time", simulation.time() * unit.time},
                     {"time_ratio", simulation.time()},
                     {"contacts", simulation.contacts().size()},
                     {"impulse", simulation.impulse() * answers::impulseUnit(bar)},
                     {"resolution", answer.resolution * unit.time},
                     {"settled", nullptr},
                     {"why", answer.settling.why.empty() ? Json() : Json(answer.settling.why)},
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
    json.update(jsonOf(answer.scene));
    if (answer.amplitude) {
        json["excitation"] = {{"force", name(answer.excitation.place)},
                              {"amplitude", *answer.amplitude},
                              {"frequency_ratio", answer.frequencyRatio},
                              {"frequency", 1.0 / (answer.period() * unit.time)},
                              {"phase", answer.phase},
                              {"steps", answer.excitation.steps()}};
    }
    if (const auto& settled = answer.settling.settled) {
        json["settled"] = {{"periods", settled->periods},
                           {"residual", settled->residual},
                           {"contacts", settled->contacts},
                           {"impulse", settled->impulse * answers::impulseUnit(bar)}};
    }
    return asLine(json);
}

void writeEvents(const std::string& path, const BarSimulation& simulation, const Bar& bar)
{
    const double second = scales(bar).time;
    const bool hasTwo = simulation.stops().left.has_value();
    TextFile file(path);
    file.write(fmt::format("start,end,impulse,peak_force{},mean_force\n", hasTwo ? ",stop" : ""));
    for (const ContactEvent& contact : simulation.contacts()) {
        file.write(fmt::format("{},{},{},{}{},{}\n", contact.start * second, contact.end * second,
                               contact.impulse * answers::impulseUnit(bar),
                               contact.peakForce * answers::forceUnit(bar),
                               hasTwo ? fmt::format(",{}", name(contact.stop)) : "",
                               contact.meanForce * answers::forceUnit(bar)));
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
