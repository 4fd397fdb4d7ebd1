#include "simulation_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "json.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

std::string asText(const SimulationAnswer& answer, const BarSimulation& simulation)
{
    const Bar bar = answer.bar();
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
    } else if (answer.drive) {
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

std::string asJson(SimulationAnswer answer, const BarSimulation& simulation)
{
    answer.see(simulation);
    return asLine(wholeJsonOf(answer));
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
