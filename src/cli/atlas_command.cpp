#include "atlas_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "faults.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "ranks.hpp"
#include "signorini/atlas_figure.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double usualDistance = 0.01;
constexpr std::size_t shownRows = 20;

/// "7/2", "3.5" or "4" as an exact fraction. \throws std::invalid_argument.
PeriodFraction parsePeriod(const std::string& text)
{
    constexpr std::size_t mostDigits = 9;
    const auto refuse = [&text]() {
        Faults faults;
        faults.add("--period", text, "a fraction like 7/2 or a decimal number > 0 [L/c]",
                   "at most 9 digits a side");
        faults.throwIfAny();
    };
    const auto isWhole = [](std::string_view word) {
        return !word.empty() && word.size() <= mostDigits &&
               std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    PeriodFraction period;
    if (const std::size_t slash = text.find('/'); slash != std::string::npos) {
        if (!isWhole(text.substr(0, slash)) || !isWhole(text.substr(slash + 1))) {
            refuse();
        }
        period = {std::stoll(text.substr(0, slash)), std::stoll(text.substr(slash + 1))};
    } else {
        const std::size_t point = text.find('.');
        const std::string fraction = point == std::string::npos ? "" : text.substr(point + 1);
        const std::string digits = text.substr(0, point) + fraction;
        if (!isWhole(digits)) {
            refuse();
        }
        period.numerator = std::stoll(digits);
        for (std::size_t k = 0; k < fraction.size(); ++k) {
            period.denominator *= 10;
        }
    }
    if (period.numerator == 0 || period.denominator == 0) {
        refuse();
    }
    return period;
}

Json asJson(const AtlasEntry& entry)
{
    const AtlasRow& row = entry.row;
    Json phases = Json::array();
    for (const Phase& phase : entry.schedule.phases) {
        phases.push_back({phase.contact, phase.free});
    }
    Json json{
        {"cells", entry.schedule.cells},    {"schedule", phases},
        {"period", period(entry.schedule)}, {"frequency_ratio", frequencyRatio(entry.schedule)},
        {"status", name(row.status)},       {"reason", nullptr}};
    if (row.reason) {
        json["reason"] = name(*row.reason);
    }
    json["kernel_dimension"] = row.kernelDimension >= 0 ? Json(row.kernelDimension) : Json();
    if (row.status == Status::found) {
        json["kind"] = name(row.kind);
        json["dimension"] = row.dimension;
        json["contact"] = name(row.contact);
        json["canonical"] = row.isCanonical;
        json["energy_ratio_range"] = {
            row.energy.least, std::isfinite(row.energy.most) ? Json(row.energy.most) : Json()};
    }
    return json;
}

std::string asText(const AtlasEntry& entry)
{
    const AtlasRow& row = entry.row;
    std::string text =
        fmt::format("{:<34} T = {:<10.6g} ω/ω₁ = {:<9.6g} ", describe(entry.schedule),
                    period(entry.schedule), frequencyRatio(entry.schedule));
    if (row.status != Status::found) {
        return text + fmt::format("{}{}\n", name(row.status),
                                  row.reason ? fmt::format(", {}", name(*row.reason)) : "");
    }
    text += row.kind == SetKind::point ? fmt::format("E/E₁ = {:.8g}", row.energy.least)
                                       : fmt::format("E/E₁ = {:.8g} … {}", row.energy.least,
                                                     std::isfinite(row.energy.most)
                                                         ? fmt::format("{:.8g}", row.energy.most)
                                                         : std::string("unbounded or unknown"));
    return text + fmt::format(", {}, {} of dimension {}{}\n", name(row.contact), name(row.kind),
                              row.dimension, row.isCanonical ? ", canonical" : "");
}

std::string asText(const std::vector<AtlasEntry>& entries)
{
    std::string text =
        fmt::format("{} schedule{}\n", entries.size(), entries.size() == 1 ? "" : "s");
    for (std::size_t k = 0; k < entries.size() && k < shownRows; ++k) {
        text += asText(entries[k]);
    }
    if (entries.size() > shownRows) {
        text += fmt::format("… {} more; --format json lists all\n", entries.size() - shownRows);
    }
    return text;
}

std::string asText(const std::vector<Twins>& all)
{
    std::string text = fmt::format("{} group{} of different motions of equal T and E\n", all.size(),
                                   all.size() == 1 ? "" : "s");
    for (std::size_t k = 0; k < all.size() && k < shownRows; ++k) {
        const AtlasEntry& first = all[k].front();
        text += fmt::format("T = {:.6g}, E/E₁ = {:.8g}:", period(first.schedule),
                            first.row.energy.least);
        for (const AtlasEntry& entry : all[k]) {
            text += fmt::format("  {}", describe(entry.schedule));
        }
        text += "\n";
    }
    if (all.size() > shownRows) {
        text += fmt::format("… {} more; --format json lists all\n", all.size() - shownRows);
    }
    return text;
}

Json asJson(const AtlasRun& run, const std::string& database, double seconds)
{
    const AtlasTally& tally = run.tally;
    return {{"status", run.isFinished() ? "done" : "interrupted"},
            {"database", database},
            {"cells", run.range.cells},
            {"max_contact", run.range.maxContact},
            {"max_free", run.range.maxFree},
            {"phases", run.range.maxPhases},
            {"decided", tally.decided},
            {"found", tally.pressing + tally.grazing},
            {"pressing", tally.pressing},
            {"grazing", tally.grazing},
            {"refuted", tally.refuted},
            {"undecided", tally.undecided},
            {"batches", {run.nextBatch, run.batches}},
            {"seconds", seconds}};
}

std::string asText(const AtlasRun& run, const std::string& database, double seconds)
{
    const AtlasTally& tally = run.tally;
    return fmt::format(
        "{:<12}{}: N = {}, contact 1..{}, free 1..{}{}\n"
        "decided     {} schedules in {:.3g} s\n"
        "found       {}: {} pressing, {} grazing\n"
        "none        {}{}\n",
        run.isFinished() ? "done" : "interrupted", database, run.range.cells, run.range.maxContact,
        run.range.maxFree,
        run.range.maxPhases > 1 ? fmt::format(", 1..{} phases", run.range.maxPhases) : "",
        tally.decided, seconds, tally.pressing + tally.grazing, tally.pressing, tally.grazing,
        tally.refuted, tally.undecided > 0 ? fmt::format("\nundecided   {}", tally.undecided) : "");
}

}  // namespace

