#include "signorini/verdict.hpp"

#include <stdexcept>

namespace signorini {

std::string_view name(Status status)
{
    switch (status) {
        case Status::found:
            return "found";
        case Status::none:
            return "none";
        case Status::undecided:
            return "undecided";
    }
    throw std::logic_error("unnamed Status");
}

std::string_view name(Reason reason)
{
    switch (reason) {
        case Reason::noLiveClass:
            return "no-live-class";
        case Reason::contactSign:
            return "contact-sign";
        case Reason::penetration:
            return "penetration";
        case Reason::gap:
            return "gap";
        case Reason::constraints:
            return "constraints";
    }
    throw std::logic_error("unnamed Reason");
}

std::string_view name(Contact contact)
{
    switch (contact) {
        case Contact::pressing:
            return "pressing";
        case Contact::grazing:
            return "grazing";
    }
    throw std::logic_error("unnamed Contact");
}

}  // namespace signorini
