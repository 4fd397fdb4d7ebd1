// signorini families: the list against a search of this file's own, units, files, wrong use.

#include <numeric>
#include <optional>
#include <sstream>

#include "command_line.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

/// The sum of epsilon over the first w blocks, if the blocks of (w, nu, k) are a motion's: waves
/// come back after w blocks, as they were from contact, negated from flight; the wall presses in
/// contact, the tip never is beyond it in flight, and it is reached.
std::optional<std::int64_t> windowSum(std::int64_t w, std::int64_t nu, std::int64_t k)
{
    std::vector<std::int64_t> wave(static_cast<std::size_t>(nu), 0);
    const auto at = [&wave](std::int64_t block) -> std::int64_t& {
        return wave[static_cast<std::size_t>(block)];
    };
    at(0) = 1;
    std::int64_t block = 0;
    for (std::int64_t step = 0; step < nu; ++step) {
        const std::int64_t next = (block + w) % nu;
        const std::int64_t value = block < k ? at(block) : -at(block);
        if (at(next) != 0 && at(next) != value) {
            return std::nullopt;
        }
        at(next) = value;
        block = next;
    }
    for (std::int64_t i = 0; i < k; ++i) {
        if (at(i) < 0) {
            return std::nullopt;
        }
    }
    std::int64_t path = 0;
    for (std::int64_t i = k; i < nu; ++i) {
        path += at(i);
        if (path > 0) {
            return std::nullopt;
        }
    }
    std::int64_t sum = 0;
    for (std::int64_t i = 0; i < w; ++i) {
        sum += at(i % nu);
    }
    return sum < 0 ? std::optional(sum) : std::nullopt;
}

/// w, nu, k and sum of every family of order <= most.
std::vector<std::array<std::int64_t, 4>> search(std::int64_t most)
{
    std::vector<std::array<std::int64_t, 4>> found;
    for (std::int64_t w = 1; w <= most; ++w) {
        for (std::int64_t nu = 1; nu <= 3 * w; ++nu) {
            for (std::int64_t k = 1; k < nu && std::gcd(w, nu) == 1; ++k) {
                if (const auto sum = windowSum(w, nu, k)) {
                    found.push_back({w, nu, k, *sum});
                }
            }
        }
    }
    return found;
}

json ask(const CommandLine& program, const std::string& options)
{
    const auto outcome = program.run("families --format json " + options);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.err.empty());
    return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("cli families: the list is that of a search over all (w, nu, k)")
{
    const CommandLine program;
    const json answer = ask(program, "--max-order 24");
    const auto truth = search(24);
    CHECK(answer["complete"] == true);
    CHECK(answer["count"] == truth.size());
    REQUIRE(answer["families"].size() == truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const auto& [w, nu, k, sum] = truth[i];
        const json& family = answer["families"][i];
        CHECK(family["order"] == w);
        CHECK(family["nu"] == nu);
        CHECK(family["contact_blocks"] == k);
        CHECK(family["period_ratio"] == json({2 * nu, w}));
        CHECK(family["contact"] == json({2 * k, w}));
        const std::int64_t p = family["least_energy_exact"][0];
        const std::int64_t q = family["least_energy_exact"][1];
        CHECK(p * sum * sum == q * w * w);
        CHECK(std::gcd(p, q) == 1);
        CHECK(family["least_energy_ratio"].get<double>() ==
              static_cast<double>(p) / static_cast<double>(q));
        // On the curve of the mode: 2k/w = 4a + b 2nu/w.
        CHECK(2 * k ==
              family["mode"][0].get<std::int64_t>() * w + family["mode"][1].get<int>() * 2 * nu);
    }
}

TEST_CASE("cli families: 33 up to order 12, 1,651 up to 60, the paper's third from below")
{
    const CommandLine program;
    const json answer = ask(program, "");
    CHECK(answer["schema"] == 2);
    CHECK(answer["version"].is_string());
    CHECK(answer["max_order"] == 12);
    CHECK(answer["families"].size() == 33);
    CHECK(answer["families"][0]["period_ratio"] == json({10, 3}));
    CHECK(answer["families"][0]["least_energy_exact"] == json({9, 1}));
    CHECK(answer["families"][1]["period_ratio"] == json({14, 4}));
    CHECK(answer["families"][1]["mode"] == json({4, -1}));
    CHECK(ask(program, "--max-order 60")["count"] == 1651);
}

TEST_CASE("cli families: seconds, hertz and joules are those of the bar")
{
    const CommandLine program;
    // c = 5000 m/s, EA = 2e7 N: L/c = 0.4 ms, E_1 = EA g^2/(2L) = 5 uJ.
    const json answer =
        ask(program, "--length 2 --young 2e11 --density 8000 --area 1e-4 --gap 1e-6 --max-order 4");
    REQUIRE(answer["families"].size() == 2);
    const json& paper = answer["families"][1];
    CHECK(paper["period"].get<double>() == Approx(3.5 * 4e-4));
    CHECK(paper["frequency"].get<double>() == Approx(1.0 / (3.5 * 4e-4)));
    CHECK(paper["frequency_ratio"].get<double>() == Approx(8.0 / 7.0));
    CHECK(paper["least_energy"].get<double>() == Approx(4.0 * 5e-6));
    CHECK(answer["bar"]["wave_speed"] == 5000.0);
}

