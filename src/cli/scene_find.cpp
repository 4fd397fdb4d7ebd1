#include "scene_find.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "progress.hpp"
#include "scene_options.hpp"
#include "scene_report.hpp"
#include "stops.hpp"

namespace signorini::cli {

namespace {

using answers::SceneFindAnswer;

/// Pushes on a bar that drifts balance what else acts on it, on average.
std::string whyGrazing(const SceneFind& of)
{
    return pushesBalance(of.bars.network, of.bars.spans)
               ? ", nor does it in any other motion of this schedule: the pushes on a bar that "
                 "nothing else holds balance"
               : "";
}

std::string asText(const SceneFindAnswer& answer, const SceneFind& of)
{
    const LeastMotion& motions = answer.motions;
    const answers::SceneSchedule& schedule = answer.schedule;
    std::string text = of.lines(motions.status) +
                       fmt::format("frequency   {:.6g} Hz\n", 1.0 / schedule.period()) +
                       setText(motions.kind, motions.dimension, motions.kernelDimension);
    const std::string limited =
        schedule.strainLimit ? fmt::format(" with strain >= -{:.6g}", *schedule.strainLimit) : "";
    if (motions.status == Status::none) {
        text += fmt::format("proof       none below {}{}; verified by stepping backwards in time\n",
                            inWords(schedule, motions.provedEnergy), limited);
    } else if (motions.status == Status::undecided) {
        text += fmt::format("why         {}\n", motions.detail);
    } else {
        text +=
            fmt::format("energy      {:.6g} J{}{}; proved: none{} has less than {}\n",
                        schedule.joules(motions.energy),
                        schedule.unit ? ", " + inWords(schedule, motions.energy) : "",
                        answer.isOfLeast ? ", the least" + limited
                        : of.call.given.text("--objective") == "max-energy" ? std::string(mostFound)
                                                                            : "",
                        limited, inWords(schedule, motions.provedEnergy));
        if (!answer.presses()) {
            text += fmt::format("contact     grazing: nothing presses{}\n", whyGrazing(of));
        }
        text +=
            cli::asText(contactsOf(schedule, &motions.residuals)) + cli::asText(*answer.strains());
        if (const auto least = answer.provedCompression()) {
            text += fmt::format(
                "            proved: every motion has more than {:.6g} in "
                "compression\n",
                *least);
        }
        text += fmt::format("residual    {:.2g}\n{}", motions.residuals.worst(),
                            cli::asText(answer.stability));
    }
    return of.call.common.isVerbose ? text + cli::asText(motions.how) : text;
}

}  // namespace

std::string inWords(const answers::SceneSchedule& schedule, double energy, int digits)
{
    const auto ratio = schedule.ratio(energy);
    return fmt::format("{:.{}g} {}", ratio.value_or(schedule.joules(energy)), digits,
                       ratio ? "E₁" : "J");
}

answers::WavesOf wavesIn(const Given& given)
{
    return [&given](const char* option, const answers::BarsAsked& bars) {
        const std::string path = given.text(option);
        std::optional<std::vector<double>> waves;
        if (!path.empty()) {
            waves = forFile(option, path, [&] {
                return readNearestWaves(path, bars.network, barOf(bars.assembly));
            });
        }
        return waves;
    };
}

void warnOf(const answers::SceneStrains& strains, const FindCommand& call)
{
    Physical physical;
    physical.peakCompression = strains.compression;
    physical.peakStress = strains.stress;
    call.warn(physical);
}

std::string asText(const answers::SceneStrains& strains)
{
    return fmt::format("strain      at most {:.6g} in compression, {:.6g} in tension{}\n",
                       strains.compression, strains.tension,
                       strains.stress ? fmt::format("; stress {:.6g} Pa", *strains.stress) : "");
}

void requireOfBars(const FindCommand& call, const Assembly& assembly)
{
    refuseIf(call.given.text("--motion").ends_with(".pvd"), "--motion", call.given.text("--motion"),
             "FILE.csv|.vtk of several bars: a .pvd shows one before its wall");
    Bar bar;
    bar.young = answers::modulusOf(assembly);
    (void)yieldStressOf(call.given, bar);
}

std::string asText(const std::vector<answers::ContactInPeriod>& contacts)
{
    std::string text;
    for (const answers::ContactInPeriod& one : contacts) {
        text += fmt::format(
            "contact {:<4}force at most {:.6g} N, impulse {:.6g} N s per period; "
            "met at {:.6g} m/s\n",
            one.contact.number, *one.peakForce, *one.impulse, *one.speed);
    }
    return text;
}

std::string asText(const std::optional<answers::SceneStability>& tried)
{
    return tried ? fmt::format("stability   {}\n", stabilityText(tried->result, tried->periods))
                 : "";
}

bool hasSets(const Given& given)
{
    return std::any_of(given.words().begin(), given.words().end(), [](std::string_view word) {
        return word.find(':') != std::string_view::npos && !word.starts_with("L:");
    });
}

std::vector<ContactSpan> spansOf(const Given& given, const CommonOptions& common,
                                 std::size_t contacts)
{
    if (!common.sceneText.empty() || hasSets(given)) {
        return signorini::spansOf(given.words(), contacts);
    }
    const Schedule schedule{common.usualCells(), parsePhases(given.words()),
                            stopsOf(common.shortForms())};
    validate(schedule);
    return signorini::spansOf(schedule);
}

SceneFind::SceneFind(const FindCommand& of)
    : call(of), bars(of.given, of.common.assembly()), files(of)
{
    requireOfBars(of, bars.assembly);
    bars.spans = spansOf(of.given, of.common, bars.network.contacts.size());
}

std::string SceneFind::lines(Status status) const
{
    return headline(bars.assembly, bars.network) +
           fmt::format("{:<12}{}\n", name(status), textOf(bars.spans));
}

void SceneFind::write(const NetworkClaim* motion, bool isProof, const std::string& json)
{
    if (motion != nullptr) {
        files.writeBars(bars.assembly, bars.network, *motion);
    } else {
        files.lackMotion();
    }
    if (isProof) {
        files.writeProof([&json](TextFile& file) { file.write(json); });
    } else {
        files.lackProof();
    }
    call.common.useOneThread();
}

ExitStatus findInScene(const FindCommand& command)
{
    if (command.isForced()) {
        return findForcedInScene(command);
    }
    SceneFind scene(command);
    const SceneFindAnswer answer =
        watched(command.common, "finding a motion",
                answers::motionAsked(command.given, scene.bars, wavesIn(command.given)));
    if (const auto strains = answer.strains()) {
        warnOf(*strains, command);
    }
    const auto& motion = answer.motions.motion;
    return scene.finish(answer, motion ? &*motion : nullptr, answer.isProof(),
                        asText(answer, scene));
}

}  // namespace signorini::cli
