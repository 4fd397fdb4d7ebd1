#pragma once
/// \file
/// The commands. Each does the work of one call; the report goes to standard output. SIGINT and
/// SIGTERM end a search, and what was found by then is reported, in no file. Exceptions are for
/// `main` to translate.

#include "arguments.hpp"

namespace signorini::cli {

[[nodiscard]] ExitStatus runFind(const Given& given);
[[nodiscard]] ExitStatus runContinuum(const Given& given);
[[nodiscard]] ExitStatus runModes(const Given& given);
[[nodiscard]] ExitStatus runMode(const Given& given);
[[nodiscard]] ExitStatus runFamilies(const Given& given);
[[nodiscard]] ExitStatus runAtlas(const Given& given);
[[nodiscard]] ExitStatus runResponse(const Given& given);
/// The same of bars in a row, whose words say what is driven, shaken and damped, or of a bar of
/// several segments under the harmonic itself.
[[nodiscard]] ExitStatus respondInBars(const Given& given, const CommonOptions& common,
                                       const ForceOptions& force, const Assembly& assembly);
[[nodiscard]] ExitStatus runSimulate(const Given& given);
[[nodiscard]] ExitStatus runSweep(const Given& given);
[[nodiscard]] ExitStatus runStudy(const Given& given);
[[nodiscard]] ExitStatus runScene(const Given& given);

}  // namespace signorini::cli
