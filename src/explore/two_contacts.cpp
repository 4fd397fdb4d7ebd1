#include "two_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "forced_case.hpp"
#include "forced_cut.hpp"

namespace signorini {

namespace {

/// Numbers below this part of the others count as 0: such schedules are not refuted here.
constexpr double nearlyZero = 1e-9;
/// [steps]; a flight of one step closes if the tip rests in it: that is a contact.
constexpr std::int64_t shortestFlight = 2;

/// The schedules of one n, one after the other.
class Sweep {
public:
    Sweep(const ResponseRange& range, std::int64_t steps)
        : forcing_{range.place, range.cycles, {}},
          range_(range),
          steps_(steps),
          waves_(range.cells, range.damping.rho(), shapesOf(forcing_, range.cells, steps))
    {
    }

    /// Every schedule with these first two parts whose second contact is not longer than the first
    /// one; of equal contacts the first flight is the longer one.
    void visit(std::int64_t contact, std::int64_t free, FrequencyResponse& response)
    {
        const std::int64_t left = steps_ - contact - free;
        for (std::int64_t second = 1; second <= std::min(contact, left - shortestFlight);
             ++second) {
            phases_ = {{{contact, free}, {second, left - second}}};
            if (second < contact || free > left - second) {
                waves_.setPhases(phases_);
                if (!isRefuted()) {
                    decide(response);
                }
            }
        }
    }

private:
    /// Do signs along the line on which the first flight closes exclude each other?
    bool isRefuted()
    {
        const std::int64_t leave = phases_[0].contact;
        const std::int64_t back = leave + phases_[0].free;
        Plane closure;
        for (std::int64_t m = leave; m < back; ++m) {
            closure = closure + waves_.push(m);
        }
        double scale = 0.0;
        for (std::int64_t m = 0; m < steps_; m += 1 + steps_ / 16) {
            scale = std::max(scale, size(waves_.push(m)));
        }
        if (size(closure) <= nearlyZero * scale) {
            // The flight closes whatever the excitation: what is left is as with one contact.
            const ForcedLine line = waves_.line(true);
            return line.hasLine && line.isEmpty();
        }
        along_ = (1.0 / size(closure)) * Plane{-closure.s, closure.c};
        zero_ = nearlyZero * scale;
        sign_ = 0.0;
        held_.clear();
        if (waves_.heldClasses() > 0) {
            held_.resize(static_cast<std::size_t>(waves_.classes()), false);
            for (const std::int64_t j : waves_.freeClasses()) {
                held_[static_cast<std::size_t>(j)] = true;
            }
        }
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
            const bool isHeld =
                !held_.empty() && held_[static_cast<std::size_t>(m % waves_.classes())];
            if (!isHeld && differs(waves_.push(m).dot(along_))) {
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

    /// u(L, 0) = g needs the sign that the other rows have. Waves that are always in contact have
    /// to press by so much that R >= 0, which only lowers u(L, 0).
    [[nodiscard]] bool staysAway() const
    {
        if (sign_ == 0.0) {
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
        return reach <= zero_;
    }

    /// Is it a motion of n/2 steps, gone through twice?
    [[nodiscard]] bool isTwice(const ForcedMotion& motion) const
    {
        if (forcing_.cycles % 2 != 0 || steps_ % 2 != 0) {
            return false;
        }
        const Plane place{motion.amplitude * std::cos(motion.phase),
                          motion.amplitude * std::sin(motion.phase)};
        double most = 0.0;
        double change = 0.0;
        for (std::int64_t m = 0; m < steps_ / 2; ++m) {
            const double here = waves_.wave(m).dot(place);
            const double there = waves_.wave(m + steps_ / 2).dot(place);
            most = std::max({most, std::abs(here), std::abs(there)});
            change = std::max(change, std::abs(here - there));
        }
        return change <= forcedTolerance * most;
    }

    void decide(FrequencyResponse& response) const
    {
        const Schedule schedule{range_.cells, {phases_.begin(), phases_.end()}};
        const ForcedSet set = forcedMotions(schedule, range_.damping, forcing_);
        response.undecided += set.status == Status::undecided ? 1 : 0;
        if (set.status != Status::found) {
            return;
        }
        std::vector<ForcedMotion> motions{leastAmplitudeMotion(set)};
        if (set.freeWaves == 0 && isTwice(motions.front())) {
            return;
        }
        response.twoContacts.push_back({phases_, set.leastAmplitude, set.mostAmplitude});
        const double nearest = std::clamp(range_.amplitude, set.leastAmplitude, set.mostAmplitude);
        if (std::abs(nearest - range_.amplitude) > range_.band * range_.amplitude) {
            return;
        }
        if (nearest > set.leastAmplitude) {
            motions = motionsOfAmplitude(set, nearest);
        }
        for (ForcedMotion& motion : motions) {
            if (motion.residual <= forcedTolerance) {
                response.motions.push_back(std::move(motion));
            } else {
                ++response.undecided;
            }
        }
    }

    Forcing forcing_;
    const ResponseRange& range_;
    std::int64_t steps_;
    ForcedWaves waves_;
    std::array<Phase, 2> phases_ = {};
    std::vector<bool> held_;  ///< classes whose waves nothing damps; empty: none
    Plane along_;             ///< where the first flight closes
    double zero_ = 0.0;
    double sign_ = 0.0;  ///< that rows have along it; 0: none yet
};

}  // namespace

double twoContactSchedules(std::int64_t steps)
{
    // Those of two steps less with flights of one step or more.
    const auto n = static_cast<double>(steps - 2 * (shortestFlight - 1));
    const double half = steps % 2 == 0 ? 0.5 * n - 1.0 : 0.0;
    return n < 4.0 ? 0.0 : 0.5 * ((n - 1.0) * (n - 2.0) * (n - 3.0) / 6.0 - half);
}

bool addTwoContacts(FrequencyResponse& response, const ResponseRange& range, const Cancel& cancel)
{
    Sweep sweep(range, response.steps);
    for (std::int64_t contact = 1; contact < response.steps; ++contact) {
        for (std::int64_t free = shortestFlight; contact + free < response.steps; ++free) {
            if (isRequested(cancel)) {
                return false;
            }
            sweep.visit(contact, free, response);
        }
    }
    return true;
}

}  // namespace signorini
