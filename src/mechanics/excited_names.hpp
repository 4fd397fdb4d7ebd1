#pragma once
/// \file
/// The names of what is excited.

#include "names.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

inline constexpr Named<Excited> excitedNames[] = {
    {Excited::tip, "tip"},
    {Excited::base, "base"},
};

}  // namespace signorini
