#include "refined_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "infinity.hpp"

namespace signorini {

namespace {

bool happens(const FrequencyResponse& at)
{
    return !at.motions.empty() || (at.touches && !at.permanent) || at.undecided > 0;
}

/// What an answer comes down to.
struct Outline {
    double low = infinity;  ///< [omega/omega_1], of what happens
    double high = 0.0;
    std::array<double, 3> worst = {};  ///< impulse, force, strain

    [[nodiscard]] bool isNear(const Outline& other, double step) const
    {
        constexpr double part = 0.01;
        bool isIt = std::abs(low - other.low) <= step && std::abs(high - other.high) <= step;
        for (std::size_t k = 0; k < worst.size(); ++k) {
            isIt = isIt &&
                   std::abs(worst[k] - other.worst[k]) <= part * std::max(worst[k], other.worst[k]);
        }
        return isIt;
    }
};

Outline outlineOf(const std::vector<FrequencyResponse>& all)
{
    Outline outline;
    for (const FrequencyResponse& at : all) {
        if (happens(at)) {
            outline.low = std::min(outline.low, at.frequencyRatio);
            outline.high = std::max(outline.high, at.frequencyRatio);
        }
        for (const ForcedMotion& motion : at.motions) {
            const Extremes& of = motion.extremes;
            const std::array seen{of.impulse, of.peakForce,
                                  std::max(of.peakCompression, of.peakTension)};
            for (std::size_t k = 0; k < seen.size(); ++k) {
                outline.worst[k] = std::max(outline.worst[k], seen[k]);
            }
        }
    }
    return outline;
}

}  // namespace

std::vector<FrequencyResponse> refinedResponse(ResponseRange& range, const WorkResponse& work)
{
    range.cells = coarseResponseCells;
    std::vector<FrequencyResponse> all = work(range);
    Outline before = outlineOf(all);
    while (before.high > 0.0 && range.cells < mostRefinedCells) {
        // Neighbours on a grid: omega/omega_1 = 4NK/n.
        const auto steps = 4.0 * static_cast<double>(range.cells * range.cycles);
        const double step = before.high * before.high / steps;
        ResponseRange finer = range;
        finer.cells *= 2;
        finer.leastFrequencyRatio = std::max(range.leastFrequencyRatio, before.low - step);
        finer.mostFrequencyRatio = std::min(range.mostFrequencyRatio, before.high + step);
        const std::vector<FrequencyResponse> inside = work(finer);
        if (inside.empty()) {
            break;
        }
        const double low = inside.back().frequencyRatio;
        const double high = inside.front().frequencyRatio;
        std::erase_if(all, [&](const FrequencyResponse& at) {
            return at.frequencyRatio >= low && at.frequencyRatio <= high;
        });
        const auto place = std::find_if(all.begin(), all.end(), [&](const FrequencyResponse& at) {
            return at.frequencyRatio < low;
        });
        all.insert(place, inside.begin(), inside.end());
        range.cells = finer.cells;
        const Outline after = outlineOf(all);
        const bool isEnough = after.isNear(before, step);
        before = after;
        if (isEnough) {
            break;
        }
    }
    return all;
}

}  // namespace signorini
