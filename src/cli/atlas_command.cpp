#include "commands.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "arguments.hpp"
#include "atlas_coverage.hpp"
#include "faults.hpp"
#include "files.hpp"
#include "given.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "ranks.hpp"
#include "reports.hpp"
#include "scene_options.hpp"
#include "scene_report.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

namespace {

using answers::AtlasUnits;

/// Finer than the periods of a grid up to N = 280, so that one of its frequencies is meant.
constexpr double usualDistance = 0.001;

/// What was asked, as options, to be kept for people.
std::string optionsOf(const AtlasRange& range)
{
    return fmt::format("--cells {} --max-contact {} --max-free {} --phases {}{}{}{}", range.cells,
                       range.maxContact, range.maxFree, range.maxPhases,
                       std::isfinite(range.maxEnergyRatio)
                           ? fmt::format(" --max-energy-ratio {}", range.maxEnergyRatio)
                           : "",
                       range.keepsRefuted ? " --all" : "",
                       range.familiesOnly ? " --families-only" : "") +
           (range.gapSign < 0    ? " --gap < 0"
            : range.gapSign == 0 ? " --gap 0"
                                 : "") +
           (range.secondStop
                ? fmt::format(" --second-stop {}/{} units", range.secondStop->numerator,
                              range.secondStop->denominator)
                : "") +
           (range.segments.empty() ? "" : fmt::format(" --segments {}", sceneText(range))) +
           (range.bars ? fmt::format(" --scene '{}'", sceneText(range)) : "");
}

/// The schedules that a question was answered with, or, without one, all that there are.
void forEachListed(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                   const AtlasAnswer& answer, const std::function<void(const AtlasEntry&)>& action)
{
    if (answer.twins) {
        for (const answers::TwinsOf& twins : *answer.twins) {
            std::for_each(twins.value.schedules.begin(), twins.value.schedules.end(), action);
        }
    } else if (answer.schedules) {
        for (const answers::AtlasEntryOf& entry : *answer.schedules) {
            action(entry.value);
        }
    } else {
        atlas.forEachSchedule(cells, action);
    }
}

/// One call.
struct AtlasCommand {
    const Given& given;
    CommonOptions common;
    std::string database;
    std::optional<ExactPeriod> period;

    explicit AtlasCommand(const Given& words);

