// Little memory: every back end ends with a verdict or with status 3 and words, never by a signal.

#include "command_line.hpp"
#include "sanitized.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

std::string limitedTo(int megabytes)
{
    return "ulimit -c 0; ulimit -v " + std::to_string(1024 * megabytes) + ";";
}

/// The least address space in which the program starts and does what needs no solver [MB]; 0 where
/// limits mean nothing, as under a sanitizer.
int leastMemory(const CommandLine& program)
{
    const auto starts = [&program](int megabytes) {
        return program.run("find 150 900", limitedTo(megabytes)).status == 0;
    };
    int high = 1024;
    if (!starts(high)) {
        return 0;
    }
    for (int low = 1; high - low > 1;) {
        const int middle = (low + high) / 2;
        (starts(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace

TEST_CASE("cli: no back end ends the process when memory is short")
{
    const CommandLine program;
    const int least = leastMemory(program);
    if (least == 0) {
        return;
    }
    const auto solver = GENERATE(as<std::string>{}, "glpk-simplex", "glpk-interior", "glpk-exact",
                                 "ipopt", "nlopt-slsqp");
    const std::string call =
        "find 300 1800 --cells 600 --format json --formulation state --solver ";
    for (int more = 0; more <= 6; ++more) {
        const auto outcome = program.run(call + solver, limitedTo(least + more));
        INFO(solver << " with " << least + more << " MB\n" << outcome.out << outcome.err);
        if (outcome.status == 4) {
            return;  // not in this build
        }
        REQUIRE((outcome.status == 0 || outcome.status == 3));
        const json answer = json::parse(outcome.out);
        if (!answer.contains("bar")) {  // it ended before there was an answer
            CHECK(answer["status"] == "undecided");
            CHECK_THAT(answer["detail"].get<std::string>(), containsText("memory"));
            CHECK_THAT(outcome.err, containsText("memory"));
            CHECK(lines(outcome.err) == 1);
        }
    }
}

TEST_CASE("cli: a million cells stay under three states of memory")
{
    const CommandLine program;
    const auto outcome = program.run("find 500000 3000000 --cells 1000000 --quiet");
    REQUIRE(outcome.status == 0);
    const double stateKilobytes = 2e6 * sizeof(double) / 1024.0;
    CHECK((signorini::test::isSanitized || outcome.peakKilobytes < 3.0 * stateKilobytes));
}
