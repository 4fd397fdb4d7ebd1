#include <algorithm>
#include <limits>

#include "arrivals.hpp"
#include "echo.hpp"
#include "faults.hpp"
#include "propagation.hpp"
#include "signorini/motion.hpp"

namespace signorini {

namespace {

constexpr double tolerance = 1e-9;

/// Collects what a period reaches, in units of p and of steps.
class Tally {
public:
    explicit Tally(const State& state)
        : pressing_(tolerance * amplitude(state)),
          atWall_(tolerance * 0.5 * static_cast<double>(state.cells()))
    {
    }

    void contact(const Arrivals& arrivals)
    {
        see(arrivals);
        push_ = std::max(push_, arrivals.high());
        impulse_.add(arrivals.sum(), 1.0);
        if (arrivals.low() > pressing_) {
            pressed_ += arrivals.count();
        } else if (arrivals.high() > pressing_) {
            for (std::int64_t k = 0; k < arrivals.count(); ++k) {
                pressed_ += arrivals.at(k) > pressing_ ? 1 : 0;
            }
        }
    }

    void beginFlight() { prefix_ = CompensatedSum(); }

    void flight(const Arrivals& arrivals)
    {
        see(arrivals);
        CompensatedSum after = prefix_;
        after.add(arrivals.sum(), 1.0);
        // A tip that only retreats, or comes nearer and does not arrive, is lowest at an end.
        if (arrivals.high() <= 0.0 || (arrivals.low() >= 0.0 && after.value() < -atWall_)) {
            prefix_ = after;
            deepest_ = std::min(deepest_, prefix_.value());
            return;
        }
        for (std::int64_t k = 0; k < arrivals.count(); ++k) {
            const double p = arrivals.at(k);
            prefix_.add(p);
            deepest_ = std::min(deepest_, prefix_.value());
            if (p > landing_ && prefix_.value() >= -atWall_) {
                landing_ = p;
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
                .lowestTip = gapOffset + 2.0 * deepest_ * dx};
    }

private:
    void see(const Arrivals& arrivals)
    {
        highest_ = std::max(highest_, arrivals.high());
        lowest_ = std::min(lowest_, arrivals.low());
    }

    double pressing_;
    double atWall_;
    double highest_ = -std::numeric_limits<double>::infinity();
    double lowest_ = std::numeric_limits<double>::infinity();
    double push_ = 0.0;
    double landing_ = 0.0;
    double deepest_ = 0.0;
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
    Tally tally(state);
    Echo echo(state);
    for (const Phase& phase : walked.phases) {
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
