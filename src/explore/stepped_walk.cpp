#include "stepped_walk.hpp"

#include <algorithm>
#include <cmath>

#include "infinity.hpp"
#include "portable.hpp"
#include "stops.hpp"

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
                      {.mergeBelow = {}, .stops = motion.schedule.stops, .segments = bar.segments});
    own.advance(static_cast<double>(motion.excitation.steps()));
    const Waves after = own.waves();
    const double change =
        std::max((inCells(after.a, bar.cells).reverse() - motion.state.a).lpNorm<Eigen::Infinity>(),
                 (inCells(after.b, bar.cells) - motion.state.b).lpNorm<Eigen::Infinity>());
    return change / amplitude(motion.state);
}

/// The largest strain of both signs. In a segment a wave meets, in its cell and on its way to the
/// next, those that come.
void see(const SteppedBar& bar, const State& now, const State& next, Extremes& seen)
{
    const auto meet = [&seen](double a, double b, double speed) {
        seen.peakCompression = std::max(seen.peakCompression, (a - b) / speed);
        seen.peakTension = std::max(seen.peakTension, (b - a) / speed);
    };
    Eigen::Index first = 0;
    for (const Segment& segment : bar.segments) {
        const Eigen::Index last = first + segment.cells - 1;
        for (Eigen::Index k = first; k <= last; ++k) {
            meet(now.a[k], now.b[k], segment.speed);
            if (k < last) {
                meet(now.a[k], now.b[k + 1], segment.speed);
            }
        }
        meet(next.a[first], now.b[first], segment.speed);
        meet(now.a[last], next.b[last], segment.speed);
        first = last + 1;
    }
}

/// What one period of the schedule reaches, and how far it breaks what it is to keep.
void walkAlong(const SteppedCase& all, ForcedMotion& motion)
{
    const SteppedBar& bar = all.bar;
    const Stops& stops = all.schedule.stops;
    Extremes& seen = motion.extremes;
    const auto cells = static_cast<double>(bar.cells);
    const double z = bar.segments.back().impedance;
    const double size = amplitude(motion.state);
    const double unit = stops.right != 0 ? 1.0 : size;
    const double wall = stops.right;
    const double second = stops.left ? -stops.left->value() : -infinity;
    const double near = forcedTolerance * unit;
    seen.period = period(all.schedule);
    SteppedWaves waves(bar, motion.state);
    State now = motion.state;
    double tip = motion.excitation.baseDisplacement(0) + displacement(now)[bar.cells - 1];
    seen.lowestTip = tip;
    double worst = 0.0;
    std::int64_t m = 0;
    const auto step = [&](bool isHeld) {
        waves.step(endsOf(bar, all.damping, isHeld, motion.excitation, m++));
        const State next = waves.state();
        see(bar, now, next, seen);
        now = next;
    };
    for (const Phase& phase : all.schedule.phases) {
        worst = std::max(worst, std::abs(tip - placeOf(stops, phase.stop).value()) / unit);
        for (std::int64_t k = 0; k < phase.contact; ++k) {
            const double push =
                pushSign(phase.stop) * (2.0 * z * waves.arriving() + motion.excitation.force(m));
            worst = std::max(worst, -push / size);
            seen.peakForce = std::max(seen.peakForce, push);
            seen.impulse += push / cells;
            seen.contactTime += push > forcedTolerance * size ? 1.0 / cells : 0.0;
            step(true);
        }
        for (std::int64_t k = 0; k < phase.free; ++k) {
            const double v =
                tipSpeed(bar, all.damping, waves.arriving(), motion.excitation.force(m));
            tip += v / cells;
            worst = std::max({worst, (tip - wall) / unit, (second - tip) / unit});
            seen.lowestTip = std::min(seen.lowestTip, tip);
            if (v > 0.0 ? tip >= wall - near : tip <= second + near) {
                seen.approachSpeed = std::max(seen.approachSpeed, std::abs(v));
            }
            step(false);
        }
    }
    const double change = std::max((now.a - motion.state.a).lpNorm<Eigen::Infinity>(),
                                   (now.b - motion.state.b).lpNorm<Eigen::Infinity>());
    motion.residual = std::max(worst, change / size);
}

}  // namespace

double tipSpeed(const SteppedBar& bar, const Damping& damping, double p, double force)
{
    const double z = bar.segments.back().impedance;
    return (2.0 * z * p + force) / (z + damping.eta());
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
    if (motion.residual <= forcedTolerance) {  // else it may start where no tip can be
        motion.residual = std::max(motion.residual, changeOf(motion, all.bar));
    }
    return motion;
}

}  // namespace signorini
