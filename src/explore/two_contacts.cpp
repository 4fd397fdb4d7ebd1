#include "two_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bar_check.hpp"
#include "faults.hpp"
#include "forced_case.hpp"
#include "forced_cut.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// Numbers below this part of the others count as 0: such schedules are not refuted here.
constexpr double nearlyZero = 1e-9;

/// The schedules of one n, one after the other.
class Sweep {
public:
    Sweep(const ResponseRange& range, std::int64_t steps)
        : range_(range),
          question_(pairsOf(range)),
          steps_(steps),
          waves_(range.cells, range.damping.rho(),
                 shapesOf({range.place, range.cycles, {}}, range.cells, steps), range.stops)
    {
        if (const auto& left = range.stops.left) {
            way_ = static_cast<double>(2 * range.cells) * (range.stops.right + left->value()) /
                   (1.0 + range.damping.rho());
        }
    }

    /// Every schedule with these first two parts and both contacts on one stop whose second contact
    /// is not longer than the first one; of equal contacts the first flight is the longer one.
    void visit(std::int64_t contact, std::int64_t free, Stop stop, FrequencyResponse& response)
    {
        const std::int64_t left = steps_ - contact - free;
        for (std::int64_t second = 1; second <= std::min(contact, left - shortestFlight);
             ++second) {
            if (free >= shortestFlight && (second < contact || free > left - second)) {
                look({{{contact, free, stop}, {second, left - second, stop}}}, response);
            }
        }
    }

    /// The same with the first contact on the wall and the second on the other stop. Those that
    /// mirror each other at equal distances are no points, but lines: they are not looked at here.
    void visitBoth(std::int64_t contact, std::int64_t free, FrequencyResponse& response)
    {
        const std::int64_t left = steps_ - contact - free;
        for (std::int64_t second = 1; second < left; ++second) {
            const std::array<Phase, 2> phases{
                {{contact, free, Stop::right}, {second, left - second, Stop::left}}};
            if (range_.cycles % 2 == 0 || !isMirrored(phases, range_.stops)) {
                look(phases, response);
            }
        }
    }

private:
    void look(const std::array<Phase, 2>& phases, FrequencyResponse& response)
    {
        phases_ = phases;
        waves_.setPhases(phases_);
        held_.clear();
        if (waves_.heldClasses() > 0) {
            held_.resize(static_cast<std::size_t>(waves_.classes()), false);
            for (const std::int64_t j : waves_.freeClasses()) {
                held_[static_cast<std::size_t>(j)] = true;
            }
        }
        if (!(phases_[0].stop == phases_[1].stop ? isRefuted() : isRefutedBetween())) {
            const Schedule schedule{range_.cells, {phases_.begin(), phases_.end()}, range_.stops};
            addPair(response, schedule, question_);
        }
    }

    /// Of the first flight, which has to close.
    [[nodiscard]] Plane closure() const
    {
        Plane sum;
        for (std::int64_t m = 0; m < phases_[0].free; ++m) {
            sum = sum + waves_.push(phases_[0].contact + m);
        }
        return sum;
    }

    [[nodiscard]] double sizeOfPushes() const
    {
        double scale = 0.0;
        for (std::int64_t m = 0; m < steps_; m += 1 + steps_ / 16) {
            scale = std::max(scale, size(waves_.push(m)));
        }
        return scale;
    }

    [[nodiscard]] bool isHeld(std::int64_t m) const
    {
        return !held_.empty() && held_[static_cast<std::size_t>(m % waves_.classes())];
    }

    /// Does no class fly twice? Then the tip rests, as with one contact (tipRests): permanent
    /// contact, which is said once.
    [[nodiscard]] bool isPermanent() const
    {
        if (held_.empty() ||
            (range_.place == Excited::base && 2 * range_.cells * range_.cycles % steps_ == 0)) {
            return false;
        }
        std::vector<bool> flies(held_.size(), false);
        std::int64_t m = 0;
        for (const Phase& phase : phases_) {
            m += phase.contact;
            for (const std::int64_t end = m + phase.free; m < end; ++m) {
                const auto j = static_cast<std::size_t>(m % waves_.classes());
                if (flies[j]) {
                    return false;
                }
                flies[j] = true;
            }
        }
        return true;
    }

