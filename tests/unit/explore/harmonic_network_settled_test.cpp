#include "harmonic_network_settled.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"
#include "driven_bar.hpp"
#include "harmonic_network_contact.hpp"
#include "harmonic_settled.hpp"
#include "network_simulation.hpp"
#include "sanitized.hpp"
#include "scene_words.hpp"
#include "signorini/assembly.hpp"

using namespace signorini;

TEST_CASE("settled network: two equal segments settle on what the bar of the closed form does")
{
    std::mt19937 random(7);
    const auto draw = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    int several = 0;
    int settled = 0;
    for (int i = 0; i < test::drawn(24); ++i) {
        const std::int64_t cells = 4 + i % 5;
        const auto size = static_cast<double>(cells);
        const auto steps = static_cast<std::int64_t>(draw(3.0, 9.0) * size);
        const double ratio = draw(0.1, 0.3);
        test::DrivenBar drawn(cells, steps, ratio, i % 2 == 0,
                              i % 3 == 0 ? Excited::base : Excited::tip,
                              std::exp2(draw(-0.5, 2.0)));
        const SettlingSearch search{.cycles = 300};
        const auto bar = settledHarmonic(drawn.damping, drawn.excitation(), drawn.stops, search);
        drawn.halve();
        const std::int64_t cycles = bar ? bar->given.cycles : 1;
        const SettledNetwork network = settledHarmonic(drawn.network(cycles), search);
        INFO(i << ": " << cells << " cells, n = " << steps << ", " << drawn.amplitude);
        CHECK(network.motion.has_value() == bar.has_value());
        if (!bar || !network.motion) {
            continue;
        }
        const NetworkHarmonicMotion& motion = *network.motion;
        const std::vector<HarmonicContact>& contacts = bar->motion.contacts;
        CHECK(network.cycles == cycles);
        REQUIRE(motion.contacts.size() == contacts.size());
        // They may begin with another of their contacts.
        const auto phaseAt = [&](double begin, double phase) {
            return std::remainder(2.0 * std::numbers::pi * static_cast<double>(cycles) * begin /
                                          static_cast<double>(cycles * steps) -
                                      phase,
                                  2.0 * std::numbers::pi);
        };
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            const HarmonicContact& one = contacts[k];
            const auto nearest = std::min_element(
                motion.contacts.begin(), motion.contacts.end(), [&](const auto& x, const auto& y) {
                    const auto apart = [&](const auto& other) {
                        return std::abs(other.impulse - size * one.impulse) +
                               (other.contact == static_cast<std::size_t>(one.stop) ? 0.0 : 1e9);
                    };
                    return apart(x) < apart(y);
                });
            CHECK(nearest->contact == static_cast<std::size_t>(one.stop));
            CHECK(nearest->end - nearest->begin ==
                  Approx(size * (one.end - one.begin)).epsilon(1e-9));
            CHECK(nearest->impulse == Approx(size * one.impulse).epsilon(1e-9));
            CHECK(nearest->peakForce == Approx(one.peakForce).epsilon(1e-9));
            CHECK(nearest->speed == Approx(one.speed).epsilon(1e-9));
            CHECK(nearest->isPinned == one.isPinned);
            CHECK(std::abs(std::remainder(phaseAt(nearest->begin, motion.phase) -
                                              phaseAt(size * one.begin, bar->motion.phase),
                                          2.0 * std::numbers::pi)) < 1e-9);
        }
        ++settled;
        several += contacts.size() > 1 ? 1 : 0;
    }
    CHECK(settled >= test::drawn(8));
    CHECK(several >= test::drawn(4));
}

