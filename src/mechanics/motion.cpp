#include "signorini/motion.hpp"

#include "compensated_sum.hpp"
#include "propagation.hpp"

namespace signorini {

Motion::Motion(const State& state, const Schedule& schedule)
    : extremes_(extremesOf(state, schedule)), cells_(state.cells())
{
    const Schedule walked = foldedFor(state, schedule);
    steps_ = signorini::steps(walked);
    const auto count = static_cast<std::size_t>(steps_ + 2 * cells_);
    p_.reserve(count);
    const Eigen::VectorXd window = windowOf(state);
    p_.assign(window.begin(), window.end());
    auto echo = [this, m = std::size_t{0}](std::int64_t times, int factor) mutable {
        for (; times > 0; --times) {
            p_.push_back(factor * p_[m++]);
        }
    };
    for (const Phase& phase : walked.phases) {
        echo(phase.contact, contactFactor);
        echo(phase.free, flightFactor);
    }
    sum_.reserve(count + 1);
    CompensatedSum total;
    sum_.push_back(0.0);
    for (const double p : p_) {
        total.add(p);
        sum_.push_back(total.value());
    }
}

double Motion::displacement(std::int64_t node, std::int64_t instant) const
{
    const auto right = static_cast<std::size_t>(instant + cells_ + node);
    const auto left = static_cast<std::size_t>(instant + cells_ - node);
    return (sum_[left] - sum_[right]) / static_cast<double>(cells_);
}

double Motion::velocity(std::int64_t cell, std::int64_t instant) const
{
    return p_[static_cast<std::size_t>(instant + cells_ - cell)] -
           p_[static_cast<std::size_t>(instant + cells_ + cell - 1)];
}

double Motion::strain(std::int64_t cell, std::int64_t instant) const
{
    return -p_[static_cast<std::size_t>(instant + cells_ - cell)] -
           p_[static_cast<std::size_t>(instant + cells_ + cell - 1)];
}

double Motion::wallForce(std::int64_t step) const
{
    // What came back is +p_m in contact, -p_m in flight.
    return p_[static_cast<std::size_t>(step)] + p_[static_cast<std::size_t>(step + 2 * cells_)];
}

std::vector<std::int64_t> thinned(std::int64_t last, std::int64_t most)
{
    const std::int64_t intervals = most - 1;
    const std::int64_t stride = last <= intervals ? 1 : (last + intervals - 1) / intervals;
    std::vector<std::int64_t> values;
    for (std::int64_t value = 0; value < last; value += stride) {
        values.push_back(value);
    }
    values.push_back(last);
    return values;
}

}  // namespace signorini