    /// The step of a class with the least push on the wall, or the most on the other stop, for an
    /// excitation; none: it never touches that stop.
    [[nodiscard]] std::optional<Plane> leastPush(std::int64_t j, Stop stop, Plane place) const
    {
        std::optional<Plane> least;
        const std::int64_t second = phases_[0].contact + phases_[0].free;
        for (std::int64_t m = j; m < steps_; m += waves_.classes()) {
            const Plane push = pushSign(stop) * waves_.push(m);
            if ((m < second) == (stop == Stop::right) &&
                (!least || push.dot(place) < least->dot(place))) {
                least = push;
            }
        }
        return least;
    }

    /// Classes that are always in contact share in u(L, 0) = g: on the wall each has to be so large
    /// that it presses in all its steps, on the other stop so small. Their sum is bounded by convex
    /// functions of (C, S), which are cut off by their tangents at the ends of what is left.
    /// \return is anything left?
    [[nodiscard]] bool heldAllow(ForcedCut& cut) const
    {
        constexpr int mostCuts = 20;
        const auto classes = static_cast<double>(waves_.classes());
        const Plane gap = classes * waves_.tip(0);
        const double place = classes * range_.stops.right;
        const double slack = nearlyZero * classes * (1.0 + std::abs(range_.stops.right));
        for (int pass = 0; pass < mostCuts; ++pass) {
            const ForcedLine before = cut.result();
            for (const double end : {before.low, before.high}) {
                const Plane at = std::isfinite(end) ? before.at(end)
                                                    : std::copysign(1.0, end) * before.direction;
                for (const Stop stop : {Stop::right, Stop::left}) {
                    const double sign = pushSign(stop);
                    Plane row = sign * gap;
                    bool areAll = true;
                    for (const std::int64_t j : waves_.freeClasses()) {
                        const auto push = leastPush(j, stop, at);
                        areAll = areAll && push;
                        row = push ? row + *push : row;
                    }
                    if (areAll && !cut.by(row, {}, sign * place - slack)) {
                        return false;
                    }
                }
            }
            const ForcedLine after = cut.result();
            if (after.low == before.low && after.high == before.high) {
                return true;
            }
        }
        return true;
    }

    /// From one stop to the other a flight closes on a line beside 0. It and u(L, 0) = g leave a
    /// point, or, where waves that are always held share in u(L, 0), the line.
    [[nodiscard]] bool isRefutedBetween() const
    {
        const double scale = sizeOfPushes();
        const Plane end = closure();
        ForcedCut cut(end, -way_, scale, true, false);
        if (!cut.result().hasLine) {
            return false;
        }
        const double nothing = nearlyZero * scale;
        const auto by = [&](Plane row, double limit) {
            return size(row) <= nothing || cut.by(row, {}, limit - nearlyZero * way_);
        };
        if (held_.empty()) {
            const Plane gap = waves_.tip(0);
            const double area = gap.c * end.s - gap.s * end.c;
            if (!(std::abs(area) > nearlyZero * size(gap) * size(end))) {
                return false;
            }
            const double slack = nearlyZero * (1.0 + std::abs(range_.stops.right));
            by(gap, range_.stops.right - slack);
            by(-1.0 * gap, -range_.stops.right - slack);
        }
        std::int64_t m = 0;
        for (const Phase& phase : phases_) {
            const double sign = pushSign(phase.stop);
            for (const std::int64_t leave = m + phase.contact; m < leave; ++m) {
                if (!isHeld(m) && !by(sign * waves_.push(m), 0.0)) {
                    return true;
                }
            }
            Plane way;
            for (const std::int64_t back = m + phase.free - 1; m < back; ++m) {
                way = way - sign * waves_.push(m);
                if (!by(way, 0.0) || !by(-1.0 * way, -way_)) {
                    return true;
                }
            }
            ++m;
        }
        return cut.isEmpty() || (!held_.empty() && !heldAllow(cut));
    }

