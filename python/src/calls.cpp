#include "calls.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace signorini::python {

std::string nameOf(std::string_view option)
{
    std::string name(option == "--from" ? "start" : option);
    name.erase(0, name.starts_with("--") ? 2 : 0);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

PyObject* Asked::keyOf(std::string_view name)
{
    static std::map<std::string, PyObject*, std::less<>> keys;
    auto known = keys.find(name);
    if (known == keys.end()) {
        known = keys.emplace(name, PyUnicode_InternFromString(nameOf(name).c_str())).first;
    }
    return known->second;
}

void Asked::refuseKind(std::string_view name, const char* kind) const
{
    if (std::string_view(kind).starts_with("int") && PyIndex_Check(object(name).ptr()) != 0) {
        throwFault(name, shortened(py::cast<std::string>(py::repr(object(name)))),
                   "whole numbers of at most 64 bits");
    }
    const py::object shown = py::module_::import("reprlib").attr("repr")(object(name));
    throw py::type_error(
        fmt::format("{} = {}: allowed {}", nameOf(name), py::cast<std::string>(shown), kind));
}

void Asked::requireFits(std::string_view name, double value) const
{
    const Option* wrong = nullptr;
    for (const Option* row : optionsNamed(name)) {
        if (row->takes == Takes::whole || row->takes == Takes::positive ||
            row->takes == Takes::range || row->takes == Takes::real) {
            if (row->fits(value)) {
                return;
            }
            wrong = wrong == nullptr ? row : wrong;
        }
    }
    if (wrong != nullptr) {
        throwFault(name, value, wrong->allowed());
    }
}

bool Asked::has(std::string_view name) const
{
    const auto& rows = optionsNamed(name);
    const bool isFlag = !rows.empty() && rows.front()->takes == Takes::nothing;
    return isFlag ? maybe<bool>(name).value_or(false) : !object(name).is_none();
}

std::string Asked::text(std::string_view option) const
{
    const py::object held = object(option);
    const auto& rows = optionsNamed(option);
    const bool isNumber = std::any_of(rows.begin(), rows.end(), [](const Option* row) {
        return row->takes != Takes::choice && (row->takes != Takes::text || row->unit != "-");
    });
    return held.is_none()                               ? ""
           : !isNumber || py::isinstance<py::str>(held) ? get<std::string>(option)
                                                        : fmt::format("{}", get<double>(option));
}

std::optional<double> Asked::number(std::string_view option) const
{
    const auto value = maybe<double>(option);
    warnIf(option == "--damping" && value > likelyPercent,
           "damping above 1: percent are \"5%\" or 0.05");
    return value;
}

Assembly Asked::assembly() const
{
    return assemblyIn(get<std::string>("words"), scene().bar, get<double>("gravity"));
}

Schedule Asked::schedule() const
{
    const py::object held = object("schedule");
    return py::isinstance<py::list>(held) ? scheduleOf(held, maybe<std::int64_t>("cells"))
                                          : py::cast<Schedule>(held);
}

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

void runPatiently(const py::object& progress, std::function<void(const Watch&)> job, bool canBeLeft)
{
    const auto shared = std::make_shared<Shared>();
    const Watch watch{[shared] { return shared->isCancelled.load(std::memory_order_relaxed); },
                      [shared](double done, double total) {
                          const std::lock_guard lock(shared->mutex);
                          shared->news = {done, total};
                      }};
    std::packaged_task<void()> task([watch, job = std::move(job)] { job(watch); });
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
