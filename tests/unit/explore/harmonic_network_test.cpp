#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"
#include "disturbed.hpp"
#include "driven_bar.hpp"
#include "exact_response.hpp"
#include "harmonic_contact.hpp"
#include "harmonic_growth.hpp"
#include "harmonic_network_contact.hpp"
#include "has_solver.hpp"
#include "infinity.hpp"
#include "network_forced.hpp"
#include "sanitized.hpp"
#include "signorini/assembly.hpp"

using namespace signorini;

namespace {

Network barsOf(std::string_view words, double gravity = 0.0)
{
    Assembly assembly;
    assembly.parts = partsOf(words);
    assembly.gravity = gravity;
    return networkOf(assembly);
}

/// The same bars on a grid q times as fine: wider gaps in units of it.
Network finer(std::string_view words, std::int64_t q, double gravity = 0.0)
{
    Assembly assembly;
    assembly.parts = partsOf(words);
    assembly.gravity = gravity;
    for (AssemblyPart& part : assembly.parts) {
        part.cells *= q;
    }
    return networkOf(assembly);
}

}  // namespace

TEST_CASE("harmonic network: of one bar the list is that of the closed form")
{
    std::mt19937 random(3);
    const auto draw = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    std::size_t count = 0;
    std::size_t reached = 0;  // strains
    for (int i = 0; i < 300; ++i) {
        const std::int64_t cells = 3 + i % 6;
        const auto steps = static_cast<std::int64_t>(draw(2.0, 5.5) * static_cast<double>(cells));
        const double ratio = std::pow(10.0, draw(-2.0, -0.7));
        const test::DrivenBar drawn(cells, steps, ratio, i % 5 == 4,
                                    i % 2 == 0 ? Excited::tip : Excited::base,
                                    std::pow(10.0, draw(-1.0, 0.5)));
        const auto bar = harmonicContacts(drawn.damping, drawn.excitation(), drawn.stops);
        const auto network = harmonicContacts(drawn.network());
        INFO(i << ": " << cells << " cells, n = " << steps << ", " << drawn.amplitude);
        REQUIRE(network.size() == bar.size());
        for (std::size_t k = 0; k < bar.size(); ++k) {
            const auto size = static_cast<double>(cells);
            CHECK(network[k].contactTime() == Approx(size * bar[k].contacts[0].end).epsilon(1e-7));
            CHECK(network[k].impulse == Approx(size * bar[k].extremes.impulse).epsilon(1e-7));
            CHECK(network[k].peakForce == Approx(bar[k].extremes.peakForce).epsilon(1e-7));
            CHECK(network[k].speed == Approx(bar[k].contacts[0].speed).epsilon(1e-6).margin(1e-8));
            CHECK(network[k].first().isPinned == bar[k].contacts[0].isPinned);
            CHECK(network[k].residual < 1e-9);
            const auto isBound = [&](double bound, double strain) {
                CHECK(bound >= strain * (1.0 - 1e-9));
                CHECK(bound <= 1.002 * strain);  // at the clamp or the tip
                reached += bound <= strain * (1.0 + 1e-9) ? 1 : 0;
            };
            isBound(-network[k].leastStrain, bar[k].extremes.peakCompression);
            isBound(network[k].mostStrain, bar[k].extremes.peakTension);
        }
        count += bar.size();
    }
    CHECK(count > 120);
    CHECK(static_cast<double>(reached) > 1.8 * static_cast<double>(count));
}

