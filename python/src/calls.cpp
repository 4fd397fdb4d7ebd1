#include "calls.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <utility>

#include "excited_amplitude.hpp"
#include "scene_harmonic_answer.hpp"
#include "share_work.hpp"

namespace signorini::python {

PyObject* Asked::keyOf(const char* name)
{
    static std::unordered_map<const char*, PyObject*> keys;
    PyObject*& key = keys[name];
    if (key == nullptr) {
        key = PyUnicode_InternFromString(name);
    }
    return key;
}

void Asked::refuseKind(const char* name, const char* kind) const
{
    if (std::string_view(kind).starts_with("int") && PyIndex_Check(object(name).ptr()) != 0) {
        throwFault(name, shortened(py::cast<std::string>(py::repr(object(name)))),
                   "whole numbers of at most 64 bits");
    }
    const py::object shown = py::module_::import("reprlib").attr("repr")(object(name));
    throw py::type_error(
        fmt::format("{} = {}: allowed {}", name, py::cast<std::string>(shown), kind));
}

void Asked::requireFits(const char* name, double value) const
{
    if (std::string_view(name) == "amplitude" && !(std::isfinite(value) && value > 0.0)) {
        throwFault(name, value, fmt::format("finite numbers > 0 [{}]", unitOf(name)));
    }
    static std::unordered_map<const char*, std::vector<const Option*>> known;
    const auto [rows, isNew] = known.try_emplace(name);
    if (isNew) {
        rows->second = optionsNamed(name);
        std::erase_if(rows->second, [](const Option* row) {
            return row->takes != Takes::whole && row->takes != Takes::positive &&
                   row->takes != Takes::range && row->takes != Takes::real;
        });
    }
    const auto fits = [value](const Option* row) { return row->fits(value); };
    if (!rows->second.empty() && std::none_of(rows->second.begin(), rows->second.end(), fits)) {
        throwFault(name, value, rows->second.front()->allowed());
    }
}

double Asked::frequency(const char* name, const Bar& bar) const
{
    const py::object held = object(name);
    const bool isHertz =
        py::isinstance<py::str>(held) && py::cast<std::string>(held).ends_with("Hz");
    return isHertz ? inUnit(name, "Hz") * 4.0 * scales(bar).time : inUnit(name, "omega_1");
}

double Asked::inUnit(const char* name, const char* unit) const
{
    const py::object held = object(name);
    return py::isinstance<py::str>(held) ? quantityOf(name, py::cast<std::string>(held), unit)
                                         : get<double>(name);
}

std::string Asked::unitOf(const char* name) const
{
    if (std::string_view(name) == "amplitude") {
        return amplitudeUnitName(place(), maybe<int>("derivative").value_or(0));
    }
    return unitOfOption(name);
}

Assembly assemblyIn(const std::string& words, const Bar& bar, double gravity)
{
    const Assembly assembly{.parts = partsOf(words),
                            .length = bar.length,
                            .waveSpeed = bar.waveSpeed,
                            .axialStiffness = bar.axialStiffness,
                            .gravity = gravity,
                            .young = bar.young};
    validate(assembly);
    return assembly;
}

Assembly Asked::assembly() const
{
    return assemblyIn(get<std::string>("words"), scene().bar, get<double>("gravity"));
}

std::int64_t Asked::steps(const Assembly& assembly, std::int64_t cycles) const
{
    return stepsOf(assembly,
                   {maybe<double>("period"), maybe<double>("frequency"), maybe<double>("hertz")},
                   cycles);
}

std::optional<double> Asked::energyRatio(const Bar& bar) const
{
    const auto energy = maybe<double>("energy");
    if (!energy) {
        return maybe<double>("energy_ratio");
    }
    const double ratio = *energy / scales(bar).energy;
    if (!std::isfinite(ratio)) {
        throwFault("energy", *energy, "what is finite in E_1");
    }
    return ratio;
}

Schedule Asked::schedule() const
{
    const py::object held = object("schedule");
    return py::isinstance<py::list>(held) ? scheduleOf(held, maybe<std::int64_t>("cells"))
                                          : py::cast<Schedule>(held);
}

std::optional<double> Asked::displacement(double frequencyRatio, const Bar& bar) const
{
    const auto amplitude = maybe<double>("amplitude");
    const auto derivative = get<int>("derivative");
    const double hertz = frequencyRatio * (0.25 / scales(bar).time);
    return amplitude && derivative > 0 ? displacementAt(hertz, *amplitude, derivative) : amplitude;
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

void runPatiently(const py::object& progress, std::function<void(const Wires&)> job, bool canBeLeft)
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
