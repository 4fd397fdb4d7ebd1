#pragma once
/// \file
/// Polytopes of several contacts in words, in JSON and as a table.

#include <string>
#include <vector>

#include "json.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

/// The outcome of one search.
struct PolytopeListing {
    std::int64_t phases = 2;
    ModeBounds bounds;
    Bar bar;
    std::vector<ModePolytope> polytopes;
    bool isComplete = true;
};

/// "2/1→2 2/2→1": k/turns and release of each chain, contacts counted from 1.
[[nodiscard]] std::string chainsAsText(const std::vector<ModeChain>& chains);

/// Chains, free times, periods, energy and corners.
[[nodiscard]] Json identityAsJson(const ModePolytope& polytope);

[[nodiscard]] std::string asText(const PolytopeListing& listing);
[[nodiscard]] std::string asJson(const PolytopeListing& listing);

/// Motions at the corners of slices, evenly in T: how contact and flight may be shared there.
void writePolytopes(const std::string& path, const PolytopeListing& listing);

}  // namespace signorini::cli
