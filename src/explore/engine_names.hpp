#pragma once
/// \file
/// Who traces a continuum, in the words of the front ends.

#include <string>
#include <string_view>

namespace signorini {

/// The solver of an engine: auto, geometric, ipopt, nlopt, or a back end by its name.
/// \throws std::invalid_argument for another word, naming it `argument`.
[[nodiscard]] std::string solverOfEngine(std::string_view engine,
                                         std::string_view argument = "engine");

/// The engine of a curve's solver.
[[nodiscard]] std::string engineOf(const std::string& solver);

}  // namespace signorini
