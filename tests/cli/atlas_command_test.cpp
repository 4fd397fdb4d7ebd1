// signorini atlas: databases, queries, interruption, several processes.

#include <fmt/format.h>

#include <chrono>
#include <random>
#include <string>

#include "command_line.hpp"
#include "database.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

/// About half a second of work in eleven batches.
const std::string pairs = "atlas --cells 5 --phases 2 --all --quiet";

}  // namespace

TEST_CASE("cli atlas: the default range of N = 12 in JSON and in the tables of the contract")
{
    const CommandLine program;
    const auto outcome = program.run("atlas --database a.sqlite --cells 12 --format json");
    REQUIRE(outcome.status == 0);
    CHECK(outcome.err.empty());
    const json r = json::parse(outcome.out);
    CHECK(r["status"] == "done");
    CHECK(r["decided"] == 24 * 48);
    CHECK(r["found"].get<int>() == r["pressing"].get<int>() + r["grazing"].get<int>());
    CHECK(r["refuted"].get<int>() + r["found"].get<int>() == 24 * 48);
    const fs::path plain = program.file("a.sqlite");
    CHECK(number(plain, "SELECT COUNT(*) FROM families") == r["family_count"]);
    CHECK(number(plain, "SELECT COUNT(*) FROM schedules") == r["found"]);
    CHECK(number(plain,
                 "SELECT COUNT(*) FROM schedules WHERE cells = 12 AND phases = '6:36' AND period = "
                 "3.5 AND frequency_ratio = 8.0/7.0 AND status = 'found' AND reason IS NULL AND "
                 "kernel_dimension = 6 AND kind = 'simplex' AND dimension = 5 AND contact = "
                 "'pressing' AND energy_ratio_min = 4 AND energy_ratio_max = 24") == 1);
    CHECK(number(plain,
                 "SELECT COUNT(*) FROM families f JOIN schedules s ON s.family = f.id WHERE "
                 "f.family_order = 4 AND f.nu = 7 AND f.contact_blocks = 1 AND f.phases = '6:36' "
                 "AND f.dimension = 5 AND f.energy_ratio_max = 24 AND f.schedules = 11") == 11);
    CHECK(number(plain,
                 "SELECT COUNT(*) FROM runs WHERE version <> '' AND options <> '' AND "
                 "started <> '' AND finished <> ''") == 1);
    CHECK(program.files() == 1);

    // The same again is done already; --all keeps the refuted ones, too.
    CHECK(program.run("atlas --database a.sqlite --cells 12").status == 0);
    REQUIRE(program.run("atlas --database b.sqlite --cells 12 --all").status == 0);
    const fs::path all = program.file("b.sqlite");
    CHECK(number(all, "SELECT COUNT(*) FROM schedules") == 24 * 48);
    CHECK(number(all,
                 "SELECT COUNT(*) FROM schedules WHERE status = 'none' AND reason IN "
                 "('no-live-class', 'contact-sign', 'penetration', 'gap')") == r["refuted"]);
}

TEST_CASE("cli atlas: --families-only writes the same families and no schedules")
{
    const CommandLine program;
    REQUIRE(program.run("atlas --database whole.sqlite --cells 30").status == 0);
    REQUIRE(program.run("atlas --database few.sqlite --cells 30 --families-only").status == 0);
    const fs::path whole = program.file("whole.sqlite");
    const fs::path few = program.file("few.sqlite");
    CHECK(number(few, "SELECT COUNT(*) FROM schedules") == 0);
    CHECK(number(few, "SELECT COUNT(*) FROM families") > 0);
    for (const char* sum : {"SELECT COUNT(*) FROM families", "SELECT SUM(schedules) FROM families",
                            "SELECT SUM(steps * dimension) FROM families",
                            "SELECT SUM(pressing + grazing) FROM runs"}) {
        CHECK(number(few, sum) == number(whole, sum));
    }
    const auto near = program.run("atlas --database few.sqlite --near 8/7 20 --format json");
    CHECK(near.status == 0);
    CHECK(json::parse(near.out)["families"].size() == 1);
    // Its frequency-energy plot is the same.
    for (const char* name : {"whole", "few"}) {
        REQUIRE(
            program
                .run(std::string("atlas --database ") + name + ".sqlite --figure " + name + ".svg")
                .status == 0);
    }
    CHECK(contentOf(program.file("whole.svg")) == contentOf(program.file("few.svg")));
    const auto rows = program.run("atlas --database few.sqlite --near 8/7 20 --schedules");
    CHECK(rows.status == 0);
    CHECK_THAT(rows.err, containsText("no schedules"));
}

