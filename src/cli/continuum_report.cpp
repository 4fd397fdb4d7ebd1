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

const char* unitOf(Parameter parameter)
{
    switch (parameter) {
        case Parameter::arcLength:
            return " [√E₁]";
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
            {"energy_ratio", point.energyRatio},
            {"residual", point.residual},
            {"peak_strain", point.peakStrain},
            {"physical", physicalAsJson(physical)},
            {"admissible", physical.isAdmissible()}};
}

}  // namespace

Physical physicalOf(const ContinuumPoint& point, const Continuum& curve)
{
    return signorini::physicalOf(extremesOf(point.state, curve.schedule), curve.bar);
}

std::string asText(const Continuum& curve, const std::optional<Member>& member)
{
    std::string text = fmt::format("{:<12}{}, E = {:.10g} E₁, {} motions by the {} engine\n",
                                   name(curve.status), describe(curve.schedule), curve.energyRatio,
                                   curve.points.size(), engineOf(curve));
    if (curve.energyRange) {
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
                            name(curve.parameter), unitOf(curve.parameter),
                            curve.points.front().lambda, curve.points.back().lambda);
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
                     {"bar", barAsJson(curve.bar)},
                     {"period", period(curve.schedule) * scales(curve.bar).time},
                     {"period_ratio", period(curve.schedule)},
                     {"frequency_ratio", frequencyRatio(curve.schedule)},
                     {"energy_ratio", curve.energyRatio},
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
    if (curve.connected) {
        json["connected"] = *curve.connected;
    }
    if (curve.components) {
        json["components"] = *curve.components;
    }
    if (hasDimension(curve)) {
        json["dimension"] = curve.dimension;
    }
    if (curve.energyRange) {
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
