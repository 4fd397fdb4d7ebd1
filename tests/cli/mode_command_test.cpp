// signorini mode: one motion of a continuous family, at any period.

#include <cmath>
#include <cstdlib>

#include "command_line.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("cli mode: the main mode in numbers known in closed form")
{
    const CommandLine program;
    // t_c = 4 - T, 1/sqrt(E/E_1) = T - 3 in ]3, 4[; c = 5000 m/s, EA = 2e7 N, L = 2 m, g = 1 mm.
    const auto outcome = program.run(
        "mode 4 -1 --period 3.7 --length 2 --wave-speed 5000 --axial-stiffness 2e7 --gap 1e-3 "
        "--format json");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const json r = json::parse(outcome.out);
    const double time = 2.0 / 5000.0;
    const double h = 0.5 / 0.7;
    CHECK(r["schema"] == 2);
    CHECK(r["status"] == "found");
    CHECK(r["bar"]["length"] == 2.0);
    CHECK(r["mode"]["contact"] == json({4, -1}));
    CHECK(r["mode"]["family"] == "main");
    CHECK(r["mode"]["inverse_sqrt_energy"] == json({1, 3}));
    CHECK(r["period_ratio"].get<double>() == 3.7);
    CHECK(r["period"].get<double>() == Approx(3.7 * time));
    CHECK(r["frequency"].get<double>() == Approx(1.0 / (3.7 * time)));
    CHECK(r["frequency_ratio"].get<double>() == Approx(4.0 / 3.7));
    CHECK(r["contact_time"].get<double>() == Approx(0.3 * time));
    CHECK(r["energy_ratio"].get<double>() == Approx(1.0 / 0.49));
    CHECK(r["energy"].get<double>() == Approx(2e7 * 1e-6 / 4.0 / 0.49));
    CHECK(r["jumps"].size() == 2);
    CHECK(r["jumps"][0] == json({4, -1}));
    const json& physical = r["physical"];
    CHECK(physical["peak_force"].get<double>() == Approx(2.0 * h * 2e7 * 1e-3 / 2.0));
    CHECK(physical["impulse"].get<double>() == Approx(2.0 * h * 2e7 * 1e-3 / 2.0 * 0.3 * time));
    CHECK(physical["approach_speed"].get<double>() == Approx(2.0 * h * 5000.0 * 1e-3 / 2.0));
    CHECK(physical["peak_compression"].get<double>() == Approx(2.0 * h * 1e-3 / 2.0));
}

TEST_CASE("cli mode: on the grid of its period it is what find answers there")
{
    const CommandLine program;
    const auto outcome =
        program.run("mode 4 -1 --period 7/2 --cells 12 --state mode.csv --motion mode-motion.csv");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK_THAT(outcome.out, containsText("exact: T is 42 steps of 12 cells"));
    const json found = program.find("6 36 --cells 12 --state find.csv --motion find-motion.csv", 0);
    CHECK(contentOf(program.file("mode.csv")) == contentOf(program.file("find.csv")));
    const json mode = json::parse(program.run("mode 4 -1 --period 3.50 --format json").out);
    CHECK(mode["energy_ratio"].get<double>() == Approx(found["energy_ratio"].get<double>()));
    CHECK(mode["period"].get<double>() == Approx(found["period"].get<double>()));
    const std::string table = contentOf(program.file("mode-motion.csv"));
    CHECK(lines(table) == lines(contentOf(program.file("find-motion.csv"))));
    // Velocity and strain belong to the middle of a cell, and the table says which.
    CHECK(table.starts_with("time,x,displacement,velocity,strain,x_cell\n"));
    CHECK_THAT(table, containsText("\n0,1,"));
    const std::string last = table.substr(0, table.find('\n', table.find("\n0,1,") + 1));
    CHECK(std::stod(last.substr(last.rfind(',') + 1)) == Approx(11.5 / 12.0));
}

TEST_CASE("cli mode: between the grids the state holds means, and comes back as a target")
{
    const CommandLine program;
    const auto outcome = program.run("mode 8 -3 --period 2.5303030303 --cells 50 --state mode.csv");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK_THAT(outcome.out, containsText("means over 50 cells"));
    CHECK(lines(contentOf(program.file("mode.csv"))) == 51);
}

