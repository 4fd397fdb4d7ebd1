#include "signorini/control.hpp"

#include <utility>

namespace signorini {

FileError::FileError(const std::string& path, std::string reason)
    : std::runtime_error(path + ": " + reason), reason_(std::move(reason))
{
}

}  // namespace signorini
