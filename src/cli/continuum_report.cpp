#include "reports.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace signorini::cli {

namespace {

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

}  // namespace

std::string resolutionText(const std::optional<double>& resolution)
{
    return resolution ? fmt::format("resolution  neighbours at most {:.3g} √E apart\n", *resolution)
                      : "";
}

std::string detailText(Status status, const std::string& detail)
{
    return detail.empty()
               ? ""
               : fmt::format("{:<12}{}\n", status == Status::found ? "note" : "why", detail);
}

std::string asText(const answers::ContinuumAnswer& answer)
{
    const Continuum& curve = *answer.curve;
    const std::string energy =
        hasUnit(curve) ? fmt::format("{:.10g} E₁", curve.energyRatio)
                       : fmt::format("{:.10g} J", answers::joules(curve.energyRatio, curve));
    std::string text =
        fmt::format("{:<12}{}, E = {}, {} motions by the {} engine\n", name(curve.status),
                    describe(curve.schedule), energy, curve.points.size(), engineOf(curve.solver));
    if (curve.energyRange && hasUnit(curve)) {
        text += fmt::format("range       {:.10g} … {:.10g} E₁\n", curve.energyRange->least,
                            curve.energyRange->most);
    }
    const auto dimension = answers::dimensionOf(curve);
    if (curve.components) {
        text += fmt::format("set         {} component{}{} at this energy\n", *curve.components,
                            *curve.components == 1 ? "" : "s",
                            dimension ? fmt::format(" of dimension {}", *dimension) : "");
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
        text += resolutionText(curve.resolution);
        text += fmt::format("strain      at most {:.6g} … {:.6g} in compression along it\n", least,
                            most);
        text += fmt::format("residuals   at most {:.3g}\n", residual);
    }
    if (const auto& member = answer.asked) {
        text += fmt::format(
            "member      λ = {:.10g}, {}; {:.6g} in compression\n", member->point.lambda,
            member->isExact ? "exactly the one asked for" : "the nearest point of the curve",
            member->point.peakStrain);
    }
    return text + detailText(curve.status, curve.detail);
}

}  // namespace signorini::cli