    /// Do signs along the line on which the first flight closes exclude each other?
    bool isRefuted()
    {
        const std::int64_t leave = phases_[0].contact;
        const std::int64_t back = leave + phases_[0].free;
        const Plane end = closure();
        const double scale = sizeOfPushes();
        if (isPermanent()) {
            return true;
        }
        if (size(end) <= nearlyZero * scale) {
            // The flight closes whatever the excitation: what is left is as with one contact.
            if (!held_.empty() && !waves_.boundsHeld()) {
                return false;
            }
            const ForcedLine line = waves_.line(true);
            return line.hasLine && line.isEmpty();
        }
        along_ = (1.0 / size(end)) * Plane{-end.s, end.c};
        zero_ = nearlyZero * scale;
        sign_ = 0.0;
        return pulls(0, leave) || pulls(back, back + phases_[1].contact) ||
               penetrates(leave, back) || penetrates(back + phases_[1].contact, steps_) ||
               staysAway();
    }

    /// \return does a value have the other sign than those before?
    bool differs(double value)
    {
        if (std::abs(value) <= zero_) {
            return false;
        }
        sign_ = sign_ == 0.0 ? std::copysign(1.0, value) : sign_;
        return sign_ * value < 0.0;
    }

    bool pulls(std::int64_t from, std::int64_t to)
    {
        for (std::int64_t m = from; m < to; ++m) {
            if (!isHeld(m) && differs(waves_.push(m).dot(along_))) {
                return true;
            }
        }
        return false;
    }

    bool penetrates(std::int64_t from, std::int64_t to)
    {
        Plane way;
        for (std::int64_t m = from; m + 1 < to; ++m) {
            way = way - waves_.push(m);
            if (differs(way.dot(along_))) {
                return true;
            }
        }
        return false;
    }

    /// u(L, 0) = g, or -h on the second stop, needs the sign that the other rows have, or, without
    /// a gap, to be 0 with them. Waves that are always in contact have to press by so much that R
    /// >= 0, which only takes the tip away from the stop: where the bar presses on it at rest, that
    /// is no obstacle.
    [[nodiscard]] bool staysAway() const
    {
        const Stop stop = phases_[0].stop;
        const double place = pushSign(stop) * placeOf(range_.stops, stop).value();
        if (sign_ == 0.0 || (place < 0.0 && !held_.empty())) {
            return false;
        }
        double reach = sign_ * waves_.tip(0).dot(along_);
        std::vector<double> lack(held_.size(), 0.0);
        for (std::int64_t m = 0; m < steps_ && !held_.empty(); ++m) {
            if (const auto j = static_cast<std::size_t>(m % waves_.classes()); held_[j]) {
                lack[j] = std::max(lack[j], -0.5 * sign_ * waves_.push(m).dot(along_));
            }
        }
        for (const double one : lack) {
            reach -= 2.0 / static_cast<double>(waves_.classes()) * one;
        }
        if (place == 0.0) {
            return reach < -zero_ || (held_.empty() && reach > zero_);
        }
        return place * reach <= zero_;
    }

    const ResponseRange& range_;
    PairQuestion question_;
    std::int64_t steps_;
    ForcedWaves waves_;
    std::array<Phase, 2> phases_ = {};
    double way_ = 0.0;        ///< sum of the pushes of a flight from stop to stop
    std::vector<bool> held_;  ///< classes whose waves nothing damps; empty: none
    Plane along_;             ///< where the first flight closes
    double zero_ = 0.0;
    double sign_ = 0.0;  ///< that rows have along it; 0: none yet
};

}  // namespace

