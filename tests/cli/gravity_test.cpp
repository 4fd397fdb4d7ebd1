// One bar under gravity: it sags by g L^2/(2 c^2) at rest and is then a bar with a smaller gap,
// since its motions about rest know nothing of gravity. That bar is answered by another engine.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "command_line.hpp"
#include "has_solver.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

/// The words of a bar of 2 m with c = 10 m/s before a stop, under gravity, and of one that has
/// sagged.
std::pair<std::string, std::string> bars(double gap, double gravity)
{
    const std::string bar = " --length 2 --wave-speed 10 --axial-stiffness 30 ";
    return {bar + fmt::format("--gap {} --gravity {}", gap, gravity),
            bar + fmt::format("--gap {:.17g}", gap - gravity * 4.0 / 200.0)};
}

/// Numbers of two answers, but for rounding; null: without end.
void requireClose(const json& one, const json& other, double unit)
{
    REQUIRE(one.is_null() == other.is_null());
    if (one.is_null()) {
        return;
    }
    REQUIRE(one.get<double>() == Approx(other.get<double>()).epsilon(1e-9).margin(1e-9 * unit));
}

using Rows = std::vector<std::vector<double>>;

Rows rowsOf(const fs::path& path)
{
    std::ifstream file(path);
    Rows rows;
    std::string line;
    for (std::getline(file, line); std::getline(file, line);) {
        std::istringstream row(line);
        rows.emplace_back();
        for (std::string value; std::getline(row, value, ',');) {
            rows.back().push_back(std::stod(value));
        }
    }
    return rows;
}

/// A state with a row for each cell of a piece, so long [s].
Rows cellByCell(const Rows& pieces, double cell)
{
    Rows rows;
    for (std::vector<double> piece : pieces) {
        const long count = std::max(1L, std::lround(piece[3] / cell));
        piece[3] /= static_cast<double>(count);
        rows.insert(rows.end(), static_cast<std::size_t>(count), piece);
    }
    return rows;
}

void requireSame(const Rows& one, const Rows& other)
{
    REQUIRE(!one.empty());
    REQUIRE(one.size() == other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        REQUIRE(one[k].size() == other[k].size());
        for (std::size_t column = 0; column < one[k].size(); ++column) {
            INFO("row " << k << ", column " << column);
            REQUIRE(std::abs(one[k][column] - other[k][column]) < 1e-11);
        }
    }
}

}  // namespace

TEST_CASE("cli gravity: a free bar that sags is one with a smaller gap")
{
    const CommandLine program;
    int found = 0;
    for (const double gravity : {0.02, -0.03, 0.15}) {  // the last one presses at rest
        const auto [sagging, sagged] = bars(1e-3, gravity);
        for (const int contact : {1, 6}) {
            for (int free = 5; free < 30; free += 2) {
                const std::string schedule = fmt::format(
                    "find {} {} --cells 6 --objective min-energy --format json", contact, free);
                const auto truth = program.run(schedule + sagged);
                const auto asked = program.run(schedule + sagging);
                INFO(schedule << sagging);
                REQUIRE(asked.status == truth.status);
                if (truth.status == 0) {
                    const json a = json::parse(asked.out);
                    const json b = json::parse(truth.out);
                    requireClose(a["energy"], b["energy"], 1e-6);
                    ++found;
                }
            }
        }
    }
    CHECK(found > 10);
    CHECK_THAT(program.run("find 1 5 --cells 6" + bars(1e-3, 0.02).first).out,
               containsText("gravity 0.02 m/s²"));
}

