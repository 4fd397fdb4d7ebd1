#pragma once
/// \file
/// What became of disturbances of a motion, whatever moves. signorini/response.hpp.

#include <Eigen/Core>
#include <random>

#include "network_walk.hpp"
#include "signorini/response.hpp"

namespace signorini {

/// Events of one disturbance, at most: less than a second.
inline constexpr std::int64_t mostDisturbedEvents = 20'000'000;

/// A motion that can be started beside.
class Disturbed {
public:
    virtual ~Disturbed() = default;
    Disturbed() = default;
    Disturbed(const Disturbed&) = delete;
    Disturbed& operator=(const Disturbed&) = delete;

    struct Course {
        Eigen::VectorXd start;  ///< what is compared
        Eigen::VectorXd end;
        std::int64_t contacts = 0;
        bool isWhole = true;  ///< else it took too many events, or was cancelled
    };
    /// Disturbed by at most so much of itself, and after so many periods.
    [[nodiscard]] virtual Course follow(double size, std::mt19937_64& generator,
                                        std::int64_t periods) const = 0;
    [[nodiscard]] virtual double distance(const Eigen::VectorXd& one,
                                          const Eigen::VectorXd& other) const = 0;
};

/// What is periodic is compared with where it began, for rounding must not lead it away; else with
/// where it is undisturbed. \throws std::invalid_argument on options out of range.
[[nodiscard]] StabilityResult stabilityOf(const Disturbed& motion, bool isPeriodic,
                                          const StabilityOptions& options);

/// Goes on in steps of a period. \return did it, or did it take too many events?
bool goOn(auto& simulation, double period, std::int64_t periods, const Cancel& cancel)
{
    const auto goesOn = [&] {
        return simulation.events() < mostDisturbedEvents && !isRequested(cancel);
    };
    for (std::int64_t k = 0; k < periods && goesOn(); ++k) {
        simulation.advance(period);
    }
    return goesOn();
}

/// Of a motion of a network: velocities along its bars are disturbed, which moves nothing into a
/// contact. Distances are the root of the energy of what waves differ by, and of what bars that
/// drift are apart, relative to the energy of the motion. \pre a motion that repeats.
/// \throws std::invalid_argument also on one whose waves are all 0.
[[nodiscard]] StabilityResult stabilityOf(const Network& network, const NetworkClaim& motion,
                                          const StabilityOptions& options = {});

}  // namespace signorini
