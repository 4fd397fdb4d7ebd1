#include "atlas_command.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "faults.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "ranks.hpp"
#include "segments_text.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

namespace {

/// Finer than the periods of a grid up to N = 280, so that one of its frequencies is meant.
constexpr double usualDistance = 0.001;

/// "8/7" or any number.
double parseRatio(const char* name, const std::string& text, const char* unit)
{
    return text.find('/') == std::string::npos ? parsePositive(name, text, unit)
                                               : parseFraction(name, text, unit).value();
}

}  // namespace

void AtlasCommand::addTo(CLI::App& command)
{
    addFile(command, "--database", database, "the atlas, created if it does not exist; required",
            "FILE.sqlite");
    constexpr std::int64_t maxEach = maxSteps / (2 * maxAtlasPhases);
    addWhole(command, "--max-contact", 1, maxEach, maxContact, "NC", "contact steps 1..NC (2N)");
    addWhole(command, "--max-free", 1, maxEach, maxFree, "NF", "free steps 1..NF (4N)");
    addWhole(command, "--phases", 1, maxAtlasPhases, phases, "K",
             "schedules of 1..K contact phases (1)");
    addPositive(command, "--max-energy-ratio", "E_1", maxEnergyRatio, "X",
                "keep schedules with motions of E <= X E_1 (all)");
    addFlag(command, "--all", all, "also store the refuted schedules");
    addFlag(command, "--families-only", familiesOnly, "store families only, no schedules");
    addFlag(command, "--resume", resume, "continue an interrupted run");
    addWords(command, "--near", "W E", near,
             "query: families with motions near omega/omega_1, E/E_1", 2);
    addPositive(command, "--within", "-", within, "X", "how near, relative (0.001)");
    addWord(command, "--period", "T", "query: families of this period, as 7/2 or 3.5 [L/c]",
            [this](const std::string& text) { period = parseFraction("--period", text, "L/c"); });
    addFlag(command, "--twins", twins, "query: different orbits of equal period and energy");
    addFlag(command, "--schedules", schedules, "list the schedules of families as well");
    addFigure(command, "--figure", figureFile, "draw the frequency-energy plot");
    addFigure(command, "--map", mapFile, "draw the existence map over contact and flight times");
    addFile(command, "--csv", csvFile, "write the families, the bars of the plot, as a table");
    common.addTo(command);
}

bool AtlasCommand::isQuery() const
{
    return !near.empty() || period || twins;
}

AtlasRange AtlasCommand::range() const
{
    AtlasRange range = usualRange(common.usualCells());
    range.maxContact = maxContact.value_or(range.maxContact);
    range.maxFree = maxFree.value_or(range.maxFree);
    range.maxPhases = phases.value_or(range.maxPhases);
    range.maxEnergyRatio = maxEnergyRatio.value_or(range.maxEnergyRatio);
    range.keepsRefuted = all;
    range.familiesOnly = familiesOnly;
    const Stops stops = stopsOf(common.scene());
    range.gapSign = stops.right;
    range.secondStop = stops.left;
    range.segments = segments();
    if (all && familiesOnly) {
        throw std::invalid_argument("--all, --families-only: allowed one of them");
    }
    validate(range);
    return range;
}

std::vector<Segment> AtlasCommand::segments() const
{
    const Scene scene = common.scene();
    if (isUniform(scene.segments)) {
        return {};
    }
    if (scene.secondStop) {
        throw std::invalid_argument("--second-stop: allowed for a uniform bar");
    }
    return scene.segments;
}

Bar AtlasCommand::bar() const
{
    return firstMaterial({common.scene().bar, std::nullopt, segments()});
}

bool AtlasCommand::namesRange() const
{
    return common.cells || makesRange();
}

