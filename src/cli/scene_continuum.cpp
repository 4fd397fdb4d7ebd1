#include "scene_continuum.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "files.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_continuum_answer.hpp"
#include "scene_find.hpp"
#include "scene_options.hpp"
#include "scene_report.hpp"
#include "signorini/output.hpp"
#include "state_table.hpp"

namespace signorini::cli {

std::optional<Assembly> barsOf(const Given& given, const CommonOptions& common)
{
    if (common.hasScene()) {
        const std::optional<Scene> bar = barOf(common.assembly());
        return bar && bar->segments.empty() && !hasSets(given) ? std::nullopt
                                                               : std::optional(common.assembly());
    }
    const Scene scene = common.shortForms();
    if (scene.segments.empty()) {
        return std::nullopt;
    }
    return answers::assemblyOf(scene, common.usualCells(), {});
}

namespace {

std::string asText(const answers::SceneContinuumAnswer& answer)
{
    const NetworkContinuum& curve = answer.curve();
    const answers::SceneSchedule& schedule = answer.schedule();
    const auto energyText = [&](double energy) { return inWords(schedule, energy, 10); };
    std::string text =
        fmt::format("{:<12}{}, E = {}, {} motions by the {} engine\n", name(curve.status),
                    textOf(schedule.spans), energyText(curve.energy), curve.points.size(),
                    engineOf(curve.solver));
    if (curve.known.provedEnergy > 0.0 && !curve.known.isEmpty) {
        text += fmt::format("range       proved: none has less than {}\n",
                            energyText(curve.known.provedEnergy));
    }
    text += fmt::format("frequency   {:.6g} Hz\n", 1.0 / schedule.period());
    text += limitText(schedule.strainLimit);
    if (curve.dimension) {
        text += fmt::format("set         of dimension {} at this energy\n", *curve.dimension);
    }
    text += fmt::format("connected   {}\n", !curve.connected   ? "not known"
                                            : *curve.connected ? "yes"
                                                               : "no");
    if (!curve.points.empty()) {
        double residual = 0.0;
        double least = infinity;
        double most = 0.0;
        std::vector<double> forces(schedule.bars.contacts.size(), 0.0);
        for (const answers::SceneCurvePoint& point : answer.points()) {
            residual = std::max(residual, point.point().residuals.worst());
            least = std::min(least, point.strains().compression);
            most = std::max(most, point.strains().compression);
            for (std::size_t j = 0; j < forces.size(); ++j) {
                forces[j] = std::max(forces[j], point.point().residuals.peakForces[j]);
            }
        }
        const char* unit = curve.parameter == Parameter::number ? ""
                           : schedule.unit                      ? " [√E₁]"
                                                                : " [√E]";
        text += fmt::format("curve       {}, λ = {}{} from {:.6g} to {:.6g}\n", curve.family,
                            name(curve.parameter), unit, curve.points.front().lambda,
                            curve.points.back().lambda);
        text += resolutionText(curve.resolution);
        for (std::size_t j = 0; j < forces.size(); ++j) {
            text += fmt::format("contact {:<4}force at most {:.6g} N along it\n", j + 1,
                                forces[j] * schedule.scales.force());
        }
        text += fmt::format("strain      at most {:.6g} … {:.6g} in compression along it\n", least,
                            most);
        text += fmt::format("residuals   at most {:.3g}\n", residual);
    }
    if (const auto member = answer.member()) {
        text += fmt::format(
            "member      λ = {:.10g}, the nearest point of the curve; {:.6g} in compression\n",
            member->point().lambda, member->strains().compression);
    }
    return text + detailText(curve.status, curve.detail);
}

}  // namespace

ExitStatus continuumInBars(const Given& given, const CommonOptions& common,
                           const Assembly& assembly)
{
    answers::BarsAsked bars(given, assembly);
    bars.spans = spansOf(given, common, bars.network.contacts.size());
    const auto question = answers::continuumAsked(given, bars, wavesIn(given));
    Outputs outputs(given, {"--csv", "--state", "--figure", "--animate"});
    bool isInterrupted = false;
    answers::SceneContinuumAnswer answer = watched(common, "tracing", question, isInterrupted);
    const NetworkContinuum& curve = answer.curve();
    if (!curve.points.empty() && !isInterrupted) {
        if (const auto member = given.number("--member")) {
            answer.asked = pointAt(curve, *member);
        }
        outputs.put("--state", [&](const std::string& path) {
            const NetworkClaim& motion = curve.points[*answer.asked].motion;
            writeStateTable(path, bars.network, {motion.waves, motion.displacements});
        });
        outputs.put("--csv",
                    [&](const std::string& path) { writeContinuumCsv(path, bars.network, curve); });
        outputs.draw("--figure", [&] { return sceneContinuumFigure(answer); });
        outputs.draw("--animate", [&] { return sceneContinuumFrames(answer); });
        outputs.commit();
    } else if (outputs.areWanted()) {
        common.sayNoFile(isInterrupted ? "the curve is not complete" : "no motion to write");
    }
    report(common, answer, assembly, asText(answer));
    Physical worst;
    for (const answers::SceneCurvePoint& point : answer.points()) {
        worst.peakCompression = std::max(worst.peakCompression, point.strains().compression);
    }
    common.warnUnlessAdmissible(worst);
    common.useOneThread();
    return exitStatusOf(curve.status);
}

}  // namespace signorini::cli
