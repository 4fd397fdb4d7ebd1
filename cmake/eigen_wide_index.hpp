#pragma once
/// \file
/// Eigen 3.4 with 64-bit indices where pointers have 32 bits: its check of a matrix's size shifts
/// by more bits than a size has, and refuses every matrix. Included first by SignoriniCore.cmake.

#include <Eigen/Core>
#include <cstddef>
#include <limits>

namespace Eigen::internal {

template <>
inline void check_rows_cols_for_overflow<Dynamic>::run<Index>(Index rows, Index cols)
{
    if (cols != 0 && rows > std::numeric_limits<std::ptrdiff_t>::max() / cols) {
        throw_std_bad_alloc();
    }
}

}  // namespace Eigen::internal
