#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "catch.hpp"
#include "mode_chains.hpp"
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

/// Turns of a chain as they are if arrival `first` is number 0, from where it begins and ends.
std::int64_t turnsFrom(const std::vector<double>& arrivals, const std::vector<double>& releases,
                       double period, const ModeChain& chain, std::size_t i, std::size_t first)
{
    const auto since = [&](double t) {
        return t < arrivals[first] ? t + period - arrivals[first] : t - arrivals[first];
    };
    return std::llround(
        (since(arrivals[i]) + 2.0 * static_cast<double>(chain.k) - since(releases[chain.release])) /
        period);
}

/// The chains of a polytope as they are if arrival `first` is number 0.
std::vector<ModeChain> chainsFrom(const ModePolytope& polytope, std::size_t first)
{
    const double period = 0.5 * (polytope.lowest.value() + polytope.highest.value());
    std::mt19937_64 generator(first);
    const std::vector<double> times = stretches(polytope, randomPoint(polytope, period, generator));
    std::vector<double> arrivals;
    std::vector<double> releases;
    double at = 0.0;
    for (std::size_t l = 0; l < polytope.chains.size(); ++l) {
        arrivals.push_back(at);
        releases.push_back(at + times[2 * l]);
        at += times[2 * l] + times[2 * l + 1];
    }
    const std::size_t count = polytope.chains.size();
    std::vector<ModeChain> chains;
    for (std::size_t place = 0; place < count; ++place) {
        const std::size_t i = (first + place) % count;
        const ModeChain& chain = polytope.chains[i];
        chains.push_back({(chain.release + count - first) % count, chain.k,
                          turnsFrom(arrivals, releases, period, chain, i, first)});
    }
    return chains;
}

/// k, turns and release of all, in this order.
std::vector<std::int64_t> nameOf(const std::vector<ModeChain>& chains)
{
    std::vector<std::int64_t> name;
    for (const ModeChain& chain : chains) {
        name.push_back(chain.k);
    }
    for (const ModeChain& chain : chains) {
        name.push_back(chain.turns);
    }
    for (const ModeChain& chain : chains) {
        name.push_back(static_cast<std::int64_t>(chain.release));
    }
    return name;
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

TEST_CASE("polytopes: stretches fill the period, and none is empty")
{
    std::mt19937_64 generator(19);
    for (const auto& [phases, order] : {std::pair{2, 13}, std::pair{3, 7}, std::pair{4, 3}}) {
        for (const ModePolytope& polytope : findPolytopes(phases, anyEnergy(order))) {
            const double period = randomPeriod(polytope, generator);
            const auto times = stretches(polytope, randomPoint(polytope, period, generator));
            REQUIRE(times.size() == static_cast<std::size_t>(2 * phases));
            REQUIRE(*std::min_element(times.begin(), times.end()) > 0.0);
            REQUIRE(std::accumulate(times.begin(), times.end(), 0.0) == Approx(period));
        }
    }
}

TEST_CASE("polytopes: with four contacts, too, no more times are free than the theory allows")
{
    const auto all = findPolytopes(4, anyEnergy(5));
    CHECK(all.size() == 18);
    std::vector<int> free(4);
    for (const ModePolytope& polytope : all) {
        requireTheorems(polytope);
        ++free[static_cast<std::size_t>(polytope.dimension)];
    }
    CHECK(free == std::vector<int>{8, 8, 2, 0});
}

TEST_CASE("polytopes: an isolated one does not repeat fewer contacts")
{
    for (const auto& [phases, order] :
         {std::pair{2, 9}, std::pair{3, 9}, std::pair{4, 3}, std::pair{5, 1}}) {
        for (const ModePolytope& polytope : findPolytopes(phases, anyEnergy(order))) {
            const double period = 0.5 * (polytope.lowest.value() + polytope.highest.value());
            const auto times = stretches(polytope, slice(polytope, period).front());
            INFO(phases << " " << polytope.order << " " << sumOfK(polytope));
            for (std::size_t shift = 2; shift < times.size() && polytope.dimension == 0;
                 shift += 2) {
                bool isSame = true;
                for (std::size_t i = 0; i < times.size(); ++i) {
                    isSame =
                        isSame && std::abs(times[i] - times[(i + shift) % times.size()]) < 1e-9;
                }
                REQUIRE_FALSE(isSame);
            }
        }
    }
}

TEST_CASE("polytopes: a type has its name from each arrival, and is listed under the largest")
{
    for (const auto& [phases, order] : {std::pair{2, 13}, std::pair{3, 9}, std::pair{4, 5}}) {
        for (const ModePolytope& polytope : findPolytopes(phases, anyEnergy(order))) {
            const auto own = nameOf(polytope.chains);
            for (std::size_t first = 0; first < polytope.chains.size(); ++first) {
                const auto name = nameOf(chainsFrom(polytope, first));
                INFO("order " << polytope.order << " from " << first);
                REQUIRE(name == nameFrom(polytope.chains, first));
                REQUIRE(name <= own);
            }
        }
    }
}

TEST_CASE("polytopes: of one type are those of the list, whichever arrival is the first")
{
    for (const auto& [phases, order] : {std::pair{1, 13}, std::pair{2, 9}, std::pair{3, 7}}) {
        const auto all = findPolytopes(phases, anyEnergy(order));
        for (const ModePolytope& polytope : all) {
            std::vector<ModePolytope> expected;
            std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
                         [&](const ModePolytope& p) { return p.chains == polytope.chains; });
            INFO("order " << polytope.order << ", " << sumOfK(polytope) << " jumps");
            REQUIRE(polytopesOf(polytope.chains) == expected);
            for (std::size_t first = 1; first < polytope.chains.size(); ++first) {
                const auto turned = polytopesOf(chainsFrom(polytope, first));
                REQUIRE(turned.size() == expected.size());
                for (const ModePolytope& other : turned) {
                    REQUIRE(std::any_of(
                        expected.begin(), expected.end(), [&other](const ModePolytope& p) {
                            return p.lowest == other.lowest && p.highest == other.highest &&
                                   p.kappa == other.kappa && p.mu == other.mu &&
                                   p.divisor == other.divisor;
                        }));
                }
            }
        }
    }
    // Types that are not in the list have no motions.
    std::set<std::vector<std::int64_t>> names;
    for (const ModePolytope& polytope : findPolytopes(2, anyEnergy(7))) {
        names.insert(nameOf(polytope.chains));
        names.insert(nameOf(chainsFrom(polytope, 1)));
    }
    std::size_t met = 0;
    for (std::int64_t k = 2; k <= 14; k += 2) {
        for (std::int64_t l = 2; l <= 14; l += 2) {
            for (std::int64_t turns = 0; turns < 36; ++turns) {
                const std::vector<ModeChain> chains{{1, k, turns % 6}, {0, l, turns / 6}};
                const bool isListed = names.count(nameOf(chains)) == 1;
                if (turns % 6 + turns / 6 > 7) {
                    continue;  // not among the names
                }
                INFO(k << "/" << turns % 6 << ", " << l << "/" << turns / 6);
                REQUIRE(polytopesOf(chains).empty() != isListed);
                met += isListed ? 1 : 0;
            }
        }
    }
    CHECK(met > 10);
}

