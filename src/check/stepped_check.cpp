#include "stepped_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "faults.hpp"
#include "infinity.hpp"
#include "marcher.hpp"
#include "stepped_cells.hpp"

namespace signorini {

namespace {

/// Where the tip is stopped [g].
struct TipPlaces {
    double right;
    std::optional<double> left;

    explicit TipPlaces(const Stops& stops) : right(stops.right)
    {
        if (stops.left) {
            left = -stops.left->value();
        }
    }
};

/// Signorini's rule at one stop. Distances in steps of a wave: a free step moves the tip by p.
class StopRule {
public:
    StopRule(double atStop) : atStop_(atStop) {}

    enum class Outcome { free, held, fault };

    /// `room` to the stop, and a wave that comes towards it if positive.
    [[nodiscard]] Outcome of(double room, double p) const
    {
        if (!(p > 0.0 && p > room)) {
            return Outcome::free;
        }
        // Rounding may make p exceed the room of a tip that lands just now.
        if (room <= atStop_ && room < 0.5 * p) {
            return Outcome::held;
        }
        return p - room > atStop_ ? Outcome::fault : Outcome::free;
    }

private:
    double atStop_;
};

/// One period, decided step by step.
class OwnMarch {
public:
    OwnMarch(const SteppedCells& start, const State& state, const TipPlaces& stops,
             double tolerance)
        : cells_(start),
          start_(state),
          stops_(stops),
          half_(0.5 * static_cast<double>(state.cells())),
          size_(start.size()),
          tolerance_(tolerance),
          tip_(start.tip()),
          lowest_(tip_)
    {
    }

    void run(std::int64_t count)
    {
        const StopRule rule(tolerance_ * half_);
        for (std::int64_t m = 0; m < count; ++m) {
            const double p = cells_.arriving();
            const double room = half_ * (stops_.right - tip_);
            const double roomBehind = stops_.left ? half_ * (tip_ - *stops_.left) : infinity;
            const auto right = rule.of(room, p);
            const auto left = rule.of(roomBehind, -p);
            if (right == StopRule::Outcome::fault || left == StopRule::Outcome::fault) {
                march_.firstFault = m;
                march_.residual = (std::abs(p) - (p > 0.0 ? room : roomBehind)) / half_;
                return;
            }
            const bool isHeld = right == StopRule::Outcome::held || left == StopRule::Outcome::held;
            const bool isPressed = isHeld && std::abs(p) > tolerance_ * size_;
            if (isPressed) {
                runs_.press(right == StopRule::Outcome::held ? Stop::right : Stop::left, 1);
            } else {
                runs_.rest(1);
            }
            see(p, isHeld, isPressed);
            cells_.step(isHeld);
            if (count % (m + 1) == 0 && shortest_ == 0 &&
                cells_.distance(start_) <= tolerance_ * size_) {
                shortest_ = m + 1;
            }
        }
        march_.residual = cells_.distance(start_) / (size_ > 0.0 ? size_ : 1.0);
        march_.phases = runs_.phases();
    }

    [[nodiscard]] const March& march() const { return march_; }
    /// Steps after which the motion repeats; 0 if it does not.
    [[nodiscard]] std::int64_t shortest() const { return shortest_; }

    /// Over `repetitions` of the motion in the period.
    [[nodiscard]] Extremes extremes(double period, std::int64_t repetitions) const
    {
        const double dt = 0.5 / half_;
        const auto times = static_cast<double>(repetitions);
        const double z = cells_.tipImpedance();
        return {.period = period / times,
                .contactTime = static_cast<double>(pressed_) * dt / times,
                .peakForce = 2.0 * z * push_,
                .impulse = 2.0 * z * impulse_ * dt / times,
                .approachSpeed = 2.0 * landing_,
                .peakCompression = -cells_.lowestStrain(),
                .peakTension = cells_.highestStrain(),
                .lowestTip = lowest_};
    }

private:
    void see(double p, bool isHeld, bool isPressed)
    {
        if (isPressed) {
            ++pressed_;
            push_ = std::max(push_, std::abs(p));
        }
        if (isHeld) {
            impulse_ += std::abs(p);
            return;
        }
        tip_ += p / half_;
        lowest_ = std::min(lowest_, tip_);
        const bool lands = (p > 0.0 && stops_.right - tip_ <= tolerance_) ||
                           (p < 0.0 && stops_.left && tip_ - *stops_.left <= tolerance_);
        landing_ = lands ? std::max(landing_, std::abs(p)) : landing_;
    }

