// Files as the program meets them in the world: links, pipes, devices, folders with odd names,
// streams that are closed.

#include <filesystem>
#include <fstream>

#include "command_line.hpp"

using namespace signorini::test;

namespace {

const std::string small = "find 5 23 --cells 8 ";

/// A word for the shell, whatever it holds.
std::string quoted(const std::string& word)
{
    std::string text = "'";
    for (const char c : word) {
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return text + "'";
}

/// A program called gnuplot in a folder of its own, in front of the others.
std::string fakeGnuplot(const CommandLine& program, const std::string& script)
{
    fs::create_directory(program.file("bin"));
    std::ofstream(program.file("bin") / "gnuplot") << "#!/bin/sh\n" << script;
    fs::permissions(program.file("bin") / "gnuplot", fs::perms::owner_all);
    return "PATH=\"$PWD/bin:$PATH\" ";
}

bool hasGnuplot()
{
    return std::system("command -v gnuplot >/dev/null 2>&1") == 0;
}

}  // namespace

TEST_CASE("cli: standard error that is full or closed changes neither status nor files")
{
    const CommandLine program;
    REQUIRE(
        program.run("atlas --cells 2 --max-contact 2 --max-free 4 --database a.sqlite").status ==
        0);
    for (const char* sink : {"2>/dev/full", "2>&-"}) {
        const auto status = [&](const std::string& words) {
            return program.run(words + " >/dev/null " + sink + "; exit $?; #").status;
        };
        INFO(sink);
        CHECK(status("find 0 5") == 2);
        CHECK(status("fly") == 2);
        CHECK(status(small + "--state /no/such/folder/s.csv") == 4);
        CHECK(status("find 2 4 --cells 2 --state s.csv") == 1);
        CHECK(status("continuum 2 4 --cells 2 --energy-ratio 4 --csv k.csv") == 1);
        CHECK(status("atlas --database a.sqlite --near 1.1 400") == 3);
        CHECK(program.files() == 1);
        CHECK(status("find 3 93 --cells 8 --motion m.csv") == 0);
        CHECK(lines(contentOf(program.file("m.csv"))) == 1 + 65 * 9);
        CHECK_THAT(contentOf(program.file("m.csv")), !containsText("signorini"));
        fs::remove(program.file("m.csv"));
    }
    CHECK(program.run(small + "--state s.csv >&-; exit $?; #").status == 4);
}

TEST_CASE("cli: two outputs that links lead to one file are refused, even if it is not there yet")
{
    const CommandLine program;
    fs::create_symlink("new.sqlite", program.file("pic.svg"));
    fs::create_symlink("new.csv", program.file("a.csv"));
    fs::create_symlink("a.csv", program.file("b.csv"));
    fs::create_directory(program.file("folder"));
    fs::create_directory_symlink("folder", program.file("linked"));
    const std::ptrdiff_t before = program.files();
    for (const std::string& words :
         {std::string("atlas --cells 2 --max-contact 2 --max-free 4 --database new.sqlite "
                      "--figure pic.svg"),
          small + "--state a.csv --motion new.csv", small + "--state a.csv --motion b.csv",
          small + "--state folder/c.csv --motion linked/c.csv",
          std::string("continuum 6 36 --cells 12 --energy-ratio 8 --csv pic.svg "
                      "--figure new.sqlite/../pic.svg --quiet")}) {
        const auto outcome = program.run(words);
        INFO(words << " -> " << outcome.err);
        CHECK(outcome.status == (words.starts_with("continuum") ? 4 : 2));
        CHECK(lines(outcome.err) == 1);
        CHECK(program.files() == before);
        CHECK(fs::is_empty(program.file("folder")));
    }
}

TEST_CASE("cli: a path through a linked folder means what the system means by it")
{
    const CommandLine program;
    fs::create_directories(program.file("deep/sub"));
    fs::create_directory_symlink("deep/sub", program.file("linked"));
    CHECK(program.run(small + "--state linked/../s.csv").status == 0);
    CHECK(fs::exists(program.file("deep/s.csv")));
    CHECK_FALSE(fs::exists(program.file("s.csv")));
}

TEST_CASE("cli: link loops, names too long and a deleted folder are exit status 4, with the option")
{
    const CommandLine program;
    fs::create_symlink("loop.csv", program.file("loop.csv"));
    const std::string large(300, 'x');
    for (const auto& [words, named] :
         {std::pair{small + "--state loop.csv --motion m.csv", "--state loop.csv"},
          std::pair{small + "--state s.csv --motion loop.csv", "--motion loop.csv"},
          std::pair{small + "--state " + large, "--state"},
          std::pair{small + "--state s.csv --motion " + large + ".csv", "too long"},
          std::pair{small + "--objective nearest --target loop.csv", "--target loop.csv"},
          std::pair{small + "--objective nearest --target " + large, "--target"},
          std::pair{std::string("continuum 6 36 --cells 12 --energy-ratio 8 --from loop.csv "
                                "--to loop.csv"),
                    "--from loop.csv"},
          std::pair{std::string("atlas --cells 2 --database loop.csv --figure f.svg"),
                    "--database"}}) {
        const auto outcome = program.run(words);
        INFO(words << " -> " << outcome.err);
        CHECK(outcome.status == 4);
        CHECK(lines(outcome.err) == 1);
        CHECK_THAT(outcome.err, containsText(named));
        CHECK(program.files() == 1);
    }
    for (const char* words : {"--state s.csv", "--state s.csv --motion m.csv"}) {
        const auto outcome = program.run(small + words, "mkdir gone; cd gone; rmdir ../gone;");
        INFO(words << " -> " << outcome.err);
        CHECK(outcome.status == 4);
        CHECK_THAT(outcome.err, containsText("--state s.csv"));
    }
}

TEST_CASE("cli: when one file cannot be put into place none is, and the option is named")
{
    const CommandLine program;
    std::ofstream(program.file("s.csv")) << "old";
    fs::create_symlink("/dev/full", program.file("full.csv"));
    const auto full = program.run(small + "--state s.csv --motion full.csv");
    CHECK(full.status == 4);
    CHECK_THAT(full.err, containsText("--motion full.csv: cannot write: No space left"));
    CHECK(contentOf(program.file("s.csv")) == "old");
    CHECK(program.files() == 2);

    // A folder takes the place of the motion after all checks; the program waits for a reader of
    // the figure until then.
    const std::string figure =
        fakeGnuplot(program, "echo '<svg>" + std::string(64, ' ') + "</svg>'\n");
    const auto outcome = program.run(
        small + "--state s.csv --motion m.csv --figure f.svg",
        "mkfifo f.svg; (for i in $(seq 500); do [ \"$(ls -A | grep -c '^.signorini')\" = 2 ] && "
        "mkdir m.csv && cat f.svg >read.txt && exit; sleep 0.01; done) & " +
            figure);
    INFO(outcome.err);
    CHECK(outcome.status == 4);
    CHECK_THAT(outcome.err, containsText("--motion m.csv: cannot replace"));
    CHECK(contentOf(program.file("s.csv")) == "old");
    CHECK(contentOf(program.file("read.txt")).empty());
    CHECK(program.files() == 6);  // s.csv, full.csv, bin, f.svg, m.csv, read.txt
}

TEST_CASE("cli: a pipe receives a file like a folder does")
{
    const CommandLine program;
    REQUIRE(program.run(small + "--state s.csv").status == 0);
    const auto outcome =
        program.run(small + "--state pipe --motion m.csv", "mkfifo pipe; cat pipe >read.csv &");
    CHECK(outcome.status == 0);
    for (int k = 0; k < 5000 && contentOf(program.file("read.csv")).size() <
                                    contentOf(program.file("s.csv")).size();
         ++k) {
        (void)usleep(1000);
    }
    CHECK(contentOf(program.file("read.csv")) == contentOf(program.file("s.csv")));
    CHECK(program.files() == 4);
}

TEST_CASE("cli: a state comes through a pipe, too, but never without end")
{
    const CommandLine program;
    REQUIRE(program.run(small + "--objective max-energy --state t.csv").status == 0);
    const std::string nearest = "--objective nearest --target ";
    const auto through = [&](const std::string& writer) {
        return program.run(small + nearest + "pipe --quiet",
                           "rm -f pipe; mkfifo pipe; (" + writer + ") >pipe 2>/dev/null & ");
    };
    CHECK(through("cat t.csv").status == 0);
    for (const auto& [writer, named] :
         {std::pair{"cat /dev/zero", "line 1"}, std::pair{"yes 1,2,3", "no column a"},
          std::pair{"echo x,a,b; yes 1,2,3", "line 10: allowed at most 8 rows"},
          std::pair{"head -n 8 t.csv", "cells of the target = 7"},
          std::pair{"printf 'x,a,b\\n1,2,3'", "newline"}}) {
        const auto outcome = through(writer);
        INFO(writer << " -> " << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText(named));
    }
    const auto device = program.run(small + nearest + "/dev/zero");
    CHECK(device.status == 4);
    CHECK_THAT(device.err, containsText("--target /dev/zero"));
    // Nobody writes: the program waits, as every program does, and can be interrupted.
    const auto waiting =
        program.run(small + nearest + "pipe", "rm -f pipe; mkfifo pipe; timeout -k 5 -s INT 0.2");
    CHECK(waiting.status == 124);
}

TEST_CASE("cli: a signal while gnuplot runs leaves nothing behind")
{
    const CommandLine program;
    fs::create_directory(program.file("tmp"));
    const auto outcome =
        program.run(small + "--figure f.svg --state s.csv",
                    "TMPDIR=\"$PWD/tmp\" " + fakeGnuplot(program, "kill -TERM $PPID\nsleep 0.1\n"));
    CHECK(outcome.status == 128 + SIGTERM);
    CHECK(fs::is_empty(program.file("tmp")));
    CHECK(program.files() == 2);
}

TEST_CASE("cli: no name of a folder or file is a command of gnuplot")
{
    if (!hasGnuplot()) {
        return;
    }
    const CommandLine program;
    for (const char* name :
         {"x'; system 'touch ran'; y='", "\"`touch ran`\nsystem 'touch ran'\n"}) {
        fs::create_directory(program.file(name));
        const std::string figure = std::string(name) + "/" + name + ".svg";
        const auto outcome = program.run(small + "--figure " + quoted(figure),
                                         "TMPDIR=" + quoted(program.file(name).string()));
        INFO(name << " -> " << outcome.err);
        CHECK(outcome.status == 0);
        CHECK_FALSE(fs::exists(program.file("ran")));
        CHECK_THAT(contentOf(program.file(figure.c_str())), containsText("</svg>"));
        fs::remove_all(program.file(name));
    }
    CHECK(program.files() == 0);
}

TEST_CASE("cli: files are written whole, together, and replace old ones")
{
    const CommandLine program;
    std::ofstream(program.file("state.csv")) << "old";
    const auto outcome = program.run(
        "find 5 23 --cells 8 --state state.csv --motion motion.csv --figure figure.svg");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(program.files() == 3);
    CHECK_THAT(contentOf(program.file("state.csv")),
               containsText("x,a,b,velocity,strain,displacement\n"));
    CHECK(lines(contentOf(program.file("state.csv"))) == 9);
    CHECK(lines(contentOf(program.file("motion.csv"))) == 1 + 29 * 9);
    CHECK_THAT(contentOf(program.file("figure.svg")), containsText("</svg>"));
    CHECK(program.run("find 5 23 --cells 8 --motion m.vtk").status == 0);
    CHECK_THAT(contentOf(program.file("m.vtk")), containsText("RECTILINEAR_GRID"));
}

TEST_CASE("cli: without a motion no file is written, and old ones stay")
{
    const CommandLine program;
    std::ofstream(program.file("state.csv")) << "old";
    const auto outcome = program.run("find 2 4 --cells 2 --state state.csv --figure f.png");
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, containsText("no file was written"));
    CHECK(contentOf(program.file("state.csv")) == "old");
    CHECK(program.files() == 1);
}

