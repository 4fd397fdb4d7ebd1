#include "harmonic_branch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "harmonic_pattern.hpp"

namespace signorini {

namespace {

constexpr double farAway = 0.05;    // rad, L/c: two neighbours of one sheet are nearer
constexpr double arcOfFold = 0.05;  // ln |A|, rad and L/c, a step around a fold
constexpr int stepsOfFold = 200;
constexpr double otherSheet = 1e-7;  // rad, L/c: that far at least

/// How far two motions are apart; infinite if their contacts are not as many.
double distance(const HarmonicMotion& x, const HarmonicMotion& y)
{
    if (x.contacts.size() != y.contacts.size()) {
        return std::numeric_limits<double>::infinity();
    }
    double most = std::abs(std::remainder(x.phase - y.phase, 2.0 * std::numbers::pi));
    for (std::size_t k = 0; k < x.contacts.size(); ++k) {
        most = std::max({most, std::abs(x.contacts[k].begin - y.contacts[k].begin),
                         std::abs(x.contacts[k].end - y.contacts[k].end)});
    }
    return most;
}

/// Of contacts as they were expected. Fronts that meet at a period are not told apart.
std::optional<BranchEvent> change(const std::vector<HarmonicContact>& expected,
                                  const std::vector<HarmonicContact>& found)
{
    if (expected.size() != found.size()) {
        const bool isLess = expected.size() < found.size();
        const auto& fewer = isLess ? expected : found;
        const auto& more = isLess ? found : expected;
        // Is there one where none was?
        const bool isTouch = std::any_of(more.begin(), more.end(), [&](const auto& one) {
            return std::none_of(fewer.begin(), fewer.end(), [&](const auto& other) {
                return one.begin < other.end && other.begin < one.end;
            });
        });
        return isTouch  ? BranchEvent::grazing
               : isLess ? BranchEvent::newContact
                        : BranchEvent::lostContact;
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
        const HarmonicContact& a = expected[k];
        const HarmonicContact& b = found[k];
        if (a.isPinned != b.isPinned ||
            (a.isPinned && (a.front != b.front || std::abs(a.travel - b.travel) > sameTravel))) {
            return BranchEvent::pin;
        }
    }
    return std::nullopt;
}

/// The other motion of the same amplitude, around a fold.
std::optional<HarmonicMotion> aroundFold(const HarmonicCase& given, const HarmonicMotion& motion)
{
    for (const double sense : {1.0, -1.0}) {
        HarmonicCase there = given;
        HarmonicMotion next = motion;
        HarmonicDirection direction(2 + 2 * motion.contacts.size(), 0.0);
        direction[0] = sense;
        double length = arcOfFold / 16.0;
        for (int k = 0; k < stepsOfFold; ++k) {
            const double before = there.amplitude;
            if (!stepAlongAmplitude(there, next, direction, length)) {
                length /= 2.0;
                if (length < arcOfFold * 1e-5) {
                    break;
                }
                continue;
            }
            length = std::min(2.0 * length, arcOfFold);
            // Back at the amplitude from the side on which it was left.
            if (k > 0 && (before - given.amplitude) * (there.amplitude - given.amplitude) <= 0.0) {
                auto other = harmonicNear(given, {next.phase, next.contacts});
                if (other && distance(*other, motion) > otherSheet) {
                    return other;
                }
                break;
            }
        }
    }
    return std::nullopt;
}

/// One sense of a branch along frequency.
class FrequencyWalk {
public:
    FrequencyWalk(const Damping& damping, const Harmonic& excitation, const Stops& stops,
                  const BranchRange& range)
        : damping_(damping),
          excitation_(excitation),
          stops_(stops),
          range_(range),
          fine_(finest(excitation, range)),
          ticks_(excitation.steps * fine_)
    {
        excitation_.stepsPerCrossing *= static_cast<double>(fine_);
    }

