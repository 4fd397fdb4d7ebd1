#include "propagation.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"

namespace signorini {

Schedule foldedFor(const State& state, Schedule schedule)
{
    validate(schedule);
    requireCells(state, schedule.cells);
    fold(schedule);
    return schedule;
}

void requireWaves(const State& state)
{
    if (state.a.size() != state.b.size() || state.a.size() == 0) {
        throw std::invalid_argument(
            fmt::format("state: a has {} cells and b {}: allowed two arrays of equal length >= 1",
                        state.a.size(), state.b.size()));
    }
}

DelayLine::DelayLine(const State& state)
{
    requireWaves(state);
    ring_ = windowOf(state);
}

void DelayLine::contact(std::int64_t count)
{
    head_ = (head_ + count % ring_.size()) % ring_.size();
}

void DelayLine::free(std::int64_t count)
{
    // 2N free steps are an echo of every value and bring the head back.
    const int factor = flightsFactor(count / ring_.size());
    if (factor != 1) {
        ring_ *= factor;
    }
    echoFlight(count % ring_.size());
}

void DelayLine::echoFlight(std::int64_t count)
{
    const std::int64_t beforeWrap = std::min<std::int64_t>(count, ring_.size() - head_);
    ring_.segment(head_, beforeWrap) *= flightFactor;
    ring_.head(count - beforeWrap) *= flightFactor;
    contact(count);
}

void DelayLine::period(const Schedule& schedule)
{
    for (const Phase& phase : schedule.phases) {
        contact(phase.contact);
        free(phase.free);
    }
}

State DelayLine::state() const
{
    return stateOfWaves(ring_.size() / 2, [this](Eigen::Index m) { return ahead(m); });
}

double DelayLine::distance(const State& other) const
{
    requireCells(other, ring_.size() / 2);
    double largest = 0.0;
    for (Eigen::Index m = 0; m < ring_.size(); ++m) {
        largest = std::max(largest, std::abs(ahead(m) - waveAt(other, m)));
    }
    return largest;
}

}  // namespace signorini
