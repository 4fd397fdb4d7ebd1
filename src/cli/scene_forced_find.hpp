#pragma once
/// \file
/// signorini find --scene ... SET:STEPS ... --force tip|base [--amplitude A]: forced motions of any
/// bars.

#include "arguments.hpp"

namespace signorini::cli {

struct FindCommand;

/// The motions of one amplitude if it is given, at most two, else the one of least amplitude, or a
/// proof that there is none; as for one bar (forced_find.hpp). `driven` and `shaken` are words of
/// the scene, its dashpots its damping.
[[nodiscard]] ExitStatus findForcedInScene(const FindCommand& command);

}  // namespace signorini::cli