bool AtlasCommand::makesRange() const
{
    return maxContact || maxFree || phases || maxEnergyRatio || all || familiesOnly || resume;
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
        if (database.empty()) {
            throw std::invalid_argument(
                "--database is missing: allowed the name of an SQLite file");
        }
        if (stopsOf(common.scene()) != Stops{} && !figureFile.empty()) {
            throw std::invalid_argument(
                "--figure: allowed with a gap > 0 and one stop, whose plot it is; --csv holds the "
                "families");
        }
        if (!segments().empty() && !(figureFile.empty() && csvFile.empty())) {
            throw std::invalid_argument(
                "--figure, --csv: allowed for a uniform bar, whose families they show");
        }
        std::vector<OutputOption> written = outputs();
        written.insert(written.begin(), {"--database", database});
        validateOutputs(written);
        // A picture of an atlas that exists needs no range.
        const bool draws = (!figureFile.empty() || !mapFile.empty() || !csvFile.empty()) &&
                           !namesRange() && std::filesystem::exists(database);
        if (isQuery() || draws) {
            checkQuery();
            return !ranks || ranks->rank() == 0 ? answer() : exitFound;
        }
        return build(range(), ranks.get(), interrupt);
    } catch (const std::invalid_argument&) {
        if (ranks && ranks->rank() != 0) {
            return exitWrongUse;
        }
        throw;
    }
}

void AtlasCommand::checkQuery() const
{
    const int queries = (near.empty() ? 0 : 1) + (period ? 1 : 0) + (twins ? 1 : 0);
    if (queries > 1) {
        throw std::invalid_argument("--near, --period, --twins: allowed one of them");
    }
    if (makesRange()) {
        throw std::invalid_argument(
            "--near, --period and --twins ask a database and clash with --max-contact, --max-free, "
            "--phases, --max-energy-ratio, --all, --families-only and --resume, which make one");
    }
    if (within && near.empty()) {
        throw std::invalid_argument("--within: allowed only together with --near");
    }
    if (schedules && near.empty() && !period) {
        throw std::invalid_argument("--schedules: allowed only together with --near or --period");
    }
    (void)point();
}

std::optional<answers::AtlasPoint> AtlasCommand::point() const
{
    if (near.empty()) {
        return std::nullopt;
    }
    if (near.size() != 2) {
        refuse("--near", near[0], "two numbers, omega/omega_1 > 0 and E/E_1 > 0");
    }
    return answers::AtlasPoint{.frequencyRatio = parseRatio("--near W", near[0], "omega_1"),
                               .energyRatio = parsePositive("--near E", near[1], "E_1"),
                               .distance = within.value_or(usualDistance),
                               .bar = bar()};
}

AtlasQuestion AtlasCommand::question() const
{
    AtlasQuestion question{.cells = common.cells, .period = period, .wantsSchedules = schedules};
    if (const auto at = point()) {
        question.lowestFrequency = at->frequencyRatio * (1.0 - at->distance);
        question.highestFrequency = at->frequencyRatio * (1.0 + at->distance);
        question.highestEnergy = at->energyRatio * (1.0 + at->distance);
    }
    return question;
}

AtlasAnswer AtlasCommand::ask(const AtlasDatabase& atlas) const
{
    using answers::withUnits;
    AtlasAnswer answer{.bar = bar(), .near = point()};
    const AtlasSchedules which = schedules ? AtlasSchedules::all : AtlasSchedules::withoutFamily;
    if (twins) {
        answer.twins = withUnits(atlas.twins(common.cells), answer.bar);
    } else if (period) {
        answer.families = withUnits(atlas.familiesOfPeriod(*period, common.cells), answer.bar);
        answer.schedules =
            withUnits(atlas.schedulesOfPeriod(*period, common.cells, which), answer.bar);
    } else if (const auto& at = answer.near) {
        const auto [w, energy, distance, unit] = *at;
        answer.families =
            withUnits(atlas.familiesNear(w, energy, distance, common.cells), unit, energy);
        answer.schedules =
            withUnits(atlas.schedulesNear(w, energy, distance, common.cells, which), unit);
    }
    return answer;
}

std::vector<OutputOption> AtlasCommand::outputs() const
{
    return {{"--figure", figureFile}, {"--map", mapFile}, {"--csv", csvFile}};
}

