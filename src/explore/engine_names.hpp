#pragma once
/// \file
/// The names of the engines of continua.

#include "names.hpp"
#include "signorini/continuum.hpp"

namespace signorini {

inline constexpr Named<Engine> engineNames[] = {
    {Engine::automatic, "auto"},
    {Engine::geometric, "geometric"},
    {Engine::ipopt, "ipopt"},
    {Engine::nlopt, "nlopt"},
};

}  // namespace signorini
