#include "stepped_blocks.hpp"

#include <algorithm>
#include <numeric>

namespace signorini {

namespace {

/// One phase after another, as blocks.
class Layout {
public:
    explicit Layout(SteppedBlocks& result, double tipFloor)
        : result_(result), tipFloor_(tipFloor), half_(0.5 * static_cast<double>(result.bar.cells))
    {
        result_.echo.resize(result_.types.size() * static_cast<std::size_t>(result_.turns));
    }

    void contact(std::int64_t steps, Stop stop)
    {
        take(steps, [stop](StepBlock& block) {
            block.isContact = true;
            block.push = stop == Stop::right ? 1 : -1;
        });
    }

    /// From one stop to the next that is touched.
    void flight(std::int64_t steps, Stop from, Stop to)
    {
        const Stops& stops = result_.schedule.stops;
        const double start = placeOf(stops, from).value();
        const double low =
            stops.left ? std::max(tipFloor_, placeOf(stops, Stop::left).value()) : tipFloor_;
        take(steps, [&](StepBlock& block) {
            block.bound = half_ * (placeOf(stops, Stop::right).value() - start);
            block.floor = half_ * (low - start);
        });
        result_.blocks.back().isFlightEnd = true;
        result_.blocks.back().landing = half_ * (placeOf(stops, to).value() - start);
    }

private:
    template <typename Fill>
    void take(std::int64_t steps, Fill fill)
    {
        for (const std::int64_t end = step_ + steps; step_ < end;) {
            const std::int64_t residue = step_ % result_.unit;
            const auto after = std::upper_bound(
                result_.types.begin(), result_.types.end(), residue,
                [](std::int64_t value, const ResidueType& type) { return value < type.first; });
            StepBlock block;
            block.type = static_cast<std::size_t>(after - result_.types.begin()) - 1;
            block.turn = step_ / result_.unit;
            fill(block);
            result_.echo[block.type * static_cast<std::size_t>(result_.turns) +
                         static_cast<std::size_t>(block.turn)] = block.isContact ? -1 : 1;
            result_.blocks.push_back(block);
            step_ += result_.types[block.type].width;
        }
    }

    SteppedBlocks& result_;
    double tipFloor_;
    double half_;
    std::int64_t step_ = 0;
};

}  // namespace

std::int64_t SteppedBlocks::stateSize() const
{
    return std::accumulate(delays.begin(), delays.end(), std::int64_t{0});
}

SteppedBlocks blocksOf(const SteppedBar& bar, const Schedule& schedule, double tipFloor)
{
    validate(schedule);
    const NetworkBlocks folded(networkOf(schedule.stops, bar.segments, schedule.cells),
                               spansOf(schedule));
    SteppedBlocks result;
    result.bar = bar;
    result.schedule = schedule;
    result.unit = folded.unit();
    result.turns = folded.turns();
    result.types = folded.types();
    for (const Segment& segment : bar.segments) {
        result.delays.push_back(2 * segment.cells / result.unit);
    }
    Layout layout(result, tipFloor);
    const std::vector<Phase>& phases = schedule.phases;
    for (std::size_t k = 0; k < phases.size(); ++k) {
        layout.contact(phases[k].contact, phases[k].stop);
        layout.flight(phases[k].free, phases[k].stop, phases[(k + 1) % phases.size()].stop);
    }
    return result;
}

}  // namespace signorini
