// The program signorini: reads the command line, runs one command, turns trouble into exit status.

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cctype>
#include <csignal>
#include <filesystem>
#include <functional>
#include <new>
#include <sstream>
#include <system_error>

#include "atlas_command.hpp"
#include "continuum_command.hpp"
#include "families_command.hpp"
#include "faults.hpp"
#include "find_command.hpp"
#include "hints.hpp"
#include "json.hpp"
#include "mode_command.hpp"
#include "modes_command.hpp"
#include "ranks.hpp"
#include "response_command.hpp"
#include "scene_command.hpp"
#include "signorini/config.hpp"
#include "signorini/output.hpp"
#include "simulate_command.hpp"
#include "solver.hpp"
#include "sweep_command.hpp"
#include "text.hpp"

namespace {

using namespace signorini;
using namespace signorini::cli;

std::string versionText()
{
    std::string text = fmt::format("signorini {}\nback ends:\n", SIGNORINI_VERSION);
    for (const Backend& backend : backends()) {
        const std::string library =
            backend.library.empty() ? ""
            : backend.available()   ? fmt::format(" ({} {})", backend.library, backend.version())
                                    : fmt::format(" ({}, not in this build)", backend.library);
        text += fmt::format("  {:<14} {}{}\n", backend.name, backend.purpose, library);
    }
    return text;
}

/// "-5", "-inf", "-nan": a number where CLI11 sees an unknown option.
bool looksLikeNumber(const std::string& word)
{
    return word.size() > 1 && word[0] == '-' &&
           (std::isdigit(static_cast<unsigned char>(word[1])) != 0 || word[1] == '.' ||
            word == "-inf" || word == "-nan" || word == "-infinity");
}

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

/// The options of the commands that were called.
std::vector<std::string> optionsOf(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands()) {
        for (const CLI::Option* option : command->get_options()) {
            names.push_back(option->get_name());
        }
    }
    return names;
}

/// Text for words that are not expected: a number is the step count it was meant to be where a
/// command takes some, another word perhaps one of the names.
std::string explainExtras(const std::vector<std::string>& words, bool takesSteps,
                          const std::vector<std::string>& names)
{
    for (const std::string& word : words) {
        if (looksLikeNumber(word) && !takesSteps) {
            return fmt::format(
                "number = {} is out of range: allowed numbers > 0, each after an option that takes "
                "it",
                shortened(word));
        }
        if (looksLikeNumber(word)) {
            return fmt::format("step count = {} is out of range: allowed whole numbers 1..{}",
                               shortened(word), maxSteps);
        }
    }
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " ") + shortened(word);
    }
    std::string hint;
    for (const std::string& word : words) {
        hint += hint.empty() && word.starts_with("--") ? didYouMean(word, names) : "";
    }
    return fmt::format("{} is not expected{}; see signorini --help", text, hint);
}

/// Names the option that was given more often than once, if that is what went wrong.
std::string explainMismatch(const CLI::App& command, const std::string& message)
{
    for (const CLI::Option* option : command.get_options()) {
        const int most = option->get_items_expected_max();
        const auto given = static_cast<int>(option->count());
        if (most > 0 && given >= 2 * most) {
            return fmt::format("{} is given {} times: allowed once", option->get_name(),
                               given / most);
        }
    }
    return message;
}

/// The command line, cut at the first "--": what follows it are step counts.
struct Words {
    std::vector<std::string> before;
    std::vector<std::string> after;
};

