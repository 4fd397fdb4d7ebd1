#include "wall_force.hpp"

namespace signorini {

std::vector<double> wallForces(const Motion& motion)
{
    std::vector<double> force;
    force.reserve(static_cast<std::size_t>(motion.steps()));
    for (std::int64_t m = 0; m < motion.steps(); ++m) {
        force.push_back(motion.wallForce(m));
    }
    return force;
}

std::vector<Pressed> pressed(const std::vector<double>& force)
{
    std::vector<Pressed> all;
    for (std::size_t m = 0; m < force.size(); ++m) {
        const auto step = static_cast<std::int64_t>(m);
        if (force[m] == 0.0) {
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
