// The program signorini-bench: measures and writes one table, and has report.py make a report and
// figures from it.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <regex>
#include <system_error>

#include "provenance.hpp"
#include "runner.hpp"
#include "signorini/output.hpp"
#include "solver.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;

// As in the contract of signorini.
constexpr int exitDone = 0;
constexpr int exitWrongUse = 2;
constexpr int exitUndecided = 3;
constexpr int exitUnavailable = 4;

struct Arguments {
    bool isQuick = false;
    bool isReportOnly = false;
    std::string output = "benchmark-results";
    std::string filter = ".";
};

/// The same for every case.
constexpr Limits limitsOf(Extent extent)
{
    return {.seconds = extent == Extent::quick ? 3.0 : 6.0, .megabytes = 4000.0};
}

std::vector<Case> allCases(Extent extent)
{
    std::vector<Case> cases;
    for (const auto suite : {extremesSuite, leavingOutSuite, scalingSuite, steppedSuite,
                             rivalsSuite, forcedSuite, harmonicSuite, accuracySuite}) {
        std::vector<Case> more = suite(extent);
        std::move(more.begin(), more.end(), std::back_inserter(cases));
    }
    return cases;
}

void keepMatching(std::vector<Case>& cases, const std::string& filter)
{
    const std::regex pattern(filter);
    std::erase_if(cases, [&pattern](const Case& work) {
        return !std::regex_search(keyOf(work.record), pattern);
    });
}

std::string tableIn(const std::string& folder)
{
    return folder + "/results.csv";
}

/// report.md and figures from the table alone, by benchmarks/report.py.
int report(const Arguments& arguments)
{
    const pid_t child = fork();
    if (child == 0) {
        // The system's, which has the system's matplotlib; else that of the path.
        for (const char* python : {"/usr/bin/python3", "python3"}) {
            (void)execlp(python, python, SIGNORINI_REPORT, arguments.output.c_str(), nullptr);
        }
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status) ||
        WEXITSTATUS(status) != 0) {
        fmt::print(stderr, "signorini-bench: no report: cannot run python3 {} {}\n",
                   SIGNORINI_REPORT, arguments.output);
        return exitUnavailable;
    }
    return exitDone;
}

int measure(const Arguments& arguments)
{
    const Extent extent = arguments.isQuick ? Extent::quick : Extent::full;
    const Limits limits = limitsOf(extent);
    std::vector<Case> cases = allCases(extent);
    keepMatching(cases, arguments.filter);
    if (cases.empty()) {
        fmt::print(stderr, "signorini-bench: --filter {}: no case matches\n", arguments.filter);
        return exitWrongUse;
    }
    std::filesystem::create_directories(arguments.output);
    const std::string provenance = provenanceText(extent, limits);
    const std::string id = provenanceId(provenance);
    TextFile file(arguments.output + "/provenance-" + id + ".txt");
    file.write(provenance);
    file.close();
    timingBudget = arguments.isQuick ? 0.005 : 0.05;
    catchInterrupts();
    const RunSummary summary = run(cases, limits, id, tableIn(arguments.output));
    fmt::print("{} cases measured, {} taken from {}\n", summary.done, summary.kept,
               tableIn(arguments.output));
    if (summary.wasInterrupted) {
        fmt::print(stderr, "signorini-bench: interrupted; the same call goes on from here\n");
        return exitUndecided;
    }
    return exitDone;
}

int runProgram(int argc, char** argv)
{
    CLI::App app{"Measures error against run time, extremes, scaling, and what leaving out gains.",
                 "signorini-bench"};
    Arguments arguments;
    app.add_flag("--quick", arguments.isQuick, "a small part of each suite, in under two minutes");
    app.add_option("--output", arguments.output,
                   "folder for table, report and figures; cases it holds are not run again")
        ->capture_default_str();
    app.add_option("--filter", arguments.filter,
                   "only cases whose suite/case/back end/formulation/setting match this "
                   "regular expression");
    app.add_flag("--report-only", arguments.isReportOnly, "measure nothing, make the report again");
    app.set_version_flag("--version", [] {
        const std::string text = versionText();
        return text.substr(0, text.size() - 1);  // a line end follows it
    });
    try {
        app.parse(argc, argv);
        (void)std::regex(arguments.filter);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "signorini-bench: {}\n", error.what());
        return exitWrongUse;
    } catch (const std::regex_error&) {
        fmt::print(stderr,
                   "signorini-bench: --filter = {} is out of range: allowed regular "
                   "expressions\n",
                   arguments.filter);
        return exitWrongUse;
    }
    if (!arguments.isReportOnly) {
        if (const int status = measure(arguments); status != exitDone) {
            return status;
        }
    }
    (void)std::fflush(stdout);
    return report(arguments);
}

}  // namespace

int main(int argc, char** argv)
{
    // One thread for every back end; BLAS libraries read this when they are loaded, so the program
    // starts itself again.
    if (std::getenv("OMP_NUM_THREADS") == nullptr) {
        setenv("OMP_NUM_THREADS", "1", 1);
        setenv("OPENBLAS_NUM_THREADS", "1", 1);
        std::error_code none;  // without /proc it goes on as it is
        execv(std::filesystem::read_symlink("/proc/self/exe", none).c_str(), argv);
    }
    try {
        return runProgram(argc, argv);
    } catch (const FileError& error) {
        fmt::print(stderr, "signorini-bench: {}\n", error.what());
        return exitUnavailable;
    } catch (const std::filesystem::filesystem_error& error) {
        fmt::print(stderr, "signorini-bench: {}\n", error.what());
        return exitUnavailable;
    } catch (const std::exception& error) {
        fmt::print(stderr, "signorini-bench: {}\n", error.what());
        return exitUndecided;
    }
}
