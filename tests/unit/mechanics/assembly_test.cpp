#include "signorini/assembly.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "network.hpp"
#include "statics.hpp"

using namespace signorini;

namespace {

Assembly assembly(const std::string& text)
{
    return {.parts = partsOf(text)};
}

}  // namespace

TEST_CASE("assembly: words are read and come back")
{
    const std::string text =
        "clamp shaken 150 stop=0.001 gap=-0.002 200:1.3:0.5 dash=0.1 10:2 spring=4 force=-3 driven "
        "stop=-0.001 gap=0 7 stop=right:-0.5 free";
    const std::vector<AssemblyPart> parts = partsOf(text);
    CHECK(textOf(parts) == text);
    CHECK(partsOf(textOf(parts)) == parts);
    CHECK(parts[5] ==
          AssemblyPart{.kind = PartKind::cells, .cells = 200, .impedance = 1.3, .speed = 0.5});
    CHECK(partsOf("stop=-0").front().kind == PartKind::leftStop);
    CHECK(partsOf("stop=0").front().kind == PartKind::rightStop);
    CHECK(partsOf("stop=left:-1e-3").front() ==
          AssemblyPart{.kind = PartKind::leftStop, .value = -1e-3});
    CHECK(partsOf(" \t\n").empty());
}

TEST_CASE("assembly: a wrong word is named, with what is allowed")
{
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"clamp 300 wall=1", "scene, word 3 = wall=1 is out of range: allowed clamp, free"},
        {"clamp 0 stop=1",
         "word 2 = 0 is out of range: allowed N[:Z[:C]], N cells in 1..100000000"},
        {"clamp 1000000000 stop=1", "word 2 = 1000000000"},
        {"clamp 3:-1 stop=1", "word 2 = 3:-1"},
        {"clamp 3: stop=1", "word 2 = 3:"},
        {"clamp 3:1:1:1 stop=1", "word 2 = 3:1:1:1"},
        {"clamp 3 stop=nan", "word 3 = stop=nan is out of range: allowed stop=G"},
        {"clamp 3 gap=inf", "word 3 = gap=inf is out of range: allowed gap=G, G finite [m]"},
        {"clamp 3 mass=0 3 stop=1", "word 3 = mass=0 is out of range: allowed mass=M, M finite"},
        {"clamp 3 spring=-1 stop=1", "word 3 = spring=-1"},
        {"clamp 3 stop", "word 3 = stop is"},
        {"clamp=1 3 stop=1", "word 1 = clamp=1 is"}};
    for (const auto& [text, message] : wrong) {
        CHECK_THROWS_WITH(partsOf(text), Catch::Contains(message));
    }
}

TEST_CASE("assembly: what is no scene is refused, and the word is named")
{
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"", "scene = '' is out of range: allowed a row of cells"},
        {"clamp 300", "allowed a contact: stop=G or gap=G"},
        {"clamp stop=1 300", "word 2 = stop=1 is out of range: allowed places that move"},
        {"clamp 3 gap=1 clamp 4", "word 4 = clamp is out of range: allowed a stop in its place"},
        {"clamp 3 clamp gap=1 4", "word 3 = clamp is out of range: allowed a stop in its place"},
        {"clamp 3 mass=1 stop=1",
         "word 3 = mass=1 is out of range: allowed places without contact"},
        {"clamp 3 gap=1 mass=1 4",
         "word 4 = mass=1 is out of range: allowed places without contact"},
        {"clamp 3 stop=1 stop=2", "word 4 = stop=2 is out of range: allowed once at a node"},
        {"clamp 3 stop=1 stop=left:-1", "word 4 = stop=left:-1 is out of range: allowed two stops"},
        {"clamp 3 free 3 stop=1", "word 3 = free is out of range: allowed at an end"},
        {"clamp free 3 stop=1", "word 2 = free is out of range: allowed places that move"},
        {"shaken 3 stop=1", "word 1 = shaken is out of range: allowed at a clamp"},
        {"clamp 3 gap=1", "word 3 = gap=1 is out of range: allowed a gap with cells"},
        {"clamp 3 gap=1 gap=1 3", "word 4 = gap=1 is out of range: allowed a gap with cells"},
        {"clamp 3 gap=1 dash=1", "word 4 = dash=1 is out of range: allowed a gap with cells"},
        {"clamp 3 gap=1 spring=1", "word 4 = spring=1 is out of range: allowed behind a gap only"},
        {"clamp dash=1 3 stop=1", "word 2 = dash=1 is out of range: allowed places that move"},
        {"clamp 3 stop=1e200", "word 3 = stop=1e+200 is out of range: allowed 0, or what leaves"},
        {"clamp 3 gap=-1e-140 3 clamp", "word 3 = gap=-1e-140 is out of range: allowed 0, or"},
        {"clamp 3 force=1e150 stop=1", "word 3 = force=1e+150 is out of range: allowed 0, or"},
        {"clamp 99999999 9 stop=1", "word 3 = 9 is out of range: allowed at most 100000000 cells"}};
    for (const auto& [text, message] : wrong) {
        CHECK_THROWS_WITH(validate(assembly(text)), Catch::Contains(message));
    }
    CHECK_THROWS_WITH(networkOf(assembly("clamp 300 gap=1e-3 spring=50 dash=0.08")),
                      Catch::Contains("dash = 0.08 is out of range: allowed D >= K h/2"));
    Assembly heavy = assembly("clamp 3 stop=1");
    heavy.length = std::nan("");
    heavy.gravity = std::nan("");
    CHECK_THROWS_WITH(validate(heavy),
                      Catch::Contains("length = nan") && Catch::Contains("gravity"));
}

