#include "find_command.hpp"
#include "commands.hpp"

#include <optional>
#include <utility>

#include "certificate_report.hpp"
#include "demand_names.hpp"
#include "faults.hpp"
#include "files.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_find.hpp"
#include "scene_options.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/motion.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

/// The options with what needs several of them, and how the target was read.
struct FindRequest {
    FindOptions options;
    std::string reading;
};

namespace asks = answers::asks;

namespace {

FindRequest completed(const FindCommand& call)
{
    FindRequest request{answers::findAsked(call.given, call.common.scene()), {}};
    FindOptions& options = request.options;
    const std::string target = call.given.text("--target");
    if (!target.empty()) {
        StateReading read = forFile("--target", target, [&] {
            return readState(target, options.scene.bar, call.common.usualCells());
        });
        options.target = std::move(read.state);
        request.reading = std::move(read.how);
    }
    return request;
}

/// findPeriodic, with signals listened to and a line on a terminal.
answers::FindAnswer search(const Schedule& schedule, const FindRequest& request,
                           const CommonOptions& common)
{
    return watched(common, "finding a motion", [&](const answers::Watch& watch) {
        PeriodicResult result = findPeriodic(schedule, watch.on(request.options));
        if (result.status == Status::undecided && isRequested(watch.cancel)) {
            common.say("interrupted");
        }
        return answers::answerOf(std::move(result), request.options, request.reading);
    });
}

Motion fieldOf(const PeriodicResult& result)
{
    const std::vector<Segment>& segments = result.scene.segments;
    return isUniform(segments) ? Motion(result.motion->state, result.schedule)
                               : Motion(result.motion->state, result.schedule, segments);
}

/// A motion, or the proof that there is none.
void writeFiles(FindOutputs& files, const FindOptions& options, const PeriodicResult& result,
                const Json& answer)
{
    if (result.motion) {
        files.writeMotion({result.motion->state, result.scene, result.scene.bar, result.schedule,
                           [&] { return fieldOf(result); }, [&] { return motionFigure(result); }});
    } else {
        files.lackMotion();
    }
    const auto energies = files.wantsProof() ? energyCertificate(result, options) : std::nullopt;
    if (!result.absence && !energies) {
        files.lackProof();
        return;
    }
    files.writeProof([&](TextFile& file) {
        // Of an answer with the certificate in place there is none to write.
        writeAnswer(claimOf(answer, energies), result,
                    [&](std::string_view text) { file.write(text); });
    });
}

}  // namespace

FindCommand::FindCommand(const Given& words)
    : given(words),
      common(words),
      force(words),
      cycles(words.whole("--cycles").value_or(1)),
      yieldStress(words.number("--yield-stress"))
{
}

void FindCommand::warn(const Physical& physical) const
{
    common.warnUnlessAdmissible(physical);
    if (yieldStress && *physical.peakStress > *yieldStress) {
        common.say(
            fmt::format("the stress reaches {:.6g} Pa, beyond --yield-stress {:.6g} Pa{}",
                        *physical.peakStress, *yieldStress,
                        *yieldStress < answers::softestModulus
                            ? fmt::format(" ({0:.6g} MPa are typed {0:.6g}MPa)", *yieldStress)
                            : ""));
    }
}

unsigned FindCommand::kind() const
{
    return hasPeriod()  ? isForced() ? asks::forcedPeriod : asks::period
           : isForced() ? asks::forced
                        : asks::schedule;
}

ExitStatus FindCommand::findInBars() const
{
    refuseIf(
        given.has("--contacts") && !(hasPeriod() && isForced()), "--contacts",
        given.text("--contacts"),
        "only with --period, --frequency or --hertz, and --force; elsewhere motions are sought "
        "by their schedules, which say how many");
    return !hasPeriod() ? findInScene(*this)
           : isForced() ? findHarmonicInBars(*this, common.assembly())
                        : findPeriodInBars(*this, common.assembly());
}

