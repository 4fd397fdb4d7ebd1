#include "forced_rows.hpp"

#include <numeric>
#include <utility>

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

/// N u(L, 0) = N.
EnclosedRow EnclosedWaves::gapRow() const
{
    const Interval cells(static_cast<double>(cells_));
    EnclosedRow row{true, {}, {}, cells};
    row.plane =
        cells * each([this](const Excitation& e) { return Interval(e.baseDisplacement(cells_)); });
    for (std::int64_t m = 0; m < 2 * cells_; ++m) {
        addWave(row, m, -1);
    }
    return row;
}

std::optional<std::pair<std::int64_t, std::int64_t>> EnclosedWaves::flightOf(std::int64_t m) const
{
    std::int64_t begin = 0;
    for (const Phase& phase : question_.schedule.phases) {
        begin += phase.contact;
        if (m < begin) {
            return std::nullopt;
        }
        if (m < begin + phase.free) {
            return std::pair(begin, begin + phase.free - 1);
        }
        begin += phase.free;
    }
    return std::nullopt;
}

std::optional<EnclosedRow> EnclosedWaves::row(const ForcedCondition& condition) const
{
    const std::int64_t m = condition.step;
    if (m < 0 || m >= steps_) {
        return std::nullopt;
    }
    const auto flight = flightOf(m);
    EnclosedRow row;
    switch (condition.rule) {
        case ForcedRule::gap:
            return gapRow();
        case ForcedRule::pressure:
            if (flight) {
                return std::nullopt;
            }
            addPush(row, m, 1);
            return row;
        case ForcedRule::held:
            for (std::int64_t k = m % classes(); k < steps_; k += classes()) {
                if (!isContact_[static_cast<std::size_t>(k)]) {
                    return std::nullopt;
                }
                addPush(row, k, 1);
            }
            return row;
        case ForcedRule::closure:
        case ForcedRule::penetration:
            row.isEquality = condition.rule == ForcedRule::closure;
            if (!flight || (row.isEquality && m != flight->second)) {
                return std::nullopt;
            }
            for (std::int64_t k = flight->first; k <= m; ++k) {
                addPush(row, k, -1);
            }
            return row;
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
    }
    return std::nullopt;
}

}  // namespace signorini