void AtlasCommand::draw(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                        Outputs& outputs) const
{
    const std::vector<AtlasRun> runs = atlas.runs();
    if (!(figureFile.empty() && csvFile.empty()) &&
        std::any_of(runs.begin(), runs.end(),
                    [](const AtlasRun& run) { return !run.range.segments.empty(); })) {
        throw std::invalid_argument(
            "--figure, --csv: allowed for the atlas of a uniform bar, whose families they show");
    }
    outputs.put("--figure", [&](const std::string& path) {
        drawFigure(frequencyEnergyFigure(atlas, cells, {.maxFrequencyRatio = {}, .bar = bar()}),
                   figureFormat(figureFile), path);
    });
    outputs.put("--map", [&](const std::string& path) {
        drawFigure(existenceFigure(atlas, cells), figureFormat(mapFile), path);
    });
    outputs.put("--csv",
                [&](const std::string& path) { writeAtlasCsv(path, atlas, cells, bar()); });
    outputs.commit();
}

ExitStatus AtlasCommand::answer() const
{
    Outputs drawing(outputs());
    AtlasAnswer answer;
    AtlasCoverage coverage;
    const AtlasDatabase atlas = forFile("--database", database, [&] {
        AtlasDatabase opened = AtlasDatabase::open(database);
        coverage = AtlasCoverage(question(), opened.runs());
        answer = ask(opened);
        return opened;
    });
    draw(atlas, common.cells, drawing);
    const std::string gaps = coverage.gaps();
    answer.runs = coverage.runs();
    answer.isComplete = gaps.empty();
    if (!gaps.empty() && !common.quiet) {
        tell(fmt::format("signorini atlas: {}\n", gaps));
    }
    if (isQuery()) {
        writeOut(common.wantsJson ? asJson(answer) : common.restated() + asText(answer));
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
    if (source.threads() < options.threads && !common.quiet) {
        tell(fmt::format("signorini atlas: {} of {} threads could start; they do the work\n",
                         source.threads(), options.threads));
    }
    fillAtlas(atlas, run, source, fmt::format("{} threads", source.threads()), options);
}

ExitStatus AtlasCommand::build(const AtlasRange& range, Ranks* ranks,
                               std::optional<Interrupt>& interrupt) const
{
    if (within) {
        throw std::invalid_argument("--within: allowed only together with --near");
    }
    if (schedules) {
        throw std::invalid_argument("--schedules: allowed only together with --near or --period");
    }
    if (familiesOnly && !mapFile.empty()) {
        throw std::invalid_argument(
            "--map draws schedules, which --families-only leaves out: allowed one of them");
    }
    AtlasOptions options;
    options.threads = common.threads;
    options.resume = resume;
    options.options =
        fmt::format("--cells {} --max-contact {} --max-free {} --phases {}{}{}{}", range.cells,
                    range.maxContact, range.maxFree, range.maxPhases,
                    std::isfinite(range.maxEnergyRatio)
                        ? fmt::format(" --max-energy-ratio {}", range.maxEnergyRatio)
                        : "",
                    range.keepsRefuted ? " --all" : "",
                    range.familiesOnly ? " --families-only" : "") +
        (range.gapSign < 0    ? " --gap < 0"
         : range.gapSign == 0 ? " --gap 0"
                              : "") +
        (range.secondStop ? fmt::format(" --second-stop {}/{} units", range.secondStop->numerator,
                                        range.secondStop->denominator)
                          : "") +
        (range.segments.empty() ? "" : fmt::format(" --segments {}", textOf(range.segments)));
    if (!interrupt) {
        interrupt.emplace();
    }
    options.cancel = interrupt->cancel();
    if (ranks != nullptr && ranks->rank() != 0) {
        return ranks->serve(options.threads, options.cancel) ? exitFound : exitUndecided;
    }
    Outputs drawing(outputs());
    std::optional<Progress> progress(std::in_place, !common.quiet, "deciding");
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
        draw(*atlas, range.cells, drawing);
    }
    const AtlasBuilt built{run, database, common.scene()};
    writeOut(common.wantsJson ? asJson(built) : common.restated() + asText(built));
    if (!run.isFinished()) {
        if (!common.quiet) {
            tell(
                fmt::format("signorini atlas: interrupted after {} of {} batches; the same call "
                            "with --resume goes on\n",
                            run.nextBatch, run.batches));
        }
        return exitUndecided;
    }
    return exitFound;
}

}  // namespace signorini::cli