TEST_CASE("cli atlas: killed ten times at random moments and resumed, the same rows")
{
    const CommandLine program;
    const auto begin = std::chrono::steady_clock::now();
    REQUIRE(program.run(pairs + " --database whole.sqlite").status == 0);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    const auto whole = dump(program.file("whole.sqlite"));
    REQUIRE(whole.size() == 200 + 200 * 201 / 2);
    std::mt19937 generator(7);
    for (int k = 0; k < 10; ++k) {
        // At any moment of the run, however busy the machine is.
        const double limit = std::uniform_real_distribution<>(0.05, 1.0)(generator) * spent.count();
        (void)program.run(pairs + " --database parts.sqlite --resume --threads 2",
                          "timeout -s KILL " + std::to_string(limit));
    }
    // A question in between finds what is there, whatever the killed process left behind.
    const auto asked = program.run("atlas --database parts.sqlite --period 3 --format json");
    const json found = json::parse(asked.out);
    CHECK(asked.status == (found["schedules"].empty() && found["families"].empty() ? 3 : 0));
    CHECK(found["complete"].is_boolean());
    REQUIRE(program.run(pairs + " --database parts.sqlite --resume").status == 0);
    CHECK(dump(program.file("parts.sqlite")) == whole);
    CHECK_FALSE(fs::exists(program.file("parts.sqlite-journal")));
}

TEST_CASE("cli atlas: Ctrl-C ends with status 3 and words, --resume goes on")
{
    const CommandLine program;
    const std::string call = "atlas --database a.sqlite --cells 6 --phases 2 --all";
    // A busy machine may be slow to begin, and an idle one quick to end.
    auto stopped = program.run(call, "timeout -s INT 0.15");
    for (const char* later : {"timeout -s INT 0.08", "timeout -s INT 0.25", "timeout -s INT 0.4",
                              "timeout -s INT 0.8"}) {
        if (stopped.out.find("interrupted") == std::string::npos) {
            fs::remove(program.file("a.sqlite"));
            stopped = program.run(call, later);
        }
    }
    CHECK(stopped.status == 124);  // timeout's own
    CHECK_THAT(stopped.err, containsText("--resume"));
    CHECK_THAT(stopped.out, containsText("interrupted"));
    const auto other = program.run("atlas --database a.sqlite --cells 7 --resume");
    CHECK(other.status == 2);
    CHECK_THAT(other.err, containsText("another range"));
    const auto again = program.run(call);
    CHECK(again.status == 2);
    CHECK_THAT(again.err, containsText("--resume"));
    CHECK(lines(again.err) == 1);
    // Before it listens it dies of the signal, as any program does.
    int direct = 130;
    for (const char* delay : {"0.1", "0.3", "0.9"}) {
        if (direct == 130) {
            const std::string prefix = "timeout --preserve-status -s INT ";
            direct = program.run(call + " --resume --quiet", prefix + delay).status;
        }
    }
    CHECK((direct == 3 || direct == 0));
    REQUIRE(program.run(call + " --resume").status == 0);
    REQUIRE(program.run("atlas --database b.sqlite --cells 6 --phases 2 --all").status == 0);
    CHECK(dump(program.file("a.sqlite")) == dump(program.file("b.sqlite")));
}