    /// Decides the range, or answers a query; the report goes to stdout. SIGINT and SIGTERM end
    /// the work after the batch in flight. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;

private:
    [[nodiscard]] bool isQuery() const;
    [[nodiscard]] AtlasRange usualRangeOfScene() const;
    /// Whose scales the answers have.
    [[nodiscard]] Bar bar() const;
    /// Do options describe anything but these bars?
    [[nodiscard]] bool isAnother(const Assembly& known) const;
    /// The same of a database, which knows its bars.
    [[nodiscard]] AtlasUnits units(const std::optional<Assembly>& known) const;
    void checkQuery() const;
    [[nodiscard]] std::optional<answers::AtlasPoint> point(const AtlasUnits& units) const;
    [[nodiscard]] AtlasQuestion question(const std::optional<answers::AtlasPoint>& at) const;
    [[nodiscard]] AtlasAnswer ask(const AtlasDatabase& atlas,
                                  const std::vector<AtlasRun>& runs) const;
    [[nodiscard]] ExitStatus answer() const;
    [[nodiscard]] ExitStatus build(const AtlasRange& range, Ranks* ranks,
                                   std::optional<Interrupt>& interrupt) const;
    void fill(AtlasDatabase& atlas, AtlasRun& run, Ranks* ranks, const AtlasOptions& options) const;
    void draw(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
              const AtlasAnswer& answer, Outputs& outputs) const;
};

AtlasCommand::AtlasCommand(const Given& words)
    : given(words), common(words), database(words.text("--database"))
{
    if (given.has("--period")) {
        period = parseFraction("--period", given.text("--period"), "L/c");
    }
}

bool AtlasCommand::isQuery() const
{
    return given.has("--near") || period || given.has("--twins");
}

AtlasRange AtlasCommand::usualRangeOfScene() const
{
    return common.hasScene() ? answers::atlasRangeOf(common.assembly())
                             : answers::atlasRangeOf(common.shortForms(), common.usualCells());
}

Bar AtlasCommand::bar() const
{
    return firstMaterial(common.scene());
}

bool AtlasCommand::isAnother(const Assembly& known) const
{
    return common.hasScene() ? common.assembly() != known : common.shortForms() != Scene{};
}

AtlasUnits AtlasCommand::units(const std::optional<Assembly>& known) const
{
    const bool isOther = known ? isAnother(*known) : common.hasScene() && !barOf(common.assembly());
    refuseIf(isOther,
             "--scene, --gravity, and what a bar is: allowed those of the database, or none");
    return known ? answers::atlasUnitsOf(*known) : answers::atlasUnitsOf(bar());
}

ExitStatus AtlasCommand::run() const
{
    // Under mpirun the other processes neither read, write nor complain. MPI starts threads, which
    // must leave signals to us.
    std::optional<Interrupt> interrupt;
    std::unique_ptr<Ranks> ranks;
    if (Ranks::areLaunched()) {
        interrupt.emplace();
        ranks = std::make_unique<Ranks>();
    }
    try {
        refuseIf(database.empty(), "--database is missing: allowed the name of an SQLite file");
        if (given.has("--figure")) {
            const AtlasRange asked = usualRangeOfScene();
            refuseIf(hasFamilies(asked) && stopsOf(asked) != Stops{},
                     "--figure: allowed with a gap > 0 and one stop, whose plot it is; --csv holds "
                     "the families");
        }
        validateOutputs(given, {"--database", "--figure", "--map", "--csv"});
        // A picture of an atlas that exists needs no range.
        const bool draws = (given.has("--figure") || given.has("--map") || given.has("--csv")) &&
                           !common.cells && given.outside(answers::asks::atlasQuery) == nullptr &&
                           std::filesystem::exists(database);
        if (isQuery() || draws) {
            checkQuery();
            return !ranks || ranks->rank() == 0 ? answer() : exitFound;
        }
        return build(answers::atlasAsked(given, usualRangeOfScene()), ranks.get(), interrupt);
    } catch (const std::invalid_argument&) {
        if (ranks && ranks->rank() != 0) {
            return exitWrongUse;
        }
        throw;
    }
}

void AtlasCommand::checkQuery() const
{
    const bool near = given.has("--near");
    const int queries = (near ? 1 : 0) + (period ? 1 : 0) + (given.has("--twins") ? 1 : 0);
    refuseIf(queries > 1, "--near, --period, --twins: allowed one of them");
    given.requireOnly(answers::asks::atlasQuery);
    refuseIf(given.has("--within") && !near, "--within: allowed only together with --near");
    refuseIf(given.has("--schedules") && !near && !period,
             "--schedules: allowed only together with --near or --period");
    (void)point({});
    if (!common.sceneText.empty()) {
        (void)common.assembly();  // its faults are not those of the database
    }
}

std::optional<answers::AtlasPoint> AtlasCommand::point(const AtlasUnits& units) const
{
    const std::vector<std::string>& near = given.all("--near");
    if (near.empty()) {
        return std::nullopt;
    }
    if (near.size() != 2) {
        refuse("--near", near[0], "two numbers, omega/omega_1 > 0 and E/E_1 > 0");
    }
    const answers::AtlasPoint at{.frequencyRatio = parseRatio("--near W", near[0], "omega_1"),
                                 .energyRatio = parsePositive("--near E", near[1], "E_1"),
                                 .distance = given.number("--within").value_or(usualDistance),
                                 .units = units};
    validate(at);
    return at;
}

AtlasQuestion AtlasCommand::question(const std::optional<answers::AtlasPoint>& at) const
{
    AtlasQuestion question{
        .cells = common.cells, .period = period, .wantsSchedules = given.has("--schedules")};
    if (at) {
        question.lowestFrequency = at->onGrid() * (1.0 - at->distance);
        question.highestFrequency = at->onGrid() * (1.0 + at->distance);
        question.highestEnergy = at->energyRatio * (1.0 + at->distance);
    }
    return question;
}

AtlasAnswer AtlasCommand::ask(const AtlasDatabase& atlas, const std::vector<AtlasRun>& runs) const
{
    using answers::withUnits;
    AtlasAnswer answer{.bars = barsOf(runs), .period = period};
    answer.units = units(answer.bars);
    answer.near = point(answer.units);
    if (!answer.bars) {
        answer.bar = bar();
    }
    const AtlasSchedules which =
        given.has("--schedules") ? AtlasSchedules::all : AtlasSchedules::withoutFamily;
    if (given.has("--twins")) {
        answer.twins = withUnits(atlas.twins(common.cells), answer.units);
    } else if (period) {
        answer.families = withUnits(atlas.familiesOfPeriod(*period, common.cells), answer.units);
        answer.schedules =
            withUnits(atlas.schedulesOfPeriod(*period, common.cells, which), answer.units);
    } else if (const auto& at = answer.near) {
        const double w = at->onGrid();
        const auto& [ratio, energy, distance, unit] = *at;
        answer.families =
            withUnits(atlas.familiesNear(w, energy, distance, common.cells), unit, energy);
        answer.schedules =
            withUnits(atlas.schedulesNear(w, energy, distance, common.cells, which), unit);
    }
    return answer;
}

void AtlasCommand::draw(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                        const AtlasAnswer& answer, Outputs& outputs) const
{
    const std::vector<AtlasRun> runs = atlas.runs();
    outputs.draw("--figure", [&] {
        FrequencyEnergyOptions options;
        options.bar = barsOf(runs) ? Bar() : bar();
        return frequencyEnergyFigure(atlas, cells, options);
    });
    outputs.draw("--map", [&] { return existenceFigure(atlas, cells); });
    if (hasFamilies(runs)) {
        outputs.put("--csv", writeAtlasCsv, atlas, cells, bar());
    } else {
        outputs.put("--csv", writeSchedulesCsv, units(barsOf(runs)),
                    [&](const auto& action) { forEachListed(atlas, cells, answer, action); });
    }
    outputs.commit();
}

ExitStatus AtlasCommand::answer() const
{
    Outputs drawing(given, {"--figure", "--map", "--csv"});
    AtlasAnswer answer;
    AtlasCoverage coverage;
    const AtlasDatabase atlas = forFile("--database", database, [&] {
        AtlasDatabase opened = AtlasDatabase::open(database);
        const std::vector<AtlasRun> runs = opened.runs();
        answer = ask(opened, runs);
        coverage = AtlasCoverage(question(answer.near), runs);
        return opened;
    });
    draw(atlas, common.cells, answer, drawing);
    const std::string gaps = coverage.gaps();
    answer.runs = coverage.runs();
    answer.isComplete = gaps.empty();
    if (!gaps.empty()) {
        common.say(gaps);
    }
    if (isQuery()) {
        answer.bars ? report(common, answer, *answer.bars, asText(answer)) : report(common, answer);
        return answer.isEmpty() && !coverage.isDecided() ? exitUndecided : exitFound;
    }
    return exitFound;
}

void AtlasCommand::fill(AtlasDatabase& atlas, AtlasRun& run, Ranks* ranks,
                        const AtlasOptions& options) const
{
    if (ranks != nullptr) {
        const std::unique_ptr<BatchSource> source =
            ranks->share(run.range, options.threads, options.cancel, run.nextBatch);
        fillAtlas(atlas, run, *source,
                  fmt::format("{} processes of {} threads", ranks->count(), options.threads),
                  options);
        return;
    }
    LocalBatches source(run.range, options.threads, options.cancel, run.nextBatch);
    if (source.threads() < options.threads) {
        common.say(fmt::format("{} of {} threads could start; they do the work", source.threads(),
                               options.threads));
    }
    fillAtlas(atlas, run, source, fmt::format("{} threads", source.threads()), options);
}

ExitStatus AtlasCommand::build(const AtlasRange& range, Ranks* ranks,
                               std::optional<Interrupt>& interrupt) const
{
    given.requireOnly(answers::asks::atlas);
    refuseIf(range.familiesOnly && given.has("--map"),
             "--map draws schedules, which --families-only leaves out: allowed one of them");
    AtlasOptions options;
    options.threads = common.threads;
    options.resume = given.has("--resume");
    options.options = optionsOf(range);
    if (!interrupt) {
        interrupt.emplace();
    }
    options.cancel = interrupt->cancel();
    if (ranks != nullptr && ranks->rank() != 0) {
        return ranks->serve(options.threads, options.cancel) ? exitFound : exitUndecided;
    }
    Outputs drawing(given, {"--figure", "--map", "--csv"});
    std::optional<Progress> progress(std::in_place, !common.quiet, "deciding", common.progressFile);
    options.progress = [&progress](const AtlasRun& run) {
        progress->show(fmt::format("{} schedules", run.tally.decided),
                       static_cast<double>(run.nextBatch), static_cast<double>(run.batches));
    };
    AtlasRun run;
    std::optional<AtlasDatabase> atlas;
    try {
        forFile("--database", database, [&] {
            atlas = AtlasDatabase::create(database, options.cancel);
            run = beginAtlas(*atlas, range, options);
            if (!run.isFinished()) {
                fill(*atlas, run, ranks, options);
            }
        });
    } catch (const FileError& error) {
        // Ctrl-C ends a wait for a database that others have locked.
        if (!isRequested(options.cancel)) {
            throw;
        }
        tell(fmt::format("signorini atlas: interrupted: {}\n", error.what()));
        return exitUndecided;
    }
    progress.reset();
    interrupt.reset();
    if (run.isFinished()) {
        draw(*atlas, range.cells, {}, drawing);
    }
    AtlasBuilt built{run, database, {}};
    if (range.bars) {
        built.several = answers::severalOf(*range.bars, networkOf(*range.bars));
        report(common, built, *range.bars, asText(built));
    } else {
        built.scene = common.scene();
        report(common, built);
    }
    if (!run.isFinished()) {
        common.say(
            fmt::format("interrupted after {} of {} batches; the same call with --resume continues",
                        run.nextBatch, run.batches));
        return exitUndecided;
    }
    return exitFound;
}

}  // namespace

ExitStatus runAtlas(const Given& given)
{
    return AtlasCommand(given).run();
}

}  // namespace signorini::cli