    SteppedCells cells_;
    const State& start_;
    TipPlaces stops_;
    double half_;
    double size_;
    double tolerance_;
    double tip_;
    double lowest_;  ///< a tip that is held all the time is lowest where it starts
    ContactRuns runs_;
    March march_;
    std::int64_t shortest_ = 0;
    std::int64_t pressed_ = 0;
    double push_ = 0.0;
    double impulse_ = 0.0;
    double landing_ = 0.0;
};

/// (30)-(32) along the schedule.
Residuals walk(SteppedCells cells, const State& state, const Schedule& schedule,
               const TipPlaces& stops, std::vector<bool>& pressing, double tolerance)
{
    Residuals worst;
    const double size = cells.size();
    const auto relative = [size](double distance) {
        return size > 0.0 ? distance / size : distance;
    };
    double tip = cells.tip();
    const double perStep = 2.0 / static_cast<double>(state.cells());
    for (const Phase& phase : schedule.phases) {
        const bool isRight = phase.stop == Stop::right;
        worst.gap = std::max(worst.gap, std::abs(tip - (isRight ? stops.right : *stops.left)));
        double push = 0.0;
        for (std::int64_t step = 0; step < phase.contact; ++step) {
            const double p = isRight ? cells.arriving() : -cells.arriving();
            worst.pressure = std::max(worst.pressure, relative(-p));
            push = std::max(push, p);
            cells.step(true);
        }
        pressing.push_back(push > tolerance * size);
        for (std::int64_t step = 0; step < phase.free; ++step) {
            tip += perStep * cells.arriving();
            worst.penetration = std::max(worst.penetration, tip - stops.right);
            if (stops.left) {
                worst.penetration = std::max(worst.penetration, *stops.left - tip);
            }
            cells.step(false);
        }
    }
    worst.periodicity = relative(cells.distance(state));
    return worst;
}

void requireCells(const State& state, const Schedule& schedule, std::span<const Segment> segments)
{
    std::int64_t cells = 0;
    for (const Segment& segment : segments) {
        cells += segment.cells;
    }
    Faults faults;
    if (cells != schedule.cells) {
        faults.add("cells of all segments", cells, fmt::format("{}, N", schedule.cells));
    }
    if (state.a.size() != schedule.cells || state.b.size() != schedule.cells) {
        faults.add("cells of the state", state.a.size(), fmt::format("{}, N", schedule.cells));
    }
    faults.throwIfAny();
}

}  // namespace

SteppedVerification verifyStepped(const State& state, const Schedule& schedule,
                                  std::span<const Segment> segments, double tolerance)
{
    validate(schedule);
    const TipPlaces stops(schedule.stops);
    requireCells(state, schedule, segments);
    const SteppedCells cells(segments, state);
    SteppedVerification result;
    Verification& seen = result.seen;
    if (std::isinf(cells.size())) {
        seen.residuals = {infinity, infinity, infinity, infinity, infinity, infinity};
        return result;
    }
    seen.residuals = walk(cells, state, schedule, stops, seen.pressing, tolerance);
    OwnMarch own(cells, state, stops, tolerance);
    const std::int64_t count = steps(schedule);
    own.run(count);
    seen.residuals.march = own.march().residual;
    seen.repetitions = own.shortest() > 0 ? count / own.shortest() : 1;
    seen.canonical = own.march().phases;
    seen.canonical.resize(seen.canonical.size() / static_cast<std::size_t>(seen.repetitions));
    result.extremes = own.extremes(period(schedule), seen.repetitions);
    seen.peakStrain = result.extremes.peakCompression;
    return result;
}

}  // namespace signorini
