// signorini atlas where something is wrong: locks, names, limits, and databases edited by hand.

#include <chrono>
#include <fstream>
#include <utility>
#include <vector>

#include "command_line.hpp"
#include "database.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

constexpr const char* build = "atlas --database a.sqlite --cells 6";

/// Changes a copy of the database, named e.sqlite.
void edit(const CommandLine& program, const std::string& sql)
{
    fs::copy_file(program.file("a.sqlite"), program.file("e.sqlite"),
                  fs::copy_options::overwrite_existing);
    opened(program.file("e.sqlite")).exec(sql);
}

/// Status 4 and one line that names the file.
void checkRefusal(const CommandLine::Outcome& outcome)
{
    CHECK(outcome.status == 4);
    CHECK(outcome.out.empty());
    CHECK(lines(outcome.err) == 1);
    CHECK_THAT(outcome.err, containsText("e.sqlite"));
}

}  // namespace

TEST_CASE("cli atlas: Ctrl-C ends the wait for a locked database within a second")
{
    const CommandLine program;
    REQUIRE(program.run(build).status == 0);
    SQLite::Database lock = opened(program.file("a.sqlite"));
    lock.exec("BEGIN EXCLUSIVE");
    const auto start = std::chrono::steady_clock::now();
    const auto stopped =
        program.run("atlas --database a.sqlite --cells 7", "timeout --preserve-status -s INT 1");
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    lock.exec("ROLLBACK");
    INFO(stopped.err);
    CHECK(stopped.status == 3);
    CHECK_THAT(stopped.err, containsText("interrupted") && containsText("a.sqlite"));
    CHECK(lines(stopped.err) == 1);
    CHECK(spent.count() < 20.0);  // it waited for a minute
    CHECK(number(program.file("a.sqlite"), "SELECT COUNT(*) FROM runs") == 1);
}

TEST_CASE("cli atlas: a database whose name is not UTF-8 is reported in valid JSON")
{
    const CommandLine program;
    const auto outcome = program.run("atlas --database 'caf\xe9.sqlite' --cells 6 --format json");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    REQUIRE(json::accept(outcome.out));
    CHECK(json::parse(outcome.out)["database"] == "caf\xef\xbf\xbd.sqlite");
    CHECK(fs::exists(program.file("caf\xe9.sqlite")));
}

TEST_CASE("cli atlas: threads that cannot start leave the work to the others")
{
    const CommandLine program;
    if (program.run("find 1 3 --cells 1", "ulimit -v 400000;").status != 0) {
        return;  // a sanitizer needs more than can be limited
    }
    const auto outcome = program.run(std::string(build) + " --threads 1024", "ulimit -v 400000;");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK_THAT(outcome.err, containsText("of 1024 threads"));
    REQUIRE(program.run("atlas --database b.sqlite --cells 6").status == 0);
    const fs::path few = program.file("a.sqlite");
    constexpr const char* count = "SELECT COUNT(*) FROM schedules";
    CHECK(number(few, count) == number(program.file("b.sqlite"), count));
    CHECK(number(few, "SELECT COUNT(*) FROM runs WHERE finished IS NOT NULL") == 1);
}

