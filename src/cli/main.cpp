// The program signorini: reads the command line, runs one command, turns trouble into exit status.

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <new>
#include <sstream>

#include "atlas_command.hpp"
#include "continuum_command.hpp"
#include "find_command.hpp"
#include "modes_command.hpp"
#include "ranks.hpp"
#include "signorini/config.hpp"
#include "signorini/output.hpp"
#include "signorini/solver.hpp"
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
    fmt::print(stderr, "signorini: {}\n", onOneLine(std::string(text)));
    return status;
}

/// The first number CLI11 did not know where to put, as the step count it was meant to be where a
/// command takes some.
std::string explainExtras(const CLI::App& app, const std::string& message)
{
    for (const std::string& word : app.remaining(true)) {
        if (looksLikeNumber(word) && !app.got_subcommand("find") &&
            !app.got_subcommand("continuum")) {
            return fmt::format(
                "number = {} is out of range: allowed numbers > 0, each after an "
                "option that takes it",
                word);
        }
        if (looksLikeNumber(word)) {
            return fmt::format("step count = {} is out of range: allowed whole numbers 1..{}", word,
                               maxSteps);
        }
    }
    return message;
}

int run(int argc, char** argv)
{
    CLI::App app{
        "Finds, proves, measures and draws the periodic motions of an elastic bar in "
        "unilateral contact with a wall.",
        "signorini"};
    app.set_version_flag("--version", versionText());
    app.require_subcommand(1);
    FindCommand find;
    CLI::App& findApp =
        *app.add_subcommand("find", "a periodic motion of a schedule, or a proof of absence");
    find.addTo(findApp);
    ContinuumCommand continuum;
    CLI::App& continuumApp =
        *app.add_subcommand("continuum", "a curve of motions of one schedule and energy");
    continuum.addTo(continuumApp);
    ModesCommand modes;
    CLI::App& modesApp =
        *app.add_subcommand("modes", "the continuous families of motions, exact, for any grid");
    modes.addTo(modesApp);
    AtlasCommand atlas;
    CLI::App& atlasApp =
        *app.add_subcommand("atlas", "every schedule of a range decided, into a database");
    atlas.addTo(atlasApp);
    app.footer(
        "Exit status: 0 found, 1 proved that none exists, 2 wrong use, 3 undecided,\n"
        "4 a file, database or back end could not be used.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForVersion&) {
        writeOut(versionText());
        return exitFound;
    } catch (const CLI::Success& success) {
        std::ostringstream help;
        (void)app.exit(success, help, help);
        writeOut(help.str());
        return exitFound;
    } catch (const CLI::ExtrasError& error) {
        return complain(exitWrongUse, explainExtras(app, error.what()));
    } catch (const CLI::RequiredError&) {
        const std::string given = argc > 1 ? fmt::format(" = {}", argv[1]) : " is missing";
        return complain(
            exitWrongUse,
            fmt::format("command{}: allowed find|continuum|modes|atlas; see signorini --help",
                        given));
    } catch (const CLI::ParseError& error) {
        std::string text = error.what();
        text = text.substr(0, text.find('\n'));
        return complain(exitWrongUse, text + "; see signorini --help");
    }
    if (atlasApp.parsed()) {
        return atlas.run();
    }
    if (modesApp.parsed()) {
        return modes.run();
    }
    return continuumApp.parsed() ? continuum.run() : find.run();
}

}  // namespace

int main(int argc, char** argv)
{
    // A closed pipe and a file size limit are writes that fail, not the end of the program.
    (void)std::signal(SIGPIPE, SIG_IGN);
    (void)std::signal(SIGXFSZ, SIG_IGN);
    handOverToMpi(argv);
    int status = exitUndecided;
    try {
        status = run(argc, argv);
    } catch (const std::invalid_argument& error) {
        return complain(exitWrongUse, error.what());
    } catch (const FileError& error) {
        return complain(exitUnavailable, error.what());
    } catch (const BackendUnavailable& error) {
        return complain(exitUnavailable, error.what());
    } catch (const std::bad_alloc&) {
        return complain(exitUndecided, "undecided: the memory of this machine is not enough");
    } catch (const std::exception& error) {
        return complain(exitUndecided, fmt::format("undecided: {}", error.what()));
    }
    return status;
}
