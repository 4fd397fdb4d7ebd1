#include "atlas_answer.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "network_find.hpp"
#include "stepped_bar.hpp"

namespace signorini::answers {

AtlasUnits atlasUnitsOf(const Assembly& bars)
{
    const Network network = networkOf(bars);
    const SceneReference reference = referenceOf(network);
    const double time = static_cast<double>(network.cells()) * network.scales.time;
    const bool isRatio = firstEnergy(network).has_value();
    return {.time = time,
            .energy = isRatio ? *reference.energy : 1.0,
            .isRatio = isRatio,
            .frequency = std::numbers::pi / (2.0 * time * reference.frequency)};
}

AtlasRange atlasRangeOf(const Scene& scene, std::int64_t cells)
{
    validate(scene);
    AtlasRange range = usualRange(cells);
    const Stops stops = stopsOf(scene);
    range.gapSign = stops.right;
    range.secondStop = stops.left;
    range.segments = isUniform(scene.segments) ? std::vector<Segment>() : scene.segments;
    return range;
}

AtlasRange atlasRangeOf(const Assembly& bars)
{
    const std::int64_t cells = networkOf(bars).cells();
    const auto scene = barOf(bars);
    if (scene && isUniform(scene->segments)) {
        return atlasRangeOf(*scene, cells);
    }
    AtlasRange range = usualRange(cells);
    range.bars = bars;
    return range;
}

AtlasRange atlasAsked(const Call& call, AtlasRange usual)
{
    call.read("--max-contact", usual.maxContact);
    call.read("--max-free", usual.maxFree);
    call.read("--phases", usual.maxPhases);
    call.read("--max-energy-ratio", usual.maxEnergyRatio);
    usual.keepsRefuted = call.has("--all");
    usual.familiesOnly = call.has("--families-only");
    refuseIf(usual.keepsRefuted && usual.familiesOnly,
             "--all, --families-only: allowed one of them");
    validate(usual);
    return usual;
}

void validate(const AtlasPoint& point)
{
    if (!std::isfinite(point.units.frequency) || !point.units.isRatio) {
        throw std::invalid_argument(
            "near (--near): allowed of bars with omega_1 and E_1: nothing drifts, contact 1 has a "
            "gap");
    }
}

}  // namespace signorini::answers
