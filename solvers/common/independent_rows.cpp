#include "common/independent_rows.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>

#include "common/modular.hpp"

namespace signorini {

namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Index = Eigen::Index;

std::size_t at(Index index)
{
    return static_cast<std::size_t>(index);
}

template <typename Visit>
void forEachEntry(const Matrix& matrix, Index row, Visit visit)
{
    for (Matrix::InnerIterator entry(matrix, row); entry; ++entry) {
        if (entry.value() != 0.0) {
            visit(static_cast<Index>(entry.col()), entry.value());
        }
    }
}

/// Takes rows out of the matrix one by one and knows the columns that only one remaining row has.
class Peeling {
public:
    explicit Peeling(const Matrix& matrix)
        : matrix_(matrix),
          present_(at(matrix.rows()), true),
          count_(at(matrix.cols()), 0),
          rowSum_(at(matrix.cols()), 0)
    {
        for (Index row = 0; row < matrix.rows(); ++row) {
            forEachEntry(matrix, row, [&](Index column, double) {
                ++count_[at(column)];
                rowSum_[at(column)] += row;
            });
        }
        for (Index column = 0; column < matrix.cols(); ++column) {
            noteIfSingle(column);
        }
    }

    [[nodiscard]] bool isPresent(Index row) const { return present_[at(row)]; }

    void remove(Index row)
    {
        present_[at(row)] = false;
        forEachEntry(matrix_, row, [&](Index column, double) {
            --count_[at(column)];
            rowSum_[at(column)] -= row;
            noteIfSingle(column);
        });
    }

    /// Removes every row that has a column for itself, again and again.
    void peel(IndependentRows& found)
    {
        while (!single_.empty()) {
            const Index column = single_.back();
            single_.pop_back();
            if (count_[at(column)] == 1) {
                const Index row = rowSum_[at(column)];  // the sum over one row
                found.rows.push_back(row);
                found.pivots.push_back(column);
                remove(row);
            }
        }
    }

private:
    void noteIfSingle(Index column)
    {
        if (count_[at(column)] == 1) {
            single_.push_back(column);
        }
    }

    const Matrix& matrix_;
    std::vector<bool> present_;
    std::vector<Index> count_;   ///< of the remaining rows that have this column
    std::vector<Index> rowSum_;  ///< of their numbers
    std::vector<Index> single_;
};

std::vector<Index> rowsByLength(const Matrix& matrix)
{
    std::vector<Index> order(at(matrix.rows()));
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
        return matrix.innerVector(a).nonZeros() > matrix.innerVector(b).nonZeros();
    });
    return order;
}

/// Reduces rows by the pivots found so far. A pivot row holds its own pivot and later ones, never
/// an earlier one, so eliminating in order of discovery ends.
class Elimination {
public:
    Elimination(const Matrix& matrix, IndependentRows& found)
        : matrix_(matrix),
          found_(found),
          rankOf_(at(matrix.cols()), none),
          firstReduced_(found.rows.size()),
          row_(at(matrix.cols()))
    {
        for (std::size_t rank = 0; rank < found.pivots.size(); ++rank) {
            rankOf_[at(found.pivots[rank])] = static_cast<Index>(rank);
        }
    }

    /// Adds the row to `found` if something is left of it.
    void add(Index row)
    {
        forEachEntry(matrix_, row,
                     [&](Index column, double value) { subtract(column, Modular(-value)); });
        while (!waiting_.empty()) {
            const Index rank = waiting_.top();
            waiting_.pop();
            eliminate(at(rank));
        }
        keepWhatIsLeft(row);
    }

private:
    static constexpr Index none = -1;

    struct Entry {
        Index column;
        Modular value;
    };

    void subtract(Index column, Modular value)
    {
        Modular& entry = row_[at(column)];
        if (entry.isZero()) {
            touched_.push_back(column);
            if (rankOf_[at(column)] != none) {
                waiting_.push(rankOf_[at(column)]);
            }
        }
        entry = entry - value;
    }

    void eliminate(std::size_t rank)
    {
        const Index pivot = found_.pivots[rank];
        const Modular factor = row_[at(pivot)];
        if (factor.isZero()) {
            return;
        }
        if (rank >= firstReduced_) {
            for (const Entry& entry : reduced_[rank - firstReduced_]) {
                subtract(entry.column, factor * entry.value);
            }
            return;
        }
        const Index source = found_.rows[rank];
        const Modular scale = factor * Modular(matrix_.coeff(source, pivot)).inverse();
        forEachEntry(matrix_, source,
                     [&](Index column, double value) { subtract(column, scale * Modular(value)); });
    }

    void keepWhatIsLeft(Index row)
    {
        std::vector<Entry> left;
        for (const Index column : touched_) {
            Modular& value = row_[at(column)];
            if (!value.isZero()) {
                left.push_back({column, value});
                value = Modular();
            }
        }
        touched_.clear();
        if (left.empty()) {
            return;
        }
        const Modular scale = left.front().value.inverse();
        for (Entry& entry : left) {
            entry.value = entry.value * scale;
        }
        rankOf_[at(left.front().column)] = static_cast<Index>(found_.rows.size());
        found_.rows.push_back(row);
        found_.pivots.push_back(left.front().column);
        reduced_.push_back(std::move(left));
    }

    const Matrix& matrix_;
    IndependentRows& found_;
    std::vector<Index> rankOf_;   ///< position in `found`, by column
    std::size_t firstReduced_;    ///< earlier ranks are peeled: rows of the matrix as they stand
    std::vector<Modular> row_;    ///< the row at work, zero between calls
    std::vector<Index> touched_;  ///< its columns, some more than once
    std::vector<std::vector<Entry>> reduced_;
    std::priority_queue<Index, std::vector<Index>, std::greater<>> waiting_;
};

}  // namespace

IndependentRows independentRows(const Matrix& matrix)
{
    IndependentRows found;
    Peeling peeling(matrix);
    std::vector<Index> torn;
    peeling.peel(found);
    for (const Index row : rowsByLength(matrix)) {
        if (peeling.isPresent(row)) {
            torn.push_back(row);
            peeling.remove(row);
            peeling.peel(found);
        }
    }
    Elimination elimination(matrix, found);
    for (const Index row : torn) {
        elimination.add(row);
    }
    return found;
}

}  // namespace signorini
