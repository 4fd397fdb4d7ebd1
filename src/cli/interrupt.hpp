#pragma once
/// \file
/// Turns SIGINT and SIGTERM into a request to stop, as long as one of these lives.

#include <atomic>
#include <csignal>
#include <thread>

#include "signorini/control.hpp"

namespace signorini::cli {

/// While it lives the two signals are blocked in every thread started later, and a thread of its
/// own waits for them. Afterwards they act as before.
class Interrupt {
public:
    Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
    ~Interrupt();

    /// True once a signal has come. \pre this object outlives the call.
    [[nodiscard]] Cancel cancel() const
    {
        return [this] { return hasCome_.load(); };
    }

private:
    sigset_t signals_ = {};
    sigset_t before_ = {};
    std::atomic<bool> hasCome_ = false;
    std::atomic<bool> isOver_ = false;
    std::thread waiter_;
};

}  // namespace signorini::cli