TEST_CASE("cli mode: a mode that is none, or a period outside its interval, is wrong use")
{
    const CommandLine program;
    for (const auto& [arguments, text] :
         {std::pair{"4 -1 --period 4", "]3, 4["}, std::pair{"4 -1 --period 3", "--period = 3"},
          std::pair{"4 -1 --period 2.99", "]3, 4["}, std::pair{"4 -1 --period 8/2", "]3, 4["},
          std::pair{"4 -1", "--period is missing: allowed ]3, 4["},
          std::pair{"4 -1 --period nan", "--period = nan"},
          std::pair{"4 -1 --period 7/0", "--period = 7/0"},
          std::pair{"4 -1 --period 0", "--period = 0"},
          std::pair{"5 -1 --period 3.5", "A4 B = 5 -1"}, std::pair{"4 -2 --period 3.5", "4 -2"},
          std::pair{"4 1 --period 3.5", "B = 1"}, std::pair{"-4 -1 --period 3.5", "A4 = -4"},
          std::pair{"4 --period 3.5", "two numbers"}, std::pair{"4 x --period 3.5", "B = x"},
          std::pair{"4 -1 -1 --period 3.5", "two numbers"},
          std::pair{"4 -1 --period 3.5 --motion a.txt", "a.txt"},
          std::pair{"4 -1 --period 3.5 --state a.csv --motion a.csv", "two different"},
          std::pair{"4 -1 --period 3.5 --state a_files --motion a.pvd", "two different"},
          std::pair{"4 -1 --period 3.5 --figure a.gif", "a.gif"}}) {
        const auto outcome = program.run(std::string("mode ") + arguments);
        INFO(arguments << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, containsText(text));
    }
    CHECK(program.files() == 0);
}

TEST_CASE("cli mode: --motion writes a time series and its folder, together or not at all")
{
    const CommandLine program;
    const std::string call = "mode 4 -1 --period 3.3 --cells 10 --motion m.pvd";
    REQUIRE(program.run(call).status == 0);
    CHECK(program.files() == 2);
    CHECK(fs::exists(program.file("m_files") / "bar_0033.vtu"));
    REQUIRE(program.run(call).status == 0);
    CHECK(program.files() == 2);
    std::ofstream(program.file("m_files") / "notes.txt") << "mine";
    const auto kept = program.run(call);
    CHECK(kept.status == 4);
    CHECK_THAT(kept.err, containsText("m_files") && containsText("more than .vtu files"));
    CHECK(contentOf(program.file("m_files") / "notes.txt") == "mine");
    CHECK(program.files() == 2);
}

TEST_CASE("cli mode: a figure between the grids is drawn on the nearest one, and says so")
{
    const CommandLine program;
    const auto outcome =
        program.run("mode 4 -1 --period 3.14159265358979 --figure m.svg --cells 20");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK_THAT(outcome.out, containsText("figure      shows T = 3.14159292"));  // 355/113
    CHECK_THAT(contentOf(program.file("m.svg")), containsText("</svg>"));
}

TEST_CASE("cli: moving pictures of a motion and of a continuum")
{
    const CommandLine program;
    for (const char* call : {"mode 4 -1 --period 3.3 --cells 10", "find 3 18 --cells 6",
                             "continuum 6 36 --cells 12 --energy-ratio 8 --points 5"}) {
        const auto outcome = program.run(std::string(call) + " --animate a.gif");
        INFO(call << "\n" << outcome.err);
        REQUIRE(outcome.status == 0);
        const std::string gif = contentOf(program.file("a.gif"));
        CHECK(gif.starts_with("GIF89a"));
        CHECK(gif.ends_with('\x3b'));
        CHECK(gif.find("NETSCAPE2.0") != std::string::npos);  // it is played again and again
        fs::remove(program.file("a.gif"));
        const auto wrong = program.run(std::string(call) + " --animate a.avi");
        CHECK(wrong.status == 2);
        CHECK_THAT(wrong.err, containsText("a.avi") && containsText(".gif or .mp4"));
    }
    if (std::system("command -v ffmpeg >/dev/null") == 0) {
        REQUIRE(program.run("mode 4 -1 --period 3.3 --cells 5 --animate a.mp4").status == 0);
        CHECK(contentOf(program.file("a.mp4")).substr(4, 4) == "ftyp");
        fs::remove(program.file("a.mp4"));
    }
    // Without ffmpeg there is no film, and no other file of the call.
    const auto film = program.run("mode 4 -1 --period 3.3 --cells 5 --animate a.mp4 --state s.csv",
                                  "mkdir bin && ln -s $(command -v gnuplot) bin/ && PATH=$PWD/bin");
    CHECK(film.status == 4);
    CHECK_THAT(film.err, containsText("ffmpeg") && containsText(".gif"));
    CHECK(lines(film.err) == 1);
    CHECK_FALSE(fs::exists(program.file("a.mp4")));
    CHECK_FALSE(fs::exists(program.file("s.csv")));
}
