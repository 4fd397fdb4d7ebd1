#include "mode_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>

#include "files.hpp"
#include "mode_words.hpp"
#include "rational.hpp"
#include "report.hpp"
#include "signorini/families.hpp"
#include "signorini/figures.hpp"
#include "signorini/find_periodic.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

Mode modeOf(const std::vector<std::string>& words)
{
    if (words.size() != 2) {
        throw std::invalid_argument(
            "mode needs two numbers A4 B: the contact time A4 + B T in L/c, as signorini modes "
            "lists them");
    }
    const std::int64_t a4 = parseWhole("A4", words[0], 4, 4 * maxFamilyOrder);
    const std::int64_t b = parseWhole("B", words[1], -maxFamilyOrder, -1);
    const std::optional<Mode> mode = a4 % 4 == 0 ? findMode(a4 / 4, b) : std::nullopt;
    if (!mode) {
        refuse("A4 B", fmt::format("{} {}", a4, b),
               "multiples of 4 and negative odd numbers that signorini modes lists: there is no "
               "other mode");
    }
    return *mode;
}

Rational asRational(const ExactPeriod& period)
{
    return Rational(period.numerator) / period.denominator;
}

/// An end of the interval is no member.
void requireInside(const Mode& mode, const GivenNumber& period)
{
    const Rational asked = period.exact ? asRational(*period.exact) : Rational(period.value);
    if (!(asRational(mode.lowest) < asked && asked < asRational(mode.highest))) {
        refuse("--period",
               period.exact ? fractionAsText(*period.exact) : fmt::format("{}", period.value),
               fmt::format("]{}, {}[ [L/c], where the mode t_c = {} lives",
                           fractionAsText(mode.lowest), fractionAsText(mode.highest),
                           contactAsText(mode)));
    }
}

/// n where n steps of a grid are exactly the period.
std::optional<std::int64_t> stepsOn(std::int64_t cells, const GivenNumber& period)
{
    if (!period.exact || cells % period.exact->denominator != 0) {
        return std::nullopt;
    }
    return cells / period.exact->denominator * period.exact->numerator;
}

std::string reportAsJson(const Mode& mode, const ModeMotion& motion, const Bar& bar)
{
    const Scales unit = scales(bar);
    const double energy = energyRatio(mode, motion.period());
    const Physical physical = physicalOf(motion.extremes(), bar);
    Json list = Json::array();
    for (const ModeJump& jump : jumps(mode)) {
        list.push_back({2 * jump.k, -jump.turns});
    }
    Json json = newAnswer();
    json.update(Json{{"status", name(Status::found)},
                     {"bar", barAsJson(bar)},
                     {"mode", identityAsJson(mode)},
                     {"period", motion.period() * unit.time},
                     {"period_ratio", motion.period()},
                     {"frequency", 1.0 / (motion.period() * unit.time)},
                     {"frequency_ratio", 4.0 / motion.period()},
                     {"contact_time", motion.contactTime() * unit.time},
                     {"contact_time_ratio", motion.contactTime()},
                     {"energy", energy * unit.energy},
                     {"energy_ratio", energy},
                     {"jumps", list},
                     {"physical", physicalAsJson(physical)},
                     {"admissible", physical.isAdmissible()}});
    return asLine(json);
}

std::string reportAsText(const Mode& mode, const ModeMotion& motion, const Bar& bar)
{
    const Scales unit = scales(bar);
    const std::string family = familyName(mode);
    const double energy = energyRatio(mode, motion.period());
    return fmt::format(
               "found       mode t_c = {}{}, T in ]{}, {}[ L/c\n"
               "period      {:.10g} s = {:.10g} L/c, ω/ω₁ = {:.10g}\n"
               "contact     {:.6g} s = {:.10g} L/c\n"
               "energy      {:.6g} J = {:.10g} E₁, 1/√(E/E₁) = {}\n"
               "waves       p = ±{:.6g} g/L with {} jumps in a period\n",
               contactAsText(mode), family.empty() ? "" : fmt::format(" ({})", family),
               fractionAsText(mode.lowest), fractionAsText(mode.highest),
               motion.period() * unit.time, motion.period(), 4.0 / motion.period(),
               motion.contactTime() * unit.time, motion.contactTime(), energy * unit.energy, energy,
               rootAsText(mode), motion.amplitude(), motion.jumpTimes().size()) +
           asText(physicalOf(motion.extremes(), bar));
}

