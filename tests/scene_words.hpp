#pragma once
/// \file
/// Networks by their words, for tests.

#include <string>

#include "network.hpp"
#include "signorini/assembly.hpp"

inline signorini::Network sceneOf(const std::string& words)
{
    return networkOf(signorini::Assembly{.parts = signorini::partsOf(words)});
}
