#include "forced_rows.hpp"

#include <numeric>
#include <utility>

#include "stops.hpp"

namespace signorini {

EnclosedWaves::EnclosedWaves(const ForcedQuestion& question)
    : question_(question),
      cells_(question.schedule.cells),
      steps_(steps(question.schedule)),
      p_(static_cast<std::size_t>(steps_)),
      signs_(static_cast<std::size_t>(steps_), 0),
      classes_(static_cast<std::size_t>(std::gcd(2 * cells_, steps_)))
{
    for (const Phase& phase : question.schedule.phases) {
        isContact_.insert(isContact_.end(), static_cast<std::size_t>(phase.contact), true);
        isContact_.insert(isContact_.end(), static_cast<std::size_t>(phase.free), false);
    }
    for (std::size_t j = 0; j < classes_.size(); ++j) {
        enclose(static_cast<std::int64_t>(j));
    }
}

template <typename Value>
EnclosedPlane EnclosedWaves::each(Value value) const
{
    const auto& shapes = question_.shapes;
    return {value(shapes.front()), shapes.size() > 1 ? value(shapes.back()) : Interval()};
}

EnclosedPlane EnclosedWaves::force(std::int64_t m) const
{
    return each([m](const Excitation& e) { return Interval(e.force(m)); });
}

/// What leaves the tip in step m and comes back with the motion of the base.
EnclosedPlane EnclosedWaves::echo(std::int64_t m, const EnclosedPlane& p) const
{
    const EnclosedPlane base = each([m, this](const Excitation& e) {
        return (Interval(e.baseDisplacement(m + cells_ + 1)) -
                Interval(e.baseDisplacement(m + cells_))) *
               Interval(e.stepsPerCrossing);
    });
    if (isContact_[static_cast<std::size_t>(m)]) {
        return base + p;
    }
    const Interval rho(question_.rho);
    const Interval admittance = Interval(0.5) * (Interval(1.0) + rho);
    return base - (admittance * force(m) + rho * p);
}

/// Once around from 0 tells where the fixed point is, if there is one.
void EnclosedWaves::enclose(std::int64_t first)
{
    EnclosedPlane p;
    Interval factor(1.0);
    std::int64_t flights = 0;
    std::int64_t m = first;
    do {
        if (!isContact_[static_cast<std::size_t>(m)]) {
            factor = Interval(-question_.rho) * factor;
            ++flights;
        }
        p = echo(m, p);
        m = (m + 2 * cells_) % steps_;
    } while (m != first);
    Class& own = classes_[static_cast<std::size_t>(first)];
    own.isFree = flights == 0 || (question_.rho == 1.0 && flights % 2 == 0);
    if (own.isFree) {
        own.work = std::exchange(p, {});
    } else {
        const Interval grip = Interval(1.0) - factor;
        p = {p.c / grip, p.s / grip};
    }
    int sign = own.isFree ? 1 : 0;
    do {
        p_[static_cast<std::size_t>(m)] = p;
        signs_[static_cast<std::size_t>(m)] = sign;
        p = echo(m, p);
        sign = isContact_[static_cast<std::size_t>(m)] ? sign : -sign;
        m = (m + 2 * cells_) % steps_;
    } while (m != first);
}

void EnclosedWaves::addWave(EnclosedRow& row, std::int64_t m, std::int64_t factor) const
{
    const auto at = static_cast<std::size_t>(m % steps_);
    row.plane = row.plane + Interval(static_cast<double>(factor)) * p_[at];
    if (signs_[at] != 0) {
        row.free[m % classes()] += factor * signs_[at];
    }
}

/// F + 2p.
void EnclosedWaves::addPush(EnclosedRow& row, std::int64_t m, std::int64_t factor) const
{
    row.plane = row.plane + Interval(static_cast<double>(factor)) * force(m);
    addWave(row, m, 2 * factor);
}

/// N u(L, 0) = N times the place of the stop.
EnclosedRow EnclosedWaves::gapRow() const
{
    const Interval cells(static_cast<double>(cells_));
    const Fraction place =
        placeOf(question_.schedule.stops, question_.schedule.phases.front().stop);
    EnclosedRow row{true, {}, {}, {}};
    if (place.numerator != 0) {  // 0 is exact
        row.limit = cells * Interval(static_cast<double>(place.numerator)) /
                    Interval(static_cast<double>(place.denominator));
    }
    row.plane =
        cells * each([this](const Excitation& e) { return Interval(e.baseDisplacement(cells_)); });
    for (std::int64_t m = 0; m < 2 * cells_; ++m) {
        addWave(row, m, -1);
    }
    return row;
}

/// One phase, and where its flight is.
struct EnclosedWaves::Part {
    Stop from = Stop::right;  ///< the stop of its contact
    Stop to = Stop::right;    ///< and the next one
    std::int64_t takeOff = 0;
    std::int64_t last = 0;  ///< of the flight
};

EnclosedWaves::Part EnclosedWaves::partOf(std::int64_t m) const
{
    const auto& phases = question_.schedule.phases;
    std::size_t k = 0;
    std::int64_t begin = 0;
    while (m >= begin + phases[k].contact + phases[k].free) {
        begin += phases[k].contact + phases[k].free;
        ++k;
    }
    const std::int64_t takeOff = begin + phases[k].contact;
    return {phases[k].stop, phases[(k + 1) % phases.size()].stop, takeOff,
            takeOff + phases[k].free - 1};
}

/// Of sums of -push from the start of a flight, or of push.
std::optional<EnclosedRow> EnclosedWaves::flightRow(const ForcedCondition& condition) const
{
    const std::int64_t m = condition.step;
    const Part part = partOf(m);
    const auto& stops = question_.schedule.stops;
    const bool isSecond = condition.rule == ForcedRule::secondStop;
    const bool isEnd = condition.rule == ForcedRule::closure;
    if (m < part.takeOff || (isEnd && m != part.last) || (isSecond && !stops.left)) {
        return std::nullopt;
    }
    // From stop to stop: in a step the tip moves by (F + 2p)(1 + rho)/2 of a cell.
    Interval way;
    if (stops.left) {
        const Interval below(static_cast<double>(stops.left->denominator));
        const Interval above =
            Interval(stops.right) * below + Interval(static_cast<double>(stops.left->numerator));
        way = Interval(static_cast<double>(2 * cells_)) * above /
              (below * (Interval(1.0) + Interval(question_.rho)));
    }
    EnclosedRow row;
    row.isEquality = isEnd;
    for (std::int64_t k = part.takeOff; k <= m; ++k) {
        addPush(row, k, isSecond ? 1 : -1);
    }
    const bool isFromWall = part.from == Stop::right;
    if (isEnd && part.from != part.to) {
        row.limit = isFromWall ? way : Interval(0.0) - way;
    } else if (!isEnd && isSecond == isFromWall) {
        row.limit = Interval(0.0) - way;
    }
    return row;
}

std::optional<EnclosedRow> EnclosedWaves::row(const ForcedCondition& condition) const
{
    const std::int64_t m = condition.step;
    if (m < 0 || m >= steps_) {
        return std::nullopt;
    }
    EnclosedRow row;
    switch (condition.rule) {
        case ForcedRule::gap:
            return gapRow();
        case ForcedRule::pressure:
            if (const Part part = partOf(m); m < part.takeOff) {
                addPush(row, m, pushSign(part.from));
                return row;
            }
            return std::nullopt;
        case ForcedRule::held:
            for (std::int64_t k = m % classes(); k < steps_; k += classes()) {
                const Part part = partOf(k);
                if (k >= part.takeOff || part.from != partOf(m).from) {
                    return std::nullopt;
                }
                addPush(row, k, pushSign(part.from));
            }
            return row;
        case ForcedRule::closure:
        case ForcedRule::secondStop:
        case ForcedRule::penetration:
            return flightRow(condition);
        case ForcedRule::work:
            if (!classOf(m).isFree) {
                return std::nullopt;
            }
            row.isEquality = true;
            row.plane = classOf(m).work;
            return row;
        case ForcedRule::strain:
            if (!std::isfinite(question_.waveLimit)) {
                return std::nullopt;
            }
            addWave(row, m, -1);
            row.limit = Interval(-question_.waveLimit);
            return row;
        case ForcedRule::rest:
            return std::nullopt;  // it is no row
    }
    return std::nullopt;
}

}  // namespace signorini
