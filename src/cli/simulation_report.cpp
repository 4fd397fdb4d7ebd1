#include "reports.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "printing.hpp"
#include "spread.hpp"

namespace signorini::cli {

std::string asText(const Settling& settling, double impulseUnit)
{
    if (!settling.settled) {
        return fmt::format("settled     no: {}\n", settling.why);
    }
    const auto& [periods, residual, contacts, impulse] = *settling.settled;
    return fmt::format(
        "settled     repeats every {} of the excitation: {} contact{}, {:.6g} N s; residual "
        "{:.2g}\n",
        periods == 1 ? "period" : fmt::format("{} periods", periods), contacts,
        contacts == 1 ? "" : "s", impulse * impulseUnit, residual);
}

std::string asText(const SimulationAnswer& answer)
{
    const Bar bar = answer.bar();
    const Scales unit = scales(bar);
    const EnergyBalance& balance = answer.balance;
    std::string text = fmt::format("{:<12}{:.6g} s ({:.6g} L/c), {} events\n",
                                   answer.isComplete ? "simulated" : "interrupted",
                                   answer.time * unit.time, answer.time, answer.events);
    text += fmt::format("contacts    {}, impulse {:.6g} N s in all\n", answer.contactCount,
                        answer.impulse * answers::impulseUnit(bar));
    if (answer.drive) {
        text += asText(answer.settling, answers::impulseUnit(bar));
    }
    text += fmt::format("tip         u = {:.10g} m at the end{}\n", answer.tip * unit.displacement,
                        !answer.isHeld                 ? ""
                        : answer.heldAt == Stop::right ? ", at the wall"
                                                       : ", at the second stop");
    text += fmt::format(
        "energy      {:.10g} J{}; work {:.6g} J, dissipated {:.6g} J, "
        "balance off by {:.3g} of the largest\n",
        answer.energyRatio * unit.energy,
        bar.gap == 0.0 ? "" : fmt::format(" = {:.10g} E₁", answer.energyRatio),
        balance.work * unit.energy, balance.dissipated * unit.energy,
        balance.size > 0.0 ? std::abs(balance.error) / balance.size : 0.0);
    if (answer.merged > 0.0) {
        text += fmt::format("merged      faded jumps, at most {:.3g} m of displacement in all\n",
                            answer.merged * unit.displacement);
    }
    return text;
}

void writeEvents(const std::string& path, const BarSimulation& simulation, const Bar& bar)
{
    const Scales unit = scales(bar);
    const bool hasTwo = simulation.stops().left.has_value();
    writeCsv(path,
             fmt::format("start,end,impulse,peak_force{},mean_force,speed,energy",
                         hasTwo ? ",stop" : ""),
             [&](CsvRows& row) {
                 for (const ContactEvent& contact : simulation.contacts()) {
                     const auto push =
                         fmt::format("{}{}{}", contact.peakForce * answers::forceUnit(bar),
                                     hasTwo ? "," : "", hasTwo ? name(contact.stop) : "");
                     row(contact.start * unit.time, contact.end * unit.time,
                         contact.impulse * answers::impulseUnit(bar), push,
                         contact.meanForce * answers::forceUnit(bar), contact.speed * unit.velocity,
                         contact.energy * unit.energy);
                 }
             });
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
    writeImpacts(path, all, simulation.time() * scales(bar).time);
}

void writeImpacts(const std::string& path, std::span<const Impacts> all, double duration)
{
    writeCsv(path, "contact,quantity,unit,statistic,from,to,value", [&](CsvRows& row) {
        for (const auto& [contact, impulses, speeds, energies] : all) {
            const auto count = static_cast<double>(impulses.size());
            row(contact, "impacts,-,count,,", impulses.size());
            row(contact, "impacts,1/s,rate,,", duration > 0.0 ? count / duration : 0.0);
            for (const auto& [quantity, values] :
                 {std::pair{"impulse,N s", &impulses}, std::pair{"speed,m/s", &speeds},
                  std::pair{"energy,J", &energies}}) {
                const Spread spread = spreadOf(*values);
                if (spread.count == 0) {
                    continue;
                }
                row(contact, quantity, "mean,,", spread.mean);
                row(contact, quantity, "least,,", spread.least);
                row(contact, quantity, "most,,", spread.most);
                row(contact, quantity, "total,,", spread.total);
                const double part = spread.most / static_cast<double>(spread.histogram.size());
                for (std::size_t k = 0; k < spread.histogram.size(); ++k) {
                    row(contact, quantity, "histogram", static_cast<double>(k) * part,
                        static_cast<double>(k + 1) * part, spread.histogram[k]);
                }
            }
        }
    });
}

void writeTip(const std::string& path, const BarSimulation& simulation, const Bar& bar)
{
    writeCsv(path, "time,displacement", [&](CsvRows& row) {
        for (const TipPoint& point : simulation.tipPath()) {
            row(point.time * scales(bar).time, point.displacement * scales(bar).displacement);
        }
    });
}

}  // namespace signorini::cli
