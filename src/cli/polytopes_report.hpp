#pragma once
/// \file
/// Polytopes of several contacts in words and as a table.

#include <string>
#include <vector>

#include "modes_answer.hpp"

namespace signorini::cli {

/// "2/1→2 2/2→1": k/turns and release of each chain, contacts counted from 1.
[[nodiscard]] std::string chainsAsText(const std::vector<ModeChain>& chains);

[[nodiscard]] std::string asText(const answers::PolytopeList& listing);

/// Motions at the corners of slices, evenly in T: how contact and flight may be shared there.
void writePolytopes(const std::string& path, const answers::PolytopeList& listing);

}  // namespace signorini::cli
