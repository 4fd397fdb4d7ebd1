#pragma once
/// \file
/// How a long call is stopped, and what every call may throw beside std::invalid_argument (wrong
/// use) and std::bad_alloc. What the mathematics answers is no error: see schedule.hpp.

#include <functional>
#include <stdexcept>
#include <string>

namespace signorini {

/// Asked now and then by a long call, from any thread that works for it: true ends the call. It
/// must not throw. Empty: the call is not to be stopped.
using Cancel = std::function<bool()>;

/// Is the call to end?
[[nodiscard]] inline bool isRequested(const Cancel& cancel)
{
    return cancel && cancel();
}

/// A back end that this build does not contain was asked for, or an outside program is missing.
class BackendUnavailable : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A file could not be read or written; the message names it and the system's reason.
class FileError : public std::runtime_error {
public:
    /// The message is "path: reason".
    FileError(const std::string& path, std::string reason);

    /// Why, without the path: "cannot write: No space left on device".
    [[nodiscard]] const std::string& reason() const { return reason_; }

private:
    std::string reason_;
};

}  // namespace signorini
