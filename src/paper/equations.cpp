#include "equations.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "faults.hpp"

namespace signorini {

namespace {

using Index = std::int64_t;
using Triplet = Eigen::Triplet<double>;

constexpr Index maxEntries = 100'000'000;

/// One unknown with its sign: the value of an extended wave on one cell.
struct Term {
    Index column;
    double sign;
};

void validateCells(Index cells)
{
    if (cells < 1 || cells > maxEquationCells) {
        throwFault("cells", cells, fmt::format("1..{}", maxEquationCells));
    }
}

/// The extensions (21), (22), (24), (25): each maps a cell j (on [x_{j-1}, x_j]) to an unknown.
class Extension {
public:
    explicit Extension(Index cells) : n_(cells) {}

    [[nodiscard]] Term aDD(Index j) const
    {
        j = wrap(j, 2 * n_, n_);
        if (j >= 1) {
            return a(j, 1.0);
        }
        return j > -n_ ? b(1 - j, -1.0) : a(j + 2 * n_, 1.0);
    }

    [[nodiscard]] Term bDD(Index j) const
    {
        j = wrap(j, 2 * n_, 2 * n_);
        return j <= n_ ? b(j, 1.0) : a(2 * n_ + 1 - j, -1.0);
    }

    [[nodiscard]] Term aDN(Index j) const
    {
        j = wrap(j, 4 * n_, n_);
        if (j >= 1) {
            return a(j, 1.0);
        }
        if (j > -n_) {
            return b(1 - j, -1.0);
        }
        return j > -2 * n_ ? a(j + 2 * n_, -1.0) : b(1 - j - 2 * n_, 1.0);
    }

    [[nodiscard]] Term bDN(Index j) const
    {
        j = wrap(j, 4 * n_, 4 * n_);
        if (j <= n_) {
            return b(j, 1.0);
        }
        if (j <= 2 * n_) {
            return a(2 * n_ + 1 - j, 1.0);
        }
        return j <= 3 * n_ ? b(j - 2 * n_, -1.0) : a(4 * n_ + 1 - j, -1.0);
    }

private:
    [[nodiscard]] static Term a(Index i, double sign) { return {i - 1, sign}; }
    [[nodiscard]] Term b(Index i, double sign) const { return {n_ + i - 1, sign}; }

    /// The representative of j modulo `repeat` in last-repeat+1 .. last.
    static Index wrap(Index j, Index repeat, Index last)
    {
        const Index above = ((j - last - 1) % repeat + repeat) % repeat;  // 0 .. repeat-1
        return last - repeat + 1 + above;
    }

