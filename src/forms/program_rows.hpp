#pragma once
/// \file
/// The rows of a program of integers, as the exact projection asks for them.

#include <memory>

#include "exact_projection.hpp"
#include "program.hpp"

namespace signorini {

/// Rows and finite bounds. Tags count equalities, then inequalities, then bounds.
class ProgramRows : public RowSource {
public:
    /// Null if a coefficient or a right side is no integer below 2^53. O(entries + rows unknowns).
    [[nodiscard]] static std::unique_ptr<ProgramRows> of(const Program& program);

    [[nodiscard]] std::size_t unknowns() const override { return unknowns_; }

    /// A broken equality, else the inequality broken by most. O(rows unknowns).
    [[nodiscard]] std::optional<ExactRow> violatedRow(const Homogeneous& point) const override;

private:
    std::vector<ExactRow> rows_;
    std::size_t unknowns_ = 0;
};

}  // namespace signorini
