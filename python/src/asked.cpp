#include "asked.hpp"

#include <pybind11/stl.h>

#include <limits>
#include <unordered_map>

#include "excited_amplitude.hpp"
#include "excited_names.hpp"
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
        Faults faults;
        faults.add(name, shortened(py::cast<std::string>(py::repr(object(name)))),
                   "whole numbers of at most 64 bits");
        faults.throwIfAny();
    }
    const py::object shown = py::module_::import("reprlib").attr("repr")(object(name));
    throw py::type_error(
        fmt::format("{} = {}: allowed {}", name, py::cast<std::string>(shown), kind));
}

std::optional<double> Asked::positive(const char* name, const char* unit) const
{
    const auto value = maybe<double>(name);
    Faults faults;
    if (value) {
        faults.requirePositive(name, *value, unit);
    }
    faults.throwIfAny();
    return value;
}

double Asked::frequency(const char* name, const Bar& bar) const
{
    const py::object held = object(name);
    if (py::isinstance<py::str>(held)) {
        const auto text = py::cast<std::string>(held);
        return text.ends_with("Hz") ? quantityOf(name, text, "Hz") * 4.0 * scales(bar).time
                                    : quantityOf(name, text, "omega_1");
    }
    return get<double>(name);
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

Assembly Asked::assembly() const
{
    const Bar bar = scene().bar;
    const Assembly assembly{.parts = partsOf(get<std::string>("words")),
                            .length = bar.length,
                            .waveSpeed = bar.waveSpeed,
                            .axialStiffness = bar.axialStiffness,
                            .gravity = get<double>("gravity"),
                            .young = bar.young};
    validate(assembly);
    return assembly;
}

Schedule Asked::schedule() const
{
    return scheduleOf(py::cast<py::tuple>(object("schedule")), maybe<std::int64_t>("cells"));
}

std::int64_t Asked::threads() const
{
    const auto threads = get<std::int64_t>("threads");
    Faults faults;
    faults.requireWhole("threads", threads, maxThreads);
    faults.throwIfAny();
    return threads;
}

Excited Asked::place() const
{
    return named("force", excitedNames);
}

std::optional<double> Asked::displacement(double frequencyRatio, const Bar& bar) const
{
    const auto amplitude = maybe<double>("amplitude");
    const auto derivative = get<int>("derivative");
    const double hertz = frequencyRatio * (0.25 / scales(bar).time);
    return amplitude && derivative > 0 ? displacementAt(hertz, *amplitude, derivative) : amplitude;
}

double Asked::strainLimit(double unit) const
{
    const auto limit = maybe<double>("strain_limit");
    Faults faults;
    if (limit && !(*limit > 0.0)) {
        faults.add("strain_limit", *limit, "numbers > 0 [-]");
    }
    faults.throwIfAny();
    return limit ? *limit / unit : std::numeric_limits<double>::infinity();
}

}  // namespace signorini::python