TEST_CASE("harmonic network: of one bar disturbances grow as by the closed form")
{
    std::mt19937 random(8);
    const auto draw = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    std::size_t known = 0;
    std::size_t missing = 0;  // in one of the two
    std::array<std::size_t, 2> growing{};
    std::array<std::size_t, 2> pinned{};
    for (int i = 0; i < 300; ++i) {
        const std::int64_t cells = 30 + i % 23;
        const auto steps = static_cast<std::int64_t>(draw(2.0, 5.5) * static_cast<double>(cells));
        const double ratio = std::pow(10.0, draw(-2.0, -0.2));
        const test::DrivenBar drawn(cells, steps, ratio, false,
                                    i % 2 == 0 ? Excited::tip : Excited::base,
                                    std::pow(10.0, draw(-1.0, 0.5)));
        const HarmonicCase given = harmonicCase(drawn.damping, drawn.excitation(), drawn.stops);
        const auto network = harmonicContacts(drawn.network());
        const auto bar = harmonicContacts(given);
        REQUIRE(network.size() == bar.size());
        for (std::size_t k = 0; k < bar.size(); ++k) {
            const auto closed = growthOf(given, bar[k]);
            const auto& growth = network[k].growth;
            if (!closed || !growth) {
                missing += closed || growth ? 1 : 0;
                continue;
            }
            ++known;
            ++pinned.at(network[k].first().isPinned ? 1 : 0);
            ++growing.at(*growth > 1.0 ? 1 : 0);
            // Where waves between fronts fade as slowly both know it to a hundredth only.
            CHECK(*growth == Approx(*closed).epsilon(*closed > 0.8 ? 2e-3 : 2e-2));
        }
    }
    CHECK(known > 40);
    CHECK(missing < 10);
    CHECK(growing[0] > 10);
    CHECK(growing[1] > 10);
    CHECK(pinned[1] > 5);
}

namespace {

/// Of a motion with one contact, in steps of the coarse grid.
struct Met {
    double impulse;
    double contact;
};

/// All motions with one contact of more than a step under a staircase with q steps in each.
std::vector<Met> staircase(std::string_view words, std::int64_t q, std::int64_t steps,
                           Excited place, double amplitude, double gravity = 0.0)
{
    const Network fine = finer(words, q, gravity);
    const double unit = place == Excited::tip ? 1.0 : static_cast<double>(fine.cells());
    std::vector<Met> all;
    for (std::int64_t contact = 2; contact < q * steps; ++contact) {
        const ForcedSet set =
            forcedScene(fine, {{1, contact}, {0, q * steps - contact}}, {place, 1, {}}, 1e6);
        if (set.status == Status::found) {
            for (const ForcedMotion& motion : motionsOfAmplitude(set, unit * amplitude)) {
                const auto size = static_cast<double>(q);
                all.push_back(
                    {motion.extremes.impulse / size, static_cast<double>(contact) / size});
            }
        }
    }
    return all;
}

}  // namespace

TEST_CASE(
    "harmonic network: bars that meet, a stepped bar, an obstacle: lists are those of staircases")
{
    std::mt19937 random(5);
    const auto draw = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    std::size_t count = 0;
    for (const char* words :
         {"clamp 3 dash=0.1 driven gap=1e-3 2:1.3 dash=0.2 2:1.3 clamp",
          "clamp 3 4:1.7 dash=0.1 driven stop=1e-3", "clamp shaken 2 3:0.6 dash=0.1 stop=1e-3",
          "clamp 3 driven stop=5e-4 4 dash=0.3 2 clamp"}) {
        const Network network = barsOf(words);
        if (network.bars.size() == 1 && network.nodes.back().isClamped && !test::hasSimplex()) {
            continue;  // some of its waves have a node at the dashpot: staircases need programs
        }
        const bool isShaken = network.nodes.front().isShaken;
        const Excited place = isShaken ? Excited::base : Excited::tip;
        const double unit = isShaken ? static_cast<double>(network.cells()) : 1.0;
        for (int i = 0; i < test::drawn(12); ++i) {
            const auto n =
                static_cast<std::int64_t>(draw(2.2, 4.5) * static_cast<double>(network.cells()));
            const double amplitude = std::exp2(draw(-1.0, 2.0));
            const auto exact =
                harmonicContacts(HarmonicNetwork{network, place, unit * amplitude, n, 1});
            std::vector<Met> coarse;
            bool areOne = false;
            for (std::int64_t q = 4; q <= 16 && !areOne; q *= 2) {
                coarse = staircase(words, q, n, place, amplitude);
                std::sort(coarse.begin(), coarse.end(),
                          [](const Met& x, const Met& y) { return x.impulse < y.impulse; });
                areOne = std::equal(exact.begin(), exact.end(), coarse.begin(), coarse.end(),
                                    [](const auto& motion, const Met& met) {
                                        return std::abs(motion.impulse - met.impulse) <
                                               0.05 * met.impulse;
                                    });
            }
            INFO(words << ", n = " << n << ", " << amplitude << ": " << exact.size() << " and "
                       << coarse.size());
            CHECK(areOne);
            count += exact.size();
        }
    }
    CHECK(count >= static_cast<std::size_t>(test::drawn(8)));
}

