#include "signorini/motion.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "catch.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/verification.hpp"
#include "stepped_waves.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

const Schedule paper = onePhase(12, 6, 36);  // family (4, 7, 1), G = 6

/// A motion of `schedule` with amplitudes in given proportions.
State motion(const Schedule& schedule, std::vector<double> z)
{
    const OnePhaseSet whole = onePhaseSet(schedule);
    double total = 0.0;
    for (const double value : z) {
        total += value;
    }
    for (double& value : z) {
        value *= whole.set.sum / total;
    }
    return motionOf(whole, z);
}

/// By trying all rotations.
bool isRotation(const std::vector<double>& a, std::vector<double> b)
{
    for (std::size_t shift = 0; shift < b.size(); ++shift) {
        if (a == b) {
            return true;
        }
        std::rotate(b.begin(), b.begin() + 1, b.end());
    }
    return false;
}

/// The state some steps into the period of a one-phase motion.
State later(const State& state, const Schedule& schedule, std::int64_t count)
{
    test::UniformWaves bar(state);
    for (std::int64_t m = 0; m < count; ++m) {
        if (m % steps(schedule) < schedule.phases.front().contact) {
            bar.contact();
        } else {
            bar.free();
        }
    }
    return bar.state();
}

}  // namespace

TEST_CASE("orbit: leading zeros moved to the end are the same orbit later")
{
    const State block = motion(paper, {1, 2, 1, 0, 0, 0});
    for (int zeros = 1; zeros <= 3; ++zeros) {
        std::vector<double> z(6, 0.0);
        const auto first = z.begin() + zeros;
        first[0] = first[2] = 1.0;
        first[1] = 2.0;
        const State travelled = motion(paper, z);
        CHECK(isSameOrbit(block, travelled, paper));
        CHECK(isSameOrbit(block, travelled, paper, 1e-12));
        CHECK(orbitRepresentative(travelled, paper) == orbitRepresentative(block, paper));
        CHECK_FALSE(travelled == block);
    }
}

TEST_CASE("orbit: members with a first amplitude above 0 are different orbits")
{
    for (const Schedule& schedule : {paper, onePhase(15, 12, 36), onePhase(14, 12, 32)}) {
        const std::int64_t count = onePhaseSet(schedule).kernelDimension;
        REQUIRE(count >= 4);
        std::mt19937_64 generator(3);
        std::uniform_int_distribution<int> small(0, 2);
        std::set<std::vector<double>> seen;
        std::vector<State> states;
        for (int i = 0; i < 60; ++i) {
            std::vector<double> z{1.0};
            while (z.size() < static_cast<std::size_t>(count)) {
                z.push_back(small(generator));
            }
            if (seen.insert(z).second) {
                states.push_back(motion(schedule, z));
            }
        }
        for (std::size_t i = 0; i < states.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                REQUIRE_FALSE(isSameOrbit(states[i], states[j], schedule));
            }
        }
    }
}

TEST_CASE("orbit: the ring comparison agrees with trying every rotation")
{
    std::mt19937_64 generator(17);
    std::uniform_int_distribution<int> small(0, 1);
    const Schedule schedule = onePhase(15, 12, 36);  // k = 2: zeros leave several contacts
    const auto count = static_cast<std::size_t>(onePhaseSet(schedule).kernelDimension);
    int same = 0;
    int different = 0;
    for (int i = 0; i < 300; ++i) {
        std::vector<double> first(count);
        std::vector<double> second(count);
        for (std::size_t j = 0; j < count; ++j) {
            first[j] = small(generator);
            second[j] = small(generator);
        }
        first.back() = second[count / 2] = 1.0;
        const State a = motion(schedule, first);
        const State b = motion(schedule, second);
        const bool expected = isRotation(arrivals(a, schedule), arrivals(b, schedule));
        ++(expected ? same : different);
        REQUIRE(isSameOrbit(a, b, schedule) == expected);
        REQUIRE(isSameOrbit(a, b, schedule, 1e-9) == expected);
        REQUIRE((orbitRepresentative(a, schedule) == orbitRepresentative(b, schedule)) == expected);
    }
    CHECK(same > 5);
    CHECK(different > 100);
}

