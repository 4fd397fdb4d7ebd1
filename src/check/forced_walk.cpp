#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "compensated_sum.hpp"
#include "forced_check.hpp"
#include "infinity.hpp"

namespace signorini {

namespace {

/// The bar cell by cell: a moves right, b left, one cell a step.
class Cells {
public:
    Cells(const State& state, const Damping& damping, const Excitation& excitation)
        : count_(state.cells()),
          a_(state.a.begin(), state.a.end()),
          b_(state.b.begin(), state.b.end()),
          eta_(damping.eta()),
          excitation_(excitation)
    {
        CompensatedSum sum;
        for (std::int64_t i = 0; i < count_; ++i) {
            sum.add(state.b[i] - state.a[i]);
        }
        tip_ = CompensatedSum(excitation.baseDisplacement(0));
        tip_.add(sum.value() * cell());
    }

    [[nodiscard]] double cell() const { return 1.0 / static_cast<double>(count_); }
    [[nodiscard]] double tip() const { return tip_.value(); }
    void putTipAt(double place) { tip_ = CompensatedSum(place); }
    /// F + 2p of the next step, what would press on a wall.
    [[nodiscard]] double push() const { return excitation_.force(step_) + 2.0 * arriving(); }
    [[nodiscard]] double gained() const { return gained_.value(); }
    [[nodiscard]] double spent() const { return spent_.value(); }
    /// The wave that arrives in the next step.
    [[nodiscard]] double arriving() const { return a_[tipSlot()]; }

    void take(bool isHeld)
    {
        const double p = arriving();
        const double force = excitation_.force(step_);
        const double v = isHeld ? 0.0 : push() / (1.0 + eta_);
        const double base = excitation_.baseVelocity(step_);
        double& left = b_[static_cast<std::size_t>(step_ % count_)];
        a_[tipSlot()] = base - left;
        gained_.add((base * (base - 2.0 * left) + force * v) * cell());
        spent_.add(eta_ * v * v * cell());
        left = v - p;
        tip_.add(v * cell());
        ++step_;
    }

    /// max |x - start| over both waves.
    [[nodiscard]] double distance(const State& start) const
    {
        double largest = 0.0;
        for (std::int64_t i = 0; i < count_; ++i) {
            largest = std::max({largest, std::abs(a_[slot(i - step_)] - start.a[i]),
                                std::abs(b_[slot(i + step_)] - start.b[i])});
        }
        return largest;
    }

private:
    [[nodiscard]] std::size_t slot(std::int64_t i) const
    {
        return static_cast<std::size_t>((i % count_ + count_) % count_);
    }
    [[nodiscard]] std::size_t tipSlot() const { return slot(count_ - 1 - step_); }

    std::int64_t count_;
    std::vector<double> a_;
    std::vector<double> b_;
    double eta_;
    const Excitation& excitation_;
    CompensatedSum tip_;
    CompensatedSum gained_;
    CompensatedSum spent_;
    std::int64_t step_ = 0;
};

/// Where the tip is stopped, and how near counts as there.
struct Places {
    double wall;
    double second;  ///< -infinity: none
    double near;

    Places(const Stops& stops, double tolerance)
        : wall(stops.right),
          second(stops.left ? -stops.left->value() : -std::numeric_limits<double>::infinity()),
          near(tolerance)
    {
    }

