// Words of the command line that are easy to get wrong.

#include "command_line.hpp"

using namespace signorini::test;

TEST_CASE("cli: an empty value is refused for every option of every command")
{
    struct Command {
        const char* words;
        std::vector<const char*> options;
    };
    const std::vector<const char*> common{"cells",   "length", "wave-speed", "axial-stiffness",
                                          "gap",     "young",  "density",    "area",
                                          "threads", "format"};
    const CommandLine program;
    for (const Command& command :
         {Command{"find 5 23",
                  {"solver", "formulation", "objective", "target", "energy-ratio", "strain-limit",
                   "tip-floor", "tolerance", "time-limit", "state", "motion", "figure"}},
          Command{"continuum 5 23",
                  {"energy-ratio", "points", "from", "to", "direction", "seed", "engine",
                   "strain-limit", "tolerance", "csv", "figure"}},
          Command{"modes", {"max-energy-ratio", "max-order", "max-period", "figure"}},
          Command{"families", {"max-energy-ratio", "max-order", "csv", "figure"}},
          Command{"atlas",
                  {"database", "max-contact", "max-free", "phases", "max-energy-ratio", "near",
                   "within", "period", "figure", "map"}},
          Command{"response",
                  {"damping", "force", "amplitude", "from", "to", "cycles", "csv", "figure"}},
          Command{"simulate",
                  {"from", "damping", "force", "amplitude", "frequency", "phase", "time", "periods",
                   "events", "tip", "figure"}}}) {
        std::vector<const char*> options = command.options;
        options.insert(options.end(), common.begin(), common.end());
        for (const std::string option : options) {
            for (const char* value : {"= --quiet"}) {
                const auto outcome =
                    program.run(std::string(command.words) + " --" + option + value);
                INFO(command.words << " --" << option << value << " -> " << outcome.err);
                CHECK(outcome.status == 2);
                CHECK(lines(outcome.err) == 1);
                CHECK_THAT(outcome.err, containsText("--" + option));
            }
        }
    }
    CHECK(program.run("find 5 23 --cells 8 --state --quiet").status == 2);
    CHECK(program.run("find 5 23 --cells 8 --state ''").status == 2);
    CHECK(program.files() == 0);
}

TEST_CASE("cli: two dashes end the options, wherever they stand among the step counts")
{
    const CommandLine program;
    const std::string whole = program.run("find 5 23 --cells 8").out;
    CHECK_THAT(whole, containsText("found"));
    for (const char* words :
         {"--cells 8 5 -- 23", "--cells 8 -- 5 23", "--cells 8 5 23 --", "5 --cells 8 -- 23"}) {
        INFO(words);
        const auto outcome = program.run(std::string("find ") + words);
        CHECK(outcome.status == 0);
        CHECK(outcome.out.substr(0, 60) == whole.substr(0, 60));
    }
    CHECK(program.run("continuum --energy-ratio 8 --cells 12 --points 2 6 -- 36").status == 0);
    CHECK(program.run("modes --max-order 1 --").status == 0);
    for (const auto& [words, named] :
         {std::pair{"find 5 -- --cells", "--cells"}, std::pair{"find 5 -- -23", "-23"},
          std::pair{"modes -- 7", "7"}, std::pair{"modes -- --quiet", "--quiet"},
          std::pair{"find 5 23 --cells -- 8", "--cells"}, std::pair{"-- find 5 23", "--"}}) {
        const auto outcome = program.run(words);
        INFO(words << " -> " << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK_THAT(outcome.err, containsText(named));
    }
}

TEST_CASE("cli: an option given again is refused and counted")
{
    const CommandLine program;
    for (const auto& [words, named] :
         {std::pair{"find 5 23 --gap 1 --gap 2 --gap 3", "--gap is given 3 times"},
          std::pair{"modes --max-order 2 --max-order=3", "--max-order is given 2 times"},
          std::pair{"atlas --near 1 2 --near 1 2", "--near is given 2 times"}}) {
        const auto outcome = program.run(words);
        INFO(words << " -> " << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText(named));
    }
}

TEST_CASE("cli: a value of any length is answered in few words")
{
    const CommandLine program;
    const std::string large(100'000, '7');
    for (const std::string& words :
         {"find 5 " + large, "find 5 -" + large, "find 5 23 --gap x" + large,
          "find 5 23 --solver " + large, "find 5 23 --motion " + large,
          "find 5 23 --figure " + large, "find 5 23 --format " + large, "atlas --period " + large,
          "fly" + large, "find 5 23 --" + large}) {
        const auto outcome = program.run(words);
        INFO(words.substr(0, 40) << " -> " << outcome.err.substr(0, 400));
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK(outcome.err.size() < 400);
    }
}

TEST_CASE("cli: every answer in words begins with the bar that was meant")
{
    const CommandLine program;
    // c = 5000 m/s: ω₁ = 5000/(4·2) Hz, E₁ = 2e7·(1e-6)²/(2·2) J.
    const std::string steel = " --length 2 --young 2e11 --density 8000 --area 1e-4 --gap 1e-6";
    const std::string forced = " --damping 5 --force tip --amplitude 20";
    for (const std::string call :
         {"find 3 25 --cells 8", "find --period 7/2", "continuum 6 36 --cells 12 --energy-ratio 8",
          "modes", "modes --phases 2 --max-order 3", "mode 4 -1 --period 3.2", "families",
          "atlas --database a.sqlite --cells 6", "atlas --database a.sqlite --period 7/2",
          "simulate --rest --cells 10 --time 1e-3"}) {
        const auto outcome = program.run(call + steel);
        INFO(call << "\n" << outcome.out << outcome.err);
        const std::string first = outcome.out.substr(0, outcome.out.find('\n'));
        CHECK_THAT(first, containsText("L = 2 m, c = 5000 m/s, EA = 2e+07 N, g = 1e-06 m"));
        CHECK_THAT(first, containsText("ω₁ = 625 Hz, E₁ = 5e-06 J"));
    }
    for (const std::string call : {"find 10 60 --cells 20", "response --cells 8 --from 0.9 --to 1",
                                   "simulate --rest --cells 10 --frequency 1 --periods 2"}) {
        const auto outcome = program.run(call + forced);
        INFO(call << "\n" << outcome.out << outcome.err);
        CHECK_THAT(outcome.out.substr(0, outcome.out.find('\n')), containsText(", ζ = 5; "));
    }
    const std::string stepped = program.run("find 3 25 --segments 4:1,4:1.3").out;
    CHECK_THAT(stepped.substr(0, stepped.find('\n')), containsText("segments 4:1"));
    const std::string touching = program.run("find 225 675 --gap 0 --energy 1e-6").out;
    CHECK_THAT(touching.substr(0, touching.find('\n')), containsText("no E₁"));
}
