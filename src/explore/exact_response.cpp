#include "exact_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonic_contact.hpp"
#include "harmonic_growth.hpp"
#include "harmonic_settled.hpp"
#include "harmonic_trial.hpp"

namespace signorini {

namespace {

constexpr double onCurve = 1e-7;        // rad, L/c: the same motion
constexpr double oneFrequency = 1e-12;  // relative

Harmonic harmonicOf(const ResponseRange& range, std::int64_t steps)
{
    return {range.place,  range.amplitude, 0.0,
            range.cycles, steps,           static_cast<double>(range.cells)};
}

/// max u(L) of a tip that never touches.
double linearPeak(const HarmonicCase& given)
{
    const std::complex<double> back = given.inCells(given.back);
    const std::complex<double> wave = given.after(0.0, false) / (back + given.rho);
    return given.amplitude * given.admittance() * lengthOf(given.push(wave)) / given.omega;
}

bool areSame(const HarmonicMotion& x, const HarmonicMotion& y)
{
    return std::equal(x.contacts.begin(), x.contacts.end(), y.contacts.begin(), y.contacts.end(),
                      [](const HarmonicContact& a, const HarmonicContact& b) {
                          return std::abs(a.begin - b.begin) <= onCurve &&
                                 std::abs(a.end - b.end) <= onCurve;
                      }) &&
           std::abs(std::remainder(x.phase - y.phase, 2.0 * std::numbers::pi)) <= onCurve;
}

/// Of a point of a curve: as the list says, or at periods between those of the list what growth
/// says by itself where it is known.
ExactStability stabilityAt(const BranchPoint& point, const std::vector<ExactFrequency>& all)
{
    const double ratio = point.frequencyRatio;
    const auto at = std::find_if(all.begin(), all.end(), [&](const ExactFrequency& one) {
        return std::abs(one.frequencyRatio - ratio) <= oneFrequency * ratio;
    });
    if (at != all.end()) {
        const auto same =
            std::find_if(at->motions.begin(), at->motions.end(),
                         [&](const ExactMotion& one) { return areSame(one.motion, point.motion); });
        return same != at->motions.end() ? same->stability
                                         : exactStability(point.given, point.motion);
    }
    const std::optional<double> growth = growthOf(point.given, point.motion);
    return growth ? ExactStability{growth, *growth < 1.0}
                  : exactStability(point.given, point.motion);
}

}  // namespace

ExactStability exactStability(const HarmonicCase& given, const HarmonicMotion& motion)
{
    ExactStability found{growthOf(given, motion), comesBack(given, motion)};
    if (found.growth) {
        const bool isSmall = *found.growth < 1.0;
        if (found.attracts != isSmall) {
            // Near 1 nothing is seen in the periods tried.
            found.attracts = found.attracts ? std::nullopt : std::optional(isSmall);
        }
    }
    return found;
}

std::optional<ExactFrequency> exactAt(const ResponseRange& range, std::int64_t steps,
                                      const Cancel& cancel)
{
    const HarmonicCase given = harmonicCase(range.damping, harmonicOf(range, steps), range.stops);
    ExactFrequency at;
    at.steps = steps;
    at.frequencyRatio = 4.0 * static_cast<double>(range.cycles) / given.period();
    at.linearPeak = linearPeak(given);
    const auto& [right, left] = range.stops;
    at.touches = at.linearPeak >= (left ? std::min<double>(right, left->value()) : right);
    bool attracts = false;
    for (HarmonicMotion& motion : harmonicContacts(given)) {
        const ExactStability stability = exactStability(given, motion);
        attracts = attracts || stability.attracts.value_or(false);
        at.motions.push_back({given, std::move(motion), stability});
    }
    if (at.touches && !attracts && !isRequested(cancel)) {
        SettlingSearch search;
        search.cycles = responseCycles;
        search.cancel = cancel;
        auto settled =
            settledHarmonic(range.damping, harmonicOf(range, steps), range.stops, search);
        if (settled && std::none_of(at.motions.begin(), at.motions.end(), [&](const auto& one) {
                return areSame(one.motion, settled->motion);
            })) {
            const ExactStability stability = exactStability(settled->given, settled->motion);
            at.motions.push_back({settled->given, std::move(settled->motion), stability});
        }
    }
    return isRequested(cancel) ? std::nullopt : std::optional(std::move(at));
}

std::vector<ExactBranch> exactBranches(const ResponseRange& range,
                                       const std::vector<ExactFrequency>& all, const Cancel& cancel)
{
    std::vector<ExactBranch> branches;
    const auto isCovered = [&](const ExactMotion& one, double ratio) {
        for (const ExactBranch& branch : branches) {
            for (const BranchPoint& point : branch.curve.points) {
                if (std::abs(point.frequencyRatio - ratio) <= oneFrequency * ratio &&
                    areSame(point.motion, one.motion)) {
                    return true;
                }
            }
        }
        return false;
    };
    for (const ExactFrequency& at : all) {
        for (const ExactMotion& one : at.motions) {
            if (isRequested(cancel) || isCovered(one, at.frequencyRatio)) {
                continue;
            }
            Harmonic excitation = harmonicOf(range, at.steps);
            // What bars settle on may have a period of several cycles.
            excitation.steps = at.steps * one.given.cycles;
            excitation.stepsPerCrossing *= static_cast<double>(range.cycles);
            excitation.cycles = one.given.cycles;
            BranchRange follow;
            follow.least = range.leastFrequencyRatio * (1.0 - oneFrequency);
            follow.most = range.mostFrequencyRatio * (1.0 + oneFrequency);
            follow.cancel = cancel;
            ExactBranch branch{
                alongFrequency(range.damping, excitation, range.stops, one.motion, follow), {}};
            for (const BranchPoint& point : branch.curve.points) {
                branch.stability.push_back(stabilityAt(point, all));
            }
            branches.push_back(std::move(branch));
        }
    }
    return branches;
}

}  // namespace signorini