    /// Starts with the motion itself. `sense` 1: to longer periods.
    HarmonicBranch run(const HarmonicMotion& motion, std::int64_t sense)
    {
        given_ = caseAt(ticks_);
        begin(motion);
        std::int64_t step = fine_;
        while (branch_.points.size() < range_.mostPoints && !isRequested(range_.cancel)) {
            const std::int64_t to = ticks_ + sense * step;
            const double ratio = ratioAt(to);
            if (ratio < range_.least || ratio > range_.most || to > maxHarmonicCells) {
                if (step == 1) {
                    break;
                }
                step /= 2;
                continue;
            }
            if (tryTo(to, step == 1)) {
                step = std::min(2 * step, fine_);
                // Coarse points stand on coarse periods.
                while (ticks_ % step != 0) {
                    step /= 2;
                }
                continue;
            }
            if (step > 1) {
                step /= 2;
                continue;
            }
            if (jumps(sense)) {
                continue;
            }
            const auto other = aroundFold(given_, last_);
            mark(other ? BranchEvent::fold : BranchEvent::end);
            // A second fold without a way between them is a knot that is not untied here.
            if (!other || isAtFold_) {
                break;
            }
            isAtFold_ = true;
            begin(*other);
            sense = -sense;
        }
        return std::move(branch_);
    }

private:
    /// Parts of a step: fewer where the longest period would have too many.
    static std::int64_t finest(const Harmonic& excitation, const BranchRange& range)
    {
        const double longest = 4.0 * static_cast<double>(excitation.cycles) *
                               excitation.stepsPerCrossing / range.least;
        const double most = std::max(
            {longest, static_cast<double>(excitation.steps), 2.0 * excitation.stepsPerCrossing});
        std::int64_t fine = range.fine;
        while (fine > 1 &&
               most * static_cast<double>(fine) > static_cast<double>(maxHarmonicCells)) {
            fine /= 2;
        }
        return fine;
    }

    void begin(const HarmonicMotion& motion)
    {
        last_ = motion;
        slope_.clear();
        add();
    }

    /// \return was there a neighbour at that period?
    bool tryTo(std::int64_t to, bool mayChange)
    {
        const HarmonicCase there = caseAt(to);
        const HarmonicStart start = predicted(there);
        const auto next = harmonicNear(there, start);
        if (!next) {
            return false;
        }
        const auto event = change(start.contacts, next->contacts);
        const bool isNear =
            event ? mayChange && isSmallChange(*next) : distance(last_, *next) < reach(there);
        if (isNear) {
            go(to, there, *next, event);
        }
        return isNear;
    }

