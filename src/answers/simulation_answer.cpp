#include "simulation_answer.hpp"

#include "faults.hpp"
#include "stepped_bar.hpp"

namespace signorini::answers {

void Drive::follow(const Excitation& excitation, const Bar& bar)
{
    steps = excitation.steps();
    period = static_cast<double>(steps) / excitation.stepsPerCrossing * scales(bar).time;
}

double stretchesOf(double stretch, double crossing, const Bar& bar,
                   const std::optional<double>& time, const std::optional<std::int64_t>& periods)
{
    constexpr double longest = 1e9;  // [L/c]
    const double unit = scales(bar).time;
    const double total =
        periods ? static_cast<double>(*periods) : *time / unit * crossing / stretch;
    if (!(total * stretch <= longest * crossing)) {
        const std::string allowed =
            fmt::format("what lasts at most {} L/c, {:.3g} s", longest, longest * unit);
        periods ? throwFault("periods", *periods, allowed) : throwFault("time", *time, allowed);
    }
    return total;
}

std::string_view name(Ending ending)
{
    switch (ending) {
        case Ending::done:
            return "done";
        case Ending::interrupted:
            return "interrupted";
    }
    return {};
}

void SimulationAnswer::see(const BarSimulation& simulation)
{
    time = simulation.time();
    contactCount = static_cast<std::int64_t>(simulation.contacts().size());
    impulse = simulation.impulse();
    tip = simulation.tip();
    isHeld = simulation.isHeld();
    heldAt = simulation.stop();
    energyRatio = simulation.energyRatio();
    balance = simulation.balance();
    events = simulation.events();
    pieces = simulation.pieces();
    merged = simulation.merged();
}

Bar SimulationAnswer::bar() const
{
    return firstMaterial(scene);
}

}  // namespace signorini::answers
