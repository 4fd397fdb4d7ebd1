#pragma once
/// \file
/// The names of sets.

#include "names.hpp"
#include "signorini/amplitude_set.hpp"

namespace signorini {

inline constexpr auto setKindNames = std::to_array<Named<SetKind>>({
    {SetKind::empty, "empty"},
    {SetKind::point, "point"},
    {SetKind::simplex, "simplex"},
    {SetKind::box, "box"},
    {SetKind::polytope, "polytope"},
    {SetKind::cone, "cone"},
});

}  // namespace signorini
