#pragma once
/// \file
/// --segments-file: the pieces of a bar as a drawing has them.

#include <string>
#include <vector>

#include "signorini/bar_pieces.hpp"

namespace signorini::cli {

/// Rows of a table with columns length [m], young [Pa], density [kg/m^3], and area [m^2] or
/// diameter [m]; clamp first.
/// \throws FileError, std::invalid_argument naming file, line, column and what is allowed.
[[nodiscard]] std::vector<BarPiece> readPieces(const std::string& path);

}  // namespace signorini::cli
