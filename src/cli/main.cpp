// The program signorini: reads the command line, runs one command, turns trouble into exit status.

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <new>
#include <system_error>

#include "commands.hpp"
#include "faults.hpp"
#include "given.hpp"
#include "hints.hpp"
#include "json.hpp"
#include "mapped.hpp"
#include "ranks.hpp"
#include "signorini/output.hpp"
#include "solver.hpp"
#include "study_file.hpp"
#include "text.hpp"

namespace {

using namespace signorini;
using namespace signorini::cli;

int complain(ExitStatus status, std::string_view text)
{
    constexpr std::size_t longest = 4000;  // a path may be as long as that
    tell(fmt::format("signorini: {}\n", shortened(onOneLine(std::string(text)), longest)));
    return status;
}

/// Does the command line ask for an answer in JSON? The commands know it too, but may be gone.
bool asksForJson(int argc, char** argv)
{
    const std::vector<std::string_view> words(argv + std::min(argc, 1), argv + argc);
    const auto format = std::find(words.rbegin(), words.rend(), "--format");
    return (format != words.rend() && format != words.rbegin() && format[-1] == "json") ||
           std::find(words.begin(), words.end(), "--format=json") != words.end();
}

/// The work ended before there was an answer: docs/schema/unfinished.json.
int leaveUndecided(bool wantsJson, std::string_view reason)
{
    try {
        if (wantsJson) {
            Json json = newAnswer();
            json["status"] = name(Status::undecided);
            json["detail"] = reason;
            writeOut(asLine(json));
        }
    } catch (const std::exception& error) {
        return complain(exitUnavailable, error.what());
    }
    return complain(exitUndecided, fmt::format("undecided: {}", reason));
}

/// Holds 0, 1 and 2, or a file opened later gets one of them and with it what is meant for people.
/// Using them fails as if they were closed.
void occupyStandardStreams()
{
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) < 0) {
            (void)open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

/// A command, and what its help says.
struct Command {
    Usage usage;
    ExitStatus (*run)(const Given&);
};

namespace asks = answers::asks;

constexpr std::array commands{
    Command{
        {"find", "a periodic motion of a schedule, or a proof of absence", asks::find, "NC NF ...",
         "contact and free steps of each phase; of a scene with several contacts SET:STEPS "
         "..., SET those that are closed, as in 1+2:6 -:35"},
        runFind},
    Command{{"continuum", "a curve of motions of one schedule and energy", asks::continuum,
             "NC NF ...", "contact and free steps of each phase"},
            runContinuum},
    Command{
        {"modes", "the continuous families of motions, exact, for any grid", asks::modes, "", "",
         "Times are in units of L/c and energies in E_1: the list holds for every bar and every "
         "grid. JSON adds frequencies in Hz and energies in J of the bar that the options "
         "name.\nWith several contacts chains k/turns→release say which release follows which "
         "arrival, s + 2k - turns T, and `free` how many times may be chosen beside T."},
        runModes},
    Command{{"mode", "the motion of one mode at any period", asks::mode, "A4 B",
             "the mode of contact time A4 + B T, e.g. 4 -1"},
            runMode},
    Command{
        {"families", "the families of motions by order: each set of orbits once, for any grid",
         asks::families, "", "",
         "A family (w, nu, k) is all motions of one period T = 2 nu/w and one contact pattern, "
         "with energies from the least one upwards, on every grid with w | 2N. Times are in "
         "units of L/c and energies in E_1: the list holds for every bar. Hz, s and J are those "
         "of the bar that the options name. Ordered by w, nu, k."},
        runFamilies},
    Command{{"atlas", "decides every schedule of a range and stores the results in a database",
             asks::atlas | asks::atlasQuery, "", ""},
            runAtlas},
    Command{
        {"response", "all forced, damped motions with one contact phase, frequency by frequency",
         asks::response, "", "",
         "Of the periods that are n steps of L/(N c): 4 N K/n is the frequency of the "
         "excitation in ω₁.\n--damping, --force and --amplitude are required.\n"
         "--csv: steps n, frequency_ratio ω/ω₁, frequency [Hz], touches (would the bar without "
         "a wall meet it?), linear_peak [m], then of each motion contact, free [steps], phase "
         "[rad], impulse [N s], peak_force [N], tip_lowest [m], stability, amplitude [N or m], "
         "second_contact, second_free [steps], stop, then undecided, the number of schedules "
         "at this frequency, and contact_time [s], approach_speed [m/s], peak_compression, "
         "peak_tension [-], peak_stress [Pa] of the motion, and cells, N of its grid; one row "
         "without "
         "them where there is no motion. Contact of all n steps: the tip never leaves the wall.\n"
         "--csv with --exact: steps, frequency_ratio, frequency, touches, linear_peak, motion (0, "
         "1, ... at this frequency), contacts and cycles in its period, contact (0, 1, ...), "
         "begin, end [s], stop, release (pinned: ended by a wave front, or smooth), impulse [N s], "
         "peak_force [N], speed [m/s], phase [rad], growth of disturbances in a period, attracts "
         "(1, 0), residual. Of several bars (--scene) and of segments: steps, frequency_ratio, "
         "frequency, amplitude, touches, motion, contact (1, 2, ...), contact_time [s], release, "
         "phase, impulse, peak_force, speed, residual, stability, compression, tension, growth, "
         "attracts.\n"
         "--map-csv: steps, frequency_ratio, frequency, contacts (0, 1 or 2), contact, free, "
         "second_contact, second_free, least_amplitude, most_amplitude [N or m]; no largest "
         "one: empty. Schedules in order of contact; an amplitude has as many motions as rows "
         "hold it. Of several bars: steps, frequency_ratio, frequency, which (contact 1, 2, ...; "
         "empty: bars that do not meet), contact, free (0: it never opens), least_amplitude, "
         "most_amplitude.\n"
         "--backbone-csv: a4, b and family of the mode (t_c = a4 + b T), frequency_ratio and "
         "frequency of the excitation, period_ratio cT/L, energy_ratio E/E₁, impulse, "
         "peak_force, tip_lowest."},
        runResponse},
    Command{{"simulate", "the exact motion from any initial state", asks::simulation, "", "",
             "Only the excitation is on a grid: it is constant for L/(N c), or a time near it that "
             "fits a\nwhole number of times into its period."},
            runSimulate},
    Command{
        {"sweep", "what a driven bar settles on while a frequency, or another number, is varied",
         asks::sweep, "", "",
         "At each value the bar is followed until it repeats itself after 1 ... 16 periods of "
         "the\nexcitation, or for --periods of them.\n"
         "--csv: value (ω/ω₁, N or m, m, -), frequency [Hz], direction, periods it repeats "
         "after\n(empty: it does not), residual, watched (periods), contacts, contacts_least, "
         "contacts_most,\nimpulse, impulse_least, impulse_most [N s] in a period of the "
         "excitation, mean_force [N] over\n--resolve, tip_lowest, tip_highest [m], "
         "peak_strain [-], peak_stress [Pa]."},
        runSweep},
    Command{{"study", "sweeps for many gaps, damping ratios and amplitudes, and the worst of each",
             asks::study, "FILE.toml", "the question; required",
             "FILE.toml holds options of sweep, gap, damping and amplitude one value or a list:\n"
             "  force = \"base\"\n  gap = [\"0.05mm\", \"0.1mm\"]\n  damping = [0.02, 0.05]\n"
             "  amplitude = [\"10um\", \"20um\"]\n  length = 3\n  young = \"210GPa\"\n"
             "  density = 7850\n  area = \"1cm2\"\n  points = 31\n  cells = 40\n"
             "--csv: the question, then gap [m], damping, amplitude, impulse [N s], frequency "
             "[Hz],\nmean_force [N], peak_strain, peak_stress [Pa], rattles_from, rattles_to "
             "[Hz], irregular.",
             isStudyKey},
            runStudy},
    Command{
        {"scene", "bars in a row, with springs, masses, gaps and stops: parsed, converted, drawn",
         asks::scene, "TEXT", "TEXT or FILE.json: the words of the scene",
         "Elements, from left to right, separated by blanks: clamp, free, N[:Z[:C]] cells, "
         "gap=G, stop=G (to the right), stop=-G\n(to the left), dash=D, spring=K, mass=M, "
         "force=F, driven, shaken. Example: signorini scene clamp 150 gap=1e-3 200:1.3 clamp"},
        runScene},
};

std::string helpText()
{
    std::string text =
        "Finds, proves, measures and draws the periodic motions of an elastic bar in unilateral "
        "contact with a wall.\nUsage: signorini [OPTIONS] SUBCOMMAND\n\nOptions:\n"
        "  -h,--help                   Print this help message and exit\n"
        "  --version                   Display program version information and exit\n"
        "\nSubcommands:\n";
    for (const Command& command : commands) {
        text += fmt::format("  {:<28}{}\n", command.usage.command, command.usage.sentence);
    }
    return text +
           "\nExit status: 0 found, 1 proved that none exists, 2 usage error, 3 undecided,\n"
           "4 a file, database or back end could not be used; 128 + N ended by signal N: 129 "
           "hang-up,\n130 Ctrl-C, 143 SIGTERM.\n";
}

int run(std::vector<std::string> words)
{
    if (!words.empty() && words.front() == "help") {  // what newcomers type first
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    const std::string first = words.empty() ? "" : words.front();
    if (first == "--version" || first == "--help" || first == "-h") {
        writeOut(first == "--version" ? versionText() : helpText());
        return exitFound;
    }
    const auto* const called =
        std::find_if(commands.begin(), commands.end(),
                     [&](const Command& command) { return command.usage.command == first; });
    if (called == commands.end()) {
        const auto names = mapped(
            commands, [](const Command& command) { return std::string(command.usage.command); });
        const std::string given = words.empty() ? " is missing" : " = " + shortened(first);
        throw std::invalid_argument(fmt::format("command{}: allowed {}{}; see signorini --help",
                                                given, fmt::join(names, "|"),
                                                didYouMean(first, names)));
    }
    const auto options = std::find(words.begin(), words.end(), "--");
    if (std::find(words.begin(), options, "--version") != options) {
        writeOut(versionText());
        return exitFound;
    }
    const Given given(called->usage, {words.begin() + 1, words.end()});
    if (given.wantsHelp()) {
        writeOut(helpOf(called->usage));
        return exitFound;
    }
    try {
        return called->run(given);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(given.inOptions(error.what()));
    }
}

}  // namespace

int main(int argc, char** argv)
{
    // A closed pipe and a file size limit are writes that fail, not the end of the program.
    (void)std::signal(SIGPIPE, SIG_IGN);
    (void)std::signal(SIGXFSZ, SIG_IGN);
    occupyStandardStreams();
    handOverToMpi(argv);
    int status = exitUndecided;
    try {
        status = run({argv + std::min(argc, 1), argv + argc});
    } catch (const std::invalid_argument& error) {
        return complain(exitWrongUse, error.what());
    } catch (const FileError& error) {
        return complain(exitUnavailable, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return complain(exitUnavailable, error.what());
    } catch (const BackendUnavailable& error) {
        return complain(exitUnavailable, error.what());
    } catch (const std::bad_alloc&) {
        return leaveUndecided(asksForJson(argc, argv), "the memory of this machine is not enough");
    } catch (const std::system_error& error) {
        return leaveUndecided(
            asksForJson(argc, argv),
            error.code() == std::errc::resource_unavailable_try_again
                ? "the memory of this machine is not enough: a thread could not be started"
                : error.what());
    } catch (const std::exception& error) {
        return leaveUndecided(asksForJson(argc, argv), error.what());
    }
    return status;
}