TEST_CASE("polytopes: a type that cannot be is refused by name")
{
    CHECK_THROWS_WITH(polytopesOf({}), Catch::Contains("phases = 0"));
    CHECK_THROWS_WITH(polytopesOf({{0, 0, 1}}), Catch::Contains("k = 0"));
    CHECK_THROWS_WITH(polytopesOf({{0, 3, 1}}), Catch::Contains("k = 3"));
    CHECK_THROWS_WITH(polytopesOf({{0, 10'002, 1}}), Catch::Contains("k = 10002"));
    CHECK_THROWS_WITH(polytopesOf({{0, 2, -1}}), Catch::Contains("turns = -1"));
    CHECK_THROWS_WITH(polytopesOf({{0, 2, 10'001}}), Catch::Contains("turns = 10001"));
    CHECK_THROWS_WITH(polytopesOf({{1, 2, 1}}), Catch::Contains("release = 1"));
    CHECK_THROWS_WITH(polytopesOf({{1, 2, 1}, {1, 2, 2}}), Catch::Contains("release = 1"));
    CHECK_THROWS_WITH(polytopesOf({{0, 2, 1}, {0, 2, 2}}), Catch::Contains("release = 0"));
    // The largest numbers are heard: such motions would last too long, or not at all.
    CHECK(polytopesOf({{0, 10'000, 1}}).empty());
    CHECK(polytopesOf({{1, 2, 10'000}, {0, 2, 1}}).empty());
    CHECK(polytopesOf({{1, 2, 0}, {0, 2, 1}}).empty());
}

TEST_CASE("polytopes: their ends are no members")
{
    const ModePolytope polytope = findPolytopes(1, anyEnergy(1)).front();
    REQUIRE(polytope.lowest == ExactPeriod{3, 1});
    REQUIRE(polytope.highest == ExactPeriod{4, 1});
    for (const double period : {3.0, 4.0}) {
        CHECK_THROWS_AS(slice(polytope, period), std::invalid_argument);
        CHECK_THROWS_AS(energyRatio(polytope, period), std::invalid_argument);
    }
    CHECK_NOTHROW(slice(polytope, std::nextafter(3.0, 4.0)));
    CHECK_NOTHROW(slice(polytope, std::nextafter(4.0, 3.0)));
    // Contacts last s + 4 - 2T and 4 - T - s, here 1/8 together: either may not be empty.
    const ModePolytope pair = findPolytopes(2, anyEnergy(3)).front();
    REQUIRE(pair.chains == std::vector<ModeChain>{{1, 2, 1}, {0, 2, 2}});
    CHECK_NOTHROW(ModeMotion(pair, {2.625, {1.3125}}));
    CHECK_THROWS_WITH(ModeMotion(pair, {2.625, {1.25}}), Catch::Contains("outside"));
    CHECK_THROWS_WITH(ModeMotion(pair, {2.625, {1.375}}), Catch::Contains("outside"));
    CHECK_THROWS_WITH(stretches(pair, {2.625, {}}), Catch::Contains("1 numbers"));
}

TEST_CASE("polytopes: progress is measured by the work that an order takes")
{
    ModeBounds bounds = anyEnergy(5);
    std::vector<double> shares;
    bounds.progress = [&shares](double done, double total) { shares.push_back(done / total); };
    (void)findPolytopes(2, bounds);
    REQUIRE(shares.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(shares[i] == Approx(std::pow((2.0 * static_cast<double>(i) + 1.0) / 5.0, 4)));
    }
}