void AtlasCommand::addTo(CLI::App& command)
{
    command.add_option("--database", database, "the atlas, made if it does not exist; required")
        ->type_name("FILE.sqlite");
    command.add_option("--max-contact", maxContact, "contact steps 1..NC (2N)")->type_name("NC");
    command.add_option("--max-free", maxFree, "free steps 1..NF (4N)")->type_name("NF");
    command.add_option("--phases", phases, "schedules of 1..K contact phases (1)")->type_name("K");
    command
        .add_option("--max-energy-ratio", maxEnergyRatio,
                    "keep schedules with motions of E <= X E_1 (all)")
        ->type_name("X");
    command.add_flag("--all", all, "keep the refuted schedules, too");
    command.add_flag("--resume", resume, "go on with an interrupted run");
    command.add_option("--near", near, "ask: all schedules with motions near omega/omega_1, E/E_1")
        ->type_name("W E")
        ->expected(2);
    command.add_option("--within", within, "how near, relative (0.01)")->type_name("X");
    command.add_option("--period", period, "ask: all schedules of this period, as 7/2 or 3.5")
        ->type_name("T");
    command.add_flag("--twins", twins, "ask: different motions of equal period and energy");
    command.add_option("--figure", figureFile, "draw the frequency-energy plot (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    command.add_option("--map", mapFile, "draw the existence map over contact and flight times")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
}

bool AtlasCommand::isQuery() const
{
    return !near.empty() || !period.empty() || twins;
}

AtlasRange AtlasCommand::parseRange() const
{
    AtlasRange range = usualRange(common.parseCells());
    const auto whole = [](const char* name, const std::string& text, std::int64_t& value,
                          std::int64_t most) {
        value = text.empty() ? value : parseWhole(name, text, 1, most);
    };
    whole("--max-contact", maxContact, range.maxContact, maxSteps / (2 * maxAtlasPhases));
    whole("--max-free", maxFree, range.maxFree, maxSteps / (2 * maxAtlasPhases));
    whole("--phases", phases, range.maxPhases, maxAtlasPhases);
    if (!maxEnergyRatio.empty()) {
        range.maxEnergyRatio = parsePositive("--max-energy-ratio", maxEnergyRatio, "E_1");
    }
    range.keepsRefuted = all;
    validate(range);
    return range;
}

ExitStatus AtlasCommand::run() const
{
    if (database.empty()) {
        throw std::invalid_argument("--database is missing: allowed the name of an SQLite file");
    }
    (void)common.parseBar();
    for (const std::string& figure : {figureFile, mapFile}) {
        if (!figure.empty()) {
            (void)figureFormat(figure);
        }
    }
    validateOutputs({{"--database", database}, {"--figure", figureFile}, {"--map", mapFile}});
    return isQuery() ? answer() : build();
}

void AtlasCommand::draw(const AtlasDatabase& atlas) const
{
    const std::optional<std::int64_t> cells =
        common.cells.empty() && isQuery() ? std::nullopt
                                          : std::optional<std::int64_t>(common.parseCells());
    const OutputOption figureOption{"--figure", figureFile};
    const OutputOption mapOption{"--map", mapFile};
    OutputFiles files;
    const std::string figure = stage(files, figureOption);
    const std::string map = stage(files, mapOption);
    if (!figure.empty()) {
        forFile("--figure", figureFile,
                [&] { drawFrequencyEnergyPlot(atlas, cells, figureFormat(figureFile), figure); });
    }
    if (!map.empty()) {
        forFile("--map", mapFile,
                [&] { drawExistenceMap(atlas, cells, figureFormat(mapFile), map); });
    }
    files.commit();
}

ExitStatus AtlasCommand::answer() const
{
    const bool json = common.wantsJson();
    (void)common.parseThreads();
    const int queries = (near.empty() ? 0 : 1) + (period.empty() ? 0 : 1) + (twins ? 1 : 0);
    if (queries > 1) {
        throw std::invalid_argument("--near, --period, --twins: allowed one of them");
    }
    if (!maxContact.empty() || !maxFree.empty() || !phases.empty() || !maxEnergyRatio.empty() ||
        all || resume) {
        throw std::invalid_argument(
            "--near, --period and --twins ask a database and clash with --max-contact, --max-free, "
            "--phases, --max-energy-ratio, --all and --resume, which make one");
    }
    if (!within.empty() && near.empty()) {
        throw std::invalid_argument("--within: allowed only together with --near");
    }
    const std::optional<std::int64_t> cells =
        common.cells.empty() ? std::nullopt : std::optional<std::int64_t>(common.parseCells());
    const double distance = within.empty() ? usualDistance : parsePositive("--within", within, "-");
    std::optional<PeriodFraction> fraction;
    std::array<double, 2> point{};
    if (!period.empty()) {
        fraction = parsePeriod(period);
    } else if (!near.empty()) {
        point = {parsePositive("--near W", near[0], "omega_1"),
                 parsePositive("--near E", near[1], "E_1")};
    }

    forFile("--database", database, [&] {
        const AtlasDatabase atlas = AtlasDatabase::open(database);
        if (twins) {
            const std::vector<Twins> groups = atlas.twins(cells);
            Json list = Json::array();
            for (const Twins& group : groups) {
                Json entries = Json::array();
                for (const AtlasEntry& entry : group) {
                    entries.push_back(asJson(entry));
                }
                list.push_back({{"period", signorini::period(group.front().schedule)},
                                {"energy_ratio", group.front().row.energy.least},
                                {"schedules", entries}});
            }
            writeOut(json ? Json{{"twins", list}}.dump() + "\n" : asText(groups));
        } else {
            const std::vector<AtlasEntry> entries =
                fraction ? atlas.ofPeriod(*fraction, cells)
                         : atlas.near(point[0], point[1], distance, cells);
            Json list = Json::array();
            for (const AtlasEntry& entry : entries) {
                list.push_back(asJson(entry));
            }
            writeOut(json ? Json{{"schedules", list}}.dump() + "\n" : asText(entries));
        }
        draw(atlas);
    });
    return exitFound;
}

ExitStatus AtlasCommand::build() const
{
    const bool json = common.wantsJson();
    const AtlasRange range = parseRange();
    AtlasOptions options;
    options.threads = common.parseThreads();
    options.resume = resume;
    if (!within.empty()) {
        throw std::invalid_argument("--within: allowed only together with --near");
    }
    options.options = fmt::format("--cells {} --max-contact {} --max-free {} --phases {}{}{}",
                                  range.cells, range.maxContact, range.maxFree, range.maxPhases,
                                  std::isfinite(range.maxEnergyRatio)
                                      ? fmt::format(" --max-energy-ratio {}", range.maxEnergyRatio)
                                      : "",
                                  range.keepsRefuted ? " --all" : "");

    std::optional<Interrupt> interrupt(std::in_place);
    options.cancel = interrupt->token();
    std::unique_ptr<Ranks> ranks;
    if (Ranks::areLaunched()) {
        ranks = std::make_unique<Ranks>();
        if (ranks->rank() != 0) {
            return ranks->serve(range, options.threads, options.cancel) ? exitFound : exitUndecided;
        }
    }
    Progress progress(!common.quiet);
    options.progress = [&progress](const AtlasRun& run) {
        progress.show("schedules", static_cast<double>(run.tally.decided),
                      static_cast<double>(numbersOf(run.range)));
    };
    return forFile("--database", database, [&] {
        AtlasDatabase atlas = AtlasDatabase::create(database);
        AtlasRun run = beginAtlas(atlas, range, options);
        const double before = run.seconds;
        if (!run.isFinished()) {
            const std::unique_ptr<BatchSource> source =
                ranks ? ranks->share(range, options.threads, options.cancel, run.nextBatch)
                      : std::make_unique<LocalBatches>(range, options.threads, options.cancel,
                                                       run.nextBatch);
            const int count = ranks ? ranks->count() : 1;
            fillAtlas(atlas, run, *source,
                      fmt::format("{} processes of {} threads", count, options.threads), options);
        }
        const double seconds = run.seconds - before;
        writeOut(json ? asJson(run, database, seconds).dump() + "\n"
                      : asText(run, database, seconds));
        if (!run.isFinished()) {
            if (!common.quiet) {
                fmt::print(stderr,
                           "signorini atlas: interrupted after {} of {} batches; the same call "
                           "with --resume goes on\n",
                           run.nextBatch, run.batches);
            }
            return exitUndecided;
        }
        draw(atlas);
        return exitFound;
    });
}

}  // namespace signorini::cli