TEST_CASE("cli gravity: under a force, too, of a schedule and of a range of frequencies", "[glpk]")
{
    const CommandLine program;
    const auto [sagging, sagged] = bars(1e-3, 0.02);
    const std::string force = " --cells 10 --damping 0.1 --force tip --format json";
    int found = 0;
    for (int contact = 3; contact < 9; ++contact) {
        for (int free = 27; free < 33; ++free) {
            const std::string schedule = fmt::format("find {} {}", contact, free) + force;
            const auto truth = program.run(schedule + sagged);
            const auto asked = program.run(schedule + sagging);
            REQUIRE(asked.status == truth.status);
            if (truth.status == 0) {
                const json a = json::parse(asked.out);
                const json b = json::parse(truth.out);
                requireClose(a["amplitude_range"][0], b["amplitude_range"][0], 1.0);
                requireClose(a["amplitude_range"][1], b["amplitude_range"][1], 1.0);
                requireClose(a["motions"][0]["contacts"][0]["impulse"], b["motions"][0]["impulse"],
                             1.0);
                ++found;
            }
        }
    }
    CHECK(found > 5);
    const std::string range = "response --amplitude 0.1 --from 1 --to 1.2" + force;
    const json a = json::parse(program.run(range + sagging).out)["frequencies"];
    const json b = json::parse(program.run(range + sagged).out)["frequencies"];
    REQUIRE(a.size() == b.size());
    int motions = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        REQUIRE(a[k]["motions"].size() == b[k]["motions"].size());
        for (std::size_t m = 0; m < a[k]["motions"].size(); ++m) {
            requireClose(a[k]["motions"][m]["impulse"], b[k]["motions"][m]["impulse"], 1.0);
            ++motions;
        }
    }
    CHECK(motions > 1);
}

TEST_CASE("cli gravity: families and modes are those of the gap that weight leaves")
{
    const CommandLine program;
    for (const double gravity : {0.02, -0.03, 0.15}) {
        const auto both = bars(1e-3, gravity);
        const auto& sagging = both.first;
        const auto& sagged = both.second;
        const double gap = 1e-3 - gravity * 4.0 / 200.0;
        const auto check = [&](const std::string& question, const char* rows,
                               const std::string& stop = "", const std::string& left = "") {
            INFO(question << sagging << stop);
            json asked = json::parse(program.run(question + sagging + stop).out);
            json truth = json::parse(program.run(question + sagged + left).out);
            CHECK(asked["gravity"] == gravity);
            CHECK(truth["gravity"] == 0.0);
            CHECK(asked["bar"]["gap"].get<double>() == Approx(gap));
            REQUIRE(asked[rows].size() == truth[rows].size());
            CHECK(asked[rows].empty() == (gravity < 0.0 && !stop.empty()));
            for (std::size_t k = 0; k < asked[rows].size(); ++k) {
                for (const char* energy : {"least_energy", "energy_range"}) {
                    if (asked[rows][k].contains(energy)) {
                        const json& one = asked[rows][k][energy];
                        const json& other = truth[rows][k][energy];
                        requireClose(one.is_array() ? one[0] : one,
                                     other.is_array() ? other[0] : other, 1e-9);
                    }
                }
            }
        };
        check("families --max-order 6 --format json", "families");
        check("modes --max-order 5 --format json", "modes");
        if (gap > 0.0) {
            check("modes --phases 2 --max-order 3 --format json", "polytopes");
            check("families --max-order 6 --format json", "families", " --second-stop 2e-3",
                  fmt::format(" --second-stop {:.17g}", 2e-3 + gravity * 4.0 / 200.0));
        }
        CHECK_THAT(program.run("families --max-order 3" + sagging).out,
                   containsText(" under its weight; "));
    }
    // What just touches has no gap, whatever is rounded, and weight is to blame.
    CHECK_THAT(program.run("modes --gravity 0.1 --wave-speed 3 --gap 0.005555555555555556").err,
               containsText("--gravity = 0.1 is out of range: allowed a weight that leaves another "
                            "gap than 0 m"));
    // The same of a file that says its gravity, and of words.
    CHECK(program
              .run("families --max-order 4 --scene 'clamp 8 stop=1e-3' --gravity 1e-3 --format "
                   "json")
              .out == program.run("families --max-order 4 --gravity 1e-3 --format json").out);
}