TEST_CASE("cli: --certificate is the claim with all of its proof, of a motion that of its energy")
{
    const CommandLine program;
    CHECK(program.run("find 2 4 --cells 2 --certificate proof.json --state s.csv").status == 1);
    CHECK(program.files() == 1);
    const json written = json::parse(contentOf(program.file("proof.json")));
    const json printed = json::parse(program.run("find 2 4 --cells 2 --format json").out);
    CHECK(written.size() == 9);
    for (const auto& [key, value] : written.items()) {
        CHECK(value == printed.at(key));
    }
    CHECK(written["certificate"]["verified"] == true);
    CHECK(!written["certificate"]["periodicity"].empty());

    const auto found = program.run("find 5 23 --cells 8 --certificate other.json --state s.csv");
    CHECK(found.status == 0);
    const json energies = json::parse(contentOf(program.file("other.json")))["certificate"];
    CHECK(energies["kind"] == "energy-range");
    CHECK(energies["verified"] == true);
    CHECK(energies["equalities"].size() == 1);
    CHECK(program.files() == 3);
    // Within a limit the least of all is the least, too; of the most nothing is proved.
    CHECK(program.run("find 5 23 --cells 8 --strain-limit 1 --certificate l.json").status == 0);
    CHECK(program.files() == 4);
    const auto unproved = program.run(
        "find 5 23 --cells 8 --strain-limit 1 --energy-ratio 8 --certificate unproved.json");
    CHECK(unproved.status == 0);
    CHECK_THAT(unproved.err, containsText("no proof to write"));
    CHECK(program.files() == 4);
    // The proof that a forced bar has no motion is its answer.
    const auto force = [&program](const char* more) {
        return program.run(
            std::string("find 12 75 --cells 10 --damping 0.02 --force tip --amplitude 1e-4 ") +
            more);
    };
    CHECK(force("--certificate forced.json --state s.csv").status == 1);
    CHECK(contentOf(program.file("forced.json")) == force("--format json").out);
    CHECK(program.files() == 5);
    CHECK(program.run("find 5 23 --cells 8 --certificate s.csv --state s.csv").status == 2);
    CHECK(program.run("find --period 7/2 --certificate p.json").status == 2);
    // A list longer than a piece in which it is written.
    CHECK(program.run("find 20001 90000 --cells 30000 --certificate long.json").status == 1);
    CHECK(json::parse(contentOf(program.file("long.json")))["certificate"]["periodicity"].size() >
          20'000);
}

TEST_CASE("cli: files that cannot be written are exit status 4, and nothing is left behind")
{
    const CommandLine program;
    for (const char* arguments :
         {"--state /no/such/folder/x.csv", "--state .", "--state /dev/full",
          "--motion good.csv --state /dev/full", "--figure /no/such/folder/x.png"}) {
        const auto outcome = program.run(std::string("find 5 23 --cells 8 ") + arguments);
        INFO(arguments << " -> " << outcome.err);
        CHECK(outcome.status == 4);
        CHECK(outcome.out.empty());
        CHECK(lines(outcome.err) == 1);
        CHECK(program.files() == 0);
    }
    const auto full = program.run("find 5 23 --cells 8 >/dev/full; exit $?; #");
    CHECK(full.status == 4);
}

TEST_CASE("cli: a file size limit is a full disk: exit status 4 and nothing left behind")
{
    const CommandLine program;
    for (const char* arguments : {"find 150 900 --figure f.svg", "find 150 900 --figure f.png",
                                  "find 150 900 --state s.csv", "find 150 900 --motion m.vtk"}) {
        const auto outcome = program.run(arguments, "ulimit -f 16;");
        INFO(arguments << " -> " << outcome.err);
        CHECK(outcome.status == 4);
        CHECK(program.files() == 0);
    }
}

TEST_CASE("cli: links are followed, modes kept, read-only and looping targets refused")
{
    const CommandLine program;
    std::ofstream(program.file("private.csv")) << "old";
    fs::permissions(program.file("private.csv"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("private.csv", program.file("link.csv"));
    fs::create_symlink("new.csv", program.file("dangling.csv"));
    fs::create_symlink("loop2.csv", program.file("loop1.csv"));
    fs::create_symlink("loop1.csv", program.file("loop2.csv"));
    CHECK(program.run("find 5 23 --cells 8 --state link.csv").status == 0);
    CHECK(fs::is_symlink(program.file("link.csv")));
    CHECK(lines(contentOf(program.file("private.csv"))) == 9);
    CHECK(fs::status(program.file("private.csv")).permissions() ==
          (fs::perms::owner_read | fs::perms::owner_write));
    CHECK(program.run("find 5 23 --cells 8 --state dangling.csv").status == 0);
    CHECK(lines(contentOf(program.file("new.csv"))) == 9);
    CHECK(program.run("find 5 23 --cells 8 --state loop1.csv").status == 4);
    CHECK(program.run("find 5 23 --cells 8 --figure f.svg", "TMPDIR=/no/such/folder").status == 4);
}

TEST_CASE("cli: standard output is for the report alone")
{
    const CommandLine program;
    CHECK(program.run("find 5 23 --cells 8 --state /dev/stdout").status == 2);
    CHECK(program.run("--version >/dev/full; exit $?; #").status == 4);
    const auto large =
        program.run("find 2000 10901 --cells 4000 --format json >/dev/full; exit $?; #");
    CHECK(large.status == 4);
}

TEST_CASE("cli: a signal removes what was begun")
{
    const CommandLine program;
    const auto outcome =
        program.run("find 1 39999999 --cells 10000000 --state s.csv", "timeout --signal=INT 0.7");
    if (outcome.status == 0) {
        return;  // a machine fast enough to finish first
    }
    CHECK(program.files() == 0);
}
