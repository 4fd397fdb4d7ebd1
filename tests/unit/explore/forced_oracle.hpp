#pragma once
/// \file
/// Has a schedule a forced motion? The answer of a linear program in the 2N waves that arrive first
/// and in (C, S), written down here step by step from the law at the tip and solved by GLPK: it
/// shares no code with the library. Only the numbers of the excitation are taken from it.

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "forced_program.hpp"
#include "forced_support.hpp"

namespace signorini::test {

class ForcedOracle {
public:
    /// `shapes`: cosine and sine.
    ForcedOracle(const Schedule& schedule, double rho, std::span<const Excitation> shapes)
        : cells_(schedule.cells),
          stops_(schedule.stops),
          rho_(rho),
          shapes_(shapes),
          program_(2 * cells_ + 2, 1e-9)
    {
        const Eigen::Index waves = 2 * cells_;
        for (Eigen::Index m = 0; m < waves; ++m) {
            queue_.push_back(unit(m));
        }
        addGap(schedule.phases.front());
        std::int64_t step = 0;
        for (std::size_t k = 0; k < schedule.phases.size(); ++k) {
            const Phase& phase = schedule.phases[k];
            for (std::int64_t c = 0; c < phase.contact; ++c, ++step) {
                const Eigen::VectorXd push = pushOf(step);
                program_.add(phase.stop == Stop::right ? push : Eigen::VectorXd(-push), 0.0, false);
                advance(step, true);
            }
            Eigen::VectorXd moved = Eigen::VectorXd::Zero(waves + 2);
            const double start = placeOf(phase.stop);
            for (std::int64_t f = 0; f < phase.free; ++f, ++step) {
                moved += pushOf(step) * (0.5 * (1.0 + rho_) / static_cast<double>(cells_));
                program_.add(-moved, start - stops_.right, false);
                if (stops_.left) {
                    program_.add(moved, placeOf(Stop::left) - start, false);
                }
                advance(step, false);
            }
            const Phase& next = schedule.phases[(k + 1) % schedule.phases.size()];
            program_.add(moved, placeOf(next.stop) - start, true);
        }
        for (Eigen::Index m = 0; m < waves; ++m) {
            program_.add(queue_[static_cast<std::size_t>(m)] - unit(m), 0.0, true);
        }
    }

    /// By how much inequalities have to be missed; NaN: the equalities contradict each other.
    [[nodiscard]] double leastMissed() const { return program_.leastMissed(); }

    /// The largest c C + s S, with |C|, |S| <= most.
    [[nodiscard]] double farthest(double c, double s, double most) const
    {
        return program_.farthest(c, s, most);
    }

    /// The largest amplitude in four directions, with |C|, |S| <= 1.
    [[nodiscard]] double reach() const
    {
        double most = 0.0;
        for (const double sign : {1.0, -1.0}) {
            most = std::max(
                {most, program_.farthest(sign, 0.0, 1.0), program_.farthest(0.0, sign, 1.0)});
        }
        return most;
    }

private:
    [[nodiscard]] double placeOf(Stop stop) const
    {
        return stop == Stop::right ? stops_.right
                                   : -static_cast<double>(stops_.left->numerator) /
                                         static_cast<double>(stops_.left->denominator);
    }
    [[nodiscard]] Eigen::VectorXd unit(Eigen::Index which) const
    {
        Eigen::VectorXd one = Eigen::VectorXd::Zero(2 * cells_ + 2);
        one[which] = 1.0;
        return one;
    }
    template <typename Value>
    [[nodiscard]] Eigen::VectorXd excitation(Value value) const
    {
        Eigen::VectorXd one = Eigen::VectorXd::Zero(2 * cells_ + 2);
        one[2 * cells_] = value(shapes_[0]);
        one[2 * cells_ + 1] = value(shapes_[1]);
        return one;
    }
    [[nodiscard]] Eigen::VectorXd pushOf(std::int64_t step) const
    {
        return 2.0 * queue_.front() +
               excitation([step](const Excitation& e) { return e.force(step); });
    }
    void advance(std::int64_t step, bool isHeld)
    {
        Eigen::VectorXd next =
            excitation([&](const Excitation& e) { return e.baseVelocity(step + cells_); });
        next += isHeld
                    ? Eigen::VectorXd(queue_.front())
                    : Eigen::VectorXd(-rho_ * queue_.front() - excitation([&](const Excitation& e) {
                          return 0.5 * (1.0 + rho_) * e.force(step);
                      }));
        queue_.erase(queue_.begin());
        queue_.push_back(next);
    }
    void addGap(const Phase& first)
    {
        Eigen::VectorXd tip =
            excitation([this](const Excitation& e) { return e.baseDisplacement(cells_); });
        tip.head(2 * cells_).setConstant(-1.0 / static_cast<double>(cells_));
        program_.add(tip, placeOf(first.stop), true);
    }
    std::int64_t cells_;
    Stops stops_;
    double rho_;
    std::span<const Excitation> shapes_;
    std::vector<Eigen::VectorXd> queue_;
    ForcedProgram program_;
};

/// The kinds of stops there are, and a second stop at some distances.
inline std::vector<Stops> forcedStops()
{
    return {{-1, {}},
            {0, {}},
            {1, Fraction{1, 1}},
            {1, Fraction{2, 3}},
            {1, Fraction{5, 2}},
            {-1, Fraction{3, 2}},
            {0, Fraction{1, 4}}};
}

}  // namespace signorini::test
