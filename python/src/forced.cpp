#include "forced.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "excited_names.hpp"
#include "faults.hpp"
#include "force.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "signorini/response.hpp"

namespace signorini::python {

/// What is known of one schedule.
struct ForcedAnswer {
    ForcedSet set;
    Bar bar;
    std::optional<double> asked;  ///< [N] or [m]
    std::vector<MotionOf> motions;
    /// Where the set has motions, but none of the amplitude.
    std::optional<AmplitudeExclusion> exclusion = {};

    [[nodiscard]] Status status() const
    {
        return !exclusion ? set.status : exclusion->isCertain ? Status::none : Status::undecided;
    }
};
template <>
struct Members<ForcedAnswer> {
    static constexpr auto list =
        std::tuple{&ForcedAnswer::set, &ForcedAnswer::bar, &ForcedAnswer::asked,
                   &ForcedAnswer::motions, &ForcedAnswer::exclusion};
};

namespace {

void addMotionOf(py::module_& module)
{
    Record<MotionOf> record(module, "ForcedMotion", "One forced, damped motion.");
    const auto amplitude = [](const MotionOf& m) {
        return m.value.amplitude * amplitudeUnit(m.value.excitation.place, m.bar);
    };
    const auto physical = [](const MotionOf& m) { return physicalOf(m.value.extremes, m.bar); };
    record
        .key(
            "schedule", [](const MotionOf& m) { return m.value.schedule; }, "Contact and flight.")
        .key(
            "amplitude", [amplitude](const MotionOf& m) { return amplitude(m); },
            "Of the excitation [N] or [m].")
        .key(
            "phase", [](const MotionOf& m) { return m.value.phase; },
            "Of the excitation at the start of contact [rad].")
        .key(
            "impulse", [physical](const MotionOf& m) { return physical(m).impulse; },
            "[N s] a period.")
        .key(
            "peak_force", [physical](const MotionOf& m) { return physical(m).peakForce; }, "[N]")
        .key(
            "tip_lowest", [physical](const MotionOf& m) { return physical(m).tipLowest; }, "[m]")
        .key("physical", physical, "What can be measured, in SI units: a Physical.")
        .key(
            "admissible", [physical](const MotionOf& m) { return physical(m).isAdmissible(); },
            "Is s > -1 everywhere?")
        .key(
            "residual", [](const MotionOf& m) { return m.value.residual; },
            "The worst that was seen walking along it; relative.")
        .keyUnless(
            "stable",
            [](const MotionOf& m) -> py::object {
                const auto found = m.value.stability.value_or(Stability::unclear);
                return found == Stability::unclear ? py::object(py::none())
                                                   : py::bool_(found == Stability::attracts);
            },
            [](const MotionOf& m) { return !m.isOfResponse; },
            "Does the bar stay near it? None: not tried, or unclear.");
    record.more()
        .def_property_readonly(
            "impulse_ratio", [](const MotionOf& m) { return m.value.extremes.impulse; },
            "[EA g/c] a period.")
        .def_property_readonly(
            "peak_force_ratio", [](const MotionOf& m) { return m.value.extremes.peakForce; },
            "[EA g/L]")
        .def_property_readonly(
            "tip_lowest_ratio", [](const MotionOf& m) { return m.value.extremes.lowestTip; }, "[g]")
        .def_property_readonly(
            "state",
            [](const std::shared_ptr<MotionOf>& m) {
                return StateOf{std::shared_ptr<const State>(m, &m->value.state), m->bar,
                               m->segments};
            },
            "At the start of contact: a State.");
}

/// [{"rule": ..., "step": ...}, ...].
py::list conditionsOf(const std::vector<ForcedCondition>& conflict)
{
    py::list rows;
    for (const ForcedCondition& condition : conflict) {
        py::dict row;
        row["rule"] = nameOf(condition.rule);
        row["step"] = condition.step;
        rows.append(row);
    }
    return rows;
}

py::object certificateOf(const ForcedAnswer& answer)
{
    if (answer.status() == Status::undecided || !answer.motions.empty()) {
        return py::none();
    }
    py::dict dict;
    dict["kind"] = answer.exclusion ? "amplitude-range" : "forced";
    dict["verified"] = answer.exclusion ? answer.exclusion->isCertain : isCertain(answer.set);
    dict["conditions"] =
        conditionsOf(answer.exclusion ? answer.exclusion->conflict : answer.set.conflict);
    return dict;
}

std::string detailOf(const ForcedAnswer& answer)
{
    const ForcedSet& set = answer.set;
    if (set.status != Status::found || !answer.exclusion) {
        return set.status != Status::found ? set.detail : "";
    }
    const double unit = amplitudeUnit(set.forcing.place, answer.bar);
    const double most = set.mostAmplitude * unit;
    return fmt::format(
        "the motions have amplitudes of {:.6g} … {} {}{}", set.leastAmplitude * unit,
        std::isfinite(most) ? fmt::format("{:.6g}", most) : "∞",
        set.forcing.place == Excited::tip ? "N" : "m",
        answer.exclusion->isCertain ? "" : "; that none has this one was computed, not proved");
}

void addAnswer(py::module_& module)
{
    Record<ForcedAnswer> record(module, "ForcedResult",
                                "What is known of a schedule that is damped and forced.");
    const auto last = [](auto get) {
        return [get](const ForcedAnswer& a) -> py::object {
            return a.motions.empty() ? py::none() : py::object(py::float_(get(a.motions.back())));
        };
    };
    record
        .key(
            "status", [](const ForcedAnswer& a) { return nameOf(a.status()); },
            "\"found\", \"none\" or \"undecided\".")
        .key(
            "cells", [](const ForcedAnswer& a) { return a.set.schedule.cells; }, "N.")
        .key(
            "schedule", [](const ForcedAnswer& a) { return a.set.schedule; }, "Asked about.")
        .key(
            "bar", [](const ForcedAnswer& a) { return a.bar; }, "Asked about.")
        .key(
            "stops", [](const ForcedAnswer& a) { return stopsIn(Scene(a.bar)); },
            "[{\"side\", \"place\" [m]}, ...].")
        .key(
            "segments", [](const ForcedAnswer&) { return std::vector<Segment>{}; },
            "[Segment, ...].")
        .key(
            "static_force", [](const ForcedAnswer& a) { return staticForce(Scene(a.bar)); },
            "What the bar at rest presses on the wall with [N].")
        .key(
            "damping",
            [](const ForcedAnswer& a) {
                return Of<Damping>{a.set.damping, a.bar};
            },
            "A dashpot.")
        .key(
            "force", [](const ForcedAnswer& a) { return nameOf(a.set.forcing.place); },
            "\"tip\" or \"base\".")
        .key(
            "cycles", [](const ForcedAnswer& a) { return a.set.forcing.cycles; },
            "Of the excitation in a period.")
        .key(
            "period",
            [](const ForcedAnswer& a) { return period(a.set.schedule) * scales(a.bar).time; },
            "T [s].")
        .key(
            "period_ratio", [](const ForcedAnswer& a) { return period(a.set.schedule); },
            "T [L/c].")
        .key(
            "frequency_ratio",
            [](const ForcedAnswer& a) {
                return static_cast<double>(a.set.forcing.cycles) * frequencyRatio(a.set.schedule);
            },
            "omega/omega_1 of the excitation.")
        .key(
            "solution_set",
            [](const ForcedAnswer& a) {
                py::dict dict;
                dict["kind"] = nameOf(a.set.kind);
                dict["free_waves"] = a.set.freeWaves;
                return dict;
            },
            "{\"kind\": \"empty\", \"point\", \"segment\" \"ray\" or \"polytope\", \"free_waves\": "
            "...}.")
        .key(
            "strain_limit",
            [](const ForcedAnswer& a) {
                return finiteOrNone(a.set.limits.strain * scales(a.bar).strain);
            },
            "Of all motions [-], or None.")
        .key(
            "amplitude",
            [](const ForcedAnswer& a) -> py::object {
                return a.motions.empty() ? orNone(a.asked)
                                         : py::cast(a.motions.back()).attr("amplitude");
            },
            "Of the last motion [N] or [m].")
        .key(
            "amplitude_range",
            [](const ForcedAnswer& a) -> py::object {
                if (a.set.status != Status::found) {
                    return py::none();
                }
                return boundsOf({a.set.leastAmplitude, a.set.mostAmplitude},
                                amplitudeUnit(a.set.forcing.place, a.bar));
            },
            "(least, most) that have a motion [N] or [m].")
        .key("phase", last([](const MotionOf& m) { return m.value.phase; }),
             "Of the last motion [rad].")
        .key(
            "motions", [](const ForcedAnswer& a) { return a.motions; },
            "[ForcedMotion, ...] by ascending impulse.")
        .key(
            "reason",
            [](const ForcedAnswer& a) {
                const auto reason = a.exclusion && a.exclusion->isCertain
                                        ? std::optional(Reason::constraints)
                                        : a.set.reason;
                return orNone(reason, [](Reason r) { return nameOf(r); });
            },
            "Why there is none.")
        .key("certificate", &certificateOf, "The proof that there is none, a dictionary.")
        .keyIfAny(
            "detail",
            [](const ForcedAnswer& a) -> py::object {
                const std::string detail = detailOf(a);
                return detail.empty() ? py::object(py::none()) : py::str(detail);
            },
            "Why it is not decided, or which amplitudes have motions.");
}

ForcedAnswer findForced(const py::tuple& words, std::optional<std::int64_t> cells, const Bar& bar,
                        double damping, const std::string& force, std::optional<double> asked,
                        std::int64_t cycles, std::optional<double> strainLimit)
{
    const Schedule schedule = scheduleOf(words, cells);
    const Forcing forcing{placeOf(force), cycles, {}};
    ForcedLimits limits;
    if (strainLimit) {
        limits.strain = *strainLimit / scales(bar).strain;
    }
    return patiently([=](const Wires&) {
        ForcedAnswer answer{
            forcedMotions(schedule, {damping}, forcing, limits), bar, asked, {}, {}};
        if (answer.set.status != Status::found) {
            return answer;
        }
        if (!asked) {
            answer.motions = {{leastAmplitudeMotion(answer.set), bar}};
            return answer;
        }
        const double amplitude = *asked / amplitudeUnit(forcing.place, bar);
        for (const ForcedMotion& motion : motionsOfAmplitude(answer.set, amplitude)) {
            answer.motions.push_back({motion, bar});
        }
        if (answer.motions.empty()) {
            answer.exclusion = exclusionOf(answer.set, amplitude);
        }
        return answer;
    });
}

}  // namespace

void addForced(py::module_& module)
{
    Record<Of<Damping>>(module, "Damping", "A dashpot at the tip.")
        .key(
            "ratio", [](const Of<Damping>& d) { return d.value.ratio; },
            "zeta of the first linear mode.")
        .key(
            "dashpot", [](const Of<Damping>& d) { return dashpot(d.value, d.bar); }, "[N s/m]");
    addMotionOf(module);
    addAnswer(module);
    module.def("find_forced", &findForced);
}

Excited placeOf(const std::string& force)
{
    const auto place = valueIn(excitedNames, force);
    if (!place) {
        Faults faults;
        faults.add("force", force, namesIn(excitedNames));
        faults.throwIfAny();
    }
    return *place;
}

double amplitudeUnit(Excited place, const Bar& bar)
{
    return place == Excited::tip ? forceUnit(bar) : scales(bar).displacement;
}

}  // namespace signorini::python
