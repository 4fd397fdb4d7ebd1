#pragma once
/// \file
/// Has a schedule a forced motion? The answer of a linear program in the 2N waves that arrive first
/// and in (C, S), written down here step by step from the law at the tip and solved by GLPK: it
/// shares no code with the library. Only the numbers of the excitation are taken from it.

#include <glpk.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "forced_support.hpp"

namespace signorini::test {

class ForcedOracle {
public:
    /// `shapes`: cosine and sine.
    ForcedOracle(const Schedule& schedule, double rho, std::span<const Excitation> shapes)
        : cells_(schedule.cells), stops_(schedule.stops), rho_(rho), shapes_(shapes)
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
                add(phase.stop == Stop::right ? push : Eigen::VectorXd(-push), 0.0, false);
                advance(step, true);
            }
            Eigen::VectorXd moved = Eigen::VectorXd::Zero(waves + 2);
            const double start = placeOf(phase.stop);
            for (std::int64_t f = 0; f < phase.free; ++f, ++step) {
                moved += pushOf(step) * (0.5 * (1.0 + rho_) / static_cast<double>(cells_));
                add(-moved, start - stops_.right, false);
                if (stops_.left) {
                    add(moved, placeOf(Stop::left) - start, false);
                }
                advance(step, false);
            }
            const Phase& next = schedule.phases[(k + 1) % schedule.phases.size()];
            add(moved, placeOf(next.stop) - start, true);
        }
        for (Eigen::Index m = 0; m < waves; ++m) {
            add(queue_[static_cast<std::size_t>(m)] - unit(m), 0.0, true);
        }
    }

    /// By how much inequalities have to be missed; NaN: the equalities contradict each other.
    [[nodiscard]] double leastMissed() const
    {
        Lp lp(*this, true);
        return lp.best({}, true);
    }

    /// The largest amplitude in four directions, with |C|, |S| <= 1.
    [[nodiscard]] double reach() const
    {
        double most = 0.0;
        for (const double sign : {1.0, -1.0}) {
            for (const Eigen::Index which : {2 * cells_, 2 * cells_ + 1}) {
                Eigen::VectorXd objective = Eigen::VectorXd::Zero(2 * cells_ + 2);
                objective[which] = sign;
                Lp lp(*this, false);
                most = std::max(most, lp.best(objective, false));
            }
        }
        return most;
    }

private:
    struct Row {
        Eigen::VectorXd values;
        double least;
        bool isEqual;
    };

    class Lp {
    public:
        Lp(const ForcedOracle& oracle, bool mayMiss) : lp_(glp_create_prob())
        {
            const auto count = static_cast<int>(2 * oracle.cells_ + 2);
            glp_add_cols(lp_, count + 1);
            for (int column = 1; column <= count; ++column) {
                const bool isBounded = !mayMiss && column > count - 2;
                glp_set_col_bnds(lp_, column, isBounded ? GLP_DB : GLP_FR, -1.0, 1.0);
            }
            glp_set_col_bnds(lp_, count + 1, mayMiss ? GLP_LO : GLP_FX, 0.0, 0.0);
            glp_add_rows(lp_, static_cast<int>(oracle.rows_.size()));
            int number = 0;
            for (const Row& row : oracle.rows_) {
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
                ++number;
                glp_set_mat_row(lp_, number, static_cast<int>(columns.size()) - 1, columns.data(),
                                values.data());
                glp_set_row_bnds(lp_, number, row.isEqual ? GLP_FX : GLP_LO, row.least, row.least);
            }
        }
        Lp(const Lp&) = delete;
        Lp& operator=(const Lp&) = delete;
        ~Lp() { glp_delete_prob(lp_); }

        /// The largest value of an objective, or the least of what is missed.
        double best(const Eigen::VectorXd& objective, bool leastMissed)
        {
            glp_set_obj_dir(lp_, leastMissed ? GLP_MIN : GLP_MAX);
            for (Eigen::Index k = 0; k < objective.size(); ++k) {
                glp_set_obj_coef(lp_, static_cast<int>(k) + 1, objective[k]);
            }
            if (leastMissed) {
                glp_set_obj_coef(lp_, glp_get_num_cols(lp_), 1.0);
            }
            glp_smcp settings;
            glp_init_smcp(&settings);
            settings.msg_lev = GLP_MSG_OFF;
            settings.tol_bnd = 1e-9;
            const int failed = glp_simplex(lp_, &settings);
            return failed == 0 && glp_get_status(lp_) == GLP_OPT ? glp_get_obj_val(lp_) : NAN;
        }

    private:
        glp_prob* lp_;
    };

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
        add(tip, placeOf(first.stop), true);
    }
    /// values . x >= least, or = least.
    void add(Eigen::VectorXd values, double least, bool isEqual)
    {
        const double size = std::max(values.cwiseAbs().maxCoeff(), 1e-12);
        // What is 0 but for rounding is 0.
        values = (values.array().abs() < 1e-13 * std::max(1.0, size)).select(0.0, values);
        rows_.push_back({values / size, least / size, isEqual});
    }

    std::int64_t cells_;
    Stops stops_;
    double rho_;
    std::span<const Excitation> shapes_;
    std::vector<Eigen::VectorXd> queue_;
    std::vector<Row> rows_;
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
