#pragma once
/// \file
/// Where figures come from: without it they mean nothing on another machine.

#include <string>

#include "runner.hpp"
#include "suites.hpp"

namespace signorini::bench {

/// "name: value" lines: version, commit, compiler, flags, machine, libraries, limits.
[[nodiscard]] std::string provenanceText(Extent extent, const Limits& limits);

/// Eight hexadecimal digits that change with the text.
[[nodiscard]] std::string provenanceId(const std::string& text);

}  // namespace signorini::bench
