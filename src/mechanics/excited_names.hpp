#pragma once
/// \file
/// The names of what is excited.

#include "names.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

inline constexpr auto excitedNames = std::to_array<Named<Excited>>({
    {Excited::tip, "tip"},
    {Excited::base, "base"},
});

}  // namespace signorini
