// What a wrong word was probably meant to be.

#include "hints.hpp"

#include <set>

#include "command_line.hpp"
#include "options.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

/// One line on stderr, status 2, nothing on stdout; and in it all of these.
void checkRefused(const CommandLine& program, const std::string& words,
                  const std::vector<std::string>& wanted)
{
    const auto outcome = program.run(words);
    INFO(words << " -> " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(lines(outcome.err) == 1);
    CHECK(outcome.out.empty());
    for (const std::string& text : wanted) {
        CHECK_THAT(outcome.err, containsText(text));
    }
}

}  // namespace

TEST_CASE("cli hints: an option or command that is spelt nearly right is named")
{
    const CommandLine program;
    for (const auto& [words, meant] :
         {std::pair{"find 150 900 --energy_ratio 20", "did you mean --energy-ratio?"},
          std::pair{"find 150 900 --energyratio=20", "did you mean --energy-ratio?"},
          std::pair{"find 150 900 --enregy-ratio 20", "did you mean --energy-ratio?"},
          std::pair{"families --secondstop 1", "did you mean --second-stop?"},
          std::pair{"response --yield 250MPa", "did you mean --yield-stress?"},
          std::pair{"fnd 150 900", "did you mean find?"},
          std::pair{"respnse --from 1", "did you mean response?"}}) {
        checkRefused(program, words, {meant, "see signorini --help"});
    }
    // What stands behind an option of another command is its value.
    checkRefused(program, "find 150 900 --points -inf",
                 {"--points -inf is not expected; --points is allowed with continuum"});
    checkRefused(program, "sweep --energy -1",
                 {"--energy -1 is not expected; --energy is allowed with find, continuum"});
    checkRefused(program, "response --colour --strain-limit=1",
                 {"--strain-limit is allowed with find, continuum"});
    for (const char* words : {"find 150 900 --colour red", "fly 150 900", "find 150 900 --x 3"}) {
        const auto outcome = program.run(words);
        INFO(words << " -> " << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, !containsText("did you mean"));
    }
}

