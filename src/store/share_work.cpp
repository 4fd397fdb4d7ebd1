#include "share_work.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace signorini {

void shareWork(std::size_t count, std::int64_t threads,
               const std::function<bool(std::size_t)>& serve,
               const std::function<void(double done, double total)>& show)
{
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> isOver = false;
    std::size_t done = 0;
    std::exception_ptr trouble;
    std::mutex mutex;
    const auto work = [&] {
        try {
            for (std::size_t k = next++; k < count && !isOver; k = next++) {
                if (!serve(count - 1 - k)) {
                    isOver = true;
                    return;
                }
                const std::lock_guard lock(mutex);
                ++done;
                if (show) {
                    show(static_cast<double>(done), static_cast<double>(count));
                }
            }
        } catch (...) {
            isOver = true;
            const std::lock_guard lock(mutex);
            trouble = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    for (std::int64_t k = 1; k < std::min(threads, static_cast<std::int64_t>(count)); ++k) {
        others.emplace_back(work);
    }
    work();
    for (std::thread& other : others) {
        other.join();
    }
    if (trouble) {
        std::rethrow_exception(trouble);
    }
}

}  // namespace signorini
