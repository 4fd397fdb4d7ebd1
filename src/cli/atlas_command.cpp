#include "atlas_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "atlas_report.hpp"
#include "faults.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "ranks.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

constexpr double usualDistance = 0.01;

}  // namespace

void AtlasCommand::addTo(CLI::App& command)
{
    command.add_option("--database", database, "the atlas, made if it does not exist; required")
        ->type_name("FILE.sqlite");
    constexpr std::int64_t maxEach = maxSteps / (2 * maxAtlasPhases);
    addWhole(command, "--max-contact", 1, maxEach, maxContact, "NC", "contact steps 1..NC (2N)");
    addWhole(command, "--max-free", 1, maxEach, maxFree, "NF", "free steps 1..NF (4N)");
    addWhole(command, "--phases", 1, maxAtlasPhases, phases, "K",
             "schedules of 1..K contact phases (1)");
    addPositive(command, "--max-energy-ratio", "E_1", maxEnergyRatio, "X",
                "keep schedules with motions of E <= X E_1 (all)");
    command.add_flag("--all", all, "keep the refuted schedules, too");
    command.add_flag("--resume", resume, "go on with an interrupted run");
    command.add_option("--near", near, "ask: all schedules with motions near omega/omega_1, E/E_1")
        ->type_name("W E")
        ->expected(1, 2);
    addPositive(command, "--within", "-", within, "X", "how near, relative (0.01)");
    addWord(command, "--period", "T", "ask: all schedules of this period, as 7/2 or 3.5",
            [this](const std::string& text) { period = parseFraction("--period", text, "L/c"); });
    command.add_flag("--twins", twins, "ask: different motions of equal period and energy");
    command.add_option("--figure", figureFile, "draw the frequency-energy plot (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    command.add_option("--map", mapFile, "draw the existence map over contact and flight times")
        ->type_name("FILE.svg|.png|.pdf");
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
    validate(range);
    return range;
}

bool AtlasCommand::namesRange() const
{
    return common.cells || makesRange();
}

bool AtlasCommand::makesRange() const
{
    return maxContact || maxFree || phases || maxEnergyRatio || all || resume;
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
        (void)common.bar();
        for (const std::string& figure : {figureFile, mapFile}) {
            if (!figure.empty()) {
                (void)figureFormat(figure);
            }
        }
        validateOutputs({{"--database", database}, {"--figure", figureFile}, {"--map", mapFile}});
        // A picture of an atlas that exists needs no range.
        const bool draws = (!figureFile.empty() || !mapFile.empty()) && !namesRange() &&
                           std::filesystem::exists(database);
        if (isQuery() || draws) {
            const Query question = query();
            return !ranks || ranks->rank() == 0 ? answer(question) : exitFound;
        }
        return build(range(), ranks.get(), interrupt);
    } catch (const std::invalid_argument&) {
        if (ranks && ranks->rank() != 0) {
            return exitWrongUse;
        }
        throw;
    }
}

AtlasCommand::Query AtlasCommand::query() const
{
    const int queries = (near.empty() ? 0 : 1) + (period ? 1 : 0) + (twins ? 1 : 0);
    if (queries > 1) {
        throw std::invalid_argument("--near, --period, --twins: allowed one of them");
    }
    if (makesRange()) {
        throw std::invalid_argument(
            "--near, --period and --twins ask a database and clash with --max-contact, --max-free, "
            "--phases, --max-energy-ratio, --all and --resume, which make one");
    }
    if (within && near.empty()) {
        throw std::invalid_argument("--within: allowed only together with --near");
    }
    Query query;
    query.bar = common.bar();
    query.cells = common.cells;
    query.period = period;
    if (!near.empty()) {
        if (near.size() != 2) {
            refuse("--near", near[0], "two numbers, omega/omega_1 > 0 and E/E_1 > 0");
        }
        query.distance = within.value_or(usualDistance);
        query.point = {parsePositive("--near W", near[0], "omega_1"),
                       parsePositive("--near E", near[1], "E_1")};
    }
    return query;
}

void AtlasCommand::stagePictures(Pictures& pictures) const
{
    pictures.figure = stage(pictures.files, {"--figure", figureFile});
    pictures.map = stage(pictures.files, {"--map", mapFile});
}

void AtlasCommand::draw(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                        Pictures& pictures) const
{
    if (!pictures.figure.empty()) {
        forFile("--figure", figureFile, [&] {
            drawFrequencyEnergyPlot(atlas, cells, figureFormat(figureFile), pictures.figure);
        });
    }
    if (!pictures.map.empty()) {
        forFile("--map", mapFile,
                [&] { drawExistenceMap(atlas, cells, figureFormat(mapFile), pictures.map); });
    }
    pictures.files.commit();
}

ExitStatus AtlasCommand::answer(const Query& query) const
{
    Pictures pictures;
    stagePictures(pictures);
    AtlasAnswer answer;
    answer.isTwins = twins;
    answer.bar = query.bar;
    if (query.period) {
        answer.shortestPeriod = query.period->value();
    } else if (query.point) {
        const auto [frequencyRatio, energyRatio] = *query.point;
        answer.shortestPeriod = 4.0 / (frequencyRatio * (1.0 + query.distance));
        answer.energyRatio = energyRatio * (1.0 + query.distance);
    }
    const AtlasDatabase atlas = forFile("--database", database, [&] {
        AtlasDatabase opened = AtlasDatabase::open(database);
        for (const AtlasRun& run : opened.runs()) {
            if (!query.cells || run.range.cells == *query.cells) {
                answer.coverage.push_back(run);
            }
        }
        if (twins) {
            answer.groups = opened.twins(query.cells);
        } else if (query.period) {
            answer.entries = opened.ofPeriod(*query.period, query.cells);
        } else if (query.point) {
            answer.entries =
                opened.near((*query.point)[0], (*query.point)[1], query.distance, query.cells);
        }
        return opened;
    });
    draw(atlas, query.cells, pictures);
    const std::string gaps = gapsOf(answer);
    if (!gaps.empty() && !common.quiet) {
        tell(fmt::format("signorini atlas: {}\n", gaps));
    }
    if (isQuery()) {
        writeOut(common.wantsJson ? asJson(answer, gaps.empty()) : asText(answer));
        return answer.isUndecided() ? exitUndecided : exitFound;
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
    const Bar bar = common.bar();
    AtlasOptions options;
    options.threads = common.threads;
    options.resume = resume;
    options.options = fmt::format("--cells {} --max-contact {} --max-free {} --phases {}{}{}",
                                  range.cells, range.maxContact, range.maxFree, range.maxPhases,
                                  std::isfinite(range.maxEnergyRatio)
                                      ? fmt::format(" --max-energy-ratio {}", range.maxEnergyRatio)
                                      : "",
                                  range.keepsRefuted ? " --all" : "");
    if (!interrupt) {
        interrupt.emplace();
    }
    options.cancel = interrupt->cancel();
    if (ranks != nullptr && ranks->rank() != 0) {
        return ranks->serve(options.threads, options.cancel) ? exitFound : exitUndecided;
    }
    Pictures pictures;
    stagePictures(pictures);
    std::optional<Progress> progress(std::in_place, !common.quiet, "deciding");
    options.progress = [&progress](const AtlasRun& run) {
        progress->show(fmt::format("{} schedules", run.tally.decided),
                       static_cast<double>(firstNumberOf(run.range, run.nextBatch)),
                       static_cast<double>(numbersOf(run.range)));
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
        draw(*atlas, range.cells, pictures);
    }
    writeOut(common.wantsJson ? asJson(run, database, bar) : asText(run, database));
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
