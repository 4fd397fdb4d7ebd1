#pragma once
/// \file
/// The names of verdicts.

#include "names.hpp"
#include "signorini/verdict.hpp"

namespace signorini {

inline constexpr Named<Status> statusNames[] = {
    {Status::found, "found"},
    {Status::none, "none"},
    {Status::undecided, "undecided"},
};

inline constexpr Named<Reason> reasonNames[] = {
    {Reason::noLiveClass, "no-live-class"}, {Reason::contactSign, "contact-sign"},
    {Reason::penetration, "penetration"},   {Reason::gap, "gap"},
    {Reason::constraints, "constraints"},
};

inline constexpr Named<Contact> contactNames[] = {
    {Contact::pressing, "pressing"},
    {Contact::grazing, "grazing"},
};

}  // namespace signorini