    [[nodiscard]] double of(Stop stop) const { return stop == Stop::right ? wall : second; }
    [[nodiscard]] double depth(double tip) const { return std::max(tip - wall, second - tip); }
};

/// A tip at a stop that is pushed is held, any other is free.
double marchForced(Cells bar, std::int64_t steps, const State& start, double size,
                   const Places& places)
{
    for (std::int64_t m = 0; m < steps; ++m) {
        const double push = bar.push();
        const double place = places.of(push > 0.0 ? Stop::right : Stop::left);
        const bool isHeld = push != 0.0 && (push > 0.0 ? bar.tip() >= place - places.near
                                                       : bar.tip() <= place + places.near);
        if (isHeld) {
            bar.putTipAt(place);
        }
        bar.take(isHeld);
        if (const double depth = places.depth(bar.tip()); depth > places.near) {
            return depth;
        }
    }
    return bar.distance(start) / size;
}

/// The largest strain of both signs: with p_i what arrives at the tip in step i, and V one crossing
/// before, s = V - p_i - p_j wherever 0 <= i - j <= 2N.
void measureStrain(const std::vector<double>& p, const Excitation& excitation, std::int64_t cells,
                   Extremes& extremes)
{
    const auto n = static_cast<std::int64_t>(p.size());
    const auto at = [&](std::int64_t m) { return p[static_cast<std::size_t>((m % n + n) % n)]; };
    // The places of the largest and the least p_j of the last 2N + 1, each before smaller ones.
    std::deque<std::int64_t> high;
    std::deque<std::int64_t> low;
    extremes.peakCompression = -std::numeric_limits<double>::infinity();
    extremes.peakTension = -std::numeric_limits<double>::infinity();
    for (std::int64_t i = -std::min(n, 2 * cells); i < n; ++i) {
        const auto keep = [&](std::deque<std::int64_t>& places, double sign) {
            while (!places.empty() && sign * at(places.back()) <= sign * at(i)) {
                places.pop_back();
            }
            places.push_back(i);
            while (places.front() < i - 2 * cells) {
                places.pop_front();
            }
        };
        keep(high, 1.0);
        keep(low, -1.0);
        const double base = excitation.baseVelocity(((i - cells) % n + n) % n);
        extremes.peakCompression =
            std::max(extremes.peakCompression, at(i) + at(high.front()) - base);
        extremes.peakTension = std::max(extremes.peakTension, base - at(i) - at(low.front()));
    }
}

/// Of one period: a motion may pass through a state without waves.
double largestWave(const State& state, const Schedule& schedule, const Damping& damping,
                   const Excitation& excitation)
{
    Cells bar(state, damping, excitation);
    double largest = amplitude(state);
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t m = 0; m < phase.contact + phase.free; ++m) {
            largest = std::max(largest, std::abs(bar.arriving()));
            bar.take(m < phase.contact);
        }
    }
    return largest;
}

}  // namespace

double ForcedWalk::worst() const
{
    return std::max({periodicity, gap, pressure, penetration, balance, march});
}

ForcedWalk walkForced(const State& state, const Schedule& schedule, const Damping& damping,
                      const Excitation& excitation, double tolerance)
{
    ForcedWalk seen;
    const double size = largestWave(state, schedule, damping, excitation);
    if (!(size > 0.0) || !state.a.allFinite() || !state.b.allFinite()) {
        seen.periodicity = infinity;
        return seen;
    }
    Cells bar(state, damping, excitation);
    Extremes& reached = seen.extremes;
    reached.lowestTip = bar.tip();
    const double pressing = tolerance * size;
    const double unit = schedule.stops.right != 0 ? 1.0 : size;
    const Places places(schedule.stops, tolerance * unit);
    std::vector<double> arrived;
    arrived.reserve(static_cast<std::size_t>(excitation.steps()));
    CompensatedSum impulse;
    for (const Phase& phase : schedule.phases) {
        const double sign = phase.stop == Stop::right ? 1.0 : -1.0;
        seen.gap = std::max(seen.gap, std::abs(bar.tip() - places.of(phase.stop)) / unit);
        for (std::int64_t m = 0; m < phase.contact; ++m) {
            const double push = sign * bar.push();
            seen.pressure = std::max(seen.pressure, -push / size);
            reached.peakForce = std::max(reached.peakForce, push);
            reached.contactTime += push > pressing ? bar.cell() : 0.0;
            impulse.add(push * bar.cell());
            arrived.push_back(bar.arriving());
            bar.take(true);
        }
        for (std::int64_t m = 0; m < phase.free; ++m) {
            const double before = bar.tip();
            arrived.push_back(bar.arriving());
            bar.take(false);
            const double speed = (bar.tip() - before) / bar.cell();
            const bool isThere = speed > 0.0 ? bar.tip() >= places.wall - places.near
                                             : bar.tip() <= places.second + places.near;
            if (isThere && std::abs(speed) > pressing) {
                reached.approachSpeed = std::max(reached.approachSpeed, std::abs(speed));
            }
            seen.penetration = std::max(seen.penetration, places.depth(bar.tip()) / unit);
            reached.lowestTip = std::min(reached.lowestTip, bar.tip());
        }
    }
    reached.period = period(schedule);
    reached.impulse = impulse.value();
    measureStrain(arrived, excitation, schedule.cells, reached);
    seen.periodicity = bar.distance(state) / size;
    const double largest = std::max(std::abs(bar.gained()), bar.spent());
    // Energies of the order of the squares of the waves are exchanged within a period.
    seen.balance = std::abs(bar.gained() - bar.spent()) / std::max(largest, size * size);
    seen.march =
        marchForced(Cells(state, damping, excitation), excitation.steps(), state, size, places);
    return seen;
}

}  // namespace signorini
