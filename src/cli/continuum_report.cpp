#include "continuum_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine_names.hpp"
#include "report.hpp"

namespace signorini::cli {

namespace {

/// No motions have no dimension.
bool hasDimension(const Continuum& curve)
{
    return curve.dimension >= 0 && curve.components != 0;
}

/// How many different motions the points are.
std::string orbitsAsText(const Continuum& curve)
{
    const auto points = static_cast<std::int64_t>(curve.points.size());
    if (curve.orbits == points) {
        return points == 1 ? "1 motion" : "all different motions, none a shift in time of another";
    }
    return fmt::format("{} different motion{}: the other points are the same at other instants",
                       curve.orbits, curve.orbits == 1 ? "" : "s");
}

/// Without a gap there is no E_1: energies are in joules.
bool hasUnit(const Continuum& curve)
{
    return curve.scene.bar.gap != 0.0;
}

double joules(double energyRatio, const Continuum& curve)
{
    return energyRatio * scales(curve.scene.bar).energy;
}

const char* unitOf(const Continuum& curve)
{
    switch (curve.parameter) {
        case Parameter::arcLength:
            return hasUnit(curve) ? " [√E₁]" : " [√(EA L/2)]";
        case Parameter::pause:
            return " between the two pulses of force [L/c]";
        case Parameter::number:
            return "";
    }
    return "";
}

Json asJson(const ContinuumPoint& point, const Continuum& curve)
{
    const Physical physical = physicalOf(point, curve);
    return {{"lambda", point.lambda},
            {"energy", joules(point.energyRatio, curve)},
            {"energy_ratio", hasUnit(curve) ? Json(point.energyRatio) : Json()},
            {"residual", point.residual},
            {"peak_strain", point.peakStrain},
            {"physical", physicalAsJson(physical)},
            {"admissible", physical.isAdmissible()}};
}

}  // namespace

Physical physicalOf(const ContinuumPoint& point, const Continuum& curve)
{
    return signorini::physicalOf(extremesOf(point.state, curve.schedule), curve.scene.bar);
}

std::string asText(const Continuum& curve, const std::optional<Member>& member)
{
    const std::string energy = hasUnit(curve)
                                   ? fmt::format("{:.10g} E₁", curve.energyRatio)
                                   : fmt::format("{:.10g} J", joules(curve.energyRatio, curve));
    std::string text =
        fmt::format("{:<12}{}, E = {}, {} motions by the {} engine\n", name(curve.status),
                    describe(curve.schedule), energy, curve.points.size(), engineOf(curve));
    if (curve.energyRange && hasUnit(curve)) {
        text += fmt::format("range       {:.10g} … {:.10g} E₁\n", curve.energyRange->least,
                            curve.energyRange->most);
    }
    if (curve.components) {
        text += fmt::format(
            "set         {} component{}{} at this energy\n", *curve.components,
            *curve.components == 1 ? "" : "s",
            hasDimension(curve) ? fmt::format(" of dimension {}", curve.dimension) : "");
    }
    text += fmt::format("connected   {}\n", !curve.connected   ? "not known"
                                            : *curve.connected ? "yes"
                                                               : "no");
    if (!curve.points.empty()) {
        double residual = 0.0;
        double least = curve.points.front().peakStrain;
        double most = least;
        for (const ContinuumPoint& point : curve.points) {
            residual = std::max(residual, point.residual);
            least = std::min(least, point.peakStrain);
            most = std::max(most, point.peakStrain);
        }
        text += fmt::format("curve       {}, λ = {}{} from {:.6g} to {:.6g}\n", curve.family,
                            name(curve.parameter), unitOf(curve), curve.points.front().lambda,
                            curve.points.back().lambda);
        text += fmt::format("orbits      {}\n", orbitsAsText(curve));
        if (curve.resolution) {
            text +=
                fmt::format("resolution  neighbours at most {:.3g} √E apart\n", *curve.resolution);
        }
        text += fmt::format("strain      at most {:.6g} … {:.6g} in compression along it\n", least,
                            most);
        text += fmt::format("residuals   at most {:.3g}\n", residual);
    }
    if (member) {
        text += fmt::format(
            "member      λ = {:.10g}, {}; {:.6g} in compression\n", member->point.lambda,
            member->isExact ? "exactly the one asked for" : "the nearest point of the curve",
            member->point.peakStrain);
    }
    if (!curve.detail.empty()) {
        text +=
            fmt::format("{:<12}{}\n", curve.status == Status::found ? "note" : "why", curve.detail);
    }
    return text;
}

std::string asJson(const Continuum& curve, const std::optional<Member>& member)
{
    Json json = newAnswer();
    json.update(Json{{"status", name(curve.status)},
                     {"cells", curve.schedule.cells},
                     {"schedule", phasesAsJson(curve.schedule.phases)},
                     {"period", period(curve.schedule) * scales(curve.scene.bar).time},
                     {"period_ratio", period(curve.schedule)},
                     {"frequency_ratio", frequencyRatio(curve.schedule)},
                     {"energy", joules(curve.energyRatio, curve)},
                     {"energy_ratio", hasUnit(curve) ? Json(curve.energyRatio) : Json()},
                     {"connected", nullptr},
                     {"components", nullptr},
                     {"dimension", nullptr},
                     {"energy_ratio_range", nullptr},
                     {"resolution", nullptr},
                     {"engine", engineOf(curve)},
                     {"family", curve.family},
                     {"parameter", name(curve.parameter)},
                     {"reason", nullptr},
                     {"orbits", curve.orbits},
                     {"points", Json::array()}});
    addScene(curve.scene, json);
    if (curve.connected) {
        json["connected"] = *curve.connected;
    }
    if (curve.components) {
        json["components"] = *curve.components;
    }
    if (hasDimension(curve)) {
        json["dimension"] = curve.dimension;
    }
    if (curve.energyRange && hasUnit(curve)) {
        json["energy_ratio_range"] = {curve.energyRange->least, curve.energyRange->most};
    }
    if (curve.resolution) {
        json["resolution"] = *curve.resolution;
    }
    if (curve.reason) {
        json["reason"] = name(*curve.reason);
    }
    for (const ContinuumPoint& point : curve.points) {
        json["points"].push_back(asJson(point, curve));
    }
    if (member) {
        json["member"] = asJson(member->point, curve);
        json["member"]["exact"] = member->isExact;
    }
    if (!curve.detail.empty()) {
        json["detail"] = curve.detail;
    }
    return asLine(json);
}

}  // namespace signorini::cli
