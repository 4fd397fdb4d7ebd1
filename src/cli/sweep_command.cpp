#include "commands.hpp"
#include "files.hpp"
#include "given.hpp"
#include "journal.hpp"
#include "network.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_options.hpp"
#include "scene_report.hpp"

namespace signorini::cli {

namespace {

/// The motions with one contact over the same frequencies, as many periods as there are values;
/// none where no period of the grid lies there, or the response does not know such a bar.
std::vector<FrequencyResponse> exactUnder(const SweepRange& sweep)
{
    ResponseRange range{.cells = static_cast<std::int64_t>(sweep.cells),
                        .damping = sweep.damping,
                        .place = sweep.place,
                        .amplitude = sweep.amplitude,
                        .derivative = sweep.derivative,
                        .leastFrequencyRatio = sweep.least,
                        .mostFrequencyRatio = sweep.most,
                        .stops = sweep.stops,
                        .segments = sweep.segments};
    std::vector<FrequencyResponse> exact;
    if (sweep.over != Swept::frequency || !(sweep.damping.rho() < 1.0)) {
        return exact;
    }
    std::vector<std::int64_t> steps;
    try {
        steps = stepsOf(range);
    } catch (const std::invalid_argument&) {
        return exact;  // the sweep has its own range, which is right
    }
    const auto most = 4 * static_cast<std::size_t>(sweep.points);
    for (std::size_t k = 0; k < steps.size(); k += 1 + steps.size() / most) {
        if (auto response = responseAt(range, steps[k])) {
            exact.push_back(std::move(*response));
        }
    }
    return exact;
}

/// What a run that is resumed must have asked, on one line.
std::string questionOf(const Given& given, const CommonOptions& common, const SweepAnswer& answer)
{
    SweepAnswer asked = answer;
    asked.points.clear();
    return fmt::format("{} {} {} {} {} {} {} {} {}", wholeJsonOf(asked).dump(), common.sceneText,
                       common.gravity, asked.range.least, asked.range.most, asked.range.points,
                       asked.range.periods, asked.range.frequencyRatio, asked.range.resolution) +
           (given.has("--up") ? " up" : "") + (given.has("--down") ? " down" : "");
}

void write(const SweepAnswer& answer, const Network* network, Outputs& outputs)
{
    const Bar& bar = answer.bar;
    outputs.put("--csv", writeSweepCsv, answer);
    outputs.draw("--figure", [&] {
        return sweepFigure(
            answer.points, answer.range, bar,
            network != nullptr ? std::vector<FrequencyResponse>{} : exactUnder(answer.range));
    });
    outputs.draw("--bifurcation",
                 [&] { return bifurcationFigure(answer.points, answer.range, bar); });
}

/// Follows a bar, or what `network` is.
ExitStatus follow(const Given& given, const CommonOptions& common, SweepAnswer answer,
                  const Network* network)
{
    std::vector<SweepDirection> directions;
    if (given.has("--up") || !given.has("--down")) {
        directions.push_back(SweepDirection::up);
    }
    if (given.has("--down") || !given.has("--up")) {
        directions.push_back(SweepDirection::down);
    }
    Outputs outputs(given, {"--csv", "--figure", "--bifurcation"});
    answer.require(network);  // nothing is written of what is refused
    const auto [option, from] = givenEnd(given, "--from");
    if (answer.range.over == Swept::frequency && answer.range.least >= answers::likelyHertz &&
        option == "--from" && !from.ends_with("Hz")) {
        common.say(fmt::format("--from {0} is {0} ω₁; {0} Hz are --from {0}Hz", from));
    }
    std::optional<Journal> journal;
    watched(common, "values", [&](const answers::Watch& watch) {
        if (given.has("--csv")) {
            journal.emplace(given.text("--csv"), questionOf(given, common, answer),
                            given.has("--resume"));
        }
        answer.points = sweepThrough(answer.range, network, answer.bar, directions,
                                     journal ? &*journal : nullptr, common.threads,
                                     {.cancel = watch.cancel, .show = watch.show});
    });
    answer.isComplete =
        answer.points.size() == directions.size() * static_cast<std::size_t>(answer.range.points);
    if (answer.isComplete) {
        write(answer, network, outputs);
        outputs.commit();
        if (journal) {
            journal->remove();
        }
    } else {
        common.say(fmt::format("interrupted; the list is not complete, and no file was written{}",
                               journal ? "; the same call with --resume continues" : ""));
    }
    network != nullptr ? report(common, answer, common.assembly(), cli::asText(answer))
                       : report(common, answer, {}, given.number("--damping"));
    return exitStatusOf(answer.status());
}

}  // namespace

ExitStatus runSweep(const Given& given)
{
    const CommonOptions common(given);
    refuseIf(given.has("--resume") && !given.has("--csv"),
             "--resume: allowed only together with --csv");
    if (common.hasScene() && !barOf(common.assembly())) {
        const Assembly& assembly = common.assembly();
        const Network network = networkOf(assembly);
        common.requireOwnDamping();
        return follow(given, common,
                      answers::sweepAsked(given, assembly, network, common.usualCells()), &network);
    }
    return follow(given, common, answers::sweepAsked(given, common.scene(), common.usualCells()),
                  nullptr);
}

}  // namespace signorini::cli