    Index n_;
};

/// A matrix whose row k holds the single entry `term(k)`.
template <typename TermOf>
SparseMatrix singleEntryRows(Index rows, Index columns, TermOf term)
{
    SparseMatrix matrix(rows, columns);
    matrix.reserve(rows);
    for (Index row = 0; row < rows; ++row) {
        const Term entry = term(row);
        matrix.startVec(row);
        matrix.insertBack(row, entry.column) = entry.sign;
    }
    matrix.finalize();
    return matrix;
}

/// (29): row i - 1 holds r_1 on cell i, row N + i - 1 holds r_2, after `count` steps.
template <typename AOf, typename BOf>
SparseMatrix stepMap(Index cells, Index count, AOf a, BOf b)
{
    return singleEntryRows(2 * cells, 2 * cells, [&](Index row) {
        return row < cells ? a(row + 1 - count) : b(row - cells + 1 + count);
    });
}

void requireEntries(Index entries)
{
    if (entries > maxEntries) {
        throw std::invalid_argument(
            fmt::format("equations: {} entries: allowed up to {} (use the reduced formulation)",
                        entries, maxEntries));
    }
}

SparseMatrix stack(const std::vector<SparseMatrix>& parts, Index columns)
{
    Index rows = 0;
    Index entries = 0;
    for (const SparseMatrix& part : parts) {
        rows += part.rows();
        entries += part.nonZeros();
    }
    SparseMatrix matrix(rows, columns);
    matrix.reserve(entries);
    Index row = 0;
    for (const SparseMatrix& part : parts) {
        for (Index k = 0; k < part.outerSize(); ++k, ++row) {
            matrix.startVec(row);
            for (SparseMatrix::InnerIterator entry(part, k); entry; ++entry) {
                matrix.insertBack(row, entry.col()) = entry.value();
            }
        }
    }
    matrix.finalize();
    return matrix;
}

/// Row k of a phase is the sum of rows 0..k of that phase.
SparseMatrix prefixSums(const SparseMatrix& terms, const std::vector<Phase>& phases)
{
    std::vector<Triplet> entries;
    Eigen::VectorXd sum(terms.cols());
    Index row = 0;
    for (const Phase& phase : phases) {
        sum.setZero();
        for (Index step = 0; step < phase.free; ++step, ++row) {
            for (SparseMatrix::InnerIterator entry(terms, row); entry; ++entry) {
                sum[entry.col()] += entry.value();
            }
            for (Index column = 0; column < terms.cols(); ++column) {
                if (sum[column] != 0.0) {
                    entries.emplace_back(static_cast<int>(row), static_cast<int>(column),
                                         sum[column]);
                }
            }
        }
    }
    SparseMatrix matrix(terms.rows(), terms.cols());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace

ExtendedWaves extendedWaves(std::int64_t cells)
{
    validateCells(cells);
    const Extension wave(cells);
    const auto build = [&](auto term) {
        return singleEntryRows(4 * cells, 2 * cells,
                               [&](Index row) { return term(row - 2 * cells + 1); });
    };
    return {.aDD = build([&](Index j) { return wave.aDD(j); }),
            .bDD = build([&](Index j) { return wave.bDD(j); }),
            .aDN = build([&](Index j) { return wave.aDN(j); }),
            .bDN = build([&](Index j) { return wave.bDN(j); })};
}

SparseMatrix contactMap(std::int64_t cells, std::int64_t count)
{
    validateCells(cells);
    if (count < 0) {
        throwFault("count", count, ">= 0");
    }
    const Extension wave(cells);
    return stepMap(
        cells, count, [&](Index j) { return wave.aDD(j); }, [&](Index j) { return wave.bDD(j); });
}

SparseMatrix freeMap(std::int64_t cells, std::int64_t count)
{
    validateCells(cells);
    if (count < 0) {
        throwFault("count", count, ">= 0");
    }
    const Extension wave(cells);
    return stepMap(
        cells, count, [&](Index j) { return wave.aDN(j); }, [&](Index j) { return wave.bDN(j); });
}

SparseMatrix periodMap(const Schedule& schedule)
{
    validate(schedule);
    validateCells(schedule.cells);
    SparseMatrix w(2 * schedule.cells, 2 * schedule.cells);
    w.setIdentity();
    for (const Phase& phase : schedule.phases) {
        w = SparseMatrix(contactMap(schedule.cells, phase.contact) * w);
        w = SparseMatrix(freeMap(schedule.cells, phase.free) * w);
    }
    return w;
}

SparseMatrix gapRow(std::int64_t cells)
{
    validateCells(cells);
    SparseMatrix row(1, 2 * cells);
    row.reserve(2 * cells);
    row.startVec(0);
    for (Index column = 0; column < 2 * cells; ++column) {
        row.insertBack(0, column) = column < cells ? -1.0 : 1.0;
    }
    row.finalize();
    return row;
}

TipRows tipRows(const Schedule& schedule)
{
    validate(schedule);
    validateCells(schedule.cells);
    requireEntries(steps(schedule));
    const Index cells = schedule.cells;
    const Extension wave(cells);
    std::vector<SparseMatrix> contact;
    std::vector<SparseMatrix> free;
    SparseMatrix toPhase(2 * cells, 2 * cells);
    toPhase.setIdentity();
    for (const Phase& phase : schedule.phases) {
        // s(L)/2 = (r_2 - r_1)/2 = -r_1 and v(L)/(2c) = (r_1 + r_2)/2 = r_1 at the tip, where
        // r_2 = -r_1 in contact (19) and r_2 = r_1 in free flight (17).
        const SparseMatrix held = singleEntryRows(phase.contact, 2 * cells, [&](Index m) {
            const Term r1 = wave.aDD(cells - m);
            return Term{r1.column, -r1.sign};
        });
        const SparseMatrix flying =
            singleEntryRows(phase.free, 2 * cells, [&](Index k) { return wave.aDN(cells - k); });
        contact.emplace_back(held * toPhase);
        toPhase = SparseMatrix(contactMap(cells, phase.contact) * toPhase);
        free.emplace_back(flying * toPhase);
        toPhase = SparseMatrix(freeMap(cells, phase.free) * toPhase);
    }
    return {.pressure = stack(contact, 2 * cells), .velocity = stack(free, 2 * cells)};
}

Inequalities inequalities(const Schedule& schedule)
{
    const TipRows rows = tipRows(schedule);
    requireEntries(rows.velocity.rows() * 2 * schedule.cells);
    const SparseMatrix penetration = prefixSums(rows.velocity, schedule.phases);
    return {.pressure = rows.pressure, .penetration = penetration};
}

}  // namespace signorini