double twoContactSchedules(std::int64_t steps, std::size_t contacts)
{
    // Those of two steps less with flights of one step or more.
    const auto n = static_cast<double>(steps - 2 * (shortestFlight - 1));
    const double half = steps % 2 == 0 ? 0.5 * n - 1.0 : 0.0;
    const double onOne = n < 4.0 ? 0.0 : 0.5 * ((n - 1.0) * (n - 2.0) * (n - 3.0) / 6.0 - half);
    const auto all = static_cast<double>(steps);
    const auto count = static_cast<double>(contacts);
    return count * onOne +
           0.5 * count * (count - 1.0) * (all - 1.0) * (all - 2.0) * (all - 3.0) / 6.0;
}

void requireFewPairs(double schedules, double most)
{
    if (schedules > most) {
        throwFault("contacts: 2, schedules", schedules,
                   fmt::format("at most {}: fewer cells, or a shorter range of frequencies", most));
    }
}

PairQuestion pairsOf(const ResponseRange& range)
{
    const auto decide = [&range](const Schedule& schedule) {
        return forcedMotions(schedule, range.damping, {range.place, range.cycles, {}}, {},
                             range.segments);
    };
    const auto isTwice = [&range](const ForcedMotion& motion) {
        const auto [seen, extremes] = verifyBar(motion.state, motion.schedule, range.segments,
                                                forcedTolerance, motion.damping, motion.excitation);
        return seen.repetitions % 2 == 0;
    };
    return {range.amplitude, range.band, range.stops, decide, isTwice};
}

void addPair(FrequencyResponse& response, const Schedule& schedule, const PairQuestion& question)
{
    const ForcedSet set = question.decide(schedule);
    if (set.status == Status::undecided) {
        addUndecided(response, set.detail);
    }
    if (set.status != Status::found) {
        return;
    }
    const double asked = question.amplitude;
    const double nearest = std::clamp(asked, set.leastAmplitude, set.mostAmplitude);
    std::vector<ForcedMotion> motions;
    if (nearest > set.leastAmplitude) {
        motions = motionsOfAmplitude(set, nearest);
        if (motions.empty()) {  // by rounding, at the end
            motions = motionsOfAmplitude(set, std::lerp(nearest, set.leastAmplitude, nearlyZero));
        }
    } else {
        motions.push_back(leastAmplitudeMotion(set));
    }
    for (ForcedMotion& motion : motions) {
        motion.schedule = schedule;
    }
    const bool canBeTwice =
        set.freeWaves == 0 && set.forcing.cycles % 2 == 0 && response.steps % 2 == 0;
    if (motions.empty() || (canBeTwice && question.isTwice(motions.front()))) {
        return;
    }
    // It is said once that a tip rests at its stop all the time.
    const bool canRest = set.freeWaves > 0 || set.mostAmplitude <= nearlyZero * asked;
    std::erase_if(motions, [canRest](const ForcedMotion& motion) {
        return canRest &&
               motion.extremes.approachSpeed <= forcedTolerance * amplitude(motion.state);
    });
    if (motions.empty()) {
        return;
    }
    response.twoContacts.push_back(
        {{schedule.phases.front(), schedule.phases.back()}, set.leastAmplitude, set.mostAmplitude});
    if (std::abs(nearest - asked) <= question.band * asked) {
        addBelievable(response, std::move(motions));
    }
}

bool addTwoContacts(FrequencyResponse& response, const ResponseRange& range, const Cancel& cancel)
{
    Sweep sweep(range, response.steps);
    for (std::int64_t contact = 1; contact < response.steps; ++contact) {
        for (std::int64_t free = 1; contact + free < response.steps; ++free) {
            if (isRequested(cancel)) {
                return false;
            }
            sweep.visit(contact, free, Stop::right, response);
            if (range.stops.left) {
                sweep.visit(contact, free, Stop::left, response);
                sweep.visitBoth(contact, free, response);
            }
        }
    }
    return true;
}

}  // namespace signorini
