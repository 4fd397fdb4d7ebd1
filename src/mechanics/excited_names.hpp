#pragma once
/// \file
/// The names of what is excited, of what is varied, and which way.

#include "names.hpp"
#include "signorini/sweep.hpp"

namespace signorini {

inline constexpr auto excitedNames = std::to_array<Named<Excited>>({
    {Excited::tip, "tip"},
    {Excited::base, "base"},
});

inline constexpr auto sweptNames = std::to_array<Named<Swept>>({
    {Swept::frequency, "frequency"},
    {Swept::amplitude, "amplitude"},
    {Swept::gap, "gap"},
    {Swept::damping, "damping"},
});

inline constexpr auto sweepDirections = std::to_array<Named<SweepDirection>>({
    {SweepDirection::up, "up"},
    {SweepDirection::down, "down"},
});

}  // namespace signorini
