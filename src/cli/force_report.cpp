#include "force_report.hpp"

#include "report.hpp"

namespace signorini::cli {

Json dampingAsJson(const Damping& damping, const Bar& bar)
{
    return {{"ratio", damping.ratio}, {"dashpot", dashpot(damping, bar)}};
}

double forceUnit(const Bar& bar)
{
    return bar.axialStiffness * scales(bar).strain;
}

double impulseUnit(const Bar& bar)
{
    return forceUnit(bar) * scales(bar).time;
}

double amplitudeUnit(Excited place, const Bar& bar)
{
    return place == Excited::tip ? forceUnit(bar) : scales(bar).displacement;
}

Json asJson(const ForcedMotion& motion, const Bar& bar)
{
    const Physical physical = physicalOf(motion.extremes, bar);
    return {{"schedule", phasesAsJson(motion.schedule.phases)},
            {"amplitude", motion.amplitude * amplitudeUnit(motion.excitation.place, bar)},
            {"phase", motion.phase},
            {"impulse", physical.impulse},
            {"peak_force", physical.peakForce},
            {"tip_lowest", physical.tipLowest},
            {"physical", physicalAsJson(physical)},
            {"admissible", physical.isAdmissible()},
            {"residual", motion.residual}};
}

}  // namespace signorini::cli
