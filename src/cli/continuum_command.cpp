#include "commands.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "faults.hpp"
#include "files.hpp"
#include "given.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_continuum.hpp"
#include "signorini/continuum.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

constexpr std::int64_t maxSeed = std::int64_t{1} << 62;

/// [E_1], whichever way it was given.
double energyOf(const Given& given, const Bar& bar)
{
    const auto energy = given.number("--energy");
    const auto energyRatio = given.number("--energy-ratio");
    requireEnergy(energy, energyRatio);
    return energy ? *energy / scales(bar).energy : *energyRatio;
}

/// Which ends go together, and with what.
void requireEnds(const Given& given)
{
    const int ends = (given.has("--to") ? 1 : 0) + (given.has("--direction") ? 1 : 0);
    refuseIf((given.has("--from") ? 1 : 0) != ends,
             "--from: allowed only together with one of --to and --direction");
    refuseIf(ends != 0 && (given.has("--seed") || given.has("--sample")),
             "--seed and --sample clash with --from: allowed one of them");
}

Trace traceOf(const Given& given, const Bar& bar, std::int64_t cells)
{
    const std::optional<std::int64_t> seed = given.whole("--seed");
    const auto seedOr = [&seed](std::uint64_t usual) {
        return seed ? static_cast<std::uint64_t>(*seed) : usual;
    };
    if (!given.has("--from")) {
        return given.has("--sample") ? Trace(trace::Sample{seedOr(trace::Sample{}.seed)})
               : seed                ? Trace(trace::RandomPath{seedOr(0)})
                                     : Trace(trace::SplitPulse{});
    }
    const auto read = [&](const char* option) {
        const std::string path = given.text(option);
        return forFile(option, path, [&] { return readState(path, bar, cells).state; });
    };
    State from = read("--from");
    if (given.has("--to")) {
        return trace::Path{std::move(from), read("--to")};
    }
    return trace::Walk{std::move(from), read("--direction")};
}

/// The options with what needs several of them.
ContinuumOptions optionsOf(const Given& given, const CommonOptions& common)
{
    ContinuumOptions options;
    options.scene = common.scene();
    options.trace = traceOf(given, options.scene.bar, common.usualCells());
    readCurve(given, options);
    options.strainLimit = given.number("--strain-limit").value_or(options.strainLimit);
    return options;
}

/// Of the member that is compressed most.
void warnOfWorst(const CommonOptions& common, const Continuum& curve)
{
    const auto worst = std::max_element(
        curve.points.begin(), curve.points.end(),
        [](const auto& one, const auto& other) { return one.peakStrain < other.peakStrain; });
    if (worst != curve.points.end()) {
        common.warnUnlessAdmissible(
            physicalOf(extremesOf(worst->state, curve.schedule), curve.scene.bar));
    }
}

}  // namespace

void requireEnergy(const std::optional<double>& energy, const std::optional<double>& energyRatio)
{
    refuseIf(energy && energyRatio, "--energy clashes with --energy-ratio: allowed one of them");
    refuseIf(!energy && !energyRatio,
             "--energy-ratio is missing: allowed finite numbers > 0 [E_1], or --energy in joules");
}

ExitStatus runContinuum(const Given& given)
{
    const CommonOptions common(given);
    requireEnds(given);
    refuseIf(given.has("--member") != given.has("--state"),
             "--member and --state: allowed both or neither");
    if (const auto assembly = barsOf(given, common)) {
        return continuumInBars(given, common, *assembly);
    }
    Schedule schedule{common.usualCells(), parsePhases(given.words())};
    ContinuumOptions request = optionsOf(given, common);
    const double ratio = energyOf(given, request.scene.bar);
    schedule.stops = stopsOf(request.scene);
    validate(schedule);
    Outputs outputs(given, {"--csv", "--state", "--figure", "--animate"});

    answers::ContinuumAnswer answer;
    watched(common, "tracing", [&](const Cancel& cancel, const auto& show) {
        request.cancel = cancel;
        request.progress = show;
        answer.curve = std::make_shared<const Continuum>(traceContinuum(schedule, ratio, request));
    });
    const Continuum& curve = *answer.curve;
    if (!curve.points.empty()) {
        if (const auto member = given.number("--member")) {
            answer.asked = memberAt(curve, *member);
        }
        outputs.put("--state", [&](const std::string& path) {
            writeStateCsv(path, answer.asked->point.state, request.scene.bar);
        });
        outputs.put("--csv", [&](const std::string& path) { writeContinuumCsv(path, curve); });
        outputs.draw("--figure", [&] { return continuumFigure(curve); });
        outputs.draw("--animate", [&] { return continuumFrames(curve); });
        outputs.commit();
    } else if (outputs.areWanted()) {
        common.say("no motion to write, so no file was written");
    }
    report(common, answer);
    warnOfWorst(common, curve);
    common.useOneThread();
    return exitStatusOf(curve.status);
}

}  // namespace signorini::cli