/// The period of at most so many cells that is nearest to the one asked for, as a schedule.
Schedule nearestSchedule(const Mode& mode, double period, std::int64_t usual)
{
    constexpr std::int64_t finest = 1000;
    Schedule best;
    double distance = std::numeric_limits<double>::infinity();
    const auto consider = [&](std::int64_t cells) {
        const auto steps = std::llround(period * static_cast<double>(cells));
        const double off =
            std::abs(static_cast<double>(steps) / static_cast<double>(cells) - period);
        const Rational place = Rational(steps) / cells;
        if (off < distance && asRational(mode.lowest) < place && place < asRational(mode.highest)) {
            best = scheduleOf(mode, cells, steps);
            distance = off;
        }
    };
    consider(std::min(usual, finest));  // the user's own grid, if no other is nearer
    for (std::int64_t cells = 1; cells <= finest; ++cells) {
        consider(cells);
    }
    return best;
}

}  // namespace

void ModeCommand::addTo(CLI::App& command)
{
    command.add_option("contact", contact, "the mode of contact time A4 + B T, e.g. 4 -1")
        ->type_name("A4 B");
    addWord(command, "--period", "T", "in L/c: 3.14, 22/7 or 3; required",
            [this](const std::string& text) { period = parseNumber("--period", text, "L/c"); });
    command.add_option("--state", stateFile, "write the state at t = 0 on the grid")
        ->type_name("FILE.csv");
    motionFile.addTo(command);
    command.add_option("--figure", figureFile, "draw the motion (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
}

ExitStatus ModeCommand::run() const
{
    const Mode mode = modeOf(contact);
    if (!period) {
        throw std::invalid_argument(fmt::format(
            "--period is missing: allowed ]{}, {}[ [L/c], where the mode t_c = {} lives",
            fractionAsText(mode.lowest), fractionAsText(mode.highest), contactAsText(mode)));
    }
    requireInside(mode, *period);
    const Bar bar = common.bar();
    const ModeMotion motion(mode, period->value);
    if (!figureFile.empty()) {
        (void)figureFormat(figureFile);
    }
    motionFile.validate();
    const OutputOption stateOption{"--state", stateFile};
    const OutputOption figureOption{"--figure", figureFile};
    validateOutputs({stateOption, motionFile.option(), figureOption});

    OutputFiles files;
    const std::string state = stage(files, stateOption);
    MotionFile::Staged moving(motionFile, files);
    const std::string figure = stage(files, figureOption);
    const std::int64_t cells = common.usualCells();
    std::string notes;
    if (!state.empty()) {
        const std::optional<std::int64_t> steps = stepsOn(cells, *period);
        forFile("--state", stateFile, [&] {
            writeStateCsv(state,
                          steps ? leastEnergyMotion(onePhaseSet(scheduleOf(mode, cells, *steps)))
                                : cellMeans(motion, cells),
                          bar);
        });
        notes += steps
                     ? fmt::format("state       exact: T is {} steps of {} cells\n", *steps, cells)
                     : fmt::format(
                           "state       means over {} cells: T is no whole number of steps "
                           "there\n",
                           cells);
    }
    if (!figure.empty()) {
        const Schedule schedule = nearestSchedule(mode, motion.period(), cells);
        FindOptions options;
        options.bar = bar;
        forFile("--figure", figureFile, [&] {
            drawMotion(findPeriodic(schedule, options), figureFormat(figureFile), figure);
        });
        const double shown = signorini::period(schedule);
        if (shown != motion.period()) {
            notes +=
                fmt::format("figure      shows T = {:.10g} L/c, {:.1e} from the one asked for\n",
                            shown, std::abs(shown - motion.period()));
        }
    }
    moving.write([&](std::int64_t most) { return MotionSamples(motion, bar, cells, most); });
    files.commit();
    if (!common.quiet) {
        warnUnlessAdmissible("mode", physicalOf(motion.extremes(), bar));
    }
    if (common.wantsJson) {
        writeOut(reportAsJson(mode, motion, bar));
        if (!common.quiet) {
            tell(notes);
        }
    } else {
        writeOut(reportAsText(mode, motion, bar) + notes);
    }
    common.useOneThread("mode");
    return exitFound;
}

}  // namespace signorini::cli
