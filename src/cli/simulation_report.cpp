#include "simulation_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "json.hpp"
#include "signorini/output.hpp"
#include "spread.hpp"

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
    file.write(fmt::format("start,end,impulse,peak_force{},mean_force,speed,energy\n",
                           hasTwo ? ",stop" : ""));
    for (const ContactEvent& contact : simulation.contacts()) {
        file.write(fmt::format("{},{},{},{}{},{},{},{}\n", contact.start * second,
                               contact.end * second, contact.impulse * answers::impulseUnit(bar),
                               contact.peakForce * answers::forceUnit(bar),
                               hasTwo ? fmt::format(",{}", name(contact.stop)) : "",
                               contact.meanForce * answers::forceUnit(bar),
                               contact.speed * scales(bar).velocity,
                               contact.energy * scales(bar).energy));
    }
    file.close();
}

void writeStatistics(const std::string& path, const BarSimulation& simulation, const Bar& bar)
{
    std::vector<Impacts> all;
    for (const Stop stop : {Stop::right, Stop::left}) {
        if (stop == Stop::left && !simulation.stops().left) {
            continue;
        }
        Impacts& impacts = all.emplace_back(Impacts{.contact = std::string(name(stop))});
        for (const ContactEvent& contact : simulation.contacts()) {
            if (contact.stop == stop) {
                impacts.impulse.push_back(contact.impulse * answers::impulseUnit(bar));
                impacts.speed.push_back(contact.speed * scales(bar).velocity);
                impacts.energy.push_back(contact.energy * scales(bar).energy);
            }
        }
    }
    writeStatistics(path, all, simulation.time() * scales(bar).time);
}

void writeStatistics(const std::string& path, std::span<const Impacts> all, double duration)
{
    TextFile file(path);
    file.write("contact,quantity,unit,statistic,from,to,value\n");
    for (const Impacts& impacts : all) {
        const auto count = static_cast<double>(impacts.impulse.size());
        file.write(fmt::format("{0},impacts,-,count,,,{1}\n{0},impacts,1/s,rate,,,{2}\n",
                               impacts.contact, impacts.impulse.size(),
                               duration > 0.0 ? count / duration : 0.0));
        for (const auto& [quantity, unit, values] : {std::tuple{"impulse", "N s", &impacts.impulse},
                                                     std::tuple{"speed", "m/s", &impacts.speed},
                                                     std::tuple{"energy", "J", &impacts.energy}}) {
            const Spread spread = spreadOf(*values);
            const std::string row = fmt::format("{},{},{},", impacts.contact, quantity, unit);
            if (spread.count == 0) {
                continue;
            }
            for (const auto& [statistic, value] :
                 {std::pair{"mean", spread.mean}, std::pair{"least", spread.least},
                  std::pair{"most", spread.most}, std::pair{"total", spread.total}}) {
                file.write(fmt::format("{}{},,,{}\n", row, statistic, value));
            }
            const double part = spread.most / static_cast<double>(spread.histogram.size());
            for (std::size_t k = 0; k < spread.histogram.size(); ++k) {
                file.write(fmt::format("{}histogram,{},{},{}\n", row, static_cast<double>(k) * part,
                                       static_cast<double>(k + 1) * part, spread.histogram[k]));
            }
        }
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
