#include "marcher.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "infinity.hpp"

namespace signorini {

Measures::Measures(const State& state, const Stops& stops)
    : halfCells(0.5 * static_cast<double>(state.cells())),
      opening(stops.right * halfCells),
      crossing(infinity)
{
    if (stops.left) {
        crossing = halfCells * (stops.right + static_cast<double>(stops.left->numerator) /
                                                  static_cast<double>(stops.left->denominator));
    }
    // Half the sum of a - b is half the sum of all that arrives in 2N steps.
    Echo echo(state);
    CompensatedSum sum;
    for (std::int64_t left = 2 * state.cells(); left > 0;) {
        const Arrivals next = echo.ahead(std::min(left, pieceSize));
        size = std::max({size, -next.low(), next.high()});
        sum.add(next.sum(), 1.0);
        echo.advance(next.count(), true);
        left -= next.count();
    }
    opening.add(0.5 * sum.value());
    if (!std::isfinite(sum.value())) {
        size = infinity;
    }
}

double Measures::relative(double distance) const
{
    return size > 0.0 ? distance / size : distance;
}

void ContactRuns::press(Stop stop, std::int64_t count)
{
    if (runs_.empty() || runs_.back().free > 0 || runs_.back().stop != stop) {
        runs_.push_back({0, 0, stop});
    }
    runs_.back().contact += count;
}

void ContactRuns::rest(std::int64_t count)
{
    (runs_.empty() ? lead_ : runs_.back().free) += count;
}

std::vector<Phase> ContactRuns::phases() const
{
    std::vector<Phase> result = runs_;
    if (!result.empty()) {
        result.back().free += lead_;
        if (result.back().free == 0 && result.size() > 1 &&
            result.front().stop == result.back().stop) {
            result.front().contact += result.back().contact;
            result.pop_back();
        }
    }
    return result;
}

Marcher::Marcher(const Measures& measures, double tolerance)
    : measures_(measures),
      atWall_(tolerance * measures.halfCells),
      pressing_(tolerance * measures.size),
      opening_(measures.opening)
{
}

const std::vector<Turn>& Marcher::take(const Arrivals& arrivals)
{
    turns_.clear();
    takeAll(arrivals);
    return turns_;
}

/// All at once if they do the same to the tip, else each half, and a few one by one.
void Marcher::takeAll(const Arrivals& arrivals)
{
    const double room = opening_.value();
    const double roomBehind = measures_.crossing - room;
    CompensatedSum after = opening_;
    after.add(arrivals.sum(), -1.0);
    const bool isNearing = arrivals.low() >= 0.0;
    const bool isRetreating = arrivals.high() <= 0.0;
    if ((isRetreating && after.value() <= measures_.crossing) ||
        (isNearing && after.value() >= 0.0)) {
        // The tip moves one way, and does not arrive.
        opening_ = after;
        fly(arrivals.count());
    } else if (isPressedThroughout(room, arrivals.low())) {
        hold(Stop::right, arrivals.count(), true);
    } else if (isPressedThroughout(roomBehind, -arrivals.high())) {
        hold(Stop::left, arrivals.count(), true);
    } else if (arrivals.isLong()) {
        const auto [first, last] = arrivals.halves();
        takeAll(first);
        if (!isAtFault()) {
            takeAll(last);
        }
    } else {
        takeEach(arrivals);
    }
}

/// Is the tip at a stop, and are all pushes on it stronger than what would be needed to be there?
bool Marcher::isPressedThroughout(double room, double weakest) const
{
    return room <= atWall_ && weakest > std::max({0.0, room, 2.0 * room}) && weakest > pressing_;
}

void Marcher::takeEach(const Arrivals& arrivals)
{
    std::int64_t flown = 0;
    const auto flyThem = [&] {
        if (flown > 0) {
            fly(std::exchange(flown, 0));
        }
    };
    for (std::int64_t k = 0; k < arrivals.count(); ++k) {
        const double p = arrivals.at(k);
        const Stop ahead = p > 0.0 ? Stop::right : Stop::left;
        const double push = std::abs(p);
        const double opening = opening_.value();
        const double room = ahead == Stop::right ? opening : measures_.crossing - opening;
        const bool wouldPass = push > 0.0 && push > room;
        // Rounding may make p exceed the room of a tip that lands just now: it is at the wall
        // before the step only if that is nearer than landing.
        if (wouldPass && room <= atWall_ && room < 0.5 * push) {
            flyThem();
            hold(ahead, 1, push > pressing_);
            continue;
        }
        if (wouldPass && push - room > atWall_) {
            flyThem();
            march_.firstFault = step_;
            march_.residual = (push - room) / measures_.halfCells;
            return;
        }
        opening_.add(-p);
        ++flown;
    }
    flyThem();
}

void Marcher::fly(std::int64_t count)
{
    runs_.rest(count);
    add(false, count);
    flight_ += count;
}

void Marcher::hold(Stop stop, std::int64_t count, bool pressed)
{
    if (pressed) {
        runs_.press(stop, count);
    } else {
        runs_.rest(count);
    }
    add(true, count);
    flight_ = 0;
}

void Marcher::add(bool isHeld, std::int64_t count)
{
    step_ += count;
    if (turns_.empty() || turns_.back().isHeld != isHeld) {
        turns_.push_back({isHeld, 0});
    }
    turns_.back().count += count;
}

void Marcher::run(Echo& echo, std::int64_t count)
{
    const auto repeat = static_cast<std::int64_t>(8.0 * measures_.halfCells);  // 4N
    while (count > 0 && !isAtFault()) {
        const Arrivals next = echo.ahead(std::min(count, pieceSize));
        for (const Turn& turn : take(next)) {
            echo.advance(turn.count, turn.isHeld);
            count -= turn.count;
        }
        if (flight_ >= repeat) {
            // Back in the state of 4N steps ago: whole further repeats change nothing.
            const std::int64_t skipped = count / repeat * repeat;
            runs_.rest(skipped);
            count -= skipped;
            step_ += skipped;
            flight_ = 0;
        }
    }
}

March Marcher::seen(double distance) const
{
    March result = march_;
    if (!isAtFault()) {
        result.residual = measures_.relative(distance);
        result.phases = runs_.phases();
    }
    return result;
}

}  // namespace signorini
