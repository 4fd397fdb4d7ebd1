#pragma once
/// \file
/// The names of sets.

#include "names.hpp"
#include "signorini/amplitude_set.hpp"

namespace signorini {

inline constexpr Named<SetKind> setKindNames[] = {
    {SetKind::empty, "empty"}, {SetKind::point, "point"},       {SetKind::simplex, "simplex"},
    {SetKind::box, "box"},     {SetKind::polytope, "polytope"},
};

}  // namespace signorini
