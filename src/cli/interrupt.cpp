#include "interrupt.hpp"

#include <chrono>
#include <ctime>

namespace signorini::cli {

Interrupt::Interrupt()
{
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    waiter_ = std::thread([this] { wait(); });
}

Interrupt::~Interrupt()
{
    isOver_ = true;
    waiter_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    if (first_ > 0 && !isHeard_) {
        (void)std::raise(first_);
    }
}

void Interrupt::wait()
{
    using Clock = std::chrono::steady_clock;
    constexpr timespec pause{0, 20'000'000};  // how long the end of a run may have to wait
    constexpr std::chrono::seconds patience{2};
    constexpr std::chrono::milliseconds same{500};  // some senders tell process and group
    Clock::time_point came;
    while (!isOver_) {
        const int number = sigtimedwait(&signals_, nullptr, &pause);
        const Clock::time_point now = Clock::now();
        if (number > 0 && first_ == 0) {
            first_ = number;
            came = now;
            hasCome_ = true;
        }
        const bool isAgain = number > 0 && now - came > same;
        if (isAgain || (first_ > 0 && !isHeard_ && now - came > patience)) {
            pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
            (void)std::raise(first_);
        }
    }
}

}  // namespace signorini::cli