TEST_CASE("assembly: the examples of the language are networks")
{
    const Network paper = networkOf(assembly("clamp 300 stop=1e-3"));
    const Network today = networkOf(Scene{}, 300);
    CHECK(paper.rows == today.rows);
    CHECK(paper.contacts == today.contacts);
    CHECK(paper.scales.time == Approx(today.scales.time));
    CHECK(paper.scales.displacement == Approx(today.scales.displacement));

    const Network two = networkOf(assembly("clamp 150 gap=1e-3 200:1.3 clamp"));
    CHECK(two.bars.size() == 2);
    CHECK(two.contacts == std::vector{NetworkContact{ContactKind::gap, 1, 350.0}});
    const Network flying = networkOf(assembly("stop=-1e-3 300 stop=1e-3"));
    CHECK(flying.bars.front().drifts());
    CHECK(flying.contacts.front() == NetworkContact{ContactKind::stopLeft, 0, 300.0});
    const Network string = networkOf(assembly("clamp 100 stop=5e-4 200 clamp"));
    CHECK(string.bars.front().clamps == 2);
    const Network soft = networkOf(assembly("clamp 300 gap=1e-3 spring=50 dash=0.1"));
    CHECK(soft.bars[1].firstNode == soft.bars[1].lastNode);
    CHECK(soft.stubs.front().impedance == Approx(50.0 / 600.0));
    const Network root = networkOf(assembly("spring=4 300 stop=1e-3"));
    CHECK(root.bars.front().springs == 1);
    CHECK(!root.bars.front().drifts());
}

TEST_CASE("assembly: frequency, damping and energy of reference are those of closed forms")
{
    const double pi = std::numbers::pi;
    CHECK(referenceOf(networkOf(assembly("clamp 300 stop=1e-3"))).frequency ==
          Approx(0.5 * pi).epsilon(1e-12));
    CHECK(referenceOf(networkOf(assembly("clamp 300 stop=1e-3"))).energy.value() ==
          Approx(0.5e-6).epsilon(1e-12));
    CHECK(referenceOf(networkOf(assembly("stop=-1e-3 300 stop=1e-3"))).frequency ==
          Approx(pi).epsilon(1e-12));
    CHECK(!referenceOf(networkOf(assembly("stop=-1e-3 300 stop=1e-3"))).energy);
    CHECK(referenceOf(networkOf(assembly("clamp 100 stop=1e-3 200 clamp"))).frequency ==
          Approx(pi).epsilon(1e-12));
    CHECK(referenceOf(networkOf(assembly("clamp 100 stop=1e-3 200 clamp"))).compliance.value() ==
          Approx(2.0 / 9.0).epsilon(1e-12));
    // tan(w l_1) tan(w l_2) = Z_1/Z_2.
    const SceneReference stepped = referenceOf(networkOf(assembly("clamp 100 200:2 stop=1e-3")));
    CHECK(std::tan(stepped.frequency / 3.0) * std::tan(stepped.frequency * 2.0 / 3.0) ==
          Approx(0.5).epsilon(1e-10));
    // A dashpot at the tip damps every mode alike.
    const Damping damping{0.02};
    const SceneReference damped = referenceOf(networkOf(Scene{}, 300, damping));
    CHECK(damped.damping.value() == Approx(0.02).epsilon(1e-9));
    CHECK(referenceOf(networkOf(assembly("clamp 300 gap=1e-3 200 clamp"))).compliance.value() ==
          Approx(1.0).epsilon(1e-12));
}