/// \throws std::invalid_argument on "--option=" with no value: CLI11 would take the next word.
Words wordsOf(int argc, char** argv)
{
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    const auto end = std::find(words.begin(), words.end(), "--");
    for (auto word = words.begin(); word != end; ++word) {
        if (word->starts_with("--") && word->find('=') == word->size() - 1) {
            Faults faults;
            faults.add(shortened(word->substr(0, word->size() - 1)), "''", "a value");
            faults.throwIfAny();
        }
    }
    Words cut{{words.begin(), end}, {end == words.end() ? end : end + 1, words.end()}};
    for (std::string& word : cut.before) {
        if (word.starts_with("-:")) {  // steps in which no contact is closed, and no option
            word.erase(0, 1);
        }
    }
    return cut;
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

/// All commands, and the one that was called.
class Commands {
public:
    explicit Commands(CLI::App& app)
    {
        add(app, find_, "find", "a periodic motion of a schedule, or a proof of absence",
            &find_.steps);
        add(app, continuum_, "continuum", "a curve of motions of one schedule and energy",
            &continuum_.steps);
        add(app, modes_, "modes", "the continuous families of motions, exact, for any grid");
        add(app, mode_, "mode", "the motion of one mode at any period", &mode_.contact);
        add(app, families_, "families",
            "the families of motions by order: each set of orbits once, for any grid");
        add(app, atlas_, "atlas",
            "decides every schedule of a range and stores the results in a database");
        add(app, response_, "response",
            "all forced, damped motions with one contact phase, frequency by frequency");
        add(app, simulate_, "simulate", "the exact motion from any initial state");
        add(app, sweep_, "sweep",
            "what a driven bar settles on while a frequency, or another number, is varied");
        add(app, scene_, "scene",
            "bars in a row, with springs, masses, gaps and stops: parsed, converted, drawn",
            &scene_.words);
    }

    /// "find", "continuum", ...
    [[nodiscard]] std::vector<std::string> names() const
    {
        std::vector<std::string> names;
        for (const Command& command : commands_) {
            names.push_back(command.app->get_name());
        }
        return names;
    }

    /// Where the command that was called keeps words that belong to no option; null if it has none.
    [[nodiscard]] std::vector<std::string>* words() const { return called().words; }

    [[nodiscard]] ExitStatus run() const { return called().run(); }

private:
    struct Command {
        CLI::App* app;
        std::vector<std::string>* words;
        std::function<ExitStatus()> run;
    };

    template <typename Options>
    void add(CLI::App& app, Options& options, const char* name, const char* what,
             std::vector<std::string>* words = nullptr)
    {
        CLI::App& command = *app.add_subcommand(name, what);
        options.addTo(command);
        commands_.push_back({&command, words, [&options] { return options.run(); }});
    }

    /// \pre one was called.
    [[nodiscard]] const Command& called() const
    {
        return *std::find_if(commands_.begin(), commands_.end(),
                             [](const Command& command) { return command.app->parsed(); });
    }

    FindCommand find_;
    ContinuumCommand continuum_;
    ModesCommand modes_;
    ModeCommand mode_;
    FamiliesCommand families_;
    AtlasCommand atlas_;
    ResponseCommand response_;
    SimulateCommand simulate_;
    SweepCommand sweep_;
    SceneCommand scene_;
    std::vector<Command> commands_;
};

int run(int argc, char** argv)
{
    CLI::App app{
        "Finds, proves, measures and draws the periodic motions of an elastic bar in "
        "unilateral contact with a wall.",
        "signorini"};
    app.set_version_flag("--version", versionText());
    app.require_subcommand(1);
    Commands commands(app);
    app.footer(
        "Exit status: 0 found, 1 proved that none exists, 2 usage error, 3 undecided,\n"
        "4 a file, database or back end could not be used; 128 + N ended by signal N: 129 "
        "hang-up,\n"
        "130 Ctrl-C, 143 SIGTERM.");
    try {
        const Words words = wordsOf(argc, argv);
        app.parse(std::vector<std::string>(words.before.rbegin(), words.before.rend()));
        std::vector<std::string>* more = commands.words();
        if (more == nullptr && !words.after.empty()) {
            return complain(exitWrongUse, explainExtras(words.after, false, {}));
        }
        if (more != nullptr) {
            more->insert(more->end(), words.after.begin(), words.after.end());
        }
    } catch (const CLI::CallForVersion&) {
        writeOut(versionText());
        return exitFound;
    } catch (const CLI::Success& success) {
        std::ostringstream help;
        (void)app.exit(success, help, help);
        writeOut(help.str());
        return exitFound;
    } catch (const CLI::ExtrasError&) {
        return complain(exitWrongUse,
                        explainExtras(app.remaining(true),
                                      app.got_subcommand("find") || app.got_subcommand("continuum"),
                                      optionsOf(app)));
    } catch (const CLI::RequiredError&) {
        const std::string given =
            argc > 1 ? fmt::format(" = {}", shortened(argv[1])) : " is missing";
        return complain(exitWrongUse,
                        fmt::format("command{}: allowed {}{}; see signorini --help", given,
                                    fmt::join(commands.names(), "|"),
                                    argc > 1 ? didYouMean(argv[1], commands.names()) : ""));
    } catch (const CLI::ParseError& error) {
        std::string text = error.what();
        text = text.substr(0, text.find('\n'));
        for (const CLI::App* command : app.get_subcommands()) {
            text = explainMismatch(*command, text);
        }
        return complain(exitWrongUse, text + "; see signorini --help");
    }
    return commands.run();
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
        status = run(argc, argv);
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
