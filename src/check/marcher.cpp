#include "marcher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Measures::Measures(const State& state)
    : halfCells(0.5 * static_cast<double>(state.cells())), opening(halfCells)
{
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

void ContactRuns::add(bool pressed, std::int64_t count)
{
    if (pressed) {
        if (runs_.empty() || runs_.back().free > 0) {
            runs_.push_back({});
        }
        runs_.back().contact += count;
    } else if (runs_.empty()) {
        lead_ += count;
    } else {
        runs_.back().free += count;
    }
}

std::vector<Phase> ContactRuns::phases() const
{
    std::vector<Phase> result = runs_;
    if (!result.empty()) {
        result.back().free += lead_;
        if (result.back().free == 0 && result.size() > 1) {
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
    const double room = opening_.value();
    CompensatedSum after = opening_;
    after.add(arrivals.sum(), -1.0);
    if (arrivals.high() <= 0.0 || (arrivals.low() >= 0.0 && after.value() >= 0.0)) {
        // The tip retreats, or comes nearer and does not arrive.
        opening_ = after;
        fly(arrivals.count());
    } else if (room <= atWall_ && arrivals.low() > std::max({0.0, room, 2.0 * room}) &&
               arrivals.low() > pressing_) {
        runs_.add(true, arrivals.count());
        add(true, arrivals.count());
        flight_ = 0;
    } else {
        takeEach(arrivals);
    }
    return turns_;
}

void Marcher::takeEach(const Arrivals& arrivals)
{
    for (std::int64_t k = 0; k < arrivals.count(); ++k) {
        const double p = arrivals.at(k);
        const double room = opening_.value();
        const bool wouldPass = p > 0.0 && p > room;
        // Rounding may make p exceed the room of a tip that lands just now: it is at the wall
        // before the step only if that is nearer than landing.
        if (wouldPass && room <= atWall_ && room < 0.5 * p) {
            runs_.add(p > pressing_, 1);
            add(true, 1);
            flight_ = 0;
            continue;
        }
        if (wouldPass && p - room > atWall_) {
            march_.firstFault = step_;
            march_.residual = (p - room) / measures_.halfCells;
            return;
        }
        opening_.add(-p);
        fly(1);
    }
}

void Marcher::fly(std::int64_t count)
{
    runs_.add(false, count);
    add(false, count);
    flight_ += count;
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
            runs_.add(false, skipped);
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
