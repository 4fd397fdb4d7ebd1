#pragma once
/// \file
/// Does a schedule have a motion, and what is its set? Rows that are written down here, step by
/// step from the waves, for GLPK to solve and for others to list: no code of the library.

#include <glpk.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "signorini/schedule.hpp"

namespace signorini::test {

/// sign * x[index]: the wave that arrives in a step, as one of the 2N of the start.
struct SignedIndex {
    std::size_t index;
    int sign;
};

/// Rows over the 2N waves p_0, p_1, ... that arrive first.
class OracleRows {
public:
    struct Row {
        std::vector<double> values;
        int kind;  ///< GLP_FX, GLP_LO or GLP_UP
        double rhs;
    };

    explicit OracleRows(const Schedule& schedule)
        : size_(static_cast<std::size_t>(2 * schedule.cells))
    {
        const auto cells = static_cast<double>(schedule.cells);
        const double right = schedule.stops.right;
        const auto& left = schedule.stops.left;
        const double second =
            left ? -static_cast<double>(left->numerator) / static_cast<double>(left->denominator)
                 : 0.0;
        const auto place = [&](const Phase& phase) {
            return phase.stop == Stop::right ? right : second;
        };
        std::vector<SignedIndex> line;
        for (std::size_t m = 0; m < size_; ++m) {
            line.push_back({m, 1});
        }
        add(std::vector<double>(size_, 1.0), GLP_FX, -cells * place(schedule.phases.front()));
        std::vector<double> pushes(size_, 0.0);
        for (std::size_t k = 0; k < schedule.phases.size(); ++k) {
            const Phase& phase = schedule.phases[k];
            const double push = phase.stop == Stop::right ? 1.0 : -1.0;
            for (std::int64_t step = 0; step < phase.contact; ++step) {
                const SignedIndex now = line.front();
                std::vector<double> row(size_, 0.0);
                row[now.index] = push * now.sign;
                add(row, GLP_LO, 0.0);
                pushes[now.index] += now.sign;
                line.erase(line.begin());
                line.push_back(now);
            }
            std::vector<double> moved(size_, 0.0);
            const double start = place(phase);
            for (std::int64_t step = 0; step < phase.free; ++step) {
                const SignedIndex now = line.front();
                moved[now.index] += now.sign;
                add(moved, GLP_UP, 0.5 * cells * (right - start));
                if (left) {
                    add(moved, GLP_LO, 0.5 * cells * (second - start));
                }
                line.erase(line.begin());
                line.push_back({now.index, -now.sign});
            }
            const double end = place(schedule.phases[(k + 1) % schedule.phases.size()]);
            add(moved, GLP_FX, 0.5 * cells * (end - start));
        }
        for (std::size_t m = 0; m < size_; ++m) {
            std::vector<double> row(size_, 0.0);
            row[line[m].index] += line[m].sign;
            row[m] -= 1.0;
            add(row, GLP_FX, 0.0);
        }
        if (right == 0.0 && !left) {
            add(pushes, GLP_FX, cells);  // not the bar at rest
        }
    }

    /// \pre the simplex method ends.
    [[nodiscard]] bool isFeasible() const
    {
        glp_prob* program = glp_create_prob();
        glp_add_cols(program, static_cast<int>(size_));
        for (int column = 1; column <= static_cast<int>(size_); ++column) {
            glp_set_col_bnds(program, column, GLP_FR, 0.0, 0.0);
        }
        std::vector<int> columns;
        std::vector<double> values;
        glp_add_rows(program, static_cast<int>(rows_.size()));
        int number = 0;
        for (const Row& row : rows_) {
            columns.assign(1, 0);
            values.assign(1, 0.0);
            for (std::size_t m = 0; m < size_; ++m) {
                if (row.values[m] != 0.0) {
                    columns.push_back(static_cast<int>(m) + 1);
                    values.push_back(row.values[m]);
                }
            }
            ++number;
            glp_set_mat_row(program, number, static_cast<int>(columns.size()) - 1, columns.data(),
                            values.data());
            glp_set_row_bnds(program, number, row.kind, row.rhs, row.rhs);
        }
        glp_smcp settings;
        glp_init_smcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        const int failed = glp_simplex(program, &settings);
        const int status = glp_get_status(program);
        glp_delete_prob(program);
        return failed == 0 && status == GLP_OPT;
    }

    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

private:
    void add(std::vector<double> values, int kind, double rhs)
    {
        rows_.push_back({std::move(values), kind, rhs});
    }

    std::size_t size_;
    std::vector<Row> rows_;
};

/// 1..3 phases on 1..maxCells cells with stops of a kind; where there are two, some touch the left.
inline Schedule randomScene(std::mt19937_64& generator, const Stops& stops, std::int64_t maxCells)
{
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    Schedule schedule{draw(1, maxCells), {}, stops};
    const std::int64_t count = draw(1, stops.left ? 4 : 2);
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t most = draw(0, 1) == 0 ? 2 * schedule.cells : 5 * schedule.cells;
        schedule.phases.push_back({draw(1, 2 * schedule.cells), draw(1, most),
                                   stops.left && draw(0, 1) == 0 ? Stop::left : Stop::right});
    }
    if (stops.left && draw(0, 1) == 0) {  // a pair of mirrored phases
        schedule.phases.resize(1);
        schedule.phases.front().stop = Stop::right;
        schedule.phases.push_back(schedule.phases.front());
        schedule.phases.back().stop = Stop::left;
    }
    return schedule;
}

}  // namespace signorini::test