TEST_CASE("cli atlas: threads and processes write the same rows")
{
    const CommandLine program;
    REQUIRE(program.run(pairs + " --database one.sqlite").status == 0);
    REQUIRE(program.run(pairs + " --database two.sqlite --threads 2").status == 0);
    const auto rows = dump(program.file("one.sqlite"));
    CHECK(dump(program.file("two.sqlite")) == rows);
    const std::string launch =
        "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
        "OMPI_MCA_btl_vader_single_copy_mechanism=none mpirun --oversubscribe -n 3";
    // One phase, several batches of families and schedules.
    const std::string single = "atlas --cells 150 --max-free 1500 --quiet --database ";
    REQUIRE(program.run(single + "a.sqlite").status == 0);
    REQUIRE(program.run(single + "b.sqlite --threads 2").status == 0);
    const auto schedules = dump(program.file("a.sqlite"));
    const auto families = dump(program.file("a.sqlite"), "families");
    CHECK(number(program.file("a.sqlite"), "SELECT batches FROM runs") > 3);
    CHECK(dump(program.file("b.sqlite")) == schedules);
    CHECK(dump(program.file("b.sqlite"), "families") == families);
    if (SIGNORINI_HAS_MPI != 0) {
        REQUIRE(program.run(single + "c.sqlite", launch).status == 0);
        CHECK(dump(program.file("c.sqlite")) == schedules);
        CHECK(dump(program.file("c.sqlite"), "families") == families);
        REQUIRE(program.run(pairs + " --database three.sqlite", launch).status == 0);
        CHECK(dump(program.file("three.sqlite")) == rows);
        // Trouble of one process ends all, with its status.
        CHECK(program.run(pairs + " --database no/three.sqlite", launch).status == 4);
    } else {
        const auto refused = program.run(pairs + " --database x.sqlite", "PMI_SIZE=2");
        CHECK(refused.status == 4);
        CHECK_THAT(refused.err, containsText("MPI"));
    }
}

