#pragma once
/// \file
/// continuum of several bars, of segments and of a bar under gravity.

#include <optional>

#include "arguments.hpp"
#include "given.hpp"

namespace signorini::cli {

/// Bars in a row, if that is what is meant: a scene that is more than a uniform bar with stops, or
/// is asked about by sets of contacts, or segments. \throws std::invalid_argument, FileError.
[[nodiscard]] std::optional<Assembly> barsOf(const Given& given, const CommonOptions& common);

[[nodiscard]] ExitStatus continuumInBars(const Given& given, const CommonOptions& common,
                                         const Assembly& assembly);

}  // namespace signorini::cli
