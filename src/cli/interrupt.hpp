#pragma once
/// \file
/// Turns SIGINT and SIGTERM into a request to stop, as long as one of these lives.

#include <atomic>
#include <csignal>
#include <thread>

#include "signorini/control.hpp"

namespace signorini::cli {

/// While it lives the two signals are blocked in every thread started later, and a thread of its
/// own waits for them. Work that does not ask soon whether it is to stop cannot be stopped: then,
/// at the end of the work, or when a second signal comes, the signal acts as it does without this.
class Interrupt {
public:
    Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
    ~Interrupt();

    /// True once a signal has come. \pre this object outlives the call.
    [[nodiscard]] Cancel cancel() const
    {
        return [this] {
            isHeard_ = hasCome_.load();
            return isHeard_.load();
        };
    }

private:
    void wait();

    sigset_t signals_ = {};
    sigset_t before_ = {};
    std::atomic<bool> hasCome_ = false;
    mutable std::atomic<bool> isHeard_ = false;  ///< the work was told so
    std::atomic<bool> isOver_ = false;
    int first_ = 0;  ///< the signal that came; the waiter's until it has ended
    std::thread waiter_;
};

}  // namespace signorini::cli
