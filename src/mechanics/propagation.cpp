#include "propagation.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"

namespace signorini {

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
    ring_.resize(2 * state.a.size());
    ring_ << state.a.reverse(), -state.b;
}

void DelayLine::contact(std::int64_t count)
{
    head_ = (head_ + count % ring_.size()) % ring_.size();
}

void DelayLine::free(std::int64_t count)
{
    // 2N free steps negate every value and bring the head back.
    const std::int64_t turns = count / ring_.size();
    if (turns % 2 != 0) {
        ring_ = -ring_;
    }
    negate(count % ring_.size());
}

void DelayLine::negate(std::int64_t count)
{
    const std::int64_t beforeWrap = std::min(count, ring_.size() - head_);
    ring_.segment(head_, beforeWrap) *= -1.0;
    ring_.head(count - beforeWrap) *= -1.0;
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
    const Eigen::Index cells = ring_.size() / 2;
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    for (Eigen::Index m = 0; m < cells; ++m) {
        state.a[cells - 1 - m] = ahead(m);
        state.b[m] = -ahead(cells + m);
    }
    return state;
}

double DelayLine::distance(const State& other) const
{
    const Eigen::Index cells = ring_.size() / 2;
    if (other.a.size() != cells || other.b.size() != cells) {
        throw std::invalid_argument(
            fmt::format("state: {} cells: allowed {}", other.a.size(), cells));
    }
    double largest = 0.0;
    for (Eigen::Index m = 0; m < cells; ++m) {
        largest = std::max({largest, std::abs(ahead(m) - other.a[cells - 1 - m]),
                            std::abs(ahead(cells + m) + other.b[m])});
    }
    return largest;
}

}  // namespace signorini
