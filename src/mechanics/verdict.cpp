#include "signorini/schedule.hpp"

#include "verdict_names.hpp"

namespace signorini {

std::string_view name(Status status)
{
    return nameIn(statusNames, status);
}

std::string_view name(Reason reason)
{
    return nameIn(reasonNames, reason);
}

std::string_view name(Contact contact)
{
    return nameIn(contactNames, contact);
}

}  // namespace signorini
