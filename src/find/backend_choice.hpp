#pragma once
/// \file
/// Which back end a request gets; the table of back ends (solver.hpp) knows their order.

#include <memory>
#include <string>
#include <string_view>

#include "solver.hpp"

namespace signorini {

/// `FindOptions::solver` for the cheapest route, and for the exact sets without any program.
inline constexpr std::string_view automaticChoice = "auto";
inline constexpr std::string_view closedForm = "closed-form";

/// \throws std::invalid_argument for an unknown name, BackendUnavailable for one that is not in
/// this build.
void requireBackend(std::string_view solver);

/// `solver`, or if that is "auto" the first suited to the program that this build contains.
/// \throws BackendUnavailable if there is none.
[[nodiscard]] std::string backendFor(const Program& program, const std::string& solver);

/// A back end for linear programs that returns duals; null if this build has none.
[[nodiscard]] std::unique_ptr<Solver> simplexWithDuals();

}  // namespace signorini
