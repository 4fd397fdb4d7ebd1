#include "mode_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "files.hpp"
#include "mode_words.hpp"
#include "rational.hpp"
#include "signorini/families.hpp"
#include "signorini/figures.hpp"
#include "signorini/find_periodic.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

/// A decimal number without an exponent as a fraction, if it has at most 18 digits.
std::optional<ExactPeriod> fractionOf(const std::string& decimal)
{
    constexpr std::size_t mostDigits = 18;
    std::string digits = decimal;
    std::int64_t denominator = 1;
    if (const std::size_t point = digits.find('.'); point != std::string::npos) {
        digits.erase(point, 1);
        for (std::size_t k = point; k < std::min(digits.size(), mostDigits); ++k) {
            denominator *= 10;
        }
    }
    std::int64_t numerator = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, numerator);
    if (error != std::errc{} || stop != end || digits.size() > mostDigits || numerator <= 0) {
        return std::nullopt;
    }
    return exactPeriod(numerator, denominator);
}

AskedPeriod parsePeriod(const std::string& text)
{
    constexpr const char* option = "--period";
    constexpr std::int64_t most = 1'000'000'000'000'000'000;
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) {
        return {parsePositive(option, text, "L/c"), fractionOf(text)};
    }
    std::int64_t numerator = 0;
    std::int64_t denominator = 0;
    try {
        numerator = parseWhole(option, text.substr(0, slash), 1, most);
        denominator = parseWhole(option, text.substr(slash + 1), 1, most);
    } catch (const std::invalid_argument&) {
        refuse(option, text, "numbers > 0 like 3.14, 3 or 22/7 [L/c]");
    }
    const ExactPeriod exact = exactPeriod(numerator, denominator);
    return {exact.value(), exact};
}

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
void requireInside(const Mode& mode, const AskedPeriod& period)
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
std::optional<std::int64_t> stepsOn(std::int64_t cells, const AskedPeriod& period)
{
    if (!period.exact || cells % period.exact->denominator != 0) {
        return std::nullopt;
    }
    return cells / period.exact->denominator * period.exact->numerator;
}

/// The lowest place of the tip [g]: u(L, t) is made of straight lines between jumps of p there and
/// those that left it 2L/c before.
double lowestTip(const ModeMotion& motion)
{
    double lowest = 1.0;
    for (const double t : motion.jumpTimes()) {
        lowest = std::min({lowest, motion.displacement(1.0, t), motion.displacement(1.0, t - 2.0)});
    }
    return std::min({lowest, motion.displacement(1.0, 0.0), motion.displacement(1.0, -2.0)});
}

/// |p| is h everywhere, so |s| is at most 2h, which the clamp sees of both signs, and the tip meets
/// the wall with 2h.
Json physicalAsJson(const ModeMotion& motion, const Scales& unit, const Bar& bar)
{
    const double largest = 2.0 * motion.amplitude();
    const double force = largest * bar.axialStiffness * unit.strain;
    return {{"frequency", 1.0 / (motion.period() * unit.time)},
            {"contact_time", motion.contactTime() * unit.time},
            {"peak_force", force},
            {"impulse", force * motion.contactTime() * unit.time},
            {"approach_speed", largest * unit.velocity},
            {"peak_compression", largest * unit.strain},
            {"peak_tension", largest * unit.strain},
            {"tip_lowest", lowestTip(motion) * unit.displacement}};
}

std::string reportAsJson(const Mode& mode, const ModeMotion& motion, const Bar& bar)
{
    const Scales unit = scales(bar);
    const double energy = energyRatio(mode, motion.period());
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
                     {"physical", physicalAsJson(motion, unit, bar)}});
    return asLine(json);
}

std::string reportAsText(const Mode& mode, const ModeMotion& motion, const Bar& bar)
{
    const Scales unit = scales(bar);
    const Json physical = physicalAsJson(motion, unit, bar);
    const auto value = [&physical](const char* name) { return physical[name].get<double>(); };
    const std::string family = familyName(mode);
    const double energy = energyRatio(mode, motion.period());
    return fmt::format(
        "found       mode t_c = {}{}, T in ]{}, {}[ L/c\n"
        "period      {:.10g} s = {:.10g} L/c, {:.6g} Hz, ω/ω₁ = {:.10g}\n"
        "contact     {:.6g} s = {:.10g} L/c\n"
        "energy      {:.6g} J = {:.10g} E₁, 1/√(E/E₁) = {}\n"
        "waves       p = ±{:.6g} g/L with {} jumps in a period\n"
        "force       {:.6g} N on the wall all through contact, impulse {:.6g} N s\n"
        "strain      at most {:.6g} in compression and in tension\n"
        "tip         meets the wall with {:.6g} m/s, goes down to {:.6g} m\n",
        contactAsText(mode), family.empty() ? "" : fmt::format(" ({})", family),
        fractionAsText(mode.lowest), fractionAsText(mode.highest), motion.period() * unit.time,
        motion.period(), value("frequency"), 4.0 / motion.period(), value("contact_time"),
        motion.contactTime(), energy * unit.energy, energy, rootAsText(mode), motion.amplitude(),
        motion.jumpTimes().size(), value("peak_force"), value("impulse"), value("peak_compression"),
        value("approach_speed"), value("tip_lowest"));
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
            [this](const std::string& text) { period = parsePeriod(text); });
    command.add_option("--state", stateFile, "write the state at t = 0 on the grid")
        ->type_name("FILE.csv");
    motionFile.addTo(command);
    command.add_option("--figure", figureFile, "draw the motion (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    command
        .add_option("--animate", animationFile,
                    "draw it moving (needs gnuplot, and ffmpeg for .mp4)")
        ->type_name("FILE.gif|.mp4");
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
    if (!animationFile.empty()) {
        (void)animationFormat(animationFile);
    }
    motionFile.validate();
    const OutputOption stateOption{"--state", stateFile};
    const OutputOption figureOption{"--figure", figureFile};
    const OutputOption animationOption{"--animate", animationFile};
    validateOutputs({stateOption, motionFile.option(), motionFile.folderOption(), figureOption,
                     animationOption});

    OutputFiles files;
    const std::string state = stage(files, stateOption);
    MotionFile::Staged moving(motionFile, files);
    const std::string figure = stage(files, figureOption);
    const std::string animation = stage(files, animationOption);
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
    if (!animation.empty()) {
        forFile("--animate", animationFile, [&] {
            animateMotion(MotionSamples(motion, bar, cells), animationFormat(animationFile),
                          animation);
        });
    }
    moving.write([&](std::int64_t most) { return MotionSamples(motion, bar, cells, most); });
    files.commit();
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
