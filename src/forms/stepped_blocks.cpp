#include <algorithm>

#include "stepped_form.hpp"
#include "stops.hpp"

namespace signorini {

SteppedBlocks blocksOf(const SteppedBar& bar, const Schedule& schedule, double tipFloor)
{
    validate(schedule);
    SteppedBlocks result{
        bar,
        schedule,
        {networkOf(schedule.stops, bar.segments, schedule.cells), spansOf(schedule)},
        {}};
    const std::size_t tip = bar.segments.size();
    std::int64_t step = 0;
    const auto take = [&](std::int64_t steps, StepBlock block) {
        for (const std::int64_t end = step + steps; step < end;) {
            const auto [type, turn] = result.network.placeOf(tip, step);
            block.type = type;
            block.turn = turn;
            result.blocks.push_back(block);
            step += result.network.types()[type].width;
        }
    };
    const Stops& stops = schedule.stops;
    const double half = 0.5 * static_cast<double>(bar.cells);
    const double low =
        stops.left ? std::max(tipFloor, placeOf(stops, Stop::left).value()) : tipFloor;
    const std::vector<Phase>& phases = schedule.phases;
    for (std::size_t k = 0; k < phases.size(); ++k) {
        take(phases[k].contact, {.isContact = true, .push = pushSign(phases[k].stop)});
        // From one stop to the next that is touched.
        const double start = placeOf(stops, phases[k].stop).value();
        const Stop to = phases[(k + 1) % phases.size()].stop;
        take(phases[k].free, {.bound = half * (placeOf(stops, Stop::right).value() - start),
                              .floor = half * (low - start)});
        result.blocks.back().isFlightEnd = true;
        result.blocks.back().landing = half * (placeOf(stops, to).value() - start);
    }
    return result;
}

}  // namespace signorini
