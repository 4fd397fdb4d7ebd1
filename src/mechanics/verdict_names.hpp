#pragma once
/// \file
/// The names of verdicts.

#include "names.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

inline constexpr auto statusNames = std::to_array<Named<Status>>({
    {Status::found, "found"},
    {Status::none, "none"},
    {Status::undecided, "undecided"},
});

inline constexpr auto reasonNames = std::to_array<Named<Reason>>({
    {Reason::noLiveClass, "no-live-class"},
    {Reason::contactSign, "contact-sign"},
    {Reason::penetration, "penetration"},
    {Reason::gap, "gap"},
    {Reason::constraints, "constraints"},
});

inline constexpr auto stopNames = std::to_array<Named<Stop>>({
    {Stop::right, "right"},
    {Stop::left, "left"},
});

inline constexpr auto contactNames = std::to_array<Named<Contact>>({
    {Contact::pressing, "pressing"},
    {Contact::grazing, "grazing"},
});

}  // namespace signorini