TEST_CASE("harmonic network: bars that bounce under their weight: impulses are those of the period")
{
    std::mt19937 random(17);
    const auto draw = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    struct Bouncing {
        const char* words;
        double gravity;
        double weight;  ///< [N], of the bar that drifts
    };
    std::size_t count = 0;
    std::size_t smooth = 0;
    for (const Bouncing& one :
         {Bouncing{"stop=0 2 dash=0.3 driven 1", 0.05, 0.05},
          Bouncing{"stop=2e-3 1 dash=0.4 driven 2:0.7 stop=-1", 0.1, 0.1 * (1.0 + 1.4) / 3.0},
          Bouncing{"clamp shaken 2 dash=0.2 1 gap=0 1 dash=0.1", -0.02, 0.02 / 4.0},
          Bouncing{"clamp shaken 3 dash=0.3 gap=0 1", -0.02, 0.02 / 4.0}}) {
        const Network network = barsOf(one.words, one.gravity);
        const bool isShaken = network.nodes.front().isShaken;
        const Excited place = isShaken ? Excited::base : Excited::tip;
        const double unit = isShaken ? static_cast<double>(network.cells()) : 1.0;
        double weight = 0.0;  // of what drifts
        for (const NetworkNode& node : network.nodes) {
            weight += network.bars[node.bar].drifts() ? std::abs(node.force) : 0.0;
        }
        CHECK(weight * network.scales.force() == Approx(one.weight).epsilon(1e-12));
        for (int i = 0; i < test::drawn(6); ++i) {
            // A ball without dashpots bounces where its own waves do not resonate.
            const std::int64_t n = 2 * static_cast<std::int64_t>(draw(2.0, 6.0)) + 1;
            const double amplitude = (isShaken ? 0.02 : 0.1) * std::exp2(draw(-1.0, 1.0));
            auto exact = harmonicContacts(HarmonicNetwork{network, place, unit * amplitude, n, 1});
            std::sort(exact.begin(), exact.end(), [](const auto& x, const auto& y) {
                return x.contactTime() < y.contactTime();
            });
            std::vector<Met> coarse;
            bool areOne = false;
            for (std::int64_t q = 3; q <= 11 && !areOne; q += 4) {
                coarse = staircase(one.words, q, n, place, amplitude, one.gravity);
                areOne = std::equal(exact.begin(), exact.end(), coarse.begin(), coarse.end(),
                                    [q](const auto& motion, const Met& met) {
                                        return std::abs(motion.impulse - met.impulse) <
                                                   1e-6 * met.impulse &&
                                               std::abs(motion.contactTime() - met.contact) *
                                                       static_cast<double>(q) <
                                                   2.0;
                                    });
            }
            INFO(one.words << ", n = " << n << ", " << amplitude << ": " << exact.size() << " and "
                           << coarse.size());
            CHECK(areOne);
            for (const NetworkHarmonicMotion& motion : exact) {
                CHECK(motion.impulse == Approx(weight * static_cast<double>(n)).epsilon(1e-8));
                CHECK(motion.residual < 1e-8);
                smooth += motion.first().isPinned ? 0 : 1;
            }
            count += exact.size();
        }
    }
    CHECK(count >= static_cast<std::size_t>(test::drawn(12)));
    CHECK(smooth >= (test::drawsFew() ? 1 : 2));
}

