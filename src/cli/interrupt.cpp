#include "interrupt.hpp"

#include <ctime>

namespace signorini::cli {

Interrupt::Interrupt()
{
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    waiter_ = std::thread([this] {
        constexpr timespec pause{0, 20'000'000};  // how long the end of a run may have to wait
        while (!isOver_) {
            if (sigtimedwait(&signals_, nullptr, &pause) > 0) {
                hasCome_ = true;
            }
        }
    });
}

Interrupt::~Interrupt()
{
    isOver_ = true;
    waiter_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace signorini::cli