TEST_CASE("cli families: an energy bound keeps those that reach below it, their own energy too")
{
    const CommandLine program;
    const auto truth = search(16);
    for (const std::int64_t bound : {1, 3, 4, 9}) {
        const auto count = std::count_if(truth.begin(), truth.end(), [bound](const auto& family) {
            return family[0] * family[0] <= bound * family[3] * family[3];
        });
        CHECK(ask(program, "--max-order 16 --max-energy-ratio " + std::to_string(bound))["count"] ==
              count);
    }
}

TEST_CASE("cli families: in words, one line a family")
{
    const CommandLine program;
    const auto outcome = program.run("families");
    CHECK(outcome.status == 0);
    CHECK(lines(outcome.out) == 4 + 33);
    CHECK_THAT(outcome.out, containsText("33 families") && containsText("f [Hz]") &&
                                containsText("E [J]") && containsText("10/3") &&
                                containsText("4 - T"));
    const auto none = program.run("families --max-order 2");
    CHECK(none.status == 0);
    CHECK(lines(none.out) == 2);
    CHECK_THAT(program.run("families --threads 2").err, containsText("one thread"));
}

TEST_CASE("cli families: the table reads back as the numbers of the JSON answer")
{
    const CommandLine program;
    const json answer = ask(program, "--max-order 20 --length 3 --csv f.csv");
    std::istringstream table(contentOf(program.file("f.csv")));
    std::string row;
    std::getline(table, row);
    CHECK_THAT(row, containsText("order,nu,contact_blocks,period_ratio") &&
                        containsText("mode_contact,mode_turns"));
    for (const json& family : answer["families"]) {
        REQUIRE(std::getline(table, row));
        std::vector<double> numbers;
        std::istringstream fields(row);
        for (std::string field; std::getline(fields, field, ',');) {
            numbers.push_back(std::stod(field));
        }
        REQUIRE(numbers.size() == 12);
        CHECK(numbers[0] == family["order"]);
        CHECK(numbers[1] == family["nu"]);
        CHECK(numbers[2] == family["contact_blocks"]);
        CHECK(numbers[3] ==
              family["period_ratio"][0].get<double>() / family["period_ratio"][1].get<double>());
        CHECK(numbers[6] == family["least_energy_ratio"]);
        CHECK(numbers[7] == family["period"]);
        CHECK(numbers[8] == family["frequency"]);
        CHECK(numbers[9] == family["least_energy"]);
        CHECK(numbers[10] == family["mode"][0]);
        CHECK(numbers[11] == family["mode"][1]);
    }
    CHECK_FALSE(std::getline(table, row));
}

TEST_CASE("cli families: a wrong call is exit status 2, one line, and no file")
{
    const CommandLine program;
    for (const auto& [arguments, text] :
         {std::pair{"--max-order 0", "--max-order = 0"}, std::pair{"--max-order 20001", "1..20000"},
          std::pair{"--max-order 2.5", "--max-order = 2.5"},
          std::pair{"--max-energy-ratio nan", "--max-energy-ratio = nan"},
          std::pair{"--max-energy-ratio=-1", "--max-energy-ratio = -1"},
          std::pair{"--figure f.svg", "two different files"},
          std::pair{"--format xml", "--format = xml"}, std::pair{"7", "7"}}) {
        const std::string figure =
            std::string(arguments).starts_with("--figure") ? "" : " --figure g.svg";
        const auto outcome = program.run(std::string("families --csv f.svg ") + arguments + figure);
        INFO(arguments << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, containsText(text));
    }
    CHECK(program.run("families --figure a.gif").status == 2);
    CHECK(program.run("families --csv no/such/f.csv").status == 4);
    CHECK(program.files() == 0);
}

TEST_CASE("cli families: an interrupted list says that it is not complete, and is no file")
{
    const CommandLine program;
    const auto outcome =
        program.run("families --max-order 20000 --max-energy-ratio 1.01 --csv f.csv --format json",
                    "timeout -s INT 0.6");
    // timeout itself answers 124; what the program wrote counts.
    const json answer = json::parse(outcome.out);
    CHECK(answer["complete"] == false);
    CHECK(!answer["families"].empty());
    CHECK(answer["count"] == answer["families"].size());
    CHECK_THAT(outcome.err, containsText("interrupted"));
    CHECK(program.files() == 0);
}

TEST_CASE("cli families: the figure has a cell for each family, axes and a scale")
{
    const CommandLine program;
    const auto outcome = program.run("families --figure f.svg --quiet");
    if (outcome.status == 4) {
        return;  // no gnuplot here
    }
    CHECK(outcome.status == 0);
    const std::string figure = contentOf(program.file("f.svg"));
    for (const char* label : {"order", "T [L/c]", "ω/ω", "least energy", "33 families", "mode",
                              ">5,1<", ">7,1<", ">18,4<", ">13,1<"}) {
        CHECK_THAT(figure, containsText(label));
    }
    CHECK(program.run("families --max-order 2 --figure f.svg").status == 0);
    CHECK(program.run("families --max-order 140 --figure f.svg --quiet").status == 0);
}
