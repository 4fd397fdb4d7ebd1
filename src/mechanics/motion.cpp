#include "signorini/motion.hpp"

#include <algorithm>
#include <cmath>

#include "arrivals.hpp"
#include "compensated_sum.hpp"
#include "contact_spans.hpp"
#include "echo.hpp"
#include "faults.hpp"
#include "signorini/simulation.hpp"
#include "stepped_bar.hpp"

namespace signorini {

namespace {

/// The whole number that is meant, or the value itself.
double snapped(double value)
{
    constexpr double near = 1e-9;
    const double whole = std::round(value);
    return std::abs(value - whole) <= near ? whole : value;
}

/// The instant of the first period, [0, steps).
double inPeriod(double t, double steps)
{
    if (!std::isfinite(t)) {
        throwFault("t", t, "finite numbers [steps]");
    }
    const double rest = snapped(t - std::floor(t / steps) * steps);
    return rest >= steps ? 0.0 : std::max(rest, 0.0);
}

}  // namespace

Motion::Motion(const State& state, const Schedule& schedule)
    : cells_(state.cells()), least_(2e-9 * amplitude(state))
{
    const Schedule walked = foldedFor(state, schedule);
    steps_ = signorini::steps(walked);
    const auto count = static_cast<std::size_t>(steps_ + 2 * cells_);
    p_.reserve(count);
    const Eigen::VectorXd window = windowOf(state);
    p_.assign(window.begin(), window.end());
    auto echo = [this, m = std::size_t{0}](std::int64_t times, int factor) mutable {
        for (; times > 0; --times) {
            p_.push_back(factor * p_[m++]);
        }
    };
    for (const Phase& phase : walked.phases) {
        echo(phase.contact, contactFactor);
        echo(phase.free, flightFactor);
    }
    sum_.reserve(count + 1);
    CompensatedSum total;
    sum_.push_back(0.0);
    for (const double p : p_) {
        total.add(p);
        sum_.push_back(total.value());
    }
}

Motion::Motion(const State& state, const Schedule& schedule, std::span<const Segment> segments)
    : Motion(state, schedule, segments, Damping{}, Excitation{})
{
}

Motion::Motion(const State& state, const Schedule& schedule, std::span<const Segment> segments,
               const Damping& damping, const Excitation& excitation)
    : cells_(state.cells()), steps_(signorini::steps(schedule)), least_(2e-9 * amplitude(state))
{
    validate(schedule);
    const SteppedBar bar = steppedBar(segments);
    requireCells(bar, schedule.cells);
    if (steps_ >= maxKeptValues / cells_) {
        throwFault("steps times cells", fmt::format("{} x {}", steps_, cells_),
                   fmt::format("less than {} to be kept", maxKeptValues));
    }
    for (const Segment& segment : bar.segments) {
        speed_.insert(speed_.end(), static_cast<std::size_t>(segment.cells), segment.speed);
    }
    const Network network = networkOf(Stops{}, bar.segments, cells_, damping);
    NetworkWaves<double> waves(network, wavesOf(network, state));
    const NetworkLaw<double> held(network, 1);
    const NetworkLaw<double> open(network, 0);
    auto keep = [&, m = std::int64_t{0}]() mutable {
        const State now = stateOf(network, waves.waves());
        a_.insert(a_.end(), now.a.begin(), now.a.end());
        b_.insert(b_.end(), now.b.begin(), now.b.end());
        double place = excitation.baseDisplacement(m++);
        u_.push_back(place);
        for (Eigen::Index k = 0; k < now.a.size(); ++k) {
            place += (now.b[k] - now.a[k]) / static_cast<double>(cells_);
            u_.push_back(place);
        }
    };
    keep();
    std::int64_t m = 0;
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t step = 0; step < phase.contact + phase.free; ++step, ++m) {
            const bool isHeld = step < phase.contact;
            const double force = excitation.force(m);
            force_.push_back(isHeld ? held.push(0).at(waves.arriving(), force, 0.0) : 0.0);
            waves.step(isHeld ? held : open, force, excitation.baseVelocity(m));
            keep();
        }
    }
}

double Motion::displacement(std::int64_t node, std::int64_t instant) const
{
    if (!u_.empty()) {
        return u_[static_cast<std::size_t>(instant * (cells_ + 1) + node)];
    }
    const auto right = static_cast<std::size_t>(instant + cells_ + node);
    const auto left = static_cast<std::size_t>(instant + cells_ - node);
    return (sum_[left] - sum_[right]) / static_cast<double>(cells_);
}

