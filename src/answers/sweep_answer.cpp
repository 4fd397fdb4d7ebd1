#include "sweep_answer.hpp"

#include "network_sweep.hpp"

namespace signorini::answers {

double unitOf(Swept over, Excited place, const Bar& bar)
{
    switch (over) {
        case Swept::amplitude:
            return amplitudeUnit(place, bar);
        case Swept::gap:
            return scales(bar).displacement;
        case Swept::frequency:
        case Swept::damping:
            return 1.0;
    }
    return 1.0;
}

const char* unitName(Swept over, Excited place)
{
    switch (over) {
        case Swept::frequency:
            return "omega_1";
        case Swept::amplitude:
            return amplitudeUnitName(place);
        case Swept::gap:
            return "m";
        case Swept::damping:
            return "-";
    }
    return "-";
}

double SweepPointOf::given() const
{
    return value.value * unitOf(over, place, bar);
}

std::optional<double> SweepPointOf::stress() const
{
    return bar.young ? std::optional(value.strain * scales(bar).strain * *bar.young) : std::nullopt;
}

std::vector<SweepPointOf> SweepAnswer::listed() const
{
    std::vector<SweepPointOf> all;
    for (const SweepPoint& point : points) {
        all.push_back({point, range.over, range.place, bar});
    }
    return all;
}

void SweepAnswer::require(const Network* network) const
{
    (void)valuesOf(range);
    if (network != nullptr) {
        NetworkSweep{*network, bar, range}.require();
    }
}

}  // namespace signorini::answers