TEST_CASE("cli atlas: an edited database is status 4 with the column, never a wrong answer")
{
    const CommandLine program;
    REQUIRE(program.run(build).status == 0);
    for (const char* sql : {"UPDATE runs SET next_batch = -5", "UPDATE runs SET next_batch = 'x'",
                            "UPDATE runs SET next_batch = 99", "UPDATE runs SET batches = 0",
                            "UPDATE runs SET cells = -1", "UPDATE runs SET phases = 'many'",
                            "UPDATE runs SET keeps_refuted = 7", "UPDATE runs SET seconds = 'x'",
                            "UPDATE runs SET decided = -1", "PRAGMA application_id = 5",
                            "PRAGMA user_version = 77", "ALTER TABLE runs DROP COLUMN seconds",
                            "ALTER TABLE schedules DROP COLUMN kind", "DROP TABLE runs"}) {
        INFO(sql);
        edit(program, sql);
        checkRefusal(program.run("atlas --database e.sqlite --period 7/2 --schedules"));
        checkRefusal(program.run("atlas --database e.sqlite --cells 6 --resume"));
    }
    for (const std::string column : {"phases = '3:x'",
                                     "phases = '3'",
                                     "phases = ''",
                                     "phases = '3:18,'",
                                     "phases = '7:77'",
                                     "phases = '3:99999999999999999999'",
                                     "phases = '-3:24'",
                                     "status = 'lost'",
                                     "kind = 'heap'",
                                     "contact = NULL",
                                     "canonical = 2",
                                     "dimension = 'x'",
                                     "kernel_dimension = -1",
                                     "period = 'x'",
                                     "period = 3",
                                     "frequency_ratio = 1",
                                     "energy_ratio_min = NULL",
                                     "energy_ratio_min = 'x'",
                                     "energy_ratio_min = -1",
                                     "energy_ratio_max = 0.5"}) {
        INFO(column);
        edit(program, "UPDATE schedules SET " + column + " WHERE phases = '3:18'");
        const auto outcome = program.run("atlas --database e.sqlite --period 7/2 --schedules");
        checkRefusal(outcome);
        CHECK_THAT(outcome.err, containsText("allowed"));
    }
    for (const std::string column :
         {"phases = '4:17'", "family_order = 5", "family_order = NULL", "nu = 8",
          "contact_blocks = 3", "contact = 'grazing'", "contact = 'soft'", "kind = 'heap'",
          "dimension = -1", "schedules = 0", "schedules = 'x'", "period = 3", "frequency_ratio = 1",
          "energy_ratio_min = -1", "energy_ratio_max = 0.5"}) {
        INFO(column);
        edit(program, "UPDATE families SET " + column + " WHERE phases = '3:18'");
        const auto outcome = program.run("atlas --database e.sqlite --period 7/2");
        checkRefusal(outcome);
        CHECK_THAT(outcome.err, containsText("allowed"));
    }
    edit(program, "DROP TABLE families; PRAGMA user_version = 1");
    const auto former = program.run("atlas --database e.sqlite --twins");
    checkRefusal(former);
    CHECK_THAT(former.err, containsText("version 1") && containsText("anew"));
}

TEST_CASE("cli atlas: a run that is there already is done only if all its rows are")
{
    const CommandLine program;
    // Of one grid, and all kinds of rows; of two ranges, one of which holds few energies.
    REQUIRE(program.run("atlas --database all.sqlite --cells 4 --phases 2 --all").status == 0);
    REQUIRE(program.run("atlas --database two.sqlite --cells 6 --max-energy-ratio 5").status == 0);
    REQUIRE(program.run("atlas --database two.sqlite --cells 6 --max-free 9").status == 0);
    REQUIRE(program.run("atlas --database fam.sqlite --cells 9 --families-only").status == 0);
    const std::vector<std::pair<std::string, std::string>> runs{
        {"all.sqlite", "--cells 4 --phases 2 --all"},
        {"two.sqlite", "--cells 6 --max-energy-ratio 5"},
        {"two.sqlite", "--cells 6 --max-free 9"},
        {"fam.sqlite", "--cells 9 --families-only"}};
    for (const auto& [file, range] : runs) {
        INFO(file << " " << range);
        CHECK(program.run("atlas --database " + file + " --resume " + range).status == 0);
        // What the other range has left, too, stays: its own rows come first and last.
        const bool isShared = file == "two.sqlite";
        const bool isFirst = range.find("energy") != std::string::npos;
        for (const std::string table : {"schedules", "families"}) {
            const std::string count = "SELECT COUNT(*) FROM " + table;
            const auto rows =
                static_cast<std::int64_t>(number(program.file(file.c_str()), count.c_str()));
            for (const std::int64_t at : {std::int64_t{1}, rows / 2, rows}) {
                fs::copy_file(program.file(file.c_str()), program.file("e.sqlite"),
                              fs::copy_options::overwrite_existing);
                SQLite::Database database = opened(program.file("e.sqlite"));
                const int changed =
                    database.exec("DELETE FROM " + table + " WHERE rowid = " + std::to_string(at));
                const bool isOther =
                    isShared && (table == "families" || at != (isFirst ? 1 : rows));
                if (changed == 0 || isOther) {
                    continue;
                }
                INFO(table << " without row " << at);
                checkRefusal(program.run("atlas --database e.sqlite --resume " + range));
            }
        }
    }
}

