// The program signorini-bench: its table, its report, and how it goes on after an end.

#include <sys/wait.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "catch.hpp"
#include "folder.hpp"
#include "judge.hpp"
#include "record.hpp"
#include "runner.hpp"
#include "signorini/one_phase_set.hpp"
#include "solver.hpp"

using namespace signorini;
using namespace signorini::bench;

namespace fs = std::filesystem;

namespace {

using Table = std::vector<Record>;

/// Does the row measure the library, and not a back end?
bool isOurs(const Record& record)
{
    return record.backEnd == "signorini" || record.backEnd == "closed-form";
}

/// A folder of its own, and calls of the program that write into it.
class Bench {
public:
    [[nodiscard]] int run(const std::string& arguments) const
    {
        const int status = std::system(("'" SIGNORINI_BENCH "' " + arguments + " --output '" +
                                        folder_.path().string() + "' >/dev/null 2>&1 </dev/null")
                                           .c_str());
        return WEXITSTATUS(status);
    }

    [[nodiscard]] Table table() const
    {
        return readTable((folder_.path() / "results.csv").string());
    }

    [[nodiscard]] std::string content(const char* name) const
    {
        std::ifstream file(folder_.path() / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    [[nodiscard]] fs::path file(const char* name) const { return folder_.path() / name; }

private:
    test::Folder folder_;
};

}  // namespace

TEST_CASE("bench: a quick run fills the table, every row of ours is right, and a report is made")
{
    const Bench bench;
    REQUIRE(bench.run("--quick") == 0);
    const Table table = bench.table();
    std::set<std::string> keys;
    std::set<std::string> suites;
    for (const Record& record : table) {
        keys.insert(keyOf(record));
        suites.insert(record.suite);
        INFO(keyOf(record) << ": " << record.outcome << " " << record.detail);
        CHECK(!record.outcome.empty());
        CHECK(record.provenance.size() == 8);
        if (isOurs(record)) {  // a forced bar on finer and finer grids: an error each, no verdict
            const bool isMeasured = record.outcome == "approximate" && record.suite == "rivals";
            CHECK((record.outcome == "right" || record.outcome == "reference" || isMeasured));
        }
        // The library's own back ends may fail, but none claims absence where there is a motion.
        if (record.claim == "none" && !record.backEnd.starts_with("clp")) {
            CHECK(record.outcome == "right");
        }
    }
    CHECK(keys.size() == table.size());
    CHECK(suites == std::set<std::string>{"accuracy", "extremes", "leaving-out", "rivals",
                                          "scaling", "stepped"});
    const std::string report = bench.content("report.md");
    for (const char* heading :
         {"# signorini-bench", "commit: ", "## Our own failures\n\nNone", "## Extremes",
          "## What leaving out gains", "## Scaling", "## Rivals", "## Error against run time"}) {
        CHECK_THAT(report, containsText(heading));
    }
    if (report.find("No figures: ") == std::string::npos) {
        for (const char* figure : {"work_precision.png", "performance_profile.png", "scaling.png",
                                   "leaving_out.png", "rivals.png"}) {
            if (report.find(figure) != std::string::npos) {
                CHECK(bench.content(figure).starts_with("\x89PNG"));
            }
        }
        CHECK_THAT(report, containsText("scaling.png"));
    }

    // A second run finds everything done; after a loss it measures only what is missing.
    REQUIRE(bench.run("--quick") == 0);
    CHECK(bench.table().size() == table.size());
    std::string text = bench.content("results.csv");
    text.resize(text.size() - 5);  // the end of a process in the middle of a row
    std::ofstream(bench.file("results.csv"), std::ios::binary) << text;
    REQUIRE(bench.run("--quick") == 0);
    CHECK(bench.table().size() == table.size());
}

TEST_CASE("bench: --filter chooses cases, and a wrong call is exit status 2")
{
    const Bench bench;
    REQUIRE(bench.run("--quick --filter '^scaling/verdict N='") == 0);
    const Table table = bench.table();
    CHECK(table.size() == 3);
    for (const Record& record : table) {
        CHECK(record.setting == "verdict");
        CHECK(record.figure("seconds_median") > 0.0);
        CHECK(record.figure("seconds_best") <= record.figure("seconds_median"));
    }
    CHECK(bench.run("--quick --filter 'no such case'") == 2);
    CHECK(bench.run("--quick --filter '('") == 2);
    CHECK(bench.run("--slow") == 2);
    CHECK(bench.run("--version") == 0);
    CHECK(bench.table().size() == 3);
}

TEST_CASE("bench: a row is read back as it was written")
{
    Record record = identified("s", "a, \"b\"", "x", "-", "1e-06");
    record.detail = "two\nlines, \"quoted\"";
    record.figures["error"] = 0.1;
    record.figures["cells"] = 300;
    const std::optional<Record> back = parseCsvLine(csvLine(record));
    REQUIRE(back.has_value());
    CHECK(keyOf(*back) == keyOf(record));
    CHECK(back->detail == "two lines, \"quoted\"");
    CHECK(back->figures == record.figures);
    CHECK_FALSE(parseCsvLine("a,b").has_value());
    record.figures["no such figure"] = 1.0;
    CHECK_THROWS_AS(csvLine(record), std::logic_error);
}

TEST_CASE("bench: whatever happens to a case is a row")
{
    constexpr Limits limits{.seconds = 0.5, .megabytes = 2000.0};
    const auto outcomeOf = [&](std::function<void(Record&)> body) {
        const std::optional<Record> record =
            execute({identified("s", "c", "b", "f", "x"), "", std::move(body)}, limits);
        REQUIRE(record.has_value());
        CHECK(record->figure("peak_megabytes") > 0.0);
        return record->outcome;
    };
    CHECK(outcomeOf([](Record& record) { record.outcome = "right"; }) == "right");
    CHECK(outcomeOf([](Record&) { std::abort(); }) == "crashed");
    CHECK(outcomeOf([](Record&) { _exit(3); }) == "crashed");
    CHECK(outcomeOf([](Record&) { sleep(60); }) == "timeout");
    CHECK(outcomeOf([](Record&) { throw std::invalid_argument("no"); }) == "refused");
    CHECK(outcomeOf([](Record&) { throw BackendUnavailable("no"); }) == "absent");
    CHECK(outcomeOf([](Record& record) {
              std::vector<double> much(1'000'000'000, 1.0);
              record.outcome = much[7] > 0.0 ? "right" : "wrong";
          }) == "memory");
}

TEST_CASE("bench: the judge takes neither x = 0 nor a wrong verdict")
{
    const Problem problem = leastEnergyOf(familyA(30), 4.0);
    const State right = leastEnergyMotion(onePhaseSet(problem.schedule));
    const auto outcomeOf = [&](const State& state, double tolerance = 1e-6) {
        Record record;
        judgeFound(problem, state, tolerance, record);
        return record.outcome;
    };
    CHECK(outcomeOf(right) == "right");
    CHECK(outcomeOf({Eigen::VectorXd::Zero(30), Eigen::VectorXd::Zero(30)}) == "wrong");
    CHECK(outcomeOf({1.0001 * right.a, 1.0001 * right.b}) == "inaccurate");
    CHECK(outcomeOf({1.0001 * right.a, 1.0001 * right.b}, 1e-3) == "right");
    CHECK(outcomeOf({-right.a, -right.b}) == "wrong");
    State spike = right;  // a motion, but not the one of least energy
    const OnePhaseSet exact = onePhaseSet(problem.schedule);
    std::vector<double> z(static_cast<std::size_t>(exact.set.count), 0.0);
    z.front() = exact.set.sum;
    spike = motionOf(exact, z);
    CHECK(outcomeOf(spike) == "wrong");
    Record record;
    judgeFound(familyC(30), right, 1e-6, record);
    CHECK(record.outcome == "wrong");
    judgeNone(problem, record);
    CHECK(record.outcome == "wrong");
    judgeNone(familyC(30), record);
    CHECK(record.outcome == "right");
}
