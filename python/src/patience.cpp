#include "patience.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace signorini::python {

namespace {

constexpr std::chrono::milliseconds look{10};
constexpr std::chrono::milliseconds grace{40};

/// What both threads see.
struct Shared {
    std::atomic<bool> isCancelled = false;
    std::mutex mutex;
    std::condition_variable changed;
    bool isOver = false;
    bool hasNews = false;
    double done = 0.0;
    double total = 0.0;
    std::exception_ptr trouble;
};

void work(const std::shared_ptr<Shared>& shared, const std::function<void(const Wires&)>& job)
{
    const Wires wires{[shared] { return shared->isCancelled.load(std::memory_order_relaxed); },
                      [shared](double done, double total) {
                          const std::lock_guard lock(shared->mutex);
                          shared->hasNews = true;
                          shared->done = done;
                          shared->total = total;
                      }};
    std::exception_ptr trouble;
    try {
        job(wires);
    } catch (...) {
        trouble = std::current_exception();
    }
    {
        const std::lock_guard lock(shared->mutex);
        shared->trouble = trouble;
        shared->isOver = true;
    }
    shared->changed.notify_all();
}

/// Waits, without Python's lock. \returns whether the work is over.
bool wait(Shared& shared, std::chrono::milliseconds time)
{
    const py::gil_scoped_release release;
    std::unique_lock lock(shared.mutex);
    return shared.changed.wait_for(lock, time, [&shared] { return shared.isOver; });
}

/// Signals and news. \throws py::error_already_set.
void listen(Shared& shared, const py::object& progress)
{
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
    double done = 0.0;
    double total = 0.0;
    {
        const std::lock_guard lock(shared.mutex);
        if (!std::exchange(shared.hasNews, false)) {
            return;
        }
        done = shared.done;
        total = shared.total;
    }
    if (!progress.is_none()) {
        progress(done, total);
    }
}

}  // namespace

void runPatiently(std::function<void(const Wires&)> job, const py::object& progress, bool canBeLeft)
{
    const auto shared = std::make_shared<Shared>();
    std::thread worker([shared, job = std::move(job)]() mutable {
        work(shared, job);
        job = nullptr;  // what it owns goes before the thread does
    });
    try {
        while (!wait(*shared, look)) {
            listen(*shared, progress);
        }
        listen(*shared, progress);
    } catch (py::error_already_set&) {
        shared->isCancelled = true;
        if (wait(*shared, grace) || !canBeLeft) {
            const py::gil_scoped_release release;
            worker.join();
        } else {
            worker.detach();
        }
        throw;
    }
    worker.join();
    if (shared->trouble) {
        std::rethrow_exception(shared->trouble);
    }
}

}  // namespace signorini::python