TEST_CASE("orbit: the mirrored schedules of a tent have the same orbits")
{
    for (std::int64_t offset = 1; offset < 6; ++offset) {
        const OnePhaseSet shorter = onePhaseSet(onePhase(12, 6 - offset, 36 + offset));
        const OnePhaseSet longer = onePhaseSet(onePhase(12, 6 + offset, 36 - offset));
        std::mt19937_64 generator(static_cast<unsigned>(offset));
        const std::vector<double> z = drawAmplitudes(shorter.set, generator);
        REQUIRE(longer.set.count == shorter.set.count);
        CHECK(isSameOrbit(motionOf(shorter, z), motionOf(longer, z), paper));
    }
}

TEST_CASE("orbit: the representative is a state of the orbit in which contact begins")
{
    std::mt19937_64 generator(23);
    const OnePhaseSet whole = onePhaseSet(paper);
    for (int i = 0; i < 20; ++i) {
        const State state = motionOf(whole, drawAmplitudes(whole.set, generator));
        const State representative = orbitRepresentative(state, paper);
        CHECK(representative == state);  // z_1 > 0: it begins with the one contact
        CHECK(verify(representative, paper).residuals.worst() < 1e-12);
        CHECK(later(representative, paper, steps(paper)) == state);
    }
    // With zeros inside and k = 2 there are several contacts; the wall is reached in each.
    const Schedule schedule = onePhase(15, 12, 36);
    const State broken = motion(schedule, {0, 1, 0, 2, 0, 0});
    const State representative = orbitRepresentative(broken, schedule);
    CHECK(displacement(representative)[14] == Approx(1.0));
    bool isVisited = false;
    for (std::int64_t m = 0; m < steps(schedule); ++m) {
        isVisited = isVisited || later(broken, schedule, m) == representative;
    }
    CHECK(isVisited);
}

TEST_CASE("orbit: a tolerance forgives rounding and no more")
{
    const State state = motion(paper, {3, 1, 4, 1, 5, 9});
    State noisy = state;
    const double size = amplitude(state);
    for (Eigen::Index i = 0; i < noisy.a.size(); ++i) {
        noisy.a[i] += 1e-10 * size * (i % 2 == 0 ? 1.0 : -1.0);
    }
    CHECK_FALSE(isSameOrbit(state, noisy, paper));
    CHECK(isSameOrbit(state, noisy, paper, 1.1e-10));
    CHECK_FALSE(isSameOrbit(state, noisy, paper, 0.9e-10));
}

TEST_CASE("orbit: long flights cost no more than folded ones")
{
    const std::int64_t far = 4 * 12 * 1'000'000'000'000'000;
    const Schedule grazing = onePhase(12, 1, 47);  // G = 24
    const Schedule longer = onePhase(12, 1, 47 + far);
    const State state = leastEnergyMotion(onePhaseSet(grazing));
    CHECK(isSameOrbit(state, state, longer));
    CHECK(arrivals(state, grazing).size() == 48);
    CHECK(arrivals(state, longer).size() == 96);
}

TEST_CASE("orbit: bad input is refused by name")
{
    const State state = motion(paper, {1, 1, 1, 1, 1, 1});
    CHECK_THROWS_WITH(isSameOrbit(state, state, onePhase(13, 6, 36)), containsText("12"));
    CHECK_THROWS_WITH(isSameOrbit(state, state, paper, -1.0), containsText("tolerance = -1"));
    CHECK_THROWS_WITH(isSameOrbit(state, state, paper, std::numeric_limits<double>::quiet_NaN()),
                      containsText("tolerance = nan"));
    CHECK_THROWS_AS(arrivals(state, onePhase(12, 0, 36)), std::invalid_argument);
}
