#include <algorithm>

#include "builders.hpp"
#include "equations.hpp"
#include "infinity.hpp"
#include "row_list.hpp"
#include "stops.hpp"

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

Row scaled(Row row, double factor)
{
    for (auto& [column, value] : row) {
        value *= factor;
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
    const std::vector<FlightLimits> limits = flightLimits(used);
    const auto crossing = crossingSum(used);
    // y counts in units that make the way between two stops a whole number.
    const std::int64_t unit = crossing ? crossing->factor : 1;
    const auto inUnits = [unit](const WaveSum& sum) {
        const std::int64_t units = unit / sum.factor;  // a whole number of them
        return static_cast<double>(units * sum.rhs);
    };

    RowList equal;
    for (Eigen::Index i = 0; i < waves; ++i) {
        Row row = rowOf(w, i);
        row.emplace_back(i, -1.0);
        equal.add(row, 0.0);
    }
    // The row of (31) is minus the sum of the waves.
    const WaveSum start = gapSum(used);
    equal.add(scaled(rowOf(gapRow(used.cells), 0), static_cast<double>(start.factor)),
              -static_cast<double>(start.rhs));
    RowList below;
    Row size;
    Eigen::Index held = 0;
    Eigen::Index flown = 0;
    for (std::size_t k = 0; k < used.phases.size(); ++k) {
        const Phase& phase = used.phases[k];
        const FlightLimits& limit = limits[k];
        for (std::int64_t step = 0; step < phase.contact; ++step, ++held) {
            const Row row = rowOf(tip.pressure, held);
            below.add(scaled(row, pushSign(phase.stop)), 0.0);
            result.delay.push_back({row.front().first, -row.front().second});
            size.emplace_back(row.front().first, -row.front().second);
        }
        const double bottom = limit.least ? inUnits(*limit.least) : -infinity;
        const double floor = static_cast<double>(unit) *
                             ((phase.stop == Stop::right ? 0.0 : crossing.value().value()) - depth);
        program.upper.segment(waves + flown, phase.free).setConstant(inUnits(limit.most));
        program.lower.segment(waves + flown, phase.free).setConstant(std::max(bottom, floor));
        for (std::int64_t step = 0; step < phase.free; ++step, ++flown) {
            Row row = rowOf(tip.velocity, flown);
            result.delay.push_back({row.front().first, row.front().second});
            row.front().second *= -static_cast<double>(unit);
            row.emplace_back(waves + flown, 1.0);
            if (step > 0) {
                row.emplace_back(waves + flown - 1, -1.0);
            }
            equal.add(row, 0.0);
        }
        if (flown < flights) {
            program.lower[waves + flown - 1] = program.upper[waves + flown - 1] =
                inUnits(limit.end);
        }
    }
    if (isCone(used.stops)) {
        equal.add(size, static_cast<double>(used.cells));
    }
    equal.moveTo(program.equalities, program.equalityRhs, program.variables());
    below.moveTo(program.inequalities, program.inequalityRhs, program.variables());
    result.leftOut = {"row (11): it is the first row of (12)",
                      "N - 1 of the N rows per step of (32): they repeat the one that is kept"};
    return result;
}

}  // namespace signorini
