#include "commands.hpp"

#include <algorithm>
#include <cmath>

#include "files.hpp"
#include "given.hpp"
#include "rational.hpp"
#include "reports.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/modes.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

Mode modeOf(const std::vector<std::string>& words, int gapSign)
{
    refuseIf(words.size() != 2,
             "mode needs two numbers A4 B: the contact time A4 + B T in L/c, as signorini modes "
             "lists them");
    const std::int64_t a4 = parseWhole("A4", words[0], 4, 4 * maxFamilyOrder);
    const std::int64_t b = parseWhole("B", words[1], -maxFamilyOrder, -1);
    const std::optional<Mode> mode = a4 % 4 == 0 ? findMode(a4 / 4, b, gapSign) : std::nullopt;
    refuseIf(!mode, "A4 B", fmt::format("{} {}", a4, b),
             "multiples of 4 and negative odd numbers that signorini modes lists: there is no "
             "other mode");
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

/// The state at t = 0 on the grid, and a line that says what it is.
std::string writeState(const std::string& path, const Mode& mode, const ModeMotion& motion,
                       std::int64_t cells, std::optional<std::int64_t> steps, const Bar& bar)
{
    writeStateCsv(path,
                  steps ? leastEnergyMotion(onePhaseSet(scheduleOf(mode, cells, *steps)))
                        : cellMeans(motion, cells),
                  bar);
    return steps ? fmt::format("state       exact: T is {} steps of {} cells\n", *steps, cells)
                 : fmt::format(
                       "state       means over {} cells: T is no whole number of steps there\n",
                       cells);
}

/// The motion on a grid that nearly has its period; adds a line that says how nearly.
FigureData drawn(const Mode& mode, double period, std::int64_t usualCells, const Bar& bar,
                 std::string& notes)
{
    const Schedule schedule = nearestSchedule(mode, period, usualCells);
    FindOptions options;
    options.scene = bar;
    if (const double shown = signorini::period(schedule); shown != period) {
        notes += fmt::format("figure      shows T = {:.10g} L/c, {:.1e} from the one asked for\n",
                             shown, std::abs(shown - period));
    }
    return motionFigure(findPeriodic(schedule, options));
}

}  // namespace

ExitStatus runMode(const Given& given)
{
    const CommonOptions common(given);
    refuseIf(common.weight() != 0.0,
             "--gravity: allowed with find, continuum, response, simulate, sweep, atlas, families "
             "and modes; mode tells what a bar does about its rest, without the shape at rest");
    const Bar bar = common.barOfAnyGap();
    const Mode mode = modeOf(given.words(), answers::gapSignOfModes(bar));
    if (!given.has("--period")) {
        throw std::invalid_argument(fmt::format(
            "--period is missing: allowed ]{}, {}[ [L/c], where the mode t_c = {} lives",
            fractionAsText(mode.lowest), fractionAsText(mode.highest), contactAsText(mode)));
    }
    const GivenNumber period = parseNumber("--period", given.text("--period"), "L/c");
    requireInside(mode, period);
    const ModeMotion motion(mode, period.value);
    Outputs outputs(given, {"--state", "--motion", "--figure", "--animate"});
    const std::int64_t cells = common.usualCells();
    std::string notes;
    outputs.put("--state", [&](const std::string& path) {
        notes += writeState(path, mode, motion, cells, stepsOn(cells, period), bar);
    });
    outputs.draw("--figure", [&] { return drawn(mode, motion.period(), cells, bar, notes); });
    outputs.draw("--animate", [&] { return motionFrames(MotionSamples(motion, bar, cells)); });
    outputs.putMotion([&](std::int64_t most) { return MotionSamples(motion, bar, cells, most); });
    outputs.commit();
    common.warnUnlessAdmissible(physicalOf(motion.extremes(), bar));
    report(common, answers::ModeAnswer{mode, bar, motion});
    if (!common.wantsJson) {
        writeOut(notes);
    } else if (!common.quiet) {
        tell(notes);
    }
    common.useOneThread();
    return exitFound;
}

}  // namespace signorini::cli