ExitStatus FindCommand::run() const
{
    refuseIf(hasPeriod() && !given.words().empty(),
             "NC NF clash with --period, --frequency and --hertz: allowed one of them");
    if (hasPeriod() && isForced()) {
        refuseIf(given.has("--state"),
                 "--state: allowed of a schedule, or without force: a state file holds waves that "
                 "are constant on pieces, and under an exact harmonic they change all along; "
                 "--motion writes samples");
        refuseIf(triesStability(),
                 "--stability: allowed of a schedule, or without force: under an exact harmonic "
                 "each motion says by itself how disturbances grow");
    }
    if (common.hasScene()) {
        const bool isOfBar = hasPeriod() && (!isForced() || force.ratio);
        if (given.outside(asks::network) == nullptr && !(isOfBar && barOf(common.assembly()))) {
            return findInBars();
        }
        if (!barOf(common.assembly()) || hasSets(given)) {
            const unsigned damped = common.sceneText.empty() ? asks::forced : 0U;
            given.requireOnly(asks::network | (isForced() ? damped : asks::freeNetwork));
            return findInBars();
        }
    }
    const unsigned asked = kind();
    given.requireOnly(asked);
    const Scene bar = common.scene();
    (void)yieldStressOf(given, unitsOfBar(bar));
    refuseIf(!haveOneSpeed(bar.segments) && given.text("--motion").ends_with(".pvd"), "--motion",
             given.text("--motion"), "FILE.csv|.vtk of segments with several speeds");
    if (hasPeriod() && !isForced() && !isUniform(bar.segments)) {
        return findPeriodInBars(*this, answers::assemblyOf(bar, common.usualCells(), {}));
    }
    ExitStatus status = exitUndecided;
    if (asked == asks::forcedPeriod) {
        status = answerHarmonic(*this);
    } else if (asked == asks::period) {
        const auto [option, word] = given.period();
        status = answerQuestion(answers::periodOnGrid(option, word, common.usualCells(), bar.bar),
                                completed(*this));
    } else {
        const Schedule schedule{common.usualCells(), parsePhases(given.words()), stopsOf(bar)};
        status = asked == asks::forced ? answerForced(*this, schedule)
                                       : answerSchedule(schedule, completed(*this));
    }
    common.useOneThread();
    return status;
}

void FindCommand::requireTried(std::int64_t steps) const
{
    if (triesStability()) {
        answers::requireTried(steps);
    }
}

ExitStatus FindCommand::answerSchedule(const Schedule& schedule, const FindRequest& request) const
{
    validate(schedule);
    requireTried(signorini::steps(schedule));
    FindOutputs files(*this);
    answers::FindAnswer answer = search(schedule, request, common);
    const PeriodicResult& result = answer.result;
    writeFiles(files, request.options, result, wholeJsonOf(answer, "certificate"));
    tryIfAsked(answer);
    if (common.wantsJson) {
        writeAnswer(wholeJsonOf(answer, "certificate"), result, writeOut);
    } else {
        writeOut(common.restated() + asText(answer, common.isVerbose));
    }
    if (result.motion) {
        warn(result.motion->physical);
    }
    return exitStatusOf(result.status);
}

ExitStatus FindCommand::answerQuestion(const answers::AskedPeriod& asked,
                                       const FindRequest& request) const
{
    const std::int64_t cells = common.usualCells();
    requireTried(asked.steps);
    FindOutputs files(*this);
    answers::QuestionAnswer answer = answers::questionOf(asked, cells, request.options);
    std::optional<PeriodicResult> first;
    std::vector<Physical> measured;
    for (const Schedule& schedule :
         schedulesOfPeriod(cells, asked.steps, stopsOf(request.options.scene).right)) {
        answers::FindAnswer& found = answer.answers.emplace_back(search(schedule, request, common));
        PeriodicResult& result = found.result;
        if (!result.motion) {
            continue;
        }
        measured.push_back(result.motion->physical);
        if (!first) {
            first = result;
        }
        tryIfAsked(found);
        found.keptSpeeds = found.approachSpeeds();
        result.motion->state = {};  // there may be many, each as long as the grid is fine
    }
    if (files.areOfMotion() && measured.size() > 1) {
        throw std::invalid_argument(
            fmt::format("--state, --motion, --figure: {} motions answer: allowed one, by its NC NF",
                        measured.size()));
    }
    writeFiles(files, request.options, first.value_or(PeriodicResult{}), {});
    writeOut(common.wantsJson ? asLine(wholeJsonOf(answer))
                              : common.restated() + asText(answer, common.isVerbose));
    for (const Physical& physical : measured) {
        warn(physical);
    }
    return exitStatusOf(answer.status());
}

ExitStatus runFind(const Given& given)
{
    return FindCommand(given).run();
}

}  // namespace signorini::cli
