#include "bar_check.hpp"

#include <algorithm>
#include <cmath>

#include "compensated_sum.hpp"
#include "contact_spans.hpp"
#include "echo.hpp"
#include "infinity.hpp"
#include "marcher.hpp"

namespace signorini {

namespace {

/// The phases in which a stop is pressed, from the start of one.
std::vector<Phase> phasesOf(const std::vector<ContactSpan>& pressed)
{
    ContactRuns runs;
    for (const ContactSpan& part : pressed) {
        part.closed == 0
            ? runs.rest(part.steps)
            : runs.press(contains(part.closed, 0) ? Stop::right : Stop::left, part.steps);
    }
    return runs.phases();
}

Extremes extremesOf(const NetworkExtremes& seen, const Schedule& schedule, double times)
{
    const auto cells = static_cast<double>(schedule.cells);
    Extremes all;
    all.period = period(schedule) / times;
    for (const ContactExtremes& contact : seen.contacts) {
        all.contactTime += static_cast<double>(contact.pressed) / cells / times;
        all.impulse += contact.impulse / cells / times;
        all.peakForce = std::max(all.peakForce, contact.peakForce);
        all.approachSpeed = std::max(all.approachSpeed, contact.approach);
    }
    all.peakCompression = -seen.leastStrain;
    all.peakTension = seen.mostStrain;
    all.lowestTip = seen.leastDisplacements.back() / cells;
    return all;
}

}  // namespace

NetworkClaim claimOf(const Network& network, const State& state, const Schedule& schedule,
                     const Excitation& excitation)
{
    NetworkClaim claim{.waves = wavesOf(network, state), .displacements = {0.0}};
    if (!excitation.values.empty()) {
        claim.displacements.front() = excitation.baseDisplacement(0) * excitation.stepsPerCrossing;
        const bool isForce = excitation.place == Excited::tip;
        std::vector<double>& drive = isForce ? claim.forces : claim.velocities;
        drive.reserve(excitation.values.size());
        for (std::int64_t m = 0; m < excitation.steps(); ++m) {
            drive.push_back(isForce ? excitation.force(m) : excitation.baseVelocity(m));
        }
    }
    Eigen::Index next = 0;
    for (const CellRow& row : network.rows) {
        CompensatedSum place(claim.displacements.back());
        for (const Eigen::Index end = next + row.cells; next < end; ++next) {
            place.add(state.b[next] - state.a[next]);
        }
        claim.displacements.push_back(place.value());
    }
    for (const ContactSpan& span : spansOf(schedule)) {
        if (span.steps > 0) {  // contact without end has no flight
            claim.schedule.push_back(span);
        }
    }
    return claim;
}

BarVerification verifyBar(const State& state, const Schedule& schedule,
                          std::span<const Segment> segments, double tolerance,
                          const Damping& damping, const Excitation& excitation)
{
    const bool opens = schedule.phases.size() != 1 || schedule.phases.front().free != 0;
    if (opens) {
        validate(schedule);
    }
    requireCells(state, schedule.cells);
    const Network network =
        networkOf(schedule.stops, {segments.begin(), segments.end()}, schedule.cells, damping);
    const auto cells = static_cast<double>(schedule.cells);
    const bool isDriven = !excitation.values.empty();
    NetworkClaim claim = claimOf(network, state, schedule, excitation);
    const auto compareWith = [&](double wave) {
        claim.wave = wave;
        claim.length = cells * (isDriven && schedule.stops.right == 0 ? wave : 1.0);
    };
    compareWith(amplitude(state));

    NetworkResiduals walked = walk(network, claim, tolerance);
    // A driven motion may pass through a state without waves.
    if (const double wave = 0.5 * walked.extremes.largestStrain();
        isDriven && wave > 10.0 * claim.wave) {
        compareWith(wave);
        walked = walk(network, claim, tolerance);
    }
    const NetworkMarch own = march(network, claim, tolerance);
    const std::int64_t count = steps(schedule);
    BarVerification result;
    Verification& seen = result.seen;
    seen.residuals = {walked.periodicity, walked.gap,   walked.pressure,
                      walked.penetration, own.residual, 0.0};
    if (isDriven && claim.wave > 0.0) {
        seen.residuals.periodicity = std::max(walked.periodicity, walked.balance);
    } else if (isDriven) {  // no wave at all
        seen.residuals.periodicity = infinity;
    }
    if (std::isinf(seen.residuals.periodicity)) {
        seen.residuals.demands = infinity;
        return result;
    }
    for (std::size_t k = 0; k < walked.pressed.size(); k += 2) {
        seen.pressing.push_back(walked.pressed[k] != 0);
    }
    seen.repetitions = own.repeats > 0 ? count / own.repeats : 1;
    seen.canonical = phasesOf(own.pressed);
    seen.canonical.resize(seen.canonical.size() / static_cast<std::size_t>(seen.repetitions));
    result.extremes =
        extremesOf(own.extremes, schedule, isDriven ? 1.0 : static_cast<double>(seen.repetitions));
    seen.peakStrain = result.extremes.peakCompression;
    return result;
}

}  // namespace signorini
