#include "field.hpp"

namespace signorini {

std::vector<std::int64_t> evenly(std::int64_t last, std::int64_t most)
{
    std::vector<std::int64_t> values = thinned(last, most);
    if (values.size() > 2 && values.back() - values[values.size() - 2] != values[1]) {
        values.pop_back();
    }
    return values;
}

plot::Series fieldOf(const Motion& motion, double length, double time, double displacement,
                     std::int64_t nodes, std::int64_t instants)
{
    plot::Series field{.kind = plot::Kind::image};
    const auto cells = static_cast<double>(motion.cells());
    const std::vector<std::int64_t> places = evenly(motion.cells(), nodes);
    for (const std::int64_t i : places) {
        field.x.push_back(static_cast<double>(i) / cells * length);
    }
    for (const std::int64_t m : evenly(motion.steps(), instants)) {
        field.y.push_back(static_cast<double>(m) / cells * time);
        for (const std::int64_t i : places) {
            field.z.push_back(motion.displacement(i, m) * displacement);
        }
    }
    return field;
}

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
