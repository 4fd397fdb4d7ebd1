#pragma once
/// \file
/// The rows of a program, put together one at a time.

#include <utility>
#include <vector>

#include "program.hpp"

namespace signorini {

/// Collects rows and right sides.
class RowList {
public:
    using Entry = std::pair<Eigen::Index, double>;

    RowList() = default;
    /// Begins with these.
    RowList(const SparseRows& matrix, const Eigen::VectorXd& rhs) : rhs_(rhs.begin(), rhs.end())
    {
        for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
            for (SparseRows::InnerIterator entry(matrix, row); entry; ++entry) {
                entries_.emplace_back(static_cast<int>(row), static_cast<int>(entry.col()),
                                      entry.value());
            }
        }
    }

    void add(const std::vector<Entry>& row, double rhs)
    {
        const auto k = static_cast<int>(rhs_.size());
        for (const auto& [column, value] : row) {
            entries_.emplace_back(k, static_cast<int>(column), value);
        }
        rhs_.push_back(rhs);
    }

    void moveTo(SparseRows& matrix, Eigen::VectorXd& rhs, Eigen::Index columns)
    {
        matrix.resize(static_cast<Eigen::Index>(rhs_.size()), columns);
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        rhs =
            Eigen::Map<const Eigen::VectorXd>(rhs_.data(), static_cast<Eigen::Index>(rhs_.size()));
    }

private:
    std::vector<Eigen::Triplet<double>> entries_;
    std::vector<double> rhs_;
};

using Row = std::vector<RowList::Entry>;

}  // namespace signorini