TEST_CASE("cli atlas: a full disk or a file that is no atlas is status 4, nothing is corrupted")
{
    const CommandLine program;
    REQUIRE(program.run(pairs + " --database whole.sqlite").status == 0);
    const auto full = program.run(pairs + " --database full.sqlite", "ulimit -f 500;");
    CHECK(full.status == 4);
    CHECK_THAT(full.err, containsText("full.sqlite"));
    CHECK(lines(full.err) == 1);
    const auto asked = program.run("atlas --database full.sqlite --twins --format json");
    CHECK(asked.status == (json::parse(asked.out)["twins"].empty() ? 3 : 0));
    CHECK(json::parse(asked.out)["complete"] == false);
    CHECK_THAT(asked.err, containsText("batches"));
    const auto before = dump(program.file("full.sqlite"));
    CHECK(before.size() < 20'300);
    REQUIRE(program.run(pairs + " --database full.sqlite --resume").status == 0);
    CHECK(dump(program.file("full.sqlite")) == dump(program.file("whole.sqlite")));

    std::ofstream(program.file("text.sqlite")) << "words, and more words, that are no database";
    CHECK(program.run(pairs + " --database text.sqlite").status == 4);
    CHECK(contentOf(program.file("text.sqlite")) == "words, and more words, that are no database");
    CHECK(program.run(pairs + " --database .").status == 4);
    CHECK(program.run(pairs + " --database no/such.sqlite").status == 4);
    opened(program.file("other.sqlite"), SQLite::OPEN_CREATE)
        .exec("PRAGMA journal_mode = WAL; CREATE TABLE mine(x)");
    const std::string mine = contentOf(program.file("other.sqlite"));
    CHECK(program.run(pairs + " --database other.sqlite").status == 4);
    CHECK(contentOf(program.file("other.sqlite")) == mine);
    CHECK(program.run("atlas --database missing.sqlite --twins").status == 4);
    CHECK_FALSE(fs::exists(program.file("missing.sqlite")));
    if (geteuid() != 0) {  // root may write everywhere
        fs::permissions(program.file("whole.sqlite"), fs::perms::owner_read);
        CHECK(program.run(pairs + " --database whole.sqlite --max-free 3").status == 4);
    }
}

TEST_CASE("cli atlas: queries")
{
    const CommandLine program;
    REQUIRE(program.run("atlas --database a.sqlite --cells 12 --max-free 96").status == 0);
    const auto ask = [&program](const std::string& question) {
        const auto outcome = program.run("atlas --database a.sqlite --format json " + question);
        REQUIRE(outcome.status == 0);
        return json::parse(outcome.out);
    };
    // A point of the plane is one family, whatever the number of schedules.
    const json near = ask("--near 1.142857 20");
    REQUIRE(near["families"].size() == 1);
    const json& family = near["families"][0];
    CHECK(family["order"] == 4);
    CHECK(family["nu"] == 7);
    CHECK(family["contact_blocks"] == 1);
    CHECK(family["schedule"] == json::parse("[[6, 36]]"));
    CHECK(family["period_ratio"] == 3.5);
    CHECK(family["dimension"] == 5);
    CHECK(family["dimension_at_energy"] == 4);
    CHECK(family["connected_at_energy"] == false);  // 20 of 24 E_1: six spikes
    CHECK(family["energy_ratio_range"] == json::parse("[4.0, 24.0]"));
    CHECK(family["schedules"] == 11);
    CHECK(near["schedules"].empty());
    CHECK(ask("--near 8/7 12 --within 1e-9")["families"][0]["connected_at_energy"] == true);
    CHECK(ask("--near 8/7 4")["families"][0]["dimension_at_energy"] == 0);
    CHECK(ask("--near 8/7 24")["families"][0]["dimension_at_energy"] == 0);
    const json rows = ask("--near 1.142857 20 --schedules");
    CHECK(rows["families"] == near["families"]);
    CHECK(rows["schedules"].size() == 9);  // 24/d <= 20: all but the two ends of the tent
    for (const json& entry : rows["schedules"]) {
        CHECK(entry["family"] == family["id"]);
        CHECK(entry["period"] == 3.5);
        CHECK(entry["energy_ratio_range"][0].get<double>() <= 20.2);
        CHECK(entry["energy_ratio_range"][1].get<double>() >= 19.8);
    }
    const json period = ask("--period 7/2 --schedules");
    CHECK(period == ask("--period 3.5 --schedules"));
    CHECK(period["exact_period"] == json({7, 2}));
    CHECK(period["families"].size() == 1);
    int canonical = 0;
    for (const json& entry : period["schedules"]) {
        canonical += entry["canonical"].get<bool>() ? 1 : 0;
    }
    CHECK(canonical == 6);
    // Motions that graze are listed at their own period, not at that of a repetition.
    const json grazing = ask("--period 4 --schedules");
    for (const json& entry : grazing["schedules"]) {
        CHECK(entry["contact"] == "grazing");
        CHECK(entry["frequency_ratio"] == 1.0);
    }
    CHECK(ask("--period 8")["families"].empty());
    CHECK(ask("--period 8 --schedules")["schedules"].empty());
    const json groups = ask("--twins");
    REQUIRE(groups["twins"].size() > 0);
    for (const json& twins : groups["twins"]) {
        CHECK(twins["families"].size() > 1);
    }
    // An answer says what it covers: a null result is no proof where nothing was decided.
    CHECK(near["complete"] == true);
    CHECK(near["ranges"][0]["max_free"] == 96);
    const auto never = program.run("atlas --database a.sqlite --cells 77 --period 3 --format json");
    CHECK(json::parse(never.out)["complete"] == false);
    CHECK_THAT(never.err, containsText("decided nothing of N = 77") && containsText("N = 12"));
    REQUIRE(program.run("atlas --database low.sqlite --cells 30 --max-energy-ratio 5").status == 0);
    const auto low = program.run("atlas --database low.sqlite --near 8/7 20 --format json");
    CHECK(json::parse(low.out)["complete"] == false);
    CHECK_THAT(low.err, containsText("energy"));
    CHECK(json::parse(program.run("atlas --database low.sqlite --near 8/7 4 --format json")
                          .out)["complete"] == true);
    const auto words = program.run("atlas --database a.sqlite --period 10/3");
    CHECK_THAT(words.out, containsText("1 family") && containsText("(3, 5, 1)") &&
                              containsText("15 schedules") && containsText("on this grid"));
}

TEST_CASE("cli atlas: wrong use is status 2, one line, and no file")
{
    const CommandLine program;
    for (const char* arguments : {"",
                                  "--database",
                                  "--database a --max-contact 0",
                                  "--database a --max-free x",
                                  "--database a --phases 9",
                                  "--database a --cells 0",
                                  "--database a --threads 0",
                                  "--database a --max-energy-ratio -1",
                                  "--database a --phases 8",
                                  "--database a --near 1",
                                  "--database a --near 1 -5",
                                  "--database a --near x 5",
                                  "--database a --period 0",
                                  "--database a --period 1/0",
                                  "--database a --period x",
                                  "--database a --period 1/2/3",
                                  "--database a --period 12345678901",
                                  "--database a --near 1 20 --twins",
                                  "--database a --twins --all",
                                  "--database a --twins --resume",
                                  "--database a --within 0.1",
                                  "--database a --schedules",
                                  "--database a --twins --schedules",
                                  "--database a --all --families-only",
                                  "--database a --families-only --map m.svg",
                                  "--database a --phases 2 --families-only",
                                  "--database a --twins --families-only",
                                  "--database a --near 8/0 5",
                                  "--database a --near 8/7/6 5",
                                  "--database a --figure f.txt",
                                  "--database a --map m",
                                  "--database a --figure a",
                                  "--database f.svg --figure f.svg",
                                  "--database a --format xml"}) {
        const auto outcome = program.run(std::string("atlas ") + arguments);
        INFO(arguments << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK(outcome.out.empty());
        CHECK(program.files() == 0);
    }
}

TEST_CASE("cli atlas: the report stays on its lines, whatever the file is called")
{
    const CommandLine program;
    const auto usual = program.run("atlas --cells 2 --database a.sqlite");
    const auto odd = program.run("atlas --cells 2 --database \"$(printf 'a\\nb\\033[31m')\"");
    INFO(odd.out);
    REQUIRE(odd.status == 0);
    CHECK(lines(odd.out) == lines(usual.out));
    CHECK(odd.out.find('\033') == std::string::npos);
    CHECK(fs::exists(program.file("a\nb\033[31m")));
}

TEST_CASE("cli atlas: --csv is table families, with seconds, hertz and joules of the bar")
{
    const CommandLine program;
    REQUIRE(program.run("atlas --database a.sqlite --cells 12").status == 0);
    const auto table = program.run(
        "atlas --database a.sqlite --csv f.csv --length 2 --wave-speed 4 --gap 3 --quiet");
    REQUIRE(table.status == 0);
    CHECK(table.out.empty());
    const std::string text = contentOf(program.file("f.csv"));
    CHECK(lines(text) ==
          1 + number(program.file("a.sqlite").string(), "SELECT COUNT(*) FROM families"));
    // (4, 7, 1): n = 42 of 12 cells, G = 6; L/c = 0.5 s, E_1 = 9/4 J; tent of 2G - 1 schedules.
    CHECK_THAT(text, containsText("\n12,4,7,1,pressing,6,36,3.5,1.1428571428571428,1.75,"
                                  "0.5714285714285714,simplex,5,4,24,9,54,11\n"));
}

TEST_CASE("cli atlas: the frequency-energy plot and the existence map")
{
    const CommandLine program;
    REQUIRE(program.run("atlas --database a.sqlite --cells 12 --figure plot.svg --map map.svg")
                .status == 0);
    CHECK_THAT(contentOf(program.file("plot.svg")), containsText("</svg>"));
    CHECK_THAT(contentOf(program.file("map.svg")),
               containsText("</svg>") && containsText("(3, 5, 1)") && containsText("(4, 7, 1)") &&
                   !containsText("(5, 9, 1)") && containsText("[L/c]"));  // 5 does not divide 24
    REQUIRE(program.run("atlas --database a.sqlite --twins --map again.svg").status == 0);
    CHECK(program.files() == 4);
    // Of an atlas that exists pictures need no range, and nothing is decided for them.
    const auto drawn = program.run("atlas --database a.sqlite --map again.svg");
    REQUIRE(drawn.status == 0);
    CHECK(drawn.out.empty());
    CHECK(program.run("atlas --database a.sqlite --cells 13 --resume").status == 0);
    // A database knows its stops.
    REQUIRE(program.run("atlas --database p.sqlite --cells 4 --gap -1e-4").status == 0);
    const auto pressed = program.run("atlas --database p.sqlite --figure p.svg");
    CHECK(pressed.status == 2);
    CHECK_THAT(pressed.err, containsText("allowed with a gap > 0 and one stop"));
    // Trouble with a picture is found before the work, and not blamed on the database.
    const auto nowhere = program.run("atlas --database b.sqlite --cells 12 --figure no/x.svg");
    CHECK(nowhere.status == 4);
    CHECK_THAT(nowhere.err, containsText("--figure no/x.svg"));
    CHECK_FALSE(fs::exists(program.file("b.sqlite")));
}

TEST_CASE("cli atlas: bars in a row are asked in their own units, which the database knows")
{
    const CommandLine program;
    const std::string bars = "--scene 'clamp 3 gap=1e-3 4 clamp' --length 0.7 --wave-speed 5000";
    const auto made = program.run("atlas " + bars +
                                  " --database a.sqlite --max-contact 6 --max-free 30 --map m.svg");
    INFO(made.err);
    REQUIRE(made.status == 0);
    CHECK_THAT(made.out, containsText("2 bars, 7 cells, 0.7 m"));
    CHECK(fs::file_size(program.file("m.svg")) > 2000);
    const json scene = json::parse(program.run("scene " + bars + " --format json").out);
    const double first = scene["reference"]["frequency"].get<double>();

    // As often as the longer bar swings: grazing motions, found by omega/omega_1 and by c T/L.
    const auto near =
        program.run("atlas --database a.sqlite --near 1 3 --within 0.01 --schedules --format json");
    REQUIRE(near.status == 0);
    const json rows = json::parse(near.out)["schedules"];
    REQUIRE(!rows.empty());
    for (const json& row : rows) {
        CHECK(row["frequency"].get<double>() == Approx(first));
        CHECK(row["energy_ratio_range"][0].get<double>() <= 3.03);
        CHECK(row["spans"][0]["closed"] == json::array({1}));
        const std::string words = fmt::format("1:{} -:{}", row["spans"][0]["steps"].get<int>(),
                                              row["spans"][1]["steps"].get<int>());
        const json found = program.find(words + " " + bars, 0);
        CHECK(row["period"].get<double>() == Approx(found["period"].get<double>()));
        CHECK(row["energy_range"][0].get<double>() == Approx(found["energy"].get<double>()));
    }
    const auto same =
        program.run("atlas --database a.sqlite --period 16/7 --schedules --format json");
    CHECK(json::parse(same.out)["schedules"].size() >= rows.size());

    const auto refuses = [&program](const std::string& words, const std::string& why) {
        const auto refused = program.run("atlas --database a.sqlite " + words);
        INFO(words << ": " << refused.err);
        CHECK(refused.status == 2);
        CHECK_THAT(refused.err, containsText(why));
    };
    refuses("--period 2 --scene 'clamp 3 gap=1e-3 5 clamp'", "those of the database");
    refuses("--period 2 --length 2", "those of the database");
    refuses("--scene 'clamp 3 gap=1e-3 5 clamp'", "ranges of other bars");
    refuses(bars + " --families-only", "for bars in a row");
    REQUIRE(program.run("atlas --database a.sqlite --figure f.svg").status == 0);
    CHECK_THAT(contentOf(program.file("f.svg")),
               containsText("clamp 3 gap=0.001 4 clamp") && containsText("pressing"));
    REQUIRE(
        program.run("atlas --database a.sqlite --near 1 3 --within 0.01 --figure g.svg").status ==
        0);
    CHECK(contentOf(program.file("g.svg")) == contentOf(program.file("f.svg")));
    REQUIRE(program
                .run("atlas --scene 'free 2 gap=1e-3 3 clamp' --database d.sqlite --max-contact 2 "
                     "--max-free 9")
                .status == 0);
    const auto drifting = program.run("atlas --database d.sqlite --near 1 3");
    CHECK(drifting.status == 2);
    CHECK_THAT(drifting.err, containsText("nothing drifts"));
}
