#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "catch.hpp"
#include "modes_support.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/modes.hpp"
#include "signorini/simulation.hpp"

using namespace signorini;
using test::anyEnergy;
using test::requireTheorems;
using test::sumOfK;
using test::upTo;

namespace {

/// A mean of the points of a slice with random weights, none of them 0.
ModePoint randomPoint(const ModePolytope& polytope, double period, std::mt19937_64& generator)
{
    std::exponential_distribution<double> weight;
    ModePoint point{period, std::vector<double>(polytope.chains.size() - 1)};
    double sum = 0.0;
    for (const ModePoint& corner : slice(polytope, period)) {
        const double w = weight(generator) + 1e-3;
        sum += w;
        for (std::size_t i = 0; i < point.arrivals.size(); ++i) {
            point.arrivals[i] += w * corner.arrivals[i];
        }
    }
    for (double& s : point.arrivals) {
        s /= sum;
    }
    return point;
}

double randomPeriod(const ModePolytope& polytope, std::mt19937_64& generator)
{
    return std::uniform_real_distribution<double>(
        std::lerp(polytope.lowest.value(), polytope.highest.value(), 0.02),
        std::lerp(polytope.lowest.value(), polytope.highest.value(), 0.98))(generator);
}

}  // namespace

TEST_CASE("polytopes: with one contact they are the modes")
{
    const std::vector<Mode> modes = findModes(upTo(31));
    const std::vector<ModePolytope> all = findPolytopes(1, anyEnergy(31));
    REQUIRE(all.size() == modes.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Mode& mode = modes[k];
        const ModePolytope& polytope = all[k];
        INFO(mode.a << " " << mode.b);
        CHECK(polytope.chains == std::vector<ModeChain>{{0, 2 * mode.a, -mode.b}});
        CHECK(polytope.lowest == mode.lowest);
        CHECK(polytope.highest == mode.highest);
        CHECK(polytope.lowestEnd == mode.lowestEnd);
        CHECK(polytope.highestEnd == mode.highestEnd);
        CHECK(polytope.kappa == mode.kappa);
        CHECK(polytope.mu == mode.mu);
        CHECK(polytope.divisor == 1);
        CHECK(polytope.dimension == 0);
        const std::vector<ModeJump> expected = jumps(mode);
        REQUIRE(polytope.jumps.size() == expected.size());
        for (std::size_t j = 0; j < expected.size(); ++j) {
            CHECK(polytope.jumps[j] == ChainJump{0, expected[j].k, expected[j].turns});
        }
    }
}

TEST_CASE("polytopes: a continuum of full dimension has the periods and energies of one mode")
{
    const auto [phases, order] = GENERATE(std::pair{2, 21}, std::pair{3, 7});
    int full = 0;
    for (const ModePolytope& polytope : findPolytopes(phases, anyEnergy(order))) {
        requireTheorems(polytope);
        if (polytope.dimension + 1 < phases) {
            continue;
        }
        ++full;
        INFO(polytope.order << " " << sumOfK(polytope));
        REQUIRE(sumOfK(polytope) % 2 == 0);
        const auto mode = findMode(sumOfK(polytope) / 2, -polytope.order);
        REQUIRE(mode);
        CHECK(polytope.lowest == mode->lowest);
        CHECK(polytope.highest == mode->highest);
        CHECK(polytope.lowestEnd == mode->lowestEnd);
        CHECK(polytope.highestEnd == ModeEnd::contactVanishes);
        CHECK(polytope.kappa == mode->kappa);
        CHECK(polytope.mu == mode->mu);
        // A simplex: contacts may have any lengths with that sum, flights depend on T alone.
        CHECK(polytope.vertices.size() == static_cast<std::size_t>(phases) + 1);
        const double period =
            std::lerp(polytope.lowest.value(), polytope.highest.value(), 1.0 / std::sqrt(3.0));
        std::set<double> contacts;
        for (const ModePoint& corner : slice(polytope, period)) {
            const std::vector<double> times = stretches(polytope, corner);
            for (std::size_t l = 0; l < times.size(); l += 2) {
                const double part = times[l] / contactTime(*mode, period);
                CHECK((part == Approx(1.0) || part == Approx(0.0).margin(1e-9)));
            }
        }
    }
    CHECK(full > 0);
}

TEST_CASE("polytopes: isolated pairs of contacts are equally long")
{
    const auto all = findPolytopes(2, anyEnergy(25));
    CHECK(all.size() == 286);
    int isolated = 0;
    for (const ModePolytope& polytope : all) {
        if (polytope.dimension == 0) {
            ++isolated;
            const double period = 0.5 * (polytope.lowest.value() + polytope.highest.value());
            const auto times = stretches(polytope, slice(polytope, period).front());
            CHECK(times[0] == Approx(times[2]));
            CHECK(times[1] != Approx(times[3]));
        }
    }
    CHECK(isolated == 150);
}

