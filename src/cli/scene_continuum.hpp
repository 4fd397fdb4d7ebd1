#pragma once
/// \file
/// continuum of several bars, of segments and of a bar under gravity.

#include <optional>

#include "arguments.hpp"
#include "engine_names.hpp"
#include "given.hpp"

namespace signorini::cli {

/// Bars in a row, if that is what is meant: a scene that is more than a uniform bar with stops, or
/// is asked about by sets of contacts, or segments. \throws std::invalid_argument, FileError.
[[nodiscard]] std::optional<Assembly> barsOf(const Given& given, const CommonOptions& common);

[[nodiscard]] ExitStatus continuumInBars(const Given& given, const CommonOptions& common,
                                         const Assembly& assembly);

/// How a curve is traced, of any bars. \throws std::invalid_argument
void readCurve(const Given& given, auto& options)
{
    options.points = given.whole("--points").value_or(options.points);
    if (given.has("--engine")) {
        options.solver = solverOfEngine(given.text("--engine"), "--engine");
    }
    options.resolution = given.number("--resolution").value_or(options.resolution);
    options.tolerance = given.number("--tolerance").value_or(options.tolerance);
}

/// \throws std::invalid_argument unless one of them is given.
void requireEnergy(const std::optional<double>& energy, const std::optional<double>& energyRatio);

}  // namespace signorini::cli