TEST_CASE("cli atlas: a database with damaged pages is no atlas that is done")
{
    const CommandLine program;
    const std::string call = " --cells 12 --all";
    REQUIRE(program.run("atlas --database a.sqlite" + call).status == 0);
    const std::string whole = contentOf(program.file("a.sqlite"));
    constexpr std::size_t page = 4096;
    REQUIRE(whole.size() > 20 * page);
    for (std::size_t at = page; at + page <= whole.size(); at += 7 * page) {
        std::string damaged = whole;
        damaged.replace(at, page / 2, page / 2, '\xff');
        std::ofstream(program.file("e.sqlite"), std::ios::binary) << damaged;
        INFO("page " << at / page);
        checkRefusal(program.run("atlas --database e.sqlite --resume" + call));
    }
}

TEST_CASE("cli atlas: an answer that is empty because nothing was decided there is status 3")
{
    const CommandLine program;
    REQUIRE(program.run(build).status == 0);
    for (const char* query :
         {"--near 1.142857 20 --cells 7", "--period 7/2 --cells 7", "--twins --cells 7",
          "--period 100", "--near 0.01 20", "--period 1/7", "--near 1.142857 20 --within 1e-9"}) {
        const auto outcome =
            program.run(std::string("atlas --database a.sqlite --format json ") + query);
        INFO(query << "\n" << outcome.err);
        CHECK(outcome.status == 3);
        CHECK(lines(outcome.err) == 1);
        CHECK(json::parse(outcome.out)["complete"] == false);
    }
    // Decided, and there is none: an answer.
    for (const char* query : {"--near 1.142857 0.5", "--period 7/6"}) {
        const auto outcome =
            program.run(std::string("atlas --database a.sqlite --format json ") + query);
        INFO(query << "\n" << outcome.err);
        CHECK(outcome.status == 0);
        CHECK(json::parse(outcome.out)["complete"] == true);
        CHECK(json::parse(outcome.out)["families"].empty());
        CHECK(json::parse(outcome.out)["schedules"].empty());
    }
    // Energies that were not kept are not decided either.
    REQUIRE(program.run("atlas --database low.sqlite --cells 30 --max-energy-ratio 2").status == 0);
    CHECK(program.run("atlas --database low.sqlite --near 1.142857 20").status == 3);
}

TEST_CASE("cli atlas: seconds and joules are those of the bar")
{
    const CommandLine program;
    REQUIRE(program.run(build).status == 0);
    // L/c = 4e-4 s, E_1 = 2e7 * 1e-12 / 4 J.
    const std::string steel = " --length 2 --young 2e11 --density 8000 --area 1e-4 --gap 1e-6";
    const json answer = json::parse(
        program.run("atlas --database a.sqlite --period 7/2 --schedules --format json" + steel)
            .out);
    CHECK(answer["schema"] == 2);
    CHECK(answer["bar"]["wave_speed"] == 5000.0);
    int found = 0;
    json rows = answer["schedules"];
    rows.insert(rows.end(), answer["families"].begin(), answer["families"].end());
    for (const json& entry : rows) {
        CHECK(entry["period"].get<double>() == Approx(3.5 * 4e-4));
        CHECK(entry["period_ratio"] == 3.5);
        CHECK(entry["frequency"].get<double>() == Approx(1.0 / (3.5 * 4e-4)));
        ++found;
        CHECK(entry["energy_range"][0].get<double>() ==
              Approx(entry["energy_ratio_range"][0].get<double>() * 5e-6));
    }
    CHECK(found > 2);
    const auto near = program.run("atlas --database a.sqlite --near 8/7 5" + steel);
    CHECK_THAT(near.out, containsText("714.286 Hz") && containsText("2e-05 … 6e-05 J"));
    const json twins =
        json::parse(program.run("atlas --database a.sqlite --twins --format json" + steel).out);
    for (const json& group : twins["twins"]) {
        CHECK(group["period"].get<double>() == Approx(group["period_ratio"].get<double>() * 4e-4));
        CHECK(group["energy"].get<double>() == Approx(group["energy_ratio"].get<double>() * 5e-6));
    }
}

TEST_CASE("cli atlas: --near without an energy says what it takes")
{
    const CommandLine program;
    const auto outcome = program.run("atlas --database a.sqlite --near 1");
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, containsText("--near = 1") && containsText("allowed two numbers") &&
                                containsText("> 0"));
}
