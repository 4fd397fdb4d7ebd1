// Long calls: Ctrl-C, the line on a terminal, and threads that a command does not use.

#include <chrono>
#include <csignal>
#include <utility>

#include "command_line.hpp"
#include "sanitized.hpp"
#include "solver.hpp"

using namespace signorini::test;

namespace {

/// Too slow to end by itself before it is interrupted: `solver` on the paper's equations.
std::string slowCall(const std::string& cells, const std::string& solver)
{
    const int n = std::stoi(cells);
    return "find " + std::to_string(n / 2) + " " + std::to_string(3 * n) + " --cells " + cells +
           " --formulation state --state s.csv --solver " + solver;
}

/// What a terminal shows of a call whose report goes elsewhere.
std::string shownBy(const CommandLine& program, const std::string& arguments)
{
    const std::string call = std::string("'") + SIGNORINI_PROGRAM + "' " + arguments;
    (void)program.run("", "script -qec \"" + call + " >out.txt\" screen.txt >screen.copy;:");
    return contentOf(program.file("screen.txt"));
}

}  // namespace

TEST_CASE("cli: Ctrl-C ends a search by a solver that can be stopped with status 3 and words")
{
    for (const auto& [call, seconds] :
         {std::pair{slowCall("60000", "glpk-exact"), "1"},
          std::pair{slowCall("6000", "ipopt --objective min-energy"), "1"},
          std::pair{slowCall("800", "nlopt-auglag --energy-ratio 20 --tolerance 1e-12"), "0.3"}}) {
        const CommandLine program;
        const std::string interrupted = "timeout --preserve-status -s INT ";
        auto outcome = program.run(call, interrupted + seconds);
        for (const char* later : {"0.8", "1.6", "3.2", "6.4"}) {
            if (outcome.status == 128 + SIGINT) {  // a busy machine had not begun
                outcome = program.run(call, interrupted + later);
            }
        }
        INFO(call << "\n" << outcome.out << outcome.err);
        if (outcome.status == 4) {
            continue;  // not in this build
        }
        CHECK(outcome.status == 3);
        CHECK_THAT(outcome.err, containsText("interrupted"));
        CHECK_THAT(outcome.out, containsText("cancelled"));
        CHECK(program.files() == 0);
    }
}

TEST_CASE("cli: Ctrl-C ends a program whose solver cannot be stopped, and leaves nothing behind",
          "[glpk]")
{
    const CommandLine program;
    const auto start = std::chrono::steady_clock::now();
    const auto outcome =
        program.run(slowCall("60000", "glpk-interior"), "timeout --preserve-status -s INT 4");
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 128 + SIGINT);
    CHECK(outcome.out.empty());
    CHECK(program.files() == 0);
    CHECK(spent.count() < 20.0);
}

TEST_CASE("cli: a signal ends the program with 128 and its number, as the help says")
{
    const CommandLine program;
    const std::string help = program.run("--help").out;
    for (const auto& [name, status] : {std::pair{"HUP", 129}, {"INT", 130}, {"TERM", 143}}) {
        // It waits for a table that nobody writes.
        const auto outcome =
            program.run("find 3 18 --cells 6 --objective nearest --target pipe --state s.csv",
                        std::string("rm -f pipe; mkfifo pipe; sleep 3 >pipe & timeout "
                                    "--preserve-status -s ") +
                            name + " 1");
        INFO(name << "\n" << outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.out.empty());
        CHECK(program.files() == 1);  // the pipe
        CHECK_THAT(help, containsText(std::to_string(status)));
    }
}

TEST_CASE("cli: long work shows a line on a terminal, and only there")
{
    const CommandLine program;
    if (program.run("--version", "command -v script >/dev/null || exit 77;").status == 77) {
        return;
    }
    const std::string find = "find 1000 6000 --cells 2000 --formulation state --solver ";
    if (signorini::findBackend("ipopt").available()) {
        CHECK_THAT(shownBy(program, find + "ipopt --objective min-energy --time-limit 3"),
                   containsText("\rfinding a motion, 1 s"));
    }
    const std::string trace = std::string("continuum 150 900 --energy-ratio 20 --points ") +
                              (signorini::test::isSanitized ? "3000" : "20000");
    const std::string shown = shownBy(program, trace);
    CHECK_THAT(shown, containsText(" %, tracing, ") && containsText(" s left"));
    CHECK_THAT(shownBy(program, "modes --max-order 6001"), containsText(" %, listing modes, "));
    CHECK(shownBy(program, trace + " --quiet").find("tracing") == std::string::npos);
    // Elsewhere there are at most whole lines, every ten seconds.
    CHECK(program.run(trace).err.find('\r') == std::string::npos);
}

TEST_CASE("cli: a command that works on one thread says so when more are allowed")
{
    const CommandLine program;
    for (const char* call : {"find 5 23 --cells 8", "modes --max-order 1", "families --max-order 3",
                             "continuum 6 36 --cells 12 --energy-ratio 8 --points 2"}) {
        const auto one = program.run(std::string(call) + " --threads 1");
        CHECK(one.status == 0);
        CHECK(one.err.empty());
        const auto more = program.run(std::string(call) + " --threads 2");
        INFO(call << "\n" << more.err);
        CHECK(more.status == 0);
        CHECK_THAT(more.err, containsText("one thread is used"));
        CHECK(lines(more.err) == 1);
        CHECK(program.run(std::string(call) + " --threads 2 --quiet").err.empty());
    }
}
