#include "patience.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

namespace signorini::python {

namespace {

constexpr std::chrono::milliseconds look{10};
constexpr std::chrono::milliseconds grace{40};

/// What both threads see.
struct Shared {
    std::atomic<bool> isCancelled = false;
    std::mutex mutex;
    std::optional<std::pair<double, double>> news = {};  ///< done, total
};

/// Waits, without Python's lock. \returns whether the work is over.
bool wait(const std::future<void>& work, std::chrono::milliseconds time)
{
    const py::gil_scoped_release release;
    return work.wait_for(time) == std::future_status::ready;
}

/// Signals and news. \throws py::error_already_set.
void listen(Shared& shared, const py::object& progress)
{
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
    std::optional<std::pair<double, double>> news;
    {
        const std::lock_guard lock(shared.mutex);
        news = std::exchange(shared.news, {});
    }
    if (news && !progress.is_none()) {
        progress(news->first, news->second);
    }
}

}  // namespace

void runPatiently(std::function<void(const Wires&)> job, const py::object& progress, bool canBeLeft)
{
    const auto shared = std::make_shared<Shared>();
    const Wires wires{[shared] { return shared->isCancelled.load(std::memory_order_relaxed); },
                      [shared](double done, double total) {
                          const std::lock_guard lock(shared->mutex);
                          shared->news = {done, total};
                      }};
    std::packaged_task<void()> task([wires, job = std::move(job)] { job(wires); });
    std::future<void> work = task.get_future();
    std::thread worker(std::move(task));
    try {
        while (!wait(work, look)) {
            listen(*shared, progress);
        }
        listen(*shared, progress);
    } catch (py::error_already_set&) {
        shared->isCancelled = true;
        if (wait(work, grace) || !canBeLeft) {
            const py::gil_scoped_release release;
            worker.join();
        } else {
            worker.detach();
        }
        throw;
    }
    worker.join();
    work.get();
}

}  // namespace signorini::python