namespace {

/// The motion of a staircase with q steps in each whose contact is nearest to one of so many steps.
std::optional<StabilityResult> triedOnStaircase(std::string_view words, std::int64_t q,
                                                std::int64_t steps, Excited place, double amplitude,
                                                const NetworkHarmonicMotion& exact, double gravity)
{
    const Network fine = finer(words, q, gravity);
    const double unit = place == Excited::tip ? 1.0 : static_cast<double>(fine.cells());
    const auto size = static_cast<double>(q);
    const auto nearest = static_cast<std::int64_t>(std::lround(size * exact.contactTime()));
    for (const std::int64_t contact : {nearest, nearest + 1, nearest - 1}) {
        const std::vector<ContactSpan> schedule{{1, contact}, {0, q * steps - contact}};
        const ForcedSet set = forcedScene(fine, schedule, {place, 1, {}}, 1e6);
        if (contact < 1 || set.status != Status::found) {
            continue;
        }
        for (const ForcedMotion& motion : motionsOfAmplitude(set, unit * amplitude)) {
            if (std::abs(motion.extremes.impulse / size - exact.impulse) < 0.03 * exact.impulse &&
                std::abs(std::remainder(motion.phase - exact.phase, 2.0 * std::numbers::pi)) <
                    0.3) {
                StabilityOptions options;
                options.periods = 100;
                options.sizes = {1e-3};
                return stabilityOf(fine, claimOf(schedule, motion), options);
            }
        }
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("harmonic network: staircases that are disturbed come back where growth says so")
{
    std::mt19937 random(11);
    const auto draw = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    std::array<std::size_t, 2> tried{};  // repel, attract
    std::array<std::size_t, 2> bouncing{};
    struct Asked {
        const char* words;
        double gravity;
        int count;
        double size;  ///< of amplitudes
    };
    for (const auto& [words, gravity, count, size] :
         {Asked{"clamp 13 dash=0.1 driven gap=1e-3 dash=0.2 17:1.3 clamp", 0.0, 40, 1.0},
          Asked{"clamp 11 8:1.7 dash=0.05 driven stop=1e-3", 0.0, 40, 1.0},
          Asked{"clamp shaken 9 8:0.6 dash=0.1 stop=1e-3", 0.0, 40, 1.0},
          Asked{"stop=0 3 dash=0.4 2 driven dash=0.2", 0.05, 15, 0.1},
          Asked{"clamp shaken 3 dash=0.4 gap=0 2 dash=0.1", -0.02, 15, 0.02}}) {
        const Network network = barsOf(words, gravity);
        const Excited place = network.nodes.front().isShaken ? Excited::base : Excited::tip;
        const double unit = place == Excited::base ? static_cast<double>(network.cells()) : 1.0;
        for (int i = 0; i < test::drawn(count); ++i) {
            const auto n =
                static_cast<std::int64_t>(draw(2.2, 4.5) * static_cast<double>(network.cells()));
            const double amplitude = size * std::exp2(draw(-1.0, 2.0));
            for (const NetworkHarmonicMotion& motion :
                 harmonicContacts(HarmonicNetwork{network, place, unit * amplitude, n, 1})) {
                if (!motion.growth || std::abs(*motion.growth - 1.0) < 0.05) {
                    continue;
                }
                const auto result =
                    triedOnStaircase(words, 12, n, place, amplitude, motion, gravity);
                if (!result || result->stability == Stability::unclear) {
                    continue;
                }
                INFO(words << ", n = " << n << ", " << amplitude << ": " << *motion.growth);
                CHECK((result->stability == Stability::attracts) == (*motion.growth < 1.0));
                ++(gravity == 0.0 ? tried : bouncing).at(*motion.growth < 1.0 ? 1 : 0);
            }
        }
    }
    CHECK(tried[0] >= (test::drawsFew() ? 1 : 4));
    CHECK(tried[1] >= static_cast<std::size_t>(test::drawn(15)));
    CHECK(bouncing[0] >= static_cast<std::size_t>(test::drawn(5)));
    CHECK(bouncing[1] >= static_cast<std::size_t>(test::drawn(5)));
}

TEST_CASE("harmonic network: without contact a gap keeps what the linear motion of one bar leaves")
{
    std::mt19937 random(7);
    const auto draw = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    for (int i = 0; i < 200; ++i) {
        ResponseRange range;
        range.cells = 2 + i % 7;
        range.damping = {std::pow(10.0, draw(-2.5, -0.5))};
        range.place = i % 2 == 0 ? Excited::tip : Excited::base;
        range.amplitude = std::pow(10.0, draw(-3.0, -2.0));  // so that there is little to settle
        const auto cells = static_cast<double>(range.cells);
        const auto n = static_cast<std::int64_t>(draw(2.5, 6.0) * cells);
        const double unit = range.place == Excited::tip ? 1.0 : cells;
        const auto distances =
            openDistances(HarmonicNetwork{networkOf(Scene{}, range.cells, range.damping),
                                          range.place, unit * range.amplitude, n, 1});
        INFO(i << ": " << range.cells << " cells, n = " << n);
        REQUIRE(distances);
        REQUIRE(distances->size() == 1);
        CHECK(1.0 - distances->front() / cells ==
              Approx(exactAt(range, n)->linearPeak).epsilon(1e-9).margin(1e-13));
    }
}

TEST_CASE("harmonic network: a contact without force is none")
{
    // At rest on its stop the tip of a bar whose waves are those of an open one touches it.
    const Network network = barsOf("clamp 3 dash=0.15580032922161893 driven stop=0");
    CHECK(harmonicContacts(HarmonicNetwork{network, Excited::tip, 1.0, 6, 1}).empty());
}

TEST_CASE("harmonic network: a bar that nothing holds presses as its weight asks, or not at all")
{
    const auto meanPushes = [](const char* words, double gravity) {
        const Network network = barsOf(words, gravity);
        std::vector<std::optional<double>> pushes;
        for (std::size_t contact = 0; contact < network.contacts.size(); ++contact) {
            pushes.push_back(meanPushOf(network, contact));
            if (pushes.back()) {
                *pushes.back() *= network.scales.force();
            }
        }
        return pushes;
    };
    const std::optional<double> none;
    CHECK(meanPushes("stop=-1e-3 5 dash=0.1 driven stop=1e-3", 0.0) == std::vector{none, none});
    const auto between = meanPushes("stop=-1e-3 5 dash=0.1 driven stop=1e-3", 0.3);
    CHECK(!between[0]);
    CHECK(between[1].value() == Approx(0.3));
    // A wall between two bars: each bar would have to be pressed by itself.
    CHECK(meanPushes("clamp 3 stop=1e-3 gap=0 3 dash=0.1 stop=1e-3", 0.2)[0] == none);
    CHECK(meanPushes("clamp 3 stop=1e-3 gap=1 3 dash=0.1 driven", 0.0)[0] == 0.0);
    const Network free = barsOf("stop=-1e-3 5 dash=0.1 driven stop=1e-3");
    CHECK(harmonicContacts(HarmonicNetwork{free, Excited::tip, 1e-3, 18, 1}).empty());
    // It swings about the middle.
    const auto open = openDistances(HarmonicNetwork{free, Excited::tip, 1e-3, 18, 1});
    REQUIRE(open);
    CHECK(open->size() == 2);
    CHECK(!openDistances(
        HarmonicNetwork{barsOf("stop=0 5 dash=0.1 driven", 0.1), Excited::tip, 1e-3, 18, 1}));
}

TEST_CASE("harmonic network: what cannot be asked")
{
    const auto ask = [](const char* words, double amplitude, std::int64_t steps) {
        return harmonicContacts(HarmonicNetwork{barsOf(words), Excited::tip, amplitude, steps, 1});
    };
    const char* bar = "clamp 5 dash=0.1 driven stop=1e-3";
    CHECK_THROWS_AS(ask(bar, 0.0, 18), std::invalid_argument);
    CHECK_THROWS_AS(ask(bar, 1.0, maxHarmonicSteps + 1), std::invalid_argument);
    CHECK_THROWS_AS(ask("clamp 5 driven stop=1e-3", 1.0, 18), std::invalid_argument);
    CHECK_THROWS_AS(ask("clamp 5 dash=0.1 stop=1e-3", 1.0, 18), std::invalid_argument);
}
