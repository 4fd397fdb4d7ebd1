#include "signorini/formulation.hpp"

#include "signorini/equations.hpp"

namespace signorini {

namespace {

using Triplet = Eigen::Triplet<double>;

void append(const SparseMatrix& rows, Eigen::Index firstRow, double factor,
            std::vector<Triplet>& entries)
{
    for (Eigen::Index row = 0; row < rows.outerSize(); ++row) {
        for (SparseMatrix::InnerIterator entry(rows, row); entry; ++entry) {
            entries.emplace_back(static_cast<int>(firstRow + row), static_cast<int>(entry.col()),
                                 factor * entry.value());
        }
    }
}

}  // namespace

Formulated stateProgram(const Schedule& schedule)
{
    validate(schedule);
    Schedule used = schedule;
    fold(used);
    const TipRows tip = tipRows(used);
    const Eigen::Index waves = 2 * used.cells;
    const Eigen::Index flights = tip.velocity.rows();
    const Eigen::Index gapAt = waves;
    const Eigen::Index prefixAt = waves + 1;

    Formulated result;
    Program& program = result.program;
    program = emptyProgram(waves + flights);

    std::vector<Triplet> equal;
    equal.reserve(static_cast<std::size_t>(3 * waves + 3 * flights));
    append(periodMap(used), 0, 1.0, equal);
    for (Eigen::Index i = 0; i < waves; ++i) {
        equal.emplace_back(static_cast<int>(i), static_cast<int>(i), -1.0);
    }
    append(gapRow(used.cells), gapAt, 1.0, equal);
    append(tip.velocity, prefixAt, -1.0, equal);
    Eigen::Index k = 0;
    for (const Phase& phase : used.phases) {
        for (std::int64_t step = 0; step < phase.free; ++step, ++k) {
            const auto row = static_cast<int>(prefixAt + k);
            equal.emplace_back(row, static_cast<int>(waves + k), 1.0);
            if (step > 0) {
                equal.emplace_back(row, static_cast<int>(waves + k - 1), -1.0);
            }
        }
        if (used.phases.size() > 1) {
            program.lower[waves + k - 1] = 0.0;
        }
    }
    program.equalities.resize(prefixAt + flights, waves + flights);
    program.equalities.setFromTriplets(equal.begin(), equal.end());
    program.equalityRhs = Eigen::VectorXd::Zero(prefixAt + flights);
    program.equalityRhs[gapAt] = static_cast<double>(used.cells);
    program.upper.tail(flights).setZero();

    std::vector<Triplet> below;
    append(tip.pressure, 0, 1.0, below);
    program.inequalities.resize(tip.pressure.rows(), waves + flights);
    program.inequalities.setFromTriplets(below.begin(), below.end());
    program.inequalityRhs = Eigen::VectorXd::Zero(tip.pressure.rows());

    result.leftOut = {"row (11): it is the first row of (12)",
                      "N - 1 of the N rows per step of (32): they repeat the one that is kept"};
    if (used.phases.size() == 1) {
        result.leftOut.emplace_back("closure of the free phase: periodicity implies it");
    }
    if (used != schedule) {
        result.leftOut.emplace_back(
            "steps beyond 2N in contact and 4N in flight: their rows repeat");
    }
    return result;
}

State stateOf(const Eigen::VectorXd& x, std::int64_t cells)
{
    return {x.head(cells), x.segment(cells, cells)};
}

}  // namespace signorini
