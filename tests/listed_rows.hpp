#pragma once
/// \file
/// The rows of a polyhedron as a list, for tests that give them one by one.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "exact_projection.hpp"

namespace signorini::test {

/// Rows in a list.
class ListedRows : public RowSource {
public:
    ListedRows(std::size_t unknowns, std::vector<ExactRow> rows)
        : unknowns_(unknowns), rows_(std::move(rows))
    {
    }

    [[nodiscard]] std::size_t unknowns() const override { return unknowns_; }

    [[nodiscard]] std::optional<ExactRow> violatedRow(const Homogeneous& point) const override
    {
        for (const ExactRow& row : rows_) {
            Integer value = -row.rhs * point.denominator;
            for (std::size_t i = 0; i < unknowns_; ++i) {
                value += row.coefficients[i] * point.numerators[i];
            }
            if (value < 0 || (row.isEquality && value != 0)) {
                return row;
            }
        }
        return std::nullopt;
    }

private:
    std::size_t unknowns_;
    std::vector<ExactRow> rows_;
};

}  // namespace signorini::test
