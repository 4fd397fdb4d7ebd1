#include "harmonic_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"
#include "harmonic_contact.hpp"
#include "harmonic_growth.hpp"
#include "harmonic_march.hpp"
#include "harmonic_proof.hpp"
#include "harmonic_settled.hpp"
#include "signorini/simulation.hpp"

using namespace signorini;

namespace {

Harmonic forceOf(std::int64_t cells, std::int64_t steps, double amplitude)
{
    return {Excited::tip, amplitude, 0.0, 1, steps, static_cast<double>(cells)};
}

/// How far contacts of three periods, marched from its waves, are from those of the motion; none
/// where there are others.
std::optional<double> apart(const HarmonicCase& given, const HarmonicMotion& motion)
{
    HarmonicMarch march = HarmonicMarch::of(given, motion);
    march.advance(3.0 * given.period() - 1e-3);
    std::vector<HarmonicContact> seen = march.contacts();
    std::erase_if(seen, [](const auto& one) { return one.end < one.begin + 1e-9; });
    const std::size_t count = motion.contacts.size();
    if (seen.size() != 3 * count) {
        return std::nullopt;
    }
    double most = 0.0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
        const HarmonicContact& one = motion.contacts[k % count];
        const double start = static_cast<double>(k / count) * given.period();
        most = std::max({most, std::abs(seen[k].begin - start - one.begin),
                         std::abs(seen[k].end - start - one.end),
                         std::abs(seen[k].impulse - one.impulse)});
    }
    return most;
}

}  // namespace

TEST_CASE("harmonic pattern: near resonance, where one contact has no motion, two have")
{
    // Computed by others: contacts [0, 0.06666667] and [0.51993477, 0.58660144], both pinned.
    const auto settled = settledHarmonic(dampingOfRho(0.9), forceOf(30, 118, 0.25));
    REQUIRE(settled);
    const HarmonicMotion& motion = settled->motion;
    CHECK(motion.residual < 1e-14);
    REQUIRE(motion.contacts.size() == 2);
    const HarmonicContact& first = motion.contacts[1];
    const HarmonicContact& second = motion.contacts[0];
    CHECK(first.isPinned);
    CHECK(second.isPinned);
    CHECK(first.end - first.begin == Approx(2.0 / 30.0).margin(1e-12));
    CHECK(second.end - second.begin == Approx(2.0 / 30.0).margin(1e-12));
    const double period = settled->given.period();
    CHECK(second.begin + period - first.begin == Approx(0.51993477).margin(1e-8));
    CHECK(first.impulse == Approx(0.28892369).margin(1e-8));
    CHECK(second.impulse == Approx(0.13764606).margin(1e-8));
    const double phase = motion.phase - settled->given.omega * first.begin;
    CHECK(-std::remainder(phase, 2.0 * std::numbers::pi) == Approx(0.122984121).margin(1e-9));
}

TEST_CASE("harmonic pattern: one contact is what the closed form has")
{
    int count = 0;
    for (std::int64_t n = 95; n <= 124; ++n) {
        const HarmonicCase given = harmonicCase(dampingOfRho(0.9), forceOf(30, n, 0.25));
        for (const HarmonicMotion& motion : harmonicContacts(given)) {
            HarmonicStart start{motion.phase + 1e-4, motion.contacts};
            if (!start.contacts[0].isPinned) {
                start.contacts[0].end += 1e-5;
            }
            INFO("n " << n << " tau " << motion.contacts[0].end);
            const auto again = harmonicNear(given, start);
            REQUIRE(again);
            CHECK(again->contacts[0].end == Approx(motion.contacts[0].end).margin(1e-11));
            CHECK(again->phase == Approx(motion.phase).margin(1e-11));
            ++count;
        }
    }
    CHECK(count == 36);
}

