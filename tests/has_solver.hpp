#pragma once
/// \file
/// Whether this build has a solver that a test needs.

#include <string_view>

#include "solver.hpp"

namespace signorini::test {

inline bool hasSolver(std::string_view name)
{
    return findBackend(name).available();
}

/// One whose duals prove that a program has no solution.
inline bool hasSimplex()
{
    return preferred({.duals = true}) != nullptr;
}

}  // namespace signorini::test
