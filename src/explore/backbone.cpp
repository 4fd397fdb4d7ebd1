#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "signorini/response.hpp"

namespace signorini {

std::vector<Backbone> backbonesOf(double leastFrequencyRatio, double mostFrequencyRatio,
                                  std::int64_t cycles, const Stops& stops, int points)
{
    Faults faults;
    faults.requirePositive("leastFrequencyRatio", leastFrequencyRatio, "-");
    faults.requirePositive("mostFrequencyRatio", mostFrequencyRatio, "-");
    if (leastFrequencyRatio > mostFrequencyRatio) {
        faults.add("leastFrequencyRatio", leastFrequencyRatio,
                   fmt::format("at most {}, the largest", mostFrequencyRatio));
    }
    faults.requireWhole("cycles", cycles, maxForcedSteps / 2);
    faults.requireWhole("points", points, 1'000'000);
    faults.throwIfAny();
    const double unit = 4.0 * static_cast<double>(cycles);
    std::vector<Backbone> backbones;
    if (stops.right == 0) {
        return backbones;
    }
    for (const Mode& mode : findModes({.maxOrder = maxBackboneOrder, .gapSign = stops.right})) {
        const double from = std::max(unit / mostFrequencyRatio, mode.lowest.value());
        const double to = std::min(unit / leastFrequencyRatio, mode.highest.value());
        if (!(from < to)) {
            continue;
        }
        Backbone backbone{mode, {}};
        for (int k = 0; k < points; ++k) {
            const double period = std::lerp(from, to, (k + 0.5) / points);
            const Extremes free = ModeMotion(mode, period).extremes();
            if (!stops.left || -free.lowestTip <= stops.left->value()) {
                backbone.points.push_back({unit / period, energyRatio(mode, period), free});
            }
        }
        backbones.push_back(std::move(backbone));
    }
    return backbones;
}

}  // namespace signorini
