#pragma once
/// \file
/// Turns SIGINT and SIGTERM into a request to stop, as long as one of these lives.

#include <csignal>
#include <stop_token>
#include <thread>

namespace signorini::cli {

/// While it lives the two signals are blocked in every thread started later, and a thread of its
/// own waits for them. Afterwards they act as before.
class Interrupt {
public:
    Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
    ~Interrupt();

    /// Stopped when a signal has come.
    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

private:
    sigset_t signals_ = {};
    sigset_t before_ = {};
    std::stop_source source_;
    std::jthread waiter_;
};

}  // namespace signorini::cli