TEST_CASE("polytopes: random points of random polytopes come back after ten periods")
{
    std::mt19937_64 generator(18);
    for (const auto& [phases, order] : {std::pair{2, 13}, std::pair{3, 5}, std::pair{4, 3}}) {
        for (const ModePolytope& polytope : findPolytopes(phases, anyEnergy(order))) {
            const ModePoint point =
                randomPoint(polytope, randomPeriod(polytope, generator), generator);
            const ModeMotion motion(polytope, point);
            INFO("order " << polytope.order << ", T = " << point.period);
            BarSimulation simulation(test::wavesOf(motion), {});
            const double tolerance = 1e-9 * std::max(1.0, motion.amplitude());
            for (int k = 1; k <= 40; ++k) {
                simulation.advance(0.25 * point.period);
                REQUIRE(
                    simulation.tip() ==
                    Approx(motion.displacement(1.0, 0.25 * k * point.period)).margin(tolerance));
            }
            // Where the tip touches the wall without force rounding may make a contact of no
            // length.
            std::vector<ContactEvent> pressed = simulation.contacts();
            pressed.erase(std::remove_if(pressed.begin(), pressed.end(),
                                         [](const ContactEvent& contact) {
                                             return contact.end - contact.start < 1e-9;
                                         }),
                          pressed.end());
            REQUIRE(pressed.size() == 10 * polytope.chains.size());
            const std::vector<double> times = stretches(polytope, point);
            double sum = 0.0;
            for (std::size_t l = 0; l < pressed.size(); ++l) {
                const double expected = times[2 * l % times.size()];
                sum += expected;
                REQUIRE(pressed[l].end - pressed[l].start == Approx(expected).margin(1e-9));
                REQUIRE(pressed[l].peakForce == Approx(2.0 * motion.amplitude()).epsilon(1e-9));
            }
            REQUIRE(sum == Approx(10.0 * motion.contactTime()).epsilon(1e-9));
            REQUIRE(energyRatio(simulation.waves()) ==
                    Approx(energyRatio(polytope, point.period)).epsilon(1e-9));
            const Extremes most = motion.extremes();
            double lowest = 1.0;
            for (int k = 0; k < 4000; ++k) {
                lowest = std::min(lowest, motion.displacement(1.0, k * point.period / 4000.0));
            }
            REQUIRE(lowest >= most.lowestTip - tolerance);
            REQUIRE(lowest ==
                    Approx(most.lowestTip).margin(motion.amplitude() * point.period / 1000.0));
        }
    }
}

TEST_CASE("polytopes: at common divisors a grid point is a motion of its schedule, too")
{
    // gcd(2N, n) = 2 and more: isolated types need whole halves of n.
    const ModePolytope isolated = findPolytopes(2, anyEnergy(3)).back();
    REQUIRE(isolated.dimension == 0);
    const std::vector<Schedule> at = schedulesOf(isolated, 23, 142);
    REQUIRE(at.size() == 1);
    CHECK(at[0].phases == std::vector<Phase>{{17, 50}, {17, 58}});
    CHECK(lumpedSet(at[0]).leastEnergy == Approx(132.25).epsilon(1e-12));
    CHECK(energyRatio(isolated, 142.0 / 23.0) == Approx(132.25).epsilon(1e-12));
    int compared = 0;
    for (const ModePolytope& polytope : findPolytopes(2, anyEnergy(9))) {
        for (const std::int64_t cells : {24, 60}) {
            const std::int64_t n = static_cast<std::int64_t>(
                std::lround(0.5 * (polytope.lowest.value() + polytope.highest.value()) *
                            static_cast<double>(cells)));
            for (const Schedule& schedule : schedulesOf(polytope, cells, n)) {
                const LumpedSet set = lumpedSet(schedule);
                INFO(describe(schedule));
                REQUIRE_FALSE(set.absence);
                REQUIRE(set.leastEnergy <= energyRatio(polytope, period(schedule)) * (1.0 + 1e-12));
                ++compared;
            }
        }
    }
    CHECK(compared > 20);
}

TEST_CASE("polytopes: what is wrong is refused by name")
{
    CHECK_THROWS_WITH(findPolytopes(0), Catch::Contains("phases = 0"));
    CHECK_THROWS_WITH(findPolytopes(6), Catch::Contains("phases = 6"));
    CHECK_THROWS_WITH(findPolytopes(2, upTo(102)), Catch::Contains("maxOrder = 102"));
    const ModePolytope polytope = findPolytopes(2, anyEnergy(3)).front();
    CHECK_THROWS_WITH(slice(polytope, 3.0), Catch::Contains("period = 3"));
    CHECK_THROWS_WITH(energyRatio(polytope, 2.5), Catch::Contains("period = 2.5"));
    CHECK_THROWS_WITH(ModeMotion(polytope, {2.6, {}}), Catch::Contains("arrivals = 0"));
    CHECK_THROWS_WITH(ModeMotion(polytope, {2.6, {0.5}}), Catch::Contains("outside"));
    CHECK_THROWS_WITH(polytopeOf({4, {{1, 12}, {3, 12}}}), Catch::Contains("gcd(2N, n) = 4"));
    CHECK_FALSE(polytopeOf({23, {{1, 26}, {6, 27}, {5, 2}}}));
    CHECK_THROWS_AS(schedulesOf(polytope, 0, 1), std::invalid_argument);
    ModeBounds bounds;
    bounds.cancel = [] { return true; };
    CHECK(findPolytopes(2, bounds).empty());
}
