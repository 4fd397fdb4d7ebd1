// The response of any network, contact by contact, against the engine of single schedules.

#include "contact_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../mechanics/random_network.hpp"
#include "catch.hpp"
#include "has_solver.hpp"
#include "network_forced.hpp"
#include "network_sweep.hpp"
#include "scene_words.hpp"

using namespace signorini;

namespace {

/// Least and largest amplitude of n_c; none: no motion.
std::optional<std::pair<double, double>> rangeIn(const FrequencyResponse& response,
                                                 std::int64_t contact)
{
    std::optional<std::pair<double, double>> range;
    for (const AmplitudeBranch& branch : response.branches) {
        if (branch.contact == contact) {
            range = {range ? std::min(range->first, branch.least) : branch.least,
                     range ? std::max(range->second, branch.most) : branch.most};
        }
    }
    return range;
}

/// Is a motion of a schedule one whose contact is always closed?
bool neverOpens(const Network& network, const ForcedSet& set)
{
    NetworkClaim claim = claimOf(set, leastAmplitudeMotion(set));
    claim.schedule = {{claim.schedule.front().closed, claim.steps()}};
    return walk(network, claim).worst() < forcedTolerance;
}

struct ResponseCount {
    int found = 0;
    int none = 0;
    int motions = 0;
    int undecided = 0;
};

/// Every contact and length of one n against the programs of its schedule.
void compareWithSets(const HarmonicNetwork& given, ResponseCount& count)
{
    const auto all = contactResponses(given, {});
    REQUIRE(all);
    REQUIRE(all->size() == given.network.contacts.size());
    for (std::size_t c = 0; c < all->size(); ++c) {
        const FrequencyResponse& response = (*all)[c].found;
        count.undecided += static_cast<int>(response.undecided);
        for (std::int64_t closed = 1; closed < given.steps; ++closed) {
            INFO("n = " << given.steps << ", contact " << c + 1 << ", n_c = " << closed);
            const std::vector<ContactSpan> spans{{ContactSet{1} << c, closed},
                                                 {0, given.steps - closed}};
            const ForcedSet set =
                forcedScene(given.network, spans, {given.place, given.cycles, {}}, 10.0);
            const auto range = rangeIn(response, closed);
            const double width = set.mostAmplitude - set.leastAmplitude;
            if (set.status == Status::undecided || set.kind == ForcedKind::point ||
                (set.status == Status::found && width < 1e-6 * set.leastAmplitude)) {
                continue;  // rounding decides
            }
            if (!range && set.status == Status::found && neverOpens(given.network, set)) {
                continue;  // permanent contact
            }
            REQUIRE((range.has_value() == (set.status == Status::found)));
            range ? ++count.found : ++count.none;
            if (range) {
                CHECK(range->first == Approx(set.leastAmplitude).epsilon(1e-6).margin(1e-7));
                INFO(range->second << " for " << set.mostAmplitude);
                CHECK((set.mostAmplitude > 1e6
                           ? range->second > 1e5
                           : range->second == Approx(set.mostAmplitude).epsilon(1e-6)));
            }
        }
        for (const ForcedMotion& motion : response.motions) {
            ++count.motions;
            CHECK(motion.residual < forcedTolerance);
            CHECK(motion.amplitude == Approx(given.amplitude).epsilon(1e-9));
            CHECK(motion.extremes.impulse > -1e-9);
        }
    }
}

}  // namespace

TEST_CASE("contact response: every schedule of one contact is what its own programs say", "[glpk]")
{
    if (!test::hasSimplex()) {
        return;
    }
    ResponseCount count;
    for (const char* words :
         {"clamp 3 dash=0.1 driven gap=1e-3 4:1.3 dash=0.05 2 clamp",
          "clamp 3 dash=0.2 driven gap=1e-3 3 clamp", "clamp 3 dash=0.1 stop=1e-3 2 driven 2 clamp",
          "spring=4 5 dash=0.1 driven stop=1e-3", "clamp 4 dash=0.1 mass=0.2 2 driven stop=1e-3",
          "clamp 3 driven gap=-2e-4 2 dash=0.1 2 clamp",
          "clamp 3 dash=0.2 gap=1e-3 spring=3 2 driven dash=0.1 gap=1e-3 3 clamp",
          "clamp 2 stop=1e-3 dash=0.1 2 driven stop=2e-3", "clamp 4 driven gap=1e-3 4 clamp",
          "clamp 2 dash=0.1 2 driven gap=1e-3 4 clamp", "stop=1e-3 4 driven dash=0.1 stop=1e-3"}) {
        for (std::int64_t n = 5; n < 27; n += 3) {
            INFO(words);
            compareWithSets({sceneOf(words), Excited::tip, 40.0, n, 1}, count);
        }
    }
    INFO(count.found << " found, " << count.none << " none, " << count.motions << " motions, "
                     << count.undecided << " undecided");
    CHECK(count.found > 100);
    CHECK(count.none > 500);
    CHECK(count.motions > 20);
    CHECK(count.undecided == 0);
}

TEST_CASE("contact response: random networks have what the programs of each schedule say", "[glpk]")
{
    if (!test::hasSimplex()) {
        return;
    }
    test::NetworkGenerator generator(2026);
    ResponseCount count;
    int networks = 0;
    while (networks < 150) {
        const Network network = generator.network(
            {.mostCells = 3, .mostBars = 3, .hasDashpots = true, .hasForces = true});
        const Excited place = generator.isOneOf(3) ? Excited::base : Excited::tip;
        const std::int64_t n = generator.whole(3, 16);
        const HarmonicNetwork given{network, place, 10.0, n, 1};
        if (!isExcitable(network, place) || network.contacts.size() > 4) {
            continue;
        }
        INFO("network " << networks << ", " << name(place));
        try {
            compareWithSets(given, count);
            ++networks;
        } catch (const std::invalid_argument&) {
            continue;  // a bar that forces pull away, or that is shaken and held elsewhere
        }
    }
    INFO(count.found << " found, " << count.none << " none, " << count.motions << " motions, "
                     << count.undecided << " undecided");
    CHECK(count.found > 50);
    CHECK(count.none > 1000);
}
