#include "commands.hpp"

#include <algorithm>
#include <cmath>

#include "bar_check.hpp"
#include "bars_motion.hpp"
#include "contact_spans.hpp"
#include "files.hpp"
#include "given.hpp"
#include "rational.hpp"
#include "reports.hpp"
#include "scene_answer.hpp"
#include "scene_figures.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/modes.hpp"
#include "state_table.hpp"
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

/// The state at t = 0 on the grid, and a line that says what it is. Under gravity it is the table
/// of several bars, about the shape at rest, as find writes it.
std::string writeState(const std::string& path, const answers::ModeAnswer& answer,
                       std::int64_t cells, std::optional<std::int64_t> steps)
{
    const auto& [mode, bar, motion, gravity] = answer;
    const State state = steps ? leastEnergyMotion(onePhaseSet(scheduleOf(mode, cells, *steps)))
                              : cellMeans(motion, cells);
    if (gravity == 0.0) {
        writeStateCsv(path, state, bar);
    } else {
        const Network network = networkOf(Scene(bar), cells, {});
        const auto tip = static_cast<double>(mode.gapSign * cells);  // at the wall
        writeStateTable(path, network, {wavesOf(network, state), {0.0, tip}});
    }
    return steps ? fmt::format("state       exact: T is {} steps of {} cells\n", *steps, cells)
                 : fmt::format(
                       "state       means over {} cells: T is no whole number of steps there\n",
                       cells);
}

/// The motion on a grid that nearly has its period.
class Drawn {
public:
    /// Adds a line that says how nearly.
    Drawn(const answers::ModeAnswer& answer, std::int64_t usualCells, std::string_view what,
          std::string& notes)
        : answer_(answer),
          schedule_(nearestSchedule(answer.mode, answer.motion.period(), usualCells))
    {
        const double period = answer.motion.period();
        if (const double shown = signorini::period(schedule_); shown != period) {
            notes += fmt::format("{:<12}shows T = {:.10g} L/c, {:.1e} from the one asked for\n",
                                 what, shown, std::abs(shown - period));
        }
    }

    [[nodiscard]] FigureData figure() const
    {
        if (answer_.gravity != 0.0) {
            const Bars bars = sagging();
            return periodFigure(bars.network, bars.claim, bars.assembly.length);
        }
        FindOptions options;
        options.scene = answer_.bar;
        return motionFigure(findPeriodic(schedule_, options));
    }

    /// Under gravity, where the wall is not as far as the gap at rest.
    [[nodiscard]] std::vector<FigureData> frames() const
    {
        const Bars bars = sagging();
        return barsFrames(bars.assembly, bars.network, shownPeriod(bars.network, bars.claim));
    }

private:
    struct Bars {
        Assembly assembly;
        Network network;
        NetworkClaim claim;
    };

    /// As a network, whose nodes know the shape at rest.
    [[nodiscard]] Bars sagging() const
    {
        // Without its weight the gap is what it was.
        const Scene weightless = aboutRest(answer_.bar, -answer_.gravity);
        Assembly assembly = answers::assemblyOf(weightless, schedule_.cells, {});
        assembly.gravity = answer_.gravity;
        Network network = networkOf(assembly);
        State state = leastEnergyMotion(onePhaseSet(schedule_));
        const double unit = scales(answer_.bar).displacement / network.scales.displacement /
                            static_cast<double>(schedule_.cells);
        state.a *= unit;
        state.b *= unit;
        NetworkClaim claim = signorini::claimOf(network, state, schedule_, {});
        return {std::move(assembly), std::move(network), std::move(claim)};
    }

    const answers::ModeAnswer& answer_;
    Schedule schedule_;
};

}  // namespace

ExitStatus runMode(const Given& given)
{
    const CommonOptions common(given);
    const Bar bar = common.barOfAnyGap();
    const Mode mode = modeOf(given.words(), answers::gapSignOfModes(bar));
    if (!given.has("--period")) {
        throw std::invalid_argument(fmt::format(
            "--period is missing: allowed ]{}, {}[ [L/c], where the mode t_c = {} lives",
            fractionAsText(mode.lowest), fractionAsText(mode.highest), contactAsText(mode)));
    }
    const GivenNumber period = parseNumber("--period", given.text("--period"), "L/c");
    requireInside(mode, period);
    const bool isUnderWeight = common.weight() != 0.0;
    refuseIf(isUnderWeight && given.text("--motion").ends_with(".pvd"), "--motion",
             given.text("--motion"),
             "FILE.csv|.vtk under gravity: a .pvd shows a bar without weight before its wall");
    const answers::ModeAnswer answer = answers::motionOf(mode, bar, period.value, common.weight());
    const ModeMotion& motion = answer.motion;
    Outputs outputs(given, {"--state", "--motion", "--figure", "--animate"});
    const std::int64_t cells = common.usualCells();
    std::string notes;
    outputs.put("--state", [&](const std::string& path) {
        notes += writeState(path, answer, cells, stepsOn(cells, period));
    });
    outputs.draw("--figure", [&] { return Drawn(answer, cells, "figure", notes).figure(); });
    outputs.draw("--animate", [&] {
        return isUnderWeight ? Drawn(answer, cells, "animation", notes).frames()
                             : motionFrames(MotionSamples(motion, bar, cells));
    });
    outputs.putMotion([&](std::int64_t most) { return MotionSamples(motion, bar, cells, most); });
    outputs.commit();
    common.warnUnlessAdmissible(physicalOf(motion.extremes(), bar));
    report(common, answer);
    if (!common.wantsJson) {
        writeOut(notes);
    } else if (!common.quiet) {
        tell(notes);
    }
    common.useOneThread();
    return exitFound;
}

}  // namespace signorini::cli
