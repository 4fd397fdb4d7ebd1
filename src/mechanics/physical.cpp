#include <algorithm>
#include <limits>

#include "arrivals.hpp"
#include "faults.hpp"
#include "signorini/motion.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

constexpr double nothing = 1e-9;

/// Collects what a period reaches, in units of p and of steps.
class Tally {
public:
    Tally(const State& state, const Schedule& schedule)
        : pressing_(nothing * amplitude(state)),
          halfCells_(0.5 * static_cast<double>(state.cells())),
          atWall_(nothing * halfCells_),
          crossing_(crossingSum(schedule).value_or(WaveSum{}).value()),
          hasTwo_(schedule.stops.left.has_value()),
          wall_(schedule.stops.right * halfCells_),
          deepest_(wall_)
    {
    }

    void beginContact(Stop stop, const Stops& stops)
    {
        isRight_ = stop == Stop::right;
        start_ = halfCells_ * stops.right - (isRight_ ? 0.0 : crossing_);
        deepest_ = std::min(deepest_, start_);
    }

    void contact(const Arrivals& arrivals)
    {
        see(arrivals);
        const double sign = isRight_ ? 1.0 : -1.0;
        const double weakest = isRight_ ? arrivals.low() : -arrivals.high();
        const double strongest = isRight_ ? arrivals.high() : -arrivals.low();
        push_ = std::max(push_, strongest);
        impulse_.add(arrivals.sum(), sign);
        if (weakest > pressing_) {
            pressed_ += arrivals.count();
        } else if (strongest > pressing_) {
            for (std::int64_t k = 0; k < arrivals.count(); ++k) {
                pressed_ += sign * arrivals.at(k) > pressing_ ? 1 : 0;
            }
        }
    }

    void beginFlight() { prefix_ = CompensatedSum(start_); }

    void flight(const Arrivals& arrivals)
    {
        see(arrivals);
        CompensatedSum after = prefix_;
        after.add(arrivals.sum(), 1.0);
        // A tip that only retreats, or comes nearer and does not arrive, is lowest at an end.
        const bool isAway = !reaches(after.value());
        if ((arrivals.high() <= 0.0 && (isAway || !hasTwo_)) || (arrivals.low() >= 0.0 && isAway)) {
            prefix_ = after;
            deepest_ = std::min(deepest_, prefix_.value());
            return;
        }
        if (arrivals.isLong()) {
            const auto [first, last] = arrivals.halves();
            flight(first);
            flight(last);
            return;
        }
        for (std::int64_t k = 0; k < arrivals.count(); ++k) {
            const double p = arrivals.at(k);
            prefix_.add(p);
            deepest_ = std::min(deepest_, prefix_.value());
            const double speed = p > 0.0 ? p : hasTwo_ ? -p : 0.0;
            if (speed > landing_ && meets(prefix_.value(), p > 0.0)) {
                landing_ = speed;
            }
        }
    }

    [[nodiscard]] Extremes extremes(double period, std::int64_t cells,
                                    std::int64_t repetitions) const
    {
        const double dx = 1.0 / static_cast<double>(cells);
        const auto times = static_cast<double>(repetitions);
        return {.period = period / times,
                .contactTime = static_cast<double>(pressed_) * dx / times,
                .peakForce = 2.0 * push_,
                .impulse = 2.0 * impulse_.value() * dx / times,
                .approachSpeed = 2.0 * landing_,
                .peakCompression = 2.0 * highest_,
                .peakTension = -2.0 * lowest_,
                .lowestTip = 2.0 * deepest_ * dx};
    }

private:
    void see(const Arrivals& arrivals)
    {
        highest_ = std::max(highest_, arrivals.high());
        lowest_ = std::min(lowest_, arrivals.low());
    }

    /// Is the tip at the stop on this side?
    [[nodiscard]] bool meets(double place, bool onTheRight) const
    {
        return onTheRight ? place >= wall_ - atWall_ : place <= wall_ - crossing_ + atWall_;
    }

    [[nodiscard]] bool reaches(double place) const
    {
        return meets(place, true) || (hasTwo_ && meets(place, false));
    }

    double pressing_;
    double halfCells_;
    double atWall_;
    double crossing_;  ///< from stop to stop
    bool hasTwo_;
    double wall_;          ///< N/2 u(L) there, as all places here
    bool isRight_ = true;  ///< the stop touched last
    double start_ = 0.0;   ///< its place
    double highest_ = -std::numeric_limits<double>::infinity();
    double lowest_ = std::numeric_limits<double>::infinity();
    double push_ = 0.0;
    double landing_ = 0.0;
    double deepest_;
    CompensatedSum prefix_;
    CompensatedSum impulse_;
    std::int64_t pressed_ = 0;
};

}  // namespace

Extremes extremesOf(const State& state, const Schedule& schedule, std::int64_t repetitions)
{
    Faults faults;
    faults.requireWhole("repetitions", repetitions, maxSteps);
    faults.throwIfAny();
    const Schedule walked = foldedFor(state, schedule);
    Tally tally(state, walked);
    Echo echo(state);
    for (const Phase& phase : walked.phases) {
        tally.beginContact(phase.stop, walked.stops);
        forEachPiece(echo, phase.contact, true, [&](const Arrivals& p) { tally.contact(p); });
        tally.beginFlight();
        forEachPiece(echo, phase.free, false, [&](const Arrivals& p) { tally.flight(p); });
    }
    return tally.extremes(period(schedule), schedule.cells, repetitions);
}

Physical physicalOf(const Extremes& extremes, const Bar& bar)
{
    validate(bar);
    const Scales unit = scales(bar);
    const double force = bar.axialStiffness * unit.strain;
    Physical physical{.frequency = 1.0 / (extremes.period * unit.time),
                      .contactTime = extremes.contactTime * unit.time,
                      .peakForce = extremes.peakForce * force,
                      .impulse = extremes.impulse * force * unit.time,
                      .approachSpeed = extremes.approachSpeed * unit.velocity,
                      .peakCompression = extremes.peakCompression * unit.strain,
                      .peakTension = extremes.peakTension * unit.strain,
                      .peakStress = std::nullopt,
                      .tipLowest = extremes.lowestTip * unit.displacement};
    if (bar.young) {
        physical.peakStress = *bar.young * std::max(physical.peakCompression, physical.peakTension);
    }
    return physical;
}

}  // namespace signorini
