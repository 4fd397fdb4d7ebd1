#include "exact_response.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"

using namespace signorini;

TEST_CASE("exact response: two contacts fill the hole that one leaves near resonance")
{
    ResponseRange range;
    range.cells = 30;
    range.damping = dampingOfRho(0.9);
    range.place = Excited::tip;
    range.amplitude = 0.25;
    range.leastFrequencyRatio = 120.0 / 122.0;
    range.mostFrequencyRatio = 120.0 / 114.0;
    std::vector<ExactFrequency> all;
    for (std::int64_t n = 114; n <= 122; ++n) {
        all.push_back(*exactAt(range, n));
    }
    for (const ExactFrequency& at : all) {
        CHECK(at.touches);
        const bool isHole = at.steps == 118;
        const auto several =
            std::find_if(at.motions.begin(), at.motions.end(),
                         [](const ExactMotion& one) { return one.motion.contacts.size() > 1; });
        CHECK((several != at.motions.end()) >= isHole);
        if (isHole) {
            CHECK(several->motion.contacts.size() == 2);
            CHECK(several->motion.extremes.impulse == Approx(0.42656975).margin(1e-8));
            CHECK(several->stability.attracts == std::optional(true));
        }
    }
    const auto branches = exactBranches(range, all);
    for (const ExactFrequency& at : all) {
        for (const ExactMotion& one : at.motions) {
            INFO("n " << at.steps);
            CHECK(std::any_of(branches.begin(), branches.end(), [&](const ExactBranch& branch) {
                return std::any_of(
                    branch.curve.points.begin(), branch.curve.points.end(),
                    [&](const BranchPoint& point) {
                        return std::abs(point.motion.phase - one.motion.phase) < 1e-7 &&
                               std::abs(point.frequencyRatio - at.frequencyRatio) < 1e-12;
                    });
            }));
        }
    }
}

TEST_CASE("exact response: without contact the tip swings as the bar without stops does")
{
    // At omega_1 the waves add up to F (1 + rho)/(2 (1 - rho)) over omega, as damping ratio says.
    ResponseRange range;
    range.cells = 1;
    range.damping = dampingOfRho(0.9);
    range.place = Excited::tip;
    range.amplitude = 1e-4;
    const auto at = exactAt(range, 4);
    REQUIRE(at);
    CHECK_FALSE(at->touches);
    CHECK(at->motions.empty());
    // eta v = F there: the dashpot alone takes the work.
    CHECK(at->linearPeak ==
          Approx(1e-4 / range.damping.eta() / (0.5 * 3.14159265358979)).epsilon(1e-12));
}
