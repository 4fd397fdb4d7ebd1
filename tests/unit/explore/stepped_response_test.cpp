// The response of bars of several segments.

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "contact_response.hpp"
#include "growing_bar.hpp"
#include "stepped_forced_oracle.hpp"

using namespace signorini;
using signorini::test::SteppedForcedOracle;

namespace {

ResponseRange rangeOf(std::vector<Segment> segments, double ratio, Excited place,
                      std::int64_t cycles = 1)
{
    ResponseRange range;
    range.cells = 0;
    for (const Segment& segment : segments) {
        range.cells += segment.cells;
    }
    range.damping = {ratio};
    range.place = place;
    range.amplitude = 1.0;
    range.cycles = cycles;
    range.segments = std::move(segments);
    return range;
}

/// Those where two conditions meet in one point: rounding decides whether they do.
void leaveOutPoints(FrequencyResponse& response)
{
    std::erase_if(response.branches, [](const AmplitudeBranch& branch) {
        return branch.most - branch.least < 1e-9 * branch.least;
    });
}

/// Those that a pressed bar has of so many contact steps and more: each class flies once at most,
/// and its tip rests at the wall, which segments have as permanent contact.
void leaveOutRest(FrequencyResponse& response, std::int64_t contact)
{
    std::erase_if(response.branches,
                  [contact](const AmplitudeBranch& branch) { return branch.contact >= contact; });
    std::erase_if(response.motions, [contact](const ForcedMotion& motion) {
        return motion.schedule.phases.front().contact >= contact;
    });
}

/// Largest deviation of the tip from the wall at the ends of ten periods that the bar decides by
/// itself, and of its impulse from ten times that of the motion.
double driftOf(const ForcedMotion& motion, const std::vector<Segment>& segments)
{
    BarSimulation own(wavesOf(motion.state), motion.damping, motion.excitation,
                      {.segments = segments});
    double worst = 0.0;
    for (int k = 0; k < 10; ++k) {
        own.advance(static_cast<double>(motion.excitation.steps()));
        worst = std::max(worst, std::abs(own.tip() - 1.0));
    }
    return std::max(worst, std::abs(own.impulse() - 10.0 * motion.extremes.impulse));
}

}  // namespace

TEST_CASE("stepped response: 4 + 4 equal cells have exactly the motions of one bar", "[glpk]")
{
    const double ratio = GENERATE(0.02, 0.15);
    const Excited place = GENERATE(Excited::tip, Excited::base);
    const std::int64_t cycles = GENERATE(1, 3);
    const Stops stops = GENERATE(Stops{}, Stops{1, Fraction{2, 1}}, Stops{-1, {}}, Stops{0, {}});
    ResponseRange equal = rangeOf({{.cells = 4}, {.cells = 4}}, ratio, place, cycles);
    equal.stops = stops;
    equal.leastFrequencyRatio = 0.4;
    equal.mostFrequencyRatio = 2.4;
    equal.amplitude *= (stops.right < 0 ? 0.31 : 1.01) * static_cast<double>(cycles);
    ResponseRange one = equal;
    one.segments.clear();
    std::size_t motions = 0;
    int held = 0;
    for (const std::int64_t n : stepsOf(one)) {
        FrequencyResponse known = responseAt(one, n).value();
        FrequencyResponse seen = steppedResponseAt(equal, n, {}).value();
        for (FrequencyResponse* response : {&known, &seen}) {
            leaveOutPoints(*response);
            if (stops.right <= 0) {
                leaveOutRest(*response, n - std::gcd(n, std::int64_t{16}));
            }
        }
        INFO("n = " << n << ", " << name(place) << ", zeta = " << ratio << ", K = " << cycles
                    << ", stops " << stops.right << (stops.left ? " two" : ""));
        CHECK(seen.linearPeak == Approx(known.linearPeak).epsilon(1e-10).margin(1e-14));
        CHECK(seen.undecided <= known.undecided);
        if (std::abs(known.linearPeak - 1.0) > 1e-12) {  // else rounding decides
            CHECK(seen.touches == known.touches);
        }
        CHECK(seen.frequencyRatio == known.frequencyRatio);
        REQUIRE(seen.permanent.has_value() == known.permanent.has_value());
        // Where waves between base and wall have the frequency of the force pushes may differ by
        // them.
        if (known.permanent && 16 * cycles % n != 0) {
            ++held;
            CHECK(seen.permanent->leastForce == Approx(known.permanent->leastForce).margin(1e-9));
            CHECK(seen.permanent->residual < forcedTolerance);
            CHECK(seen.permanent->extremes.impulse ==
                  Approx(known.permanent->extremes.impulse).epsilon(1e-9));
        }
        REQUIRE(seen.branches.size() == known.branches.size());
        for (std::size_t k = 0; k < seen.branches.size(); ++k) {
            CHECK(seen.branches[k].contact == known.branches[k].contact);
            CHECK(seen.branches[k].least == Approx(known.branches[k].least).epsilon(1e-7));
            CHECK((std::isinf(known.branches[k].most)
                       ? std::isinf(seen.branches[k].most)
                       : seen.branches[k].most == Approx(known.branches[k].most).epsilon(1e-7)));
        }
        REQUIRE(seen.motions.size() == known.motions.size());
        motions += seen.motions.size();
        for (std::size_t k = 0; k < seen.motions.size(); ++k) {
            const ForcedMotion& x = seen.motions[k];
            const ForcedMotion& y = known.motions[k];
            CHECK(x.schedule == y.schedule);
            CHECK(x.residual < forcedTolerance);
            INFO("n_c = " << x.schedule.phases.front().contact);
            if (n - x.schedule.phases.front().contact < std::gcd(n, std::int64_t{16})) {
                continue;  // one of many
            }
            CHECK(std::abs(std::remainder(x.phase - y.phase, 2.0 * std::numbers::pi)) < 1e-7);
            CHECK((x.state.a - y.state.a).lpNorm<Eigen::Infinity>() < 1e-7);
            CHECK((x.state.b - y.state.b).lpNorm<Eigen::Infinity>() < 1e-7);
            CHECK(x.extremes.impulse == Approx(y.extremes.impulse).epsilon(1e-7));
            CHECK(x.extremes.peakForce == Approx(y.extremes.peakForce).epsilon(1e-7));
            CHECK(x.extremes.lowestTip == Approx(y.extremes.lowestTip).epsilon(1e-7));
        }
    }
    CHECK((motions > 20 || cycles > 1 || stops.right < 0));
    CHECK((held > 0 || stops.right >= 0));
}

