#pragma once
/// \file
/// A linear program of a forced bar, as oracles write it down: in waves and in (C, S), the last two
/// columns; solved by GLPK.

#include <glpk.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace signorini::test {

class ForcedProgram {
public:
    /// `tolerance`: of rows, by which GLPK may miss them.
    ForcedProgram(Eigen::Index columns, double tolerance)
        : columns_(static_cast<int>(columns)), tolerance_(tolerance)
    {
    }

    /// values . x >= least, or = least.
    void add(Eigen::VectorXd values, double least, bool isEqual)
    {
        const double size = std::max(values.cwiseAbs().maxCoeff(), 1e-12);
        // What is 0 but for rounding is 0.
        values = (values.array().abs() < 1e-13 * std::max(1.0, size)).select(0.0, values);
        rows_.push_back({values / size, least / size, isEqual});
    }

    /// By how much inequalities have to be missed; NaN: the equalities contradict each other.
    [[nodiscard]] double leastMissed() const { return solve(0.0, 0.0, 0.0, true); }

    /// The largest c C + s S, with |C|, |S| <= most.
    [[nodiscard]] double farthest(double c, double s, double most) const
    {
        return solve(c, s, most, false);
    }

private:
    struct Row {
        Eigen::VectorXd values;
        double least;
        bool isEqual;
    };

    [[nodiscard]] double solve(double c, double s, double most, bool mayMiss) const
    {
        glp_prob* lp = glp_create_prob();
        glp_add_cols(lp, columns_ + 1);
        for (int column = 1; column <= columns_; ++column) {
            const bool isBounded = !mayMiss && column > columns_ - 2;
            glp_set_col_bnds(lp, column, isBounded ? GLP_DB : GLP_FR, -most, most);
        }
        glp_set_col_bnds(lp, columns_ + 1, mayMiss ? GLP_LO : GLP_FX, 0.0, 0.0);
        glp_add_rows(lp, static_cast<int>(rows_.size()));
        int number = 0;
        for (const Row& row : rows_) {
            std::vector<int> columns{0};
            std::vector<double> values{0.0};
            for (int column = 1; column <= columns_; ++column) {
                if (row.values[column - 1] != 0.0) {
                    columns.push_back(column);
                    values.push_back(row.values[column - 1]);
                }
            }
            if (mayMiss && !row.isEqual) {
                columns.push_back(columns_ + 1);
                values.push_back(1.0);
            }
            ++number;
            glp_set_mat_row(lp, number, static_cast<int>(columns.size()) - 1, columns.data(),
                            values.data());
            glp_set_row_bnds(lp, number, row.isEqual ? GLP_FX : GLP_LO, row.least, row.least);
        }
        glp_set_obj_dir(lp, mayMiss ? GLP_MIN : GLP_MAX);
        glp_set_obj_coef(lp, columns_ - 1, c);
        glp_set_obj_coef(lp, columns_, s);
        glp_set_obj_coef(lp, columns_ + 1, mayMiss ? 1.0 : 0.0);
        glp_smcp settings;
        glp_init_smcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        settings.tol_bnd = tolerance_;
        const bool isSolved = glp_simplex(lp, &settings) == 0 && glp_get_status(lp) == GLP_OPT;
        const double best = isSolved ? glp_get_obj_val(lp) : NAN;
        glp_delete_prob(lp);
        return best;
    }

    int columns_;
    double tolerance_;
    std::vector<Row> rows_;
};

}  // namespace signorini::test
