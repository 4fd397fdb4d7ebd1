#include "builders.hpp"
#include "echo.hpp"
#include "equations.hpp"
#include "row_list.hpp"

namespace signorini {

namespace {

Row rowOf(const SparseMatrix& matrix, Eigen::Index k)
{
    Row row;
    for (SparseMatrix::InnerIterator entry(matrix, k); entry; ++entry) {
        row.emplace_back(entry.col(), entry.value());
    }
    return row;
}

}  // namespace

Formulated stateForm(const Schedule& schedule, double depth)
{
    Formulated result;
    result.schedule = schedule;
    fold(result.schedule);
    const Schedule& used = result.schedule;
    const TipRows tip = tipRows(used);
    const SparseMatrix w = periodMap(used);
    const Eigen::Index waves = 2 * used.cells;
    const Eigen::Index flights = tip.velocity.rows();
    Program& program = result.program;
    program = emptyProgram(waves + flights);
    program.upper.tail(flights).setZero();
    program.lower.tail(flights).setConstant(-depth);

    RowList equal;
    for (Eigen::Index i = 0; i < waves; ++i) {
        Row row = rowOf(w, i);
        row.emplace_back(i, -1.0);
        equal.add(row, 0.0);
    }
    // The row of (31) is minus the sum of the waves.
    equal.add(rowOf(gapRow(used.cells), 0), -static_cast<double>(gapSum(used.cells)));
    RowList below;
    Eigen::Index held = 0;
    Eigen::Index flown = 0;
    for (const Phase& phase : used.phases) {
        for (std::int64_t step = 0; step < phase.contact; ++step, ++held) {
            const Row row = rowOf(tip.pressure, held);
            below.add(row, 0.0);
            result.delay.push_back({row.front().first, -row.front().second});
        }
        for (std::int64_t step = 0; step < phase.free; ++step, ++flown) {
            Row row = rowOf(tip.velocity, flown);
            result.delay.push_back({row.front().first, row.front().second});
            row.front().second *= -1.0;
            row.emplace_back(waves + flown, 1.0);
            if (step > 0) {
                row.emplace_back(waves + flown - 1, -1.0);
            }
            equal.add(row, 0.0);
        }
        if (flown < flights) {
            program.lower[waves + flown - 1] = 0.0;
        }
    }
    equal.moveTo(program.equalities, program.equalityRhs, program.variables());
    below.moveTo(program.inequalities, program.inequalityRhs, program.variables());
    result.leftOut = {"row (11): it is the first row of (12)",
                      "N - 1 of the N rows per step of (32): they repeat the one that is kept"};
    return result;
}

}  // namespace signorini