TEST_CASE("stepped response: every motion goes on by itself for ten periods")
{
    const auto segments =
        GENERATE(std::vector<Segment>{{.cells = 4}, {.cells = 4, .impedance = 1.3}},
                 std::vector<Segment>{{.cells = 3}, {.cells = 5, .impedance = 0.2}},
                 std::vector<Segment>{{.cells = 3},
                                      {.cells = 2, .impedance = 0.4, .speed = 2.0, .dashpot = 0.02},
                                      {.cells = 5, .impedance = 1.7}});
    const Excited place = GENERATE(Excited::tip, Excited::base);
    ResponseRange range = rangeOf(segments, 0.05, place);
    range.mostFrequencyRatio = 1.8;
    std::size_t motions = 0;
    for (const FrequencyResponse& response : frequencyResponse(range)) {
        CHECK(response.undecided == 0);
        for (const ForcedMotion& motion : response.motions) {
            INFO(describe(motion.schedule) << ", " << name(place));
            ++motions;
            CHECK(motion.residual < forcedTolerance);
            CHECK(motion.amplitude == Approx(range.amplitude).epsilon(1e-9));
            CHECK(driftOf(motion, segments) < 1e-6);
        }
    }
    CHECK(motions > 5);
}

TEST_CASE("stepped response: no schedule of a range is missed, says a linear program of its own",
          "[glpk]")
{
    const auto segments =
        GENERATE(std::vector<Segment>{{.cells = 2}, {.cells = 3, .impedance = 1.3}},
                 std::vector<Segment>{{.cells = 2}, {.cells = 2, .impedance = 0.1}},
                 std::vector<Segment>{{.cells = 1},
                                      {.cells = 3, .impedance = 30.0, .dashpot = 0.1},
                                      {.cells = 1, .impedance = 0.7}});
    const Excited place = GENERATE(Excited::tip, Excited::base);
    ResponseRange range = rangeOf(segments, 0.08, place);
    range.leastFrequencyRatio = 0.7;
    range.mostFrequencyRatio = 3.0;
    int exist = 0;
    int none = 0;
    int held = 0;
    for (const std::int64_t n : stepsOf(range)) {
        const FrequencyResponse response = responseAt(range, n).value();
        CHECK(response.undecided == 0);
        test::GrowingBar grown(segments, range.damping.eta(), place, 1, n);
        GrowingContact& waves = grown.waves();
        for (std::int64_t contact = 1; contact < n; ++contact) {
            INFO("n = " << n << ", n_c = " << contact << ", " << name(place));
            const SteppedForcedOracle oracle({range.cells, {{contact, n - contact}}}, segments,
                                             range.damping.eta(), place);
            const double missed = oracle.leastMissed();
            const auto has = [contact](const AmplitudeBranch& branch) {
                return branch.contact == contact;
            };
            const bool isFound =
                std::any_of(response.branches.begin(), response.branches.end(), has);
            if (missed > 1e-11 && missed < 1e-7) {
                continue;  // rounding decides
            }
            CHECK(isFound == (missed <= 1e-11));
            isFound ? ++exist : ++none;
            waves.grow();
            held += waves.freePushes() > 0 ? 1 : 0;
            if (!isFound || waves.freePushes() > 0) {
                continue;
            }
            const ForcedLine line = waves.line();
            for (const Plane way : {Plane{1, 0}, Plane{0, 1}, Plane{-1, 0}, Plane{0, -1}}) {
                const double most = std::max(way.dot(line.at(std::max(line.low, -1e9))),
                                             way.dot(line.at(std::min(line.high, 1e9)))) /
                                    grown.unit();
                const double known = oracle.farthest(way.c, way.s);
                CHECK(
                    (most > 1e4 ? known > 1e2 : most == Approx(known).epsilon(1e-5).margin(1e-6)));
            }
        }
    }
    CHECK(exist > 20);
    CHECK(none > 100);
    CHECK(held > 0);
}

TEST_CASE("stepped response: what only a uniform bar can be asked is refused by name")
{
    ResponseRange range =
        rangeOf({{.cells = 4}, {.cells = 4, .impedance = 1.3}}, 0.05, Excited::tip);
    range.cells = 9;
    CHECK_THROWS_WITH(stepsOf(range), containsText("cells of all segments = 8"));
    range.cells = 8;
    range.leastFrequencyRatio = 1e-4;
    CHECK_THROWS_WITH(stepsOf(range), containsText("20000"));
}
