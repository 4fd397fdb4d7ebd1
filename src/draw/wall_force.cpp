#include "wall_force.hpp"

#include "propagation.hpp"

namespace signorini {

std::vector<double> wallForce(const State& state, const Schedule& schedule)
{
    Schedule folded = schedule;
    fold(folded);
    std::vector<double> force;
    force.reserve(static_cast<std::size_t>(steps(folded)));
    // What rounding leaves of a zero is no force.
    const double least = 1e-9 * amplitude(state);
    forEachStep(state, folded, [&](double p, bool isContact) {
        force.push_back(isContact && p > least ? 2.0 * p : 0.0);
    });
    return force;
}

std::vector<Pressed> pressed(const std::vector<double>& force)
{
    std::vector<Pressed> all;
    for (std::size_t m = 0; m < force.size(); ++m) {
        const auto step = static_cast<std::int64_t>(m);
        if (force[m] <= 0.0) {
            continue;
        }
        if (all.empty() || all.back().to != step) {
            all.push_back({step, step});
        }
        all.back().to = step + 1;
    }
    return all;
}

}  // namespace signorini
