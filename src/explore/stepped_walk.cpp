#include "stepped_walk.hpp"

#include <algorithm>
#include <cmath>

#include "portable.hpp"

namespace signorini {

namespace {

/// The value of a wave in the middle of each cell, in the order of its pieces.
Eigen::VectorXd inCells(const std::vector<Piece>& pieces, std::int64_t cells)
{
    Eigen::VectorXd values(cells);
    std::size_t piece = 0;
    double end = pieces.front().duration;
    for (std::int64_t k = 0; k < cells; ++k) {
        while (end < static_cast<double>(k) + 0.5 && piece + 1 < pieces.size()) {
            end += pieces[++piece].duration;
        }
        values[k] = pieces[piece].value;
    }
    return values;
}

/// Where the bar is after a period that decides contact by itself, relative to where it was.
double changeOf(const ForcedMotion& motion, const SteppedBar& bar)
{
    BarSimulation own(wavesOf(motion.state), motion.damping, motion.excitation,
                      {.mergeBelow = {}, .segments = bar.segments});
    own.advance(static_cast<double>(motion.excitation.steps()));
    const Waves after = own.waves();
    const double change =
        std::max((inCells(after.a, bar.cells).reverse() - motion.state.a).lpNorm<Eigen::Infinity>(),
                 (inCells(after.b, bar.cells) - motion.state.b).lpNorm<Eigen::Infinity>());
    return change / amplitude(motion.state);
}

/// What one period of the schedule reaches, and how far it breaks what it is to keep.
void walkAlong(const SteppedCase& all, ForcedMotion& motion)
{
    const SteppedBar& bar = all.bar;
    const std::vector<bool> isContact = contactsOf(all.schedule);
    Extremes& seen = motion.extremes;
    const auto cells = static_cast<double>(bar.cells);
    const double z = bar.segments.back().impedance;
    const double size = amplitude(motion.state);
    seen.period = period(all.schedule);
    SteppedWaves waves(bar, motion.state);
    State now = motion.state;
    double tip = motion.excitation.baseDisplacement(0) + displacement(now)[bar.cells - 1];
    seen.lowestTip = tip;
    double worst = std::abs(tip - 1.0);
    // In a segment a wave meets, in its cell and on its way to the next, those that come.
    const auto see = [&seen](double a, double b, double speed) {
        seen.peakCompression = std::max(seen.peakCompression, (a - b) / speed);
        seen.peakTension = std::max(seen.peakTension, (b - a) / speed);
    };
    for (std::size_t m = 0; m < isContact.size(); ++m) {
        const auto at = static_cast<std::int64_t>(m);
        const double force = motion.excitation.force(at);
        const double p = waves.arriving();
        const double push = 2.0 * z * p + force;
        if (isContact[m]) {
            worst = std::max(worst, -push / size);
            seen.peakForce = std::max(seen.peakForce, push);
            seen.impulse += push / cells;
            seen.contactTime += push > forcedTolerance * size ? 1.0 / cells : 0.0;
        } else {
            const double v = tipSpeed(bar, all.damping, p, force);
            tip += v / cells;
            worst = std::max(worst, tip - 1.0);
            seen.lowestTip = std::min(seen.lowestTip, tip);
            if (const bool lands = m + 1 == isContact.size() || isContact[m + 1]; lands) {
                worst = std::max(worst, std::abs(tip - 1.0));
                seen.approachSpeed = std::max(seen.approachSpeed, v);
            }
        }
        waves.step(endsOf(bar, all.damping, isContact[m], motion.excitation, at));
        const State next = waves.state();
        Eigen::Index first = 0;
        for (const Segment& segment : bar.segments) {
            const Eigen::Index last = first + segment.cells - 1;
            for (Eigen::Index k = first; k <= last; ++k) {
                see(now.a[k], now.b[k], segment.speed);
                if (k < last) {
                    see(now.a[k], now.b[k + 1], segment.speed);
                }
            }
            see(next.a[first], now.b[first], segment.speed);
            see(now.a[last], next.b[last], segment.speed);
            first = last + 1;
        }
        now = next;
    }
    const double change = std::max((now.a - motion.state.a).lpNorm<Eigen::Infinity>(),
                                   (now.b - motion.state.b).lpNorm<Eigen::Infinity>());
    motion.residual = std::max(worst, change / size);
}

}  // namespace

std::vector<bool> contactsOf(const Schedule& schedule)
{
    std::vector<bool> contacts;
    for (const Phase& phase : schedule.phases) {
        contacts.insert(contacts.end(), static_cast<std::size_t>(phase.contact), true);
        contacts.insert(contacts.end(), static_cast<std::size_t>(phase.free), false);
    }
    return contacts;
}

double tipSpeed(const SteppedBar& bar, const Damping& damping, double p, double force)
{
    const double z = bar.segments.back().impedance;
    return (2.0 * z * p + force) / (z + damping.eta());
}

Ends endsOf(const SteppedBar& bar, const Damping& damping, bool isContact,
            const Excitation& excitation, std::int64_t m)
{
    const double z = bar.segments.back().impedance;
    const double eta = damping.eta();
    return {.reflected = isContact ? -1.0 : (z - eta) / (z + eta),
            .pulled = isContact ? 0.0 : excitation.force(m) / (z + eta),
            .baseVelocity = excitation.baseVelocity(m)};
}

Excitation combined(std::span<const Excitation> shapes, Plane place)
{
    Excitation sum = shapes.front();
    for (std::size_t m = 0; m < sum.values.size(); ++m) {
        sum.values[m] = place.dot({shapes.front().values[m], shapes.back().values[m]});
    }
    return sum;
}

ForcedMotion steppedMotion(const SteppedCase& all, Plane place, State state)
{
    ForcedMotion motion;
    motion.schedule = all.schedule;
    motion.damping = all.damping;
    motion.amplitude = portable::hypot(place.c, place.s);
    motion.phase = portable::atan2(place.s, place.c);
    motion.excitation = combined(all.shapes, place);
    motion.state = std::move(state);
    walkAlong(all, motion);
    motion.residual = std::max(motion.residual, changeOf(motion, all.bar));
    return motion;
}

}  // namespace signorini
