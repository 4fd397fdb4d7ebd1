#include <cmath>

#include "disturbed.hpp"
#include "faults.hpp"
#include "largest.hpp"
#include "network_motions.hpp"
#include "network_simulation.hpp"

namespace signorini {

namespace {

class DisturbedNetwork final : public Disturbed {
public:
    DisturbedNetwork(const Network& network, const NetworkClaim& motion,
                     const StabilityOptions& options)
        : network_(network),
          motion_(motion),
          options_(options),
          largest_(largestSizeOf(motion.waves))
    {
        Faults faults;
        faults.requirePositive("largest wave", largest_, "-");
        faults.throwIfAny();
    }

    [[nodiscard]] Course follow(double size, std::mt19937_64& generator,
                                std::int64_t periods) const override
    {
        const NetworkStart start = besides(size, generator);
        NetworkSimulation simulation(network_, start,
                                     {.forces = motion_.forces, .velocities = motion_.velocities},
                                     {.mergeBelow = options_.mergeBelow * largest_});
        Course course{joined(start), {}, 0, true};
        course.isWhole =
            goOn(simulation, static_cast<double>(motion_.steps()), periods, options_.cancel);
        course.end = joined(simulation.state());
        course.contacts = simulation.contactCount();
        return course;
    }

    [[nodiscard]] double distance(const Eigen::VectorXd& one,
                                  const Eigen::VectorXd& other) const override
    {
        const std::size_t waves = motion_.waves.size();
        const Eigen::VectorXd apart = one - other;
        const double drift = apart.tail(apart.size() - static_cast<Eigen::Index>(waves)).norm();
        const double energy = energyOf(network_, {apart.data(), waves});
        return std::sqrt((energy + drift * drift / static_cast<double>(network_.cells())) /
                         energyOf(network_, motion_.waves));
    }

private:
    /// Both waves of a cell by the same, so that none is strained.
    [[nodiscard]] NetworkStart besides(double size, std::mt19937_64& generator) const
    {
        NetworkStart start{motion_.waves, motion_.displacements};
        std::uniform_real_distribution<double> part(-size, size);
        for (std::size_t r = 0; size > 0.0 && r < network_.rows.size(); ++r) {
            const auto cells = static_cast<std::size_t>(network_.rows[r].cells);
            const std::size_t right = network_.firstWave(r);
            for (std::size_t k = right; k < right + cells; ++k) {
                const double kick = part(generator) * largest_;
                start.waves[k] += kick;
                start.waves[k + cells] += kick;
            }
        }
        return start;
    }

    /// Waves, and where bars are that drift.
    [[nodiscard]] Eigen::VectorXd joined(const NetworkStart& state) const
    {
        std::vector<double> all = state.waves;
        for (const NetworkBar& bar : network_.bars) {
            if (bar.drifts()) {
                all.push_back(state.displacements[bar.firstNode]);
            }
        }
        return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
    }

    const Network& network_;
    const NetworkClaim& motion_;
    const StabilityOptions& options_;
    double largest_;
};

}  // namespace

StabilityResult stabilityOf(const Network& network, const NetworkClaim& motion,
                            const StabilityOptions& options)
{
    return stabilityOf(DisturbedNetwork(network, motion, options), true, options);
}

}  // namespace signorini