TEST_CASE("assembly: springs and masses err by the square of the step")
{
    // Against the bar with a true spring or mass: w = omega L/c.
    const auto bisect = [](auto f, double low, double high) {
        for (int k = 0; k < 200; ++k) {
            const double middle = 0.5 * (low + high);
            ((f(middle) > 0.0) == (f(high) > 0.0) ? high : low) = middle;
        }
        return low;
    };
    struct Case {
        std::string before;
        std::string after;
        double exact;
        std::vector<double> errors;  // at N = 10, 20, 40, 80: docs/theory.md, section 20
    };
    const double mass = bisect([](double w) { return w * 0.5 * std::tan(w) - 1.0; }, 0.1, 1.5);
    const double spring = bisect([](double w) { return -std::tan(w) - 0.5 * w; }, 1.6, 3.1);
    const double root = bisect([](double w) { return w * std::tan(w) - 2.0; }, 0.1, 1.5);
    const std::vector<Case> cases{
        {"clamp ", " mass=0.5", mass, {-2.7e-4, -6.8e-5, -1.7e-5, -4.2e-6}},
        {"clamp ", " spring=2", spring, {-7.8e-4, -1.9e-4, -4.9e-5, -1.2e-5}},
        {"spring=2 ", "", root, {-2.7e-4, -6.8e-5, -1.7e-5, -4.2e-6}}};
    for (const Case& scene : cases) {
        std::size_t k = 0;
        for (const int cells : {10, 20, 40, 80}) {
            // A stop elsewhere, so that it is a scene.
            const std::string rows =
                std::to_string(cells / 2) + " stop=1 " + std::to_string(cells - cells / 2);
            const double found =
                referenceOf(networkOf(assembly(scene.before + rows + scene.after))).frequency;
            CHECK(found / scene.exact - 1.0 == Approx(scene.errors[k]).epsilon(0.03));
            ++k;
        }
    }
}

TEST_CASE("assembly: weight moves gaps, and is a force where a bar stands")
{
    // rho A = 1, g = 10: the tip of a hanging bar sinks by 5 rho g L^2/EA.
    Assembly hanging = assembly("clamp 100 stop=6");
    hanging.gravity = 10.0;
    const Network one = networkOf(hanging);
    CHECK(one.nodes[1].rest * one.scales.displacement == Approx(5.0).epsilon(1e-12));
    CHECK(one.contacts.front().gap * one.scales.displacement == Approx(1.0).epsilon(1e-12));
    CHECK(one.nodes[1].force == 0.0);

    Assembly standing = assembly("40 60 stop=0");
    standing.gravity = 10.0;
    const Network two = networkOf(standing);
    CHECK(two.nodes[2].force * two.scales.force() == Approx(10.0).epsilon(1e-12));
    CHECK(two.nodes[2].rest == 0.0);
    // Its head sinks by 5, the joint by what the part below shortens: 10 (0.6 (0.4 + 0.3)).
    CHECK(two.nodes[0].rest * two.scales.displacement == Approx(5.0).epsilon(1e-12));
    CHECK(two.nodes[1].rest * two.scales.displacement == Approx(4.2).epsilon(1e-12));

    // A soft root: K u = weight.
    Assembly soft = assembly("spring=4 100 stop=6");
    soft.gravity = 10.0;
    const Network root = networkOf(soft);
    CHECK(root.nodes[0].rest * root.scales.displacement == Approx(2.5).epsilon(1e-12));
    CHECK(root.nodes[1].rest * root.scales.displacement == Approx(7.5).epsilon(1e-12));
}

TEST_CASE("assembly: at rest contacts push or are open, and a step changes nothing")
{
    const std::vector<std::pair<std::string, ContactSet>> cases{
        {"clamp 5 stop=right:-1e-3", 1},
        {"clamp 5 stop=1e-3", 0},
        {"clamp 5 gap=-1e-3 7:2 clamp", 1},
        {"clamp 5 gap=-1e-3 7:2 gap=-2e-3 3 clamp", 3},
        {"clamp 5 gap=-1e-3 7:2 gap=2e-3 3 clamp", 1},
        {"clamp 5 force=1 stop=1e-3", 1},
        {"clamp 5 force=5e-4 stop=1e-3", 0},
        {"3 force=1 stop=0", 1},
        {"spring=2 3 gap=-1e-3 4 mass=1 2 clamp", 1},
        {"clamp 6 gap=-1e-3 spring=2 dash=1", 1}};
    for (const auto& [text, closed] : cases) {
        const Network scene = networkOf(assembly(text));
        const Rest rest = restOf(scene);
        CHECK(rest.closed == closed);
        const NetworkLaw<double> law(scene, rest.closed);
        NetworkWaves<double> waves(scene, rest.waves);
        double size = 0.0;
        for (const double wave : rest.waves) {
            size = std::max(size, std::abs(wave));
        }
        for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
            CHECK(law.velocity(node).at(waves.arriving(), 0.0, 0.0) == Approx(0.0).margin(1e-12));
        }
        for (int step = 0; step < 20; ++step) {
            waves.step(law);
        }
        const std::vector<double> after = waves.waves();
        for (std::size_t k = 0; k < after.size(); ++k) {
            CHECK(after[k] == Approx(rest.waves[k]).margin(1e-11 * size));
        }
    }
    CHECK_THROWS_WITH(restOf(networkOf(assembly("3 force=1 3 stop=-1"))),
                      Catch::Contains("constant forces"));
}
