#pragma once
/// \file
/// signorini response of bars in a row, or of a bar of several segments under the harmonic itself.

#include "arguments.hpp"
#include "force_options.hpp"
#include "given.hpp"

namespace signorini::cli {

/// The words of the bars say what is driven, shaken and damped.
[[nodiscard]] ExitStatus respondInBars(const Given& given, const CommonOptions& common,
                                       const ForceOptions& force, const Assembly& assembly);

}  // namespace signorini::cli