double Motion::rightGoing(std::int64_t cell, std::int64_t instant) const
{
    return a_.empty() ? p_[static_cast<std::size_t>(instant + cells_ - cell)]
                      : a_[static_cast<std::size_t>(instant * cells_ + cell - 1)];
}

double Motion::leftGoing(std::int64_t cell, std::int64_t instant) const
{
    return b_.empty() ? -p_[static_cast<std::size_t>(instant + cells_ + cell - 1)]
                      : b_[static_cast<std::size_t>(instant * cells_ + cell - 1)];
}

double Motion::strainOf(std::int64_t cell, double right, double left) const
{
    const double strain = left - right;
    return speed_.empty() ? strain : strain / speed_[static_cast<std::size_t>(cell - 1)];
}

double Motion::velocity(std::int64_t cell, std::int64_t instant) const
{
    return rightGoing(cell, instant) + leftGoing(cell, instant);
}

double Motion::strain(std::int64_t cell, std::int64_t instant) const
{
    return strainOf(cell, rightGoing(cell, instant), leftGoing(cell, instant));
}

State Motion::stateAt(std::int64_t instant) const
{
    if (instant < 0 || instant > steps_) {
        throwFault("step", instant, fmt::format("whole numbers 0..{}", steps_));
    }
    State state{Eigen::VectorXd(cells_), Eigen::VectorXd(cells_)};
    for (std::int64_t cell = 1; cell <= cells_; ++cell) {
        state.a[cell - 1] = rightGoing(cell, instant);
        state.b[cell - 1] = leftGoing(cell, instant);
    }
    return state;
}

double Motion::wallForce(std::int64_t step) const
{
    const auto m = static_cast<std::size_t>(step);
    // What came back is +p_m in contact, -p_m in flight.
    const double force =
        force_.empty() ? p_[m] + p_[m + 2 * static_cast<std::size_t>(cells_)] : force_[m];
    return std::abs(force) > least_ ? force : 0.0;
}

Motion::Place Motion::placeOf(double x, double t) const
{
    const double place = snapped(x);
    if (!(place >= 0.0 && place <= static_cast<double>(cells_))) {
        throwFault("x", x, fmt::format("numbers 0..{} [cells]", cells_));
    }
    const double now = inPeriod(t, static_cast<double>(steps_));
    Place at;
    // The clamp is the beginning of cell 1, every other node the end of the cell before it.
    at.cell = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(place)));
    at.offset = place - static_cast<double>(at.cell - 1);
    at.instant = static_cast<std::int64_t>(now);
    at.since = now - static_cast<double>(at.instant);
    return at;
}

// What is to be on a cell after the step has come in from its sides by then.

double Motion::rightGoing(const Place& at) const
{
    return rightGoing(at.cell, at.instant + (at.since >= at.offset ? 1 : 0));
}

double Motion::leftGoing(const Place& at) const
{
    return leftGoing(at.cell, at.instant + (at.since >= 1.0 - at.offset ? 1 : 0));
}

double Motion::displacementAt(double x, double t) const
{
    const Place at = placeOf(x, t);
    const double end = displacement(at.cell, at.instant);
    if (at.since == 0.0 && at.offset == 1.0) {
        return end;
    }
    // Straight along the cell, then what both waves moved since, before and after they jumped.
    const double start = displacement(at.cell - 1, at.instant);
    const auto moved = [&](double before, double after, double until) {
        return before * std::min(at.since, until) + after * std::max(at.since - until, 0.0);
    };
    const double right =
        moved(rightGoing(at.cell, at.instant), rightGoing(at.cell, at.instant + 1), at.offset);
    const double left =
        moved(leftGoing(at.cell, at.instant), leftGoing(at.cell, at.instant + 1), 1.0 - at.offset);
    return start + at.offset * (end - start) + (right + left) / static_cast<double>(cells_);
}

double Motion::velocityAt(double x, double t) const
{
    const Place at = placeOf(x, t);
    return rightGoing(at) + leftGoing(at);
}

double Motion::strainAt(double x, double t) const
{
    const Place at = placeOf(x, t);
    return strainOf(at.cell, rightGoing(at), leftGoing(at));
}

double Motion::wallForceAt(double t) const
{
    return wallForce(static_cast<std::int64_t>(inPeriod(t, static_cast<double>(steps_))));
}

std::vector<std::int64_t> thinned(std::int64_t last, std::int64_t most)
{
    const std::int64_t intervals = most - 1;
    const std::int64_t stride = last <= intervals ? 1 : (last + intervals - 1) / intervals;
    std::vector<std::int64_t> values;
    for (std::int64_t value = 0; value < last; value += stride) {
        values.push_back(value);
    }
    values.push_back(last);
    return values;
}

}  // namespace signorini
