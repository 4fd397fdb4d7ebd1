#include "harmonic_branch.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "harmonic_contact.hpp"
#include "harmonic_growth.hpp"
#include "harmonic_trial.hpp"

using namespace signorini;

namespace {

Harmonic forceOf(std::int64_t steps, double amplitude)
{
    return {Excited::tip, amplitude, 0.0, 1, steps, 30.0};
}

/// Has the complete list of a case a motion of these contacts and phase?
bool isListed(const HarmonicCase& given, const HarmonicMotion& motion)
{
    const auto all = harmonicContacts(given);
    return std::any_of(all.begin(), all.end(), [&](const HarmonicMotion& one) {
        return std::abs(one.contacts[0].end - motion.contacts[0].end) < 1e-8 &&
               std::abs(one.phase - motion.phase) < 1e-8;
    });
}

std::int64_t count(const HarmonicBranch& branch, BranchEvent event)
{
    return std::count_if(branch.marks.begin(), branch.marks.end(),
                         [&](const BranchMark& mark) { return mark.event == event; });
}

}  // namespace

TEST_CASE("harmonic branch: along the frequency it turns back at its fold")
{
    const Damping damping = dampingOfRho(0.9);
    const auto motions = harmonicContacts(damping, forceOf(108, 0.25));
    const HarmonicBranch branch =
        alongFrequency(damping, forceOf(108, 0.25), {}, motions.back(), {0.8, 1.3});
    CHECK(branch.points.size() > 30);
    CHECK(count(branch, BranchEvent::fold) == 1);
    for (const BranchMark& mark : branch.marks) {
        if (mark.event == BranchEvent::fold) {
            // The list has two motions at n = 99 and none at n = 98.
            CHECK(mark.frequencyRatio > 120.0 / 99.0);
            CHECK(mark.frequencyRatio < 120.0 / 98.0);
        }
    }
    std::size_t both = 0;
    for (const BranchPoint& point : branch.points) {
        CHECK(point.motion.residual < 1e-11);
        if (point.motion.contacts.size() == 1) {
            INFO("omega " << point.frequencyRatio << " tau " << point.motion.contacts[0].end);
            CHECK(isListed(point.given, point.motion));
        }
        // Both sheets at n = 103.
        both += std::abs(point.frequencyRatio - 120.0 / 103.0) < 1e-12 ? 1 : 0;
    }
    CHECK(both == 2);
}

TEST_CASE("harmonic branch: disturbed bars come back where growth says so, and only there")
{
    const Damping damping = dampingOfRho(0.9);
    int compared = 0;
    for (std::int64_t n = 99; n <= 134; ++n) {
        const HarmonicCase given = harmonicCase(damping, forceOf(n, 0.25));
        for (const HarmonicMotion& motion : harmonicContacts(given)) {
            const auto growth = growthOf(given, motion);
            const auto tried = comesBack(given, motion);
            if (growth && tried && std::abs(*growth - 1.0) > 0.01) {
                INFO("n " << n << " growth " << *growth);
                CHECK(*tried == (*growth < 1.0));
                ++compared;
            }
        }
    }
    CHECK(compared >= 12);
}