TEST_CASE("cli gravity: a mode shows the whole bar, as find does on the grid of its period")
{
    const CommandLine program;
    struct Case {
        double gravity;
        const char* mode;
        const char* schedule;  // on 12 cells
    };
    for (const Case& one : {Case{0.02, "mode 4 -1 --period 7/2", "6 36"},
                            Case{-0.03, "mode 4 -1 --period 7/2", "6 36"},
                            Case{-0.03, "mode 8 -3 --period 31/12", "3 28"},
                            Case{0.15, "mode 4 -1 --period 5/2", "18 12"}}) {
        const auto [sagging, sagged] = bars(1e-3, one.gravity);
        INFO(one.mode << sagging);
        const std::string grid = " --cells 12 --format json ";
        const auto asked = program.run(one.mode + grid + "--state m.csv --motion mm.csv" + sagging);
        INFO(asked.err);
        REQUIRE(asked.status == 0);
        const json mode = json::parse(asked.out);
        const json about = json::parse(program.run(one.mode + grid + sagged).out);
        const json found = program.find(
            fmt::format("{} --cells 12 --state f.csv --motion fm.csv", one.schedule) + sagging, 0);
        CHECK(mode["gravity"] == one.gravity);
        CHECK(about["gravity"] == 0.0);
        requireClose(mode["energy"], found["energy"], 1e-6);
        requireClose(mode["period"], found["period"], 1.0);
        requireClose(mode["bar"]["gap"], found["contacts"][0]["gap"], 1e-3);
        requireClose(mode["physical"]["impulse"], found["contacts"][0]["impulse"], 1e-3);
        for (const char* strain : {"peak_compression", "peak_tension"}) {
            requireClose(mode["physical"][strain], found["strains"][strain], 1e-3);
        }
        requireClose(mode["physical"]["tip_lowest"],
                     about["physical"]["tip_lowest"].get<double>() + one.gravity * 4.0 / 200.0,
                     1e-3);
        const double step = 0.2 / 12.0;
        requireSame(cellByCell(rowsOf(program.file("m.csv")), step),
                    cellByCell(rowsOf(program.file("f.csv")), step));
        requireSame(rowsOf(program.file("mm.csv")), rowsOf(program.file("fm.csv")));
    }
    const auto off = program.run(
        "mode 4 -1 --period 3.3333333333 --gravity 4e-4 --cells 7 --state m.csv --motion m.vtk");
    CHECK(off.status == 0);
    CHECK_THAT(off.out, containsText("means over 7 cells"));
    CHECK(contentOf(program.file("m.csv")).starts_with("node,displacement,wave,"));
}

TEST_CASE("cli gravity: commands that know no weight say so, and damping has its one place")
{
    const CommandLine program;
    const auto refuses = [&program](const std::string& words, const std::string& why) {
        const auto refused = program.run(words);
        INFO(words << ": " << refused.err);
        CHECK(refused.status == 2);
        CHECK_THAT(refused.err, containsText(why));
        CHECK(lines(refused.err) == 1);
    };
    refuses("mode 4 -1 --period 3.14 --gravity 1e-4 --motion m.pvd",
            "--motion = m.pvd is out of range: allowed FILE.csv|.vtk under gravity");
    refuses("mode 4 -1 --period 3.14 --gravity 1", "allowed ]2, 3[");  // it presses at rest
    refuses("families --second-stop 1e-3 --gravity=-4e-3",
            "--gravity = -4e-3 is out of range: allowed finite and > -0.002");
    refuses("find 5 41 --gravity 1 --damping 0.1", "--force is missing");
    refuses(
        "find 3 9 --scene 'clamp 4 dash=0.1 driven stop=1e-3' --gravity 1 --damping 0.1 "
        "--force tip",
        "--damping clashes with --scene");
    refuses("find 6 36 --gravity 1e-4 --tip-floor 2e-3", "--tip-floor clashes");
}