    /// Over a period at which so many fronts meet that no motion was found.
    bool jumps(std::int64_t sense)
    {
        for (std::int64_t step = 2; step <= 2 * fine_; step *= 2) {
            const std::int64_t to = ticks_ + sense * (step + 1);
            if (ratioAt(to) >= range_.least && ratioAt(to) <= range_.most &&
                to <= maxHarmonicCells && tryTo(to, true)) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] double ratioAt(std::int64_t ticks) const
    {
        return 4.0 * static_cast<double>(excitation_.cycles) * excitation_.stepsPerCrossing /
               static_cast<double>(ticks);
    }

    [[nodiscard]] HarmonicCase caseAt(std::int64_t ticks) const
    {
        Harmonic one = excitation_;
        one.steps = ticks;
        return harmonicCase(damping_, one, stops_);
    }

    [[nodiscard]] double reach(const HarmonicCase& there) const
    {
        return farAway + 10.0 * std::abs(there.period() - given_.period());
    }

    /// A contact that comes or goes is short; one that is let go otherwise stays where it is.
    [[nodiscard]] bool isSmallChange(const HarmonicMotion& next) const
    {
        return std::abs(next.extremes.impulse - last_.extremes.impulse) <=
                   farAway * (1.0 + last_.extremes.impulse) &&
               (next.contacts.size() != last_.contacts.size() || distance(next, last_) < farAway);
    }

    /// Times go on as they went, in d/dT.
    [[nodiscard]] HarmonicStart predicted(const HarmonicCase& there) const
    {
        HarmonicStart start{last_.phase, last_.contacts};
        const double change = there.period() - given_.period();
        const bool isKnown = slope_.size() == 1 + 2 * last_.contacts.size();
        start.phase += isKnown ? change * slope_[0] : 0.0;
        for (std::size_t k = 0; k < start.contacts.size() && isKnown; ++k) {
            start.contacts[k].begin += change * slope_[1 + 2 * k];
            start.contacts[k].end += change * slope_[2 + 2 * k];
        }
        for (HarmonicContact& one : start.contacts) {
            if (one.isPinned) {
                const double way = 2.0 * static_cast<double>(returnOf(given_, one));
                one.travel =
                    way - std::round((way - one.travel) / given_.period()) * there.period();
            }
        }
        return start;
    }

    void go(std::int64_t to, const HarmonicCase& there, const HarmonicMotion& next,
            const std::optional<BranchEvent>& event)
    {
        if (event) {
            mark(*event);
            branch_.marks.back().frequencyRatio = 0.5 * (ratioAt(ticks_) + ratioAt(to));
        }
        slope_.clear();
        if (!event) {
            const double change = there.period() - given_.period();
            slope_.push_back(std::remainder(next.phase - last_.phase, 2.0 * std::numbers::pi) /
                             change);
            for (std::size_t k = 0; k < next.contacts.size(); ++k) {
                slope_.push_back((next.contacts[k].begin - last_.contacts[k].begin) / change);
                slope_.push_back((next.contacts[k].end - last_.contacts[k].end) / change);
            }
        }
        isAtFold_ = false;
        ticks_ = to;
        given_ = there;
        if (event) {
            begin(next);
        } else {
            last_ = next;
            add();
        }
    }

    void add() { branch_.points.push_back({ratioAt(ticks_), given_, last_}); }
    void mark(BranchEvent event)
    {
        branch_.marks.push_back(
            {event, branch_.points.size() - 1, ratioAt(ticks_), given_.amplitude});
    }

    const Damping& damping_;
    Harmonic excitation_;  ///< on the finest periods
    const Stops& stops_;
    const BranchRange& range_;
    std::int64_t fine_;
    std::int64_t ticks_;
    HarmonicCase given_;
    HarmonicMotion last_;
    std::vector<double> slope_;  ///< by the period: phase, begins and ends
    HarmonicBranch branch_;
    bool isAtFold_ = false;  ///< was the last point the other side of one?
};

/// The second one goes on where the first one began.
HarmonicBranch wholeOf(HarmonicBranch first, HarmonicBranch second)
{
    HarmonicBranch whole;
    std::reverse(first.points.begin(), first.points.end());
    const std::size_t offset = first.points.size() - 1;
    std::reverse(first.marks.begin(), first.marks.end());
    for (BranchMark turned : first.marks) {
        turned.after = offset - turned.after - (turned.after < offset ? 1 : 0);
        if (turned.event == BranchEvent::newContact || turned.event == BranchEvent::lostContact) {
            turned.event = turned.event == BranchEvent::newContact ? BranchEvent::lostContact
                                                                   : BranchEvent::newContact;
        }
        whole.marks.push_back(turned);
    }
    for (BranchMark mark : second.marks) {
        mark.after += offset;
        whole.marks.push_back(mark);
    }
    whole.points = std::move(first.points);
    whole.points.insert(whole.points.end(), second.points.begin() + 1, second.points.end());
    return whole;
}

}  // namespace

const char* name(BranchEvent event)
{
    switch (event) {
        case BranchEvent::fold:
            return "fold";
        case BranchEvent::grazing:
            return "grazing";
        case BranchEvent::newContact:
            return "new contact";
        case BranchEvent::lostContact:
            return "lost contact";
        case BranchEvent::pin:
            return "pin";
        case BranchEvent::end:
            break;
    }
    return "end";
}

HarmonicBranch alongFrequency(const Damping& damping, const Harmonic& excitation,
                              const Stops& stops, const HarmonicMotion& motion,
                              const BranchRange& range)
{
    return wholeOf(FrequencyWalk(damping, excitation, stops, range).run(motion, 1),
                   FrequencyWalk(damping, excitation, stops, range).run(motion, -1));
}

}  // namespace signorini
