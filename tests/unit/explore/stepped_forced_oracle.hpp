#pragma once
/// \file
/// Has a schedule of a bar of several segments a forced motion? The answer of a linear program in
/// the 2N waves of its cells and in (C, S), written down here cell by cell and solved by GLPK: it
/// shares no code with the library.

#include <glpk.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "signorini/response.hpp"

namespace signorini::test {

class SteppedForcedOracle {
public:
    /// A harmonic of one cycle; eta of the dashpot at the tip, impedances relative to the first.
    SteppedForcedOracle(const Schedule& schedule, std::span<const Segment> segments, double eta,
                        Excited place)
        : cells_(schedule.cells), columns_(2 * cells_ + 2), eta_(eta), place_(place)
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
        add(tip, 1.0, true);
        for (std::int64_t m = 0; m < steps_; ++m) {
            const bool isHeld = m < phase.contact;
            const Vector p = a_.back();
            const double z = impedance_.back();
            const Vector force = forceOf(m);
            if (isHeld) {
                add(2.0 * z * p + force, 0.0, false);
            } else if (m + 1 < steps_) {
                tip += (2.0 * z * p + force) / ((z + eta_) * static_cast<double>(cells_));
                add(-tip, -1.0, false);
            }
            advance(m, isHeld, force);
        }
        for (std::size_t k = 0; k < a_.size(); ++k) {
            add(a_[k] - startA[k], 0.0, true);
            add(b_[k] - startB[k], 0.0, true);
        }
    }

    /// By how much inequalities have to be missed; NaN: the equalities contradict each other.
    [[nodiscard]] double leastMissed() const { return solve(0.0, 0.0, true); }

    /// The largest c C + s S, with |C|, |S| <= 1e4.
    [[nodiscard]] double farthest(double c, double s) const { return solve(c, s, false); }

private:
    using Vector = Eigen::VectorXd;
    struct Row {
        Vector values;
        double least;
        bool isEqual;
    };

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

    void add(Vector values, double least, bool isEqual)
    {
        const double size = std::max(values.cwiseAbs().maxCoeff(), 1e-12);
        // What is 0 but for rounding is 0.
        values = (values.array().abs() < 1e-13 * std::max(1.0, size)).select(0.0, values);
        rows_.push_back({values / size, least / size, isEqual});
    }

    [[nodiscard]] double solve(double c, double s, bool mayMiss) const
    {
        glp_prob* lp = glp_create_prob();
        const auto count = static_cast<int>(columns_);
        glp_add_cols(lp, count + 1);
        for (int column = 1; column <= count; ++column) {
            const bool isBounded = !mayMiss && column > count - 2;
            glp_set_col_bnds(lp, column, isBounded ? GLP_DB : GLP_FR, -1e4, 1e4);
        }
        glp_set_col_bnds(lp, count + 1, mayMiss ? GLP_LO : GLP_FX, 0.0, 0.0);
        glp_add_rows(lp, static_cast<int>(rows_.size()));
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const Row& row = rows_[k];
            std::vector<int> columns{0};
            std::vector<double> values{0.0};
            for (int column = 1; column <= count; ++column) {
                if (row.values[column - 1] != 0.0) {
                    columns.push_back(column);
                    values.push_back(row.values[column - 1]);
                }
            }
            if (mayMiss && !row.isEqual) {
                columns.push_back(count + 1);
                values.push_back(1.0);
            }
            const int number = static_cast<int>(k) + 1;
            glp_set_mat_row(lp, number, static_cast<int>(columns.size()) - 1, columns.data(),
                            values.data());
            glp_set_row_bnds(lp, number, row.isEqual ? GLP_FX : GLP_LO, row.least, row.least);
        }
        glp_set_obj_dir(lp, mayMiss ? GLP_MIN : GLP_MAX);
        glp_set_obj_coef(lp, count - 1, c);
        glp_set_obj_coef(lp, count, s);
        glp_set_obj_coef(lp, count + 1, mayMiss ? 1.0 : 0.0);
        glp_smcp settings;
        glp_init_smcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        settings.tol_bnd = 1e-10;
        const bool isSolved = glp_simplex(lp, &settings) == 0 && glp_get_status(lp) == GLP_OPT;
        const double best = isSolved ? glp_get_obj_val(lp) : NAN;
        glp_delete_prob(lp);
        return best;
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
    std::vector<Row> rows_;
};

}  // namespace signorini::test