namespace {

/// Contacts that begin in one of many periods of a force that is constant in each of q parts of a
/// step, counted in steps from where the harmonic has this phase.
std::vector<NetworkContactEvent> contactsInSteps(std::string_view words, std::int64_t q,
                                                 std::int64_t steps, double amplitude, double phase)
{
    Assembly assembly;
    assembly.parts = partsOf(words);
    for (AssemblyPart& part : assembly.parts) {
        part.cells *= q;
    }
    const Network network = networkOf(assembly);
    const auto period = static_cast<double>(q * steps);
    const double omega = 2.0 * std::numbers::pi / period;
    NetworkDrive drive;
    for (std::int64_t m = 0; m < q * steps; ++m) {
        drive.forces.push_back(amplitude * std::sin(omega * (static_cast<double>(m) + 0.5)));
    }
    NetworkSimulation simulation(network, startAtRest(network), drive, {.mergeBelow = 1e-9});
    constexpr double periods = 60.0;
    simulation.advance((periods + 2.0) * period);
    std::vector<NetworkContactEvent> begun;
    for (NetworkContactEvent event : simulation.contacts()) {
        const double zero = (0.5 * std::numbers::pi - phase) / omega + periods * period;
        event.start = (event.start - zero) / static_cast<double>(q);
        event.end = (event.end - zero) / static_cast<double>(q);
        const double early = 0.05 * static_cast<double>(steps);
        if (event.start > -early && event.start <= static_cast<double>(steps) - early) {
            begun.push_back(event);
        }
    }
    return begun;
}

}  // namespace

TEST_CASE("settled network: forces in finer and finer steps meet the same contacts at these times")
{
    struct Asked {
        const char* words;
        std::int64_t steps;
        double amplitude;
    };
    for (const auto& [words, steps, amplitude] :
         {Asked{"clamp 2 3:1.7 dash=0.3 driven stop=1e-3", 57, 3.0},
          Asked{"clamp 3 driven stop=5e-4 2 dash=0.3 gap=1e-3 dash=0.3 2:1.3 clamp", 41, 3.0},
          Asked{"clamp 3 driven stop=5e-4 2 dash=0.3 gap=1e-3 dash=0.3 2:1.3 clamp", 29, 5.0},
          // Bars that fly.
          Asked{"stop=-1e-3 7 dash=0.3 driven stop=1e-3", 47, 2.4},
          Asked{"stop=-1e-3 5 dash=0.3 driven gap=1e-3 6 dash=0.2 stop=1e-3", 37, 3.34},
          Asked{"driven dash=0.3 force=0.3 8 stop=0.5", 21, 0.644}}) {
        const SettledNetwork found =
            settledHarmonic(HarmonicNetwork{sceneOf(words), Excited::tip, amplitude, steps, 1});
        INFO(words << ": " << found.contacts << " in " << found.cycles);
        REQUIRE(found.motion.has_value());
        const std::vector<NetworkHarmonicContact>& contacts = found.motion->contacts;
        CHECK(contacts.size() > 1);
        for (const std::int64_t q : {4, 16}) {
            const auto begun = contactsInSteps(words, q, steps, amplitude, found.motion->phase);
            const double step = 1.0 / static_cast<double>(q);
            REQUIRE(begun.size() == contacts.size());
            for (std::size_t k = 0; k < contacts.size(); ++k) {
                CAPTURE(q, k);
                CHECK(begun[k].contact == contacts[k].contact);
                CHECK(std::abs(begun[k].start - contacts[k].begin) < 0.03 * step);
                CHECK(std::abs(begun[k].end - contacts[k].end) < 1.1 * step);
            }
        }
    }
}

TEST_CASE("settled network: a ball under its weight settles on a motion of the list of one contact")
{
    const Network network = sceneOf("driven dash=0.3 force=0.3 8 stop=0.5");
    std::mt19937 random(3);
    const auto draw = [&](double least, double most) {
        return std::uniform_real_distribution<>(least, most)(random);
    };
    int compared = 0;
    for (int i = 0; i < test::drawn(40); ++i) {
        const auto steps = static_cast<std::int64_t>(draw(11.0, 60.0));
        const HarmonicNetwork given{network, Excited::tip, std::exp2(draw(-2.0, 2.0)), steps, 1};
        const SettledNetwork found = settledHarmonic(given, {.cycles = 300});
        if (!found.motion || found.contacts != 1) {
            continue;
        }
        INFO(steps << ", " << given.amplitude);
        const auto listed = harmonicContacts(given);
        const bool isListed = std::any_of(listed.begin(), listed.end(), [&](const auto& other) {
            return std::abs(other.impulse - found.motion->impulse) <= 1e-9 * other.impulse &&
                   std::abs(other.first().end - found.motion->first().end) <= 1e-8 &&
                   std::abs(std::remainder(other.phase - found.motion->phase,
                                           2.0 * std::numbers::pi)) <= 1e-8;
        });
        CHECK(isListed);
        ++compared;
    }
    CHECK(compared >= test::drawn(15));
}
