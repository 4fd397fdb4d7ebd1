#include "force_report.hpp"

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

}  // namespace signorini::cli
