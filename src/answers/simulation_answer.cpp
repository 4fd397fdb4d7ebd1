#include "simulation_answer.hpp"

#include "stepped_bar.hpp"

namespace signorini::answers {

void Drive::follow(const Excitation& excitation, const Bar& bar)
{
    steps = excitation.steps();
    period = static_cast<double>(steps) / excitation.stepsPerCrossing * scales(bar).time;
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
