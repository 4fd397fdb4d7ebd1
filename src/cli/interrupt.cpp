#include "interrupt.hpp"

#include <ctime>

namespace signorini::cli {

Interrupt::Interrupt()
{
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    waiter_ = std::jthread([this](const std::stop_token& done) {
        constexpr timespec pause{0, 20'000'000};  // how long the end of a run may have to wait
        while (!done.stop_requested()) {
            if (sigtimedwait(&signals_, nullptr, &pause) > 0) {
                source_.request_stop();
            }
        }
    });
}

Interrupt::~Interrupt()
{
    waiter_.request_stop();
    waiter_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace signorini::cli