TEST_CASE("harmonic pattern: what a bar settles on is solved to the last digit")
{
    std::mt19937_64 generator(5);
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    int several = 0;
    int count = 0;
    for (int k = 0; k < 150; ++k) {
        const std::int64_t cells = draw(2, 12);
        const Excited place = draw(0, 1) == 0 ? Excited::base : Excited::tip;
        const Harmonic excitation{place,
                                  0.1 * static_cast<double>(draw(1, 8)),
                                  0.0,
                                  1,
                                  draw(3 * cells, 5 * cells),
                                  static_cast<double>(cells)};
        Stops stops;
        if (draw(0, 2) == 0) {
            stops.left = Fraction{draw(1, 3), 1};
        } else if (draw(0, 3) == 0) {
            stops.right = -1;
        }
        const Damping damping{0.01 * static_cast<double>(draw(3, 20))};
        INFO("draw " << k);
        const auto settled = settledHarmonic(damping, excitation, stops, {.cycles = 200});
        if (!settled) {
            continue;
        }
        ++count;
        several += settled->motion.contacts.size() > 1 ? 1 : 0;
        CHECK(settled->motion.residual < 1e-12);
        const auto off = apart(settled->given, settled->motion);
        REQUIRE(off);
        CHECK(*off < 1e-10);
    }
    CHECK(count > 50);
    CHECK(several > 10);
}

TEST_CASE("harmonic pattern: a staircase of fine steps does what the motion says")
{
    const auto settled = settledHarmonic(dampingOfRho(0.9), forceOf(30, 118, 0.25));
    REQUIRE(settled);
    constexpr std::int64_t factor = 16;
    const Excitation fine = excitationOf(forceOf(30 * factor, 118 * factor, 0.25));
    BarSimulation bar(wavesAtRest(30.0 * factor), dampingOfRho(0.9), fine, {.resolution = 0.01});
    bar.advance(300.0 * 118.0 * factor);
    const auto& contacts = bar.contacts();
    REQUIRE(contacts.size() > 2);
    std::vector<double> impulses{contacts[contacts.size() - 3].impulse,
                                 contacts[contacts.size() - 2].impulse};
    std::sort(impulses.begin(), impulses.end());
    CHECK(impulses[0] == Approx(settled->motion.contacts[0].impulse).margin(1e-3));
    CHECK(impulses[1] == Approx(settled->motion.contacts[1].impulse).margin(1e-3));
}

TEST_CASE("harmonic pattern: enclosed numbers prove motions, and refuse what is none")
{
    int count = 0;
    for (std::int64_t n = 95; n <= 124; ++n) {
        const HarmonicCase given = harmonicCase(dampingOfRho(0.9), forceOf(30, n, 0.25));
        for (const HarmonicMotion& motion : harmonicContacts(given)) {
            INFO("n " << n << " tau " << motion.contacts[0].end);
            const HarmonicProof proof = enclosed(given, motion);
            CHECK(proof.isProved);
            CHECK(proof.within < 1e-10);
            // Not of other numbers, another stop's force, or another way to let go.
            HarmonicMotion other = motion;
            other.phase += 1e-6;
            CHECK_FALSE(enclosed(given, other).isProved);
            HarmonicCase larger = given;
            larger.amplitude *= 1.0 + 1e-4;
            CHECK_FALSE(enclosed(larger, motion).isProved);
            other = motion;
            other.contacts[0].isPinned = !motion.contacts[0].isPinned;
            other.contacts[0].travel = motion.contacts[0].end;
            CHECK_FALSE(enclosed(given, other).isProved);
            ++count;
        }
    }
    CHECK(count == 36);
    const auto settled = settledHarmonic(dampingOfRho(0.9), forceOf(30, 118, 0.25));
    REQUIRE(settled);
    CHECK(enclosed(settled->given, settled->motion).isProved);
}

TEST_CASE("harmonic pattern: a push that dips below 0 for a moment makes two contacts of one")
{
    // A staircase has one contact of 0.4177, and so has a bisection on the sign of the push.
    const auto settled = settledHarmonic(dampingOfRho(0.85), forceOf(41, 169, 0.2));
    REQUIRE(settled);
    CHECK(settled->motion.residual < 1e-12);
    REQUIRE(settled->motion.contacts.size() == 2);
    const HarmonicContact& first = settled->motion.contacts[1];
    const HarmonicContact& second = settled->motion.contacts[0];
    CHECK(second.end + settled->given.period() - first.begin == Approx(0.4177).margin(5e-4));
    CHECK(second.impulse < 1e-3 * first.impulse);
}
