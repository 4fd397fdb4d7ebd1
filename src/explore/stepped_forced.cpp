#include "stepped_forced.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "faults.hpp"
#include "forced_case.hpp"
#include "infinity.hpp"
#include "stepped_blocks.hpp"

namespace signorini {

namespace {

constexpr double leastPivot = 1e-10;  // of 1 - W; below it the waves are anyone's guess
constexpr double parallel = 1e-12;    // rows with a smaller part along the line do not cut it

Eigen::VectorXd stacked(const State& state)
{
    Eigen::VectorXd x(2 * state.cells());
    x << state.a, state.b;
    return x;
}

State stateOf(const Eigen::VectorXd& x)
{
    const Eigen::Index cells = x.size() / 2;
    return {x.head(cells), x.tail(cells)};
}

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

}  // namespace

SteppedForced::SteppedForced(const Schedule& schedule, const Scene& scene, const Damping& damping,
                             const Forcing& forcing)
    : bar_(steppedBar(scene.segments))
{
    set_.schedule = schedule;
    set_.schedule.stops = stopsOf(scene);
    set_.damping = damping;
    set_.forcing = forcing;
    signorini::validate(set_.schedule);
    signorini::validate(damping);
    requireCells(bar_, schedule.cells);
    const std::int64_t n = steps(schedule);
    Faults faults;
    const char* where = " for a bar of several segments";
    if (!(scene.bar.gap > 0.0) || scene.secondStop) {
        faults.add("scene", scene.secondStop ? "a second stop" : "gap <= 0",
                   std::string("a gap > 0 and one stop") + where);
    }
    if (!forcing.shape.empty()) {
        faults.add("shape", forcing.shape.size(), std::string("a harmonic") + where);
    }
    if (bar_.cells > maxForcedCells) {
        faults.add("cells", bar_.cells, fmt::format("at most {}{}", maxForcedCells, where));
    }
    if (n > maxSteppedSteps) {
        faults.add("steps", n, fmt::format("at most {}{}", maxSteppedSteps, where));
    } else if (forcing.cycles < 1 || forcing.cycles > (n - 1) / 2) {
        faults.add("cycles", forcing.cycles,
                   fmt::format("whole numbers 1..{}, below half of the steps", (n - 1) / 2));
    }
    faults.throwIfAny();
    shapes_ = shapesOf(forcing, bar_.cells, n);
    for (const Phase& phase : schedule.phases) {
        isContact_.insert(isContact_.end(), static_cast<std::size_t>(phase.contact), true);
        isContact_.insert(isContact_.end(), static_cast<std::size_t>(phase.free), false);
    }
    if (!solve()) {
        set_.detail = "hardly anything damps some waves: 1 - W is singular but for rounding";
        return;
    }
    cut(watch());
}

double SteppedForced::tipSpeed(double p, double force) const
{
    const double z = bar_.segments.back().impedance;
    return (2.0 * z * p + force) / (z + set_.damping.eta());
}

Ends SteppedForced::endsOf(bool isContact, const Excitation& excitation, std::int64_t m) const
{
    const double z = bar_.segments.back().impedance;
    const double eta = set_.damping.eta();
    return {.reflected = isContact ? -1.0 : (z - eta) / (z + eta),
            .pulled = isContact ? 0.0 : excitation.force(m) / (z + eta),
            .baseVelocity = excitation.baseVelocity(m)};
}

/// (1 - W) x_i = f_i. False if W leaves a wave as it is.
bool SteppedForced::solve()
{
    const auto carried = [this](const State& start, const Excitation& excitation) {
        SteppedWaves waves(bar_, start);
        for (std::size_t m = 0; m < isContact_.size(); ++m) {
            waves.step(endsOf(isContact_[m], excitation, static_cast<std::int64_t>(m)));
        }
        return stacked(waves.state());
    };
    const Eigen::Index size = 2 * bar_.cells;
    Eigen::MatrixXd change = Eigen::MatrixXd::Identity(size, size);
    for (Eigen::Index k = 0; k < size; ++k) {
        change.col(k) -= carried(stateOf(Eigen::VectorXd::Unit(size, k)), {});
    }
    const Eigen::PartialPivLU<Eigen::MatrixXd> factors(change);
    const Eigen::VectorXd pivots = factors.matrixLU().diagonal().cwiseAbs();
    if (!(pivots.minCoeff() > leastPivot) || !(factors.rcond() > leastPivot)) {
        return false;
    }
    for (const Excitation& shape : shapes_) {
        states_.push_back(
            stateOf(factors.solve(carried(stateOf(Eigen::VectorXd::Zero(size)), shape))));
    }
    return true;
}

/// Follows both states. Returns u(L, 0).
Plane SteppedForced::watch()
{
    steps_.resize(isContact_.size());
    std::array<double, 2> first{};
    for (std::size_t which = 0; which < 2; ++which) {
        double Plane::*const part = which == 0 ? &Plane::c : &Plane::s;
        const Excitation& shape = shapes_[which];
        const auto cells = static_cast<double>(bar_.cells);
        SteppedWaves waves(bar_, states_[which]);
        double tip = shape.baseDisplacement(0) + displacement(states_[which])[bar_.cells - 1];
        first[which] = tip;
        for (std::size_t m = 0; m < steps_.size(); ++m) {
            const auto at = static_cast<std::int64_t>(m);
            const double p = waves.arriving();
            steps_[m].push.*part = 2.0 * bar_.segments.back().impedance * p + shape.force(at);
            tip += isContact_[m] ? 0.0 : tipSpeed(p, shape.force(at)) / cells;
            steps_[m].tip.*part = tip;
            waves.step(endsOf(isContact_[m], shape, at));
        }
    }
    return {first[0], first[1]};
}

/// What a row leaves of the line.
void SteppedForced::bound(Plane row, double limit, bool isEquality)
{
    const Plane foot{set_.foot[0], set_.foot[1]};
    const Plane direction{set_.direction[0], set_.direction[1]};
    const double along = row.dot(direction);
    const double missing = limit - row.dot(foot);
    if (std::abs(along) <= parallel * std::hypot(row.c, row.s)) {
        if (missing > forcedTolerance) {
            set_.high = -infinity;
        }
        return;
    }
    const double t = missing / along;
    if (along > 0.0 || isEquality) {
        set_.low = std::max(set_.low, t);
    }
    if (along < 0.0 || isEquality) {
        set_.high = std::min(set_.high, t);
    }
}

void SteppedForced::cut(Plane gap)
{
    const double size = std::hypot(gap.c, gap.s);
    set_.detail =
        "no motion was found, and as rounding is not enclosed nothing proves that there "
        "is none";
    if (!(size > parallel)) {
        return;
    }
    set_.foot = {gap.c / (size * size), gap.s / (size * size)};
    set_.direction = {-gap.s / size, gap.c / size};
    set_.low = -infinity;
    set_.high = infinity;
    for (std::size_t m = 0; m < steps_.size(); ++m) {
        const bool isLast = m + 1 == steps_.size();
        if (isContact_[m]) {
            bound(steps_[m].push, 0.0, false);
        } else if (!isLast && isContact_[m + 1]) {
            bound(steps_[m].tip, 1.0, true);
        } else if (!isLast) {
            bound(-1.0 * steps_[m].tip, -1.0, false);
        }
    }
    // Closures of several flights agree but for rounding.
    if (set_.low > set_.high && set_.low - set_.high <= forcedTolerance * std::abs(set_.low)) {
        set_.low = set_.high = 0.5 * (set_.low + set_.high);
    }
    if (!(set_.low <= set_.high)) {
        return;
    }
    set_.status = Status::found;
    set_.detail.clear();
    const double foot = 1.0 / size;
    set_.leastAmplitude = std::hypot(foot, std::clamp(0.0, set_.low, set_.high));
    set_.mostAmplitude = std::hypot(foot, std::max(-set_.low, set_.high));
    set_.kind = set_.low == set_.high               ? ForcedKind::point
                : std::isfinite(set_.mostAmplitude) ? ForcedKind::segment
                                                    : ForcedKind::ray;
}

ForcedMotion SteppedForced::at(double t) const
{
    const Plane place{set_.foot[0] + t * set_.direction[0], set_.foot[1] + t * set_.direction[1]};
    ForcedMotion motion;
    motion.schedule = set_.schedule;
    motion.damping = set_.damping;
    motion.amplitude = std::hypot(place.c, place.s);
    motion.phase = std::atan2(place.s, place.c);
    motion.excitation = {shapes_.front().place, {}, static_cast<double>(bar_.cells)};
    for (std::size_t m = 0; m < shapes_.front().values.size(); ++m) {
        motion.excitation.values.push_back(place.c * shapes_.front().values[m] +
                                           place.s * shapes_.back().values[m]);
    }
    motion.state = {place.c * states_[0].a + place.s * states_[1].a,
                    place.c * states_[0].b + place.s * states_[1].b};
    walk(motion);
    motion.residual = std::max(motion.residual, changeOf(motion, bar_));
    return motion;
}

ForcedMotion SteppedForced::leastAmplitude() const
{
    return at(std::clamp(0.0, set_.low, set_.high));
}

std::vector<ForcedMotion> SteppedForced::ofAmplitude(double amplitude) const
{
    const double foot = std::hypot(set_.foot[0], set_.foot[1]);
    std::vector<ForcedMotion> motions;
    if (amplitude >= foot) {
        const double away = std::sqrt((amplitude - foot) * (amplitude + foot));
        for (const double t : {-away, away}) {
            if (t >= set_.low && t <= set_.high && (motions.empty() || away > 0.0)) {
                motions.push_back(at(t));
            }
        }
    }
    std::sort(motions.begin(), motions.end(), [](const ForcedMotion& x, const ForcedMotion& y) {
        return x.extremes.impulse < y.extremes.impulse;
    });
    return motions;
}

/// What one period of the schedule reaches, and how far it breaks what it is to keep.
void SteppedForced::walk(ForcedMotion& motion) const
{
    Extremes& seen = motion.extremes;
    const auto cells = static_cast<double>(bar_.cells);
    const double z = bar_.segments.back().impedance;
    const double size = amplitude(motion.state);
    seen.period = period(set_.schedule);
    SteppedWaves waves(bar_, motion.state);
    State now = motion.state;
    double tip = motion.excitation.baseDisplacement(0) + displacement(now)[bar_.cells - 1];
    seen.lowestTip = tip;
    double worst = std::abs(tip - 1.0);
    // In a segment a wave meets, in its cell and on its way to the next, those that come.
    const auto see = [&seen](double a, double b, double speed) {
        seen.peakCompression = std::max(seen.peakCompression, (a - b) / speed);
        seen.peakTension = std::max(seen.peakTension, (b - a) / speed);
    };
    for (std::size_t m = 0; m < isContact_.size(); ++m) {
        const auto at = static_cast<std::int64_t>(m);
        const double force = motion.excitation.force(at);
        const double p = waves.arriving();
        const double push = 2.0 * z * p + force;
        if (isContact_[m]) {
            worst = std::max(worst, -push / size);
            seen.peakForce = std::max(seen.peakForce, push);
            seen.impulse += push / cells;
            seen.contactTime += push > forcedTolerance * size ? 1.0 / cells : 0.0;
        } else {
            const double v = tipSpeed(p, force);
            tip += v / cells;
            worst = std::max(worst, tip - 1.0);
            seen.lowestTip = std::min(seen.lowestTip, tip);
            if (const bool lands = m + 1 == isContact_.size() || isContact_[m + 1]; lands) {
                worst = std::max(worst, std::abs(tip - 1.0));
                seen.approachSpeed = std::max(seen.approachSpeed, v);
            }
        }
        waves.step(endsOf(isContact_[m], motion.excitation, at));
        const State next = waves.state();
        Eigen::Index first = 0;
        for (const Segment& segment : bar_.segments) {
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

}  // namespace signorini