TEST_CASE("cli hints: names are as near as one or two letters")
{
    const std::vector<std::string> names{"--gap", "--cells", "--energy", "--energy-ratio"};
    CHECK(cli::nearestName("--gpa", names) == "--gap");
    CHECK(cli::nearestName("--cell", names) == "--cells");
    CHECK(cli::nearestName("--cels", names) == "--cells");
    CHECK(cli::nearestName("--enregi", names) == "--energy");
    CHECK(cli::nearestName("--energy_ratio=3", names) == "--energy-ratio");
    CHECK(cli::nearestName("--energy-r", names) == "--energy-ratio");
    CHECK(cli::nearestName("--length", names).empty());
    CHECK(cli::nearestName("--p", names).empty());
    CHECK(cli::nearestName("--" + std::string(100'000, 'g'), names).empty());
}

TEST_CASE("cli: a number may carry its unit")
{
    const CommandLine program;
    const auto same = [&](const std::string& one, const std::string& other) {
        INFO(one);
        const auto run = program.run(one);
        const auto plain = program.run(other);
        CHECK(run.status == plain.status);
        CHECK(run.out == plain.out);
        CHECK_FALSE(run.out.empty());
    };
    same("find 3 25 --cells 8 --young 210GPa --density '7.8 g/cm3' --area 1cm2 --gap 0.1mm",
         "find 3 25 --cells 8 --young 210e9 --density 7800 --area 1e-4 --gap 1e-4");
    same("find 3 25 --cells 8 --gap '-10 µm'", "find 3 25 --cells 8 --gap -1e-5");
    same("find --hertz 0.0002kHz", "find --hertz 0.2");
    same("find 12 96 --cells 30 --damping 2% --force tip",
         "find 12 96 --cells 30 --damping 0.02 --force tip");
    same("scene 'clamp 4 gap=0.1mm 6 clamp'", "scene 'clamp 4 gap=1e-4 6 clamp'");
    const std::string driven = "find 12 96 --cells 30 --damping 0.02 --amplitude ";
    same(driven + "250mN --force tip", driven + "0.25 --force tip");
    same(driven + "0.4mm --force base", driven + "4e-4 --force base");
    checkRefused(program, driven + "5kN --force base", {"--amplitude = 5kN", "[m]"});
    checkRefused(program, "find 150 900 --gap 10kg", {"--gap = 10kg", "[m]"});
    checkRefused(program, "find 150 900 --young 210GHz --density 1 --area 1", {"--young = 210GHz"});
}

TEST_CASE("cli hints: a stiffness in GPa and a damping in per cent are noticed in the answer")
{
    const CommandLine program;
    const std::string rest = " --density 7800 --area 1e-4";
    const std::string soft = program.run("find 3 25 --cells 8 --young 210" + rest).out;
    CHECK_THAT(soft, containsText("\nnote "));
    CHECK_THAT(soft, containsText("210 GPa are --young 2.1e+11"));
    CHECK_THAT(program.run("find 3 25 --cells 8 --young 210e9" + rest).out, !containsText("note"));
    const std::string driven =
        "simulate --rest --cells 10 --periods 2 --force tip --amplitude 1e-4 "
        "--frequency 1 --damping ";
    CHECK_THAT(program.run(driven + "2").out, containsText("2 % are --damping 0.02"));
    CHECK_THAT(program.run(driven + "0.02").out, !containsText("note"));
}

TEST_CASE("cli hints: what find needs, and hertz where ω₁ was asked for")
{
    const CommandLine program;
    checkRefused(program, "find", {"NC NF is missing", "150 900", "--period", "--hertz"});
    checkRefused(program, "find --hertz 494", {"L = 1 m, c = 1 m/s by default"});
    checkRefused(program, "find --hertz 1e9 --length 3 --wave-speed 5000",
                 {"(L = 3 m, c = 5000 m/s)"});
    checkRefused(program, "find --frequency 494", {"in Hz it is --hertz 494"});
    checkRefused(
        program, "response --from 530 --to 540",
        {"530 looks like Hz: ω₁ is 0.25 Hz (L = 1 m, c = 1 m/s by default)", "--from 2120"});
    // c/(4L) = 500 Hz.
    checkRefused(program, "response --from 530 --to 540 --length 2.5 --wave-speed 5000",
                 {"ω₁ is 500 Hz", "--from 1.06"});
    checkRefused(program, "response --from 300 --to 900 --length 2.5 --wave-speed 5000",
                 {"--to = 900 is out of range: allowed below 600 [ω₁] on 300 cells",
                  "900 looks like Hz: ω₁ is 500 Hz", "--to 900Hz, or --to 1.8"});
    checkRefused(program, "response --from 300Hz --to 900Hz",
                 {"--to = 900Hz", "; ω₁ is 0.25 Hz (L = 1 m, c = 1 m/s by default)"});
    // So high a frequency is one of the grid.
    CHECK(program
              .run("response --damping 0.02 --force tip --amplitude 1e-6 --from 19 --to 20 "
                   "--cells 30")
              .status == 0);
}

TEST_CASE("cli hints: no question has two options of one name, and defaults that are values fit")
{
    for (unsigned question = 1; question <= answers::asks::study; question <<= 1U) {
        std::set<std::string_view> names;
        for (const answers::Option& option : answers::options()) {
            INFO(option.name);
            if ((option.of & question) != 0) {
                CHECK(names.insert(option.name).second);
                CHECK(answers::optionOf(question, option.name) == &option);
            }
            CHECK_FALSE(option.sentence.empty());
            const bool isValue =
                option.usual.find_first_not_of("0123456789.e-") == std::string::npos;
            CHECK((option.usual.empty() || !isValue || option.fits(option.usual)));
        }
    }
}

TEST_CASE(
    "cli hints: a fault of the library names the option, its value, and the range in its unit")
{
    const CommandLine program;
    checkRefused(program, "find 5 23 --cells 8 --tolerance 1",
                 {": --tolerance = 1 is", "1e-12..1e-2"});
    checkRefused(program, "continuum 5 23 --cells 8 --energy-ratio 9 --resolution 2",
                 {": --resolution = 2 is"});
    const auto said = [](const std::string& message) {
        return answers::inOptions(message, answers::asks::schedule, [](std::string_view name) {
            return name == "--tip-floor" ? "3mm" : name == "--energy" ? "5" : "";
        });
    };
    // 3 mm are 6 g where g = 0.5 mm, so that 2 g are 1 mm.
    CHECK(said("tipFloor = 6 is out of range: allowed below 2 [g]; cells = 3 is out of range: "
               "allowed 1..2") ==
          "--tip-floor = 3mm is out of range: allowed below 0.001 [m]; cells = 3 is out of range: "
          "allowed 1..2");
    CHECK(said("energyRatio = 50 is out of range: allowed 10..20 [E_1]") ==
          "--energy = 5 is out of range: allowed 1..2 [J]");
    CHECK(said("strainLimit = 100: none") == "strainLimit = 100: none");
}
