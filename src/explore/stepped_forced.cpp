#include "stepped_forced.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "faults.hpp"
#include "forced_case.hpp"
#include "infinity.hpp"
#include "stepped_blocks.hpp"
#include "stepped_walk.hpp"

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
    isContact_ = contactsOf(schedule);
    if (!solve()) {
        set_.detail = "hardly anything damps some waves: 1 - W is singular but for rounding";
        return;
    }
    cut(watch());
}

/// (1 - W) x_i = f_i. False if W leaves a wave as it is.
bool SteppedForced::solve()
{
    const auto carried = [this](const State& start, const Excitation& excitation) {
        SteppedWaves waves(bar_, start);
        for (std::size_t m = 0; m < isContact_.size(); ++m) {
            waves.step(endsOf(bar_, set_.damping, isContact_[m], excitation,
                              static_cast<std::int64_t>(m)));
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
            tip += isContact_[m] ? 0.0 : tipSpeed(bar_, set_.damping, p, shape.force(at)) / cells;
            steps_[m].tip.*part = tip;
            waves.step(endsOf(bar_, set_.damping, isContact_[m], shape, at));
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
    return steppedMotion({bar_, set_.schedule, set_.damping, shapes_}, place,
                         {place.c * states_[0].a + place.s * states_[1].a,
                          place.c * states_[0].b + place.s * states_[1].b});
}

ForcedMotion SteppedForced::leastAmplitude() const
{
    return at(std::clamp(0.0, set_.low, set_.high));
}

std::vector<ForcedMotion> SteppedForced::ofAmplitude(double amplitude) const
{
    ForcedLine line;
    line.foot = {set_.foot[0], set_.foot[1]};
    line.low = set_.low;
    line.high = set_.high;
    return motionsOnLine(line, amplitude, [this](double t) { return at(t); });
}

}  // namespace signorini
