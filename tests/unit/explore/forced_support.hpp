#pragma once
/// \file
/// Random forced cases, and their waves by a dense solver that knows no classes.

#include <Eigen/LU>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>

#include "signorini/response.hpp"

namespace signorini::test {

/// The waves of one schedule: (shift - law) p = source.
class Dense {
public:
    Dense(const Schedule& schedule, double rho)
        : cells_(schedule.cells), steps_(steps(schedule)), rho_(rho)
    {
        for (const Phase& phase : schedule.phases) {
            isContact_.insert(isContact_.end(), static_cast<std::size_t>(phase.contact), true);
            isContact_.insert(isContact_.end(), static_cast<std::size_t>(phase.free), false);
        }
        Eigen::MatrixXd law = Eigen::MatrixXd::Zero(steps_, steps_);
        for (std::int64_t m = 0; m < steps_; ++m) {
            law(m, (m + 2 * cells_) % steps_) += 1.0;
            law(m, m) -= isContact(m) ? 1.0 : -rho;
        }
        solver_.compute(law);
    }

    [[nodiscard]] bool isRegular() const { return solver_.isInvertible(); }

    /// p for an excitation of the schedule's steps.
    [[nodiscard]] Eigen::VectorXd waves(const Excitation& e) const
    {
        Eigen::VectorXd source(steps_);
        for (std::int64_t m = 0; m < steps_; ++m) {
            source[m] =
                e.baseVelocity(m + cells_) - (isContact(m) ? 0.0 : 0.5 * (1.0 + rho_) * e.force(m));
        }
        return solver_.solve(source);
    }

    /// By how much an excitation breaks a condition, the tip being at the wall at t = 0 but for
    /// `gap`; flights have to close.
    struct Broken {
        double gap = 0.0;
        double rows = 0.0;
        double closure = 0.0;
    };
    [[nodiscard]] Broken broken(const Excitation& e) const
    {
        const Eigen::VectorXd p = waves(e);
        Broken broken{tip(e, p) - 1.0, 0.0, 0.0};
        double prefix = 0.0;
        for (std::int64_t m = 0; m < steps_; ++m) {
            const double push = e.force(m) + 2.0 * p[m];
            if (isContact(m)) {
                broken.closure = std::max(broken.closure, std::abs(prefix));
                prefix = 0.0;
                broken.rows = std::max(broken.rows, -push);
            } else {
                prefix += push;
                broken.rows = std::max(broken.rows, prefix);
            }
        }
        return broken;
    }

    /// The excitation scaled so that the tip is at the wall at t = 0, if that is a motion.
    [[nodiscard]] std::optional<double> amplitude(const Excitation& e, double margin) const
    {
        const double scale = 1.0 / tip(e, waves(e));
        Excitation scaled = e;
        for (double& value : scaled.values) {
            value *= scale;
        }
        const Broken seen = broken(scaled);
        return seen.rows <= margin ? std::optional(scale) : std::nullopt;
    }

private:
    [[nodiscard]] bool isContact(std::int64_t m) const
    {
        return isContact_[static_cast<std::size_t>(m)];
    }
    [[nodiscard]] double tip(const Excitation& e, const Eigen::VectorXd& p) const
    {
        double tip = e.baseDisplacement(cells_);
        for (std::int64_t m = 0; m < 2 * cells_; ++m) {
            tip -= p[m % steps_] / static_cast<double>(cells_);
        }
        return tip;
    }

    std::int64_t cells_;
    std::int64_t steps_;
    double rho_;
    std::vector<bool> isContact_;
    Eigen::FullPivLU<Eigen::MatrixXd> solver_;
};

struct ForcedExample {
    Schedule schedule;
    Damping damping;
    Forcing forcing;
};

/// `phases` contact phases in about three to six crossings' time.
inline ForcedExample randomForced(std::mt19937_64& generator, std::int64_t phases = 1)
{
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    const std::int64_t cells = draw(1, 8);
    ForcedExample one{{cells, {}}, {0.01 * static_cast<double>(draw(1, 40))}, {}};
    for (std::int64_t k = 0; k < phases; ++k) {
        const std::int64_t n = draw(3 * cells, 6 * cells);
        const std::int64_t contact = draw(1, std::max<std::int64_t>(1, std::min(n - 1, 2 * cells)));
        one.schedule.phases.push_back({contact, n - contact});
    }
    const std::int64_t most = (steps(one.schedule) - 1) / 2;
    one.forcing.place = draw(0, 1) == 0 ? Excited::tip : Excited::base;
    one.forcing.cycles = draw(1, std::max<std::int64_t>(1, std::min<std::int64_t>(3, most)));
    return one;
}

/// Simulated event by event for ten periods: by how much it has moved, in units of displacement.
inline double driftInTenPeriods(const ForcedMotion& motion)
{
    const std::int64_t cells = motion.state.cells();
    const Waves start = wavesOf(motion.state);
    BarSimulation simulation(
        start, motion.damping, motion.excitation,
        {.mergeBelow = 0.0, .recordsTip = false, .stops = motion.schedule.stops});
    simulation.advance(10.0 * static_cast<double>(motion.excitation.steps()));
    return (stretching(simulation.waves(), cells) - stretching(start, cells)).cwiseAbs().maxCoeff();
}

/// How fast small disturbances grow, rounding among them.
inline double growth(const ForcedMotion& motion)
{
    double most = 1.0;
    for (const StabilityTrial& trial :
         stabilityOf(motion, {.periods = 10, .sizes = {1e-6}, .draws = 2}).trials) {
        most = std::max(most, trial.end / trial.start);
    }
    return most;
}

}  // namespace signorini::test
