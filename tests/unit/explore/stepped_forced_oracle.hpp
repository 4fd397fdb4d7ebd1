#pragma once
/// \file
/// Has a schedule of a bar of several segments a forced motion? The answer of a linear program in
/// the 2N waves of its cells and in (C, S), written down here cell by cell and solved by GLPK: it
/// shares no code with the library.

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "forced_program.hpp"
#include "signorini/response.hpp"

namespace signorini::test {

class SteppedForcedOracle {
public:
    /// A harmonic of one cycle; eta of the dashpot at the tip, impedances relative to the first.
    SteppedForcedOracle(const Schedule& schedule, std::span<const Segment> segments, double eta,
                        Excited place)
        : cells_(schedule.cells),
          columns_(2 * cells_ + 2),
          eta_(eta),
          place_(place),
          program_(columns_, 1e-10)
    {
        for (std::size_t i = 0; i < segments.size(); ++i) {
            for (std::int64_t k = 0; k < segments[i].cells; ++k) {
                const bool isLast = k + 1 == segments[i].cells;
                impedance_.push_back(segments[i].impedance);
                dashpot_.push_back(isLast ? segments[i].dashpot : 0.0);
            }
        }
        const Phase phase = schedule.phases.front();
        steps_ = phase.contact + phase.free;
        for (Eigen::Index k = 0; k < 2 * cells_; ++k) {
            auto& wave = k < cells_ ? a_ : b_;
            wave.push_back(Vector::Unit(columns_, k));
        }
        const std::vector<Vector> startA = a_;
        const std::vector<Vector> startB = b_;
        Vector tip = excitation(baseAngle(0), place_ == Excited::base ? 1.0 : 0.0);
        for (std::size_t k = 0; k < a_.size(); ++k) {
            tip += (b_[k] - a_[k]) / static_cast<double>(cells_);
        }
        program_.add(tip, 1.0, true);
        for (std::int64_t m = 0; m < steps_; ++m) {
            const bool isHeld = m < phase.contact;
            const Vector p = a_.back();
            const double z = impedance_.back();
            const Vector force = forceOf(m);
            if (isHeld) {
                program_.add(2.0 * z * p + force, 0.0, false);
            } else if (m + 1 < steps_) {
                tip += (2.0 * z * p + force) / ((z + eta_) * static_cast<double>(cells_));
                program_.add(-tip, -1.0, false);
            }
            advance(m, isHeld, force);
        }
        for (std::size_t k = 0; k < a_.size(); ++k) {
            program_.add(a_[k] - startA[k], 0.0, true);
            program_.add(b_[k] - startB[k], 0.0, true);
        }
    }

    /// By how much inequalities have to be missed; NaN: the equalities contradict each other.
    [[nodiscard]] double leastMissed() const { return program_.leastMissed(); }

    /// The largest c C + s S, with |C|, |S| <= 1e4.
    [[nodiscard]] double farthest(double c, double s) const { return program_.farthest(c, s, 1e4); }

private:
    using Vector = Eigen::VectorXd;

    [[nodiscard]] double baseAngle(std::int64_t m) const
    {
        return 2.0 * std::numbers::pi * static_cast<double>(m) / static_cast<double>(steps_);
    }
    [[nodiscard]] Vector excitation(double angle, double size) const
    {
        Vector row = Vector::Zero(columns_);
        row[2 * cells_] = size * std::cos(angle);
        row[2 * cells_ + 1] = size * std::sin(angle);
        return row;
    }
    [[nodiscard]] Vector forceOf(std::int64_t m) const
    {
        const double half = 0.5 * (baseAngle(m) + baseAngle(m + 1));
        return excitation(half, place_ == Excited::tip ? 1.0 : 0.0);
    }

    /// Every cell hands on its waves; between two cells the velocity is one and forces balance.
    void advance(std::int64_t m, bool isHeld, const Vector& force)
    {
        std::vector<Vector> a;
        std::vector<Vector> b;
        const double moved = place_ == Excited::base ? static_cast<double>(cells_) : 0.0;
        a.push_back(excitation(baseAngle(m + 1), moved) - excitation(baseAngle(m), moved) -
                    b_.front());
        for (std::size_t k = 0; k + 1 < a_.size(); ++k) {
            const double left = impedance_[k];
            const double right = impedance_[k + 1];
            const Vector v =
                (2.0 * left * a_[k] + 2.0 * right * b_[k + 1]) / (left + right + dashpot_[k]);
            b.push_back(v - a_[k]);
            a.push_back(v - b_[k + 1]);
        }
        const double z = impedance_.back();
        const Vector& p = a_.back();
        b.push_back(isHeld ? Vector(-p) : Vector(((z - eta_) * p + force) / (z + eta_)));
        a_ = std::move(a);
        b_ = std::move(b);
    }

    std::int64_t cells_;
    Eigen::Index columns_;
    double eta_;
    Excited place_;
    std::int64_t steps_ = 0;
    std::vector<double> impedance_;
    std::vector<double> dashpot_;
    std::vector<Vector> a_;
    std::vector<Vector> b_;
    ForcedProgram program_;
};

}  // namespace signorini::test
