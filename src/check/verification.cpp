#include "signorini/verification.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "faults.hpp"
#include "infinity.hpp"
#include "marcher.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// (10)-(12) and (31) along a schedule.
class Rows {
public:
    Rows(const Measures& measures, double tolerance)
        : measures_(measures), pressing_(tolerance * measures.size), opening_(measures.opening)
    {
    }

    void beginPhase(Stop stop)
    {
        const bool isRight = stop == Stop::right;
        misplaced_ =
            std::max(misplaced_, std::abs(opening_.value() - (isRight ? 0.0 : measures_.crossing)));
        push_ = 0.0;
        prefix_ = CompensatedSum();
        isRight_ = isRight;
        most_ = isRight ? 0.0 : measures_.crossing;
        least_ = isRight ? -measures_.crossing : 0.0;
    }

    void contact(const Arrivals& arrivals)
    {
        highest_ = std::max(highest_, arrivals.high());
        const double weakest = isRight_ ? arrivals.low() : -arrivals.high();
        const double strongest = isRight_ ? arrivals.high() : -arrivals.low();
        tension_ = std::max(tension_, -weakest);
        push_ = std::max(push_, strongest);
    }

    void flight(const Arrivals& arrivals)
    {
        highest_ = std::max(highest_, arrivals.high());
        if (arrivals.low() >= 0.0 || arrivals.high() <= 0.0) {
            prefix_.add(arrivals.sum(), 1.0);  // the deepest point is at an end
            see(prefix_.value());
            return;
        }
        if (arrivals.isLong()) {
            const auto [first, last] = arrivals.halves();
            flight(first);
            flight(last);
            return;
        }
        for (std::int64_t k = 0; k < arrivals.count(); ++k) {
            prefix_.add(arrivals.at(k));
            see(prefix_.value());
        }
    }

    void endPhase(std::vector<bool>& pressing)
    {
        pressing.push_back(push_ > pressing_);
        opening_.add(-prefix_.value());
    }

    [[nodiscard]] double peakStrain() const { return 2.0 * highest_; }

    [[nodiscard]] Residuals residuals(double distance) const
    {
        return {.periodicity = measures_.relative(distance),
                .gap = misplaced_ / measures_.halfCells,
                .pressure = measures_.relative(tension_),
                .penetration = deepest_ / measures_.halfCells};
    }

private:
    void see(double prefix) { deepest_ = std::max({deepest_, prefix - most_, least_ - prefix}); }

    const Measures& measures_;
    double pressing_;
    CompensatedSum opening_;
    CompensatedSum prefix_;
    bool isRight_ = true;  ///< the stop where the flight starts
    double most_ = 0.0;    ///< limits of prefix sums
    double least_ = 0.0;
    double misplaced_ = 0.0;
    double push_ = 0.0;
    double tension_ = 0.0;
    double deepest_ = 0.0;
    double highest_ = -infinity;
};

/// The march over a period beside the walk along the schedule. As long as it decides by itself to
/// do what the schedule says, both are one walk; from where they part it goes its own way.
class Companion {
public:
    Companion(const Measures& measures, double tolerance, std::int64_t steps)
        : marcher_(measures, tolerance), left_(steps)
    {
    }

    /// `echo` is about to take the arrivals, all of them held or all in flight.
    void see(const Arrivals& arrivals, bool isHeld, const Echo& echo)
    {
        if (own_) {
            return;
        }
        const std::vector<Turn>& turns = marcher_.take(arrivals);
        const bool isZero = arrivals.low() == 0.0 && arrivals.high() == 0.0;
        if (!marcher_.isAtFault() &&
            (isZero || (turns.size() == 1 && turns.front().isHeld == isHeld))) {
            left_ -= arrivals.count();
            return;
        }
        own_ = echo;
        for (const Turn& turn : turns) {
            own_->advance(turn.count, turn.isHeld);
            left_ -= turn.count;
        }
    }

    /// Goes alone what is left of the period, all of it if it has seen nothing; `distance` is that
    /// of the walk from the start.
    [[nodiscard]] March finish(const State& state, double distance)
    {
        if (!own_ && left_ == 0) {
            return marcher_.seen(distance);
        }
        Echo mine = own_ ? *own_ : Echo(state);
        marcher_.run(mine, left_);
        return marcher_.seen(mine.distance());
    }

private:
    Marcher marcher_;
    std::int64_t left_;
    std::optional<Echo> own_;
};

/// Takes `count` steps of one kind, with the march beside it if there is one.
void walk(Echo& echo, std::int64_t count, bool isContact, Rows& rows, Companion* companion)
{
    forEachPiece(echo, count, isContact, [&](const Arrivals& next) {
        isContact ? rows.contact(next) : rows.flight(next);
        if (companion != nullptr) {
            companion->see(next, isContact, echo);
        }
    });
}

/// Is the list one shorter list, `times` over?
bool repeats(const std::vector<Phase>& phases, std::size_t times)
{
    const std::size_t length = phases.size() / times;
    return phases.size() % times == 0 &&
           std::equal(phases.begin() + static_cast<std::ptrdiff_t>(length), phases.end(),
                      phases.begin());
}

/// The shortest period of a motion that repeats after `count` steps and has these pressed phases:
/// it is tried in a march. `count` where nothing shorter is confirmed. Pressed phases have to
/// repeat as the motion does; a motion without any obeys p_{m+2N} = -p_m, so 4N steps bring it
/// back.
class ShortestPeriod {
public:
    ShortestPeriod(const State& state, std::int64_t count, double tolerance, const Stops& stops)
        : state_(state), count_(count), tolerance_(tolerance), stops_(stops)
    {
    }

    [[nodiscard]] std::int64_t pressing(const std::vector<Phase>& phases) const
    {
        for (std::size_t times = phases.size(); times > 1; --times) {
            const auto divisor = static_cast<std::int64_t>(times);
            if (count_ % divisor == 0 && repeats(phases, times) && isPeriod(count_ / divisor)) {
                return count_ / divisor;
            }
        }
        return count_;
    }

    [[nodiscard]] std::int64_t grazing() const
    {
        std::int64_t shortest = std::gcd(4 * state_.cells(), count_);
        if (!isPeriod(shortest)) {
            return count_;
        }
        std::int64_t rest = shortest;
        for (std::int64_t prime = 2; rest > 1; ++prime) {
            prime = prime * prime > rest ? rest : prime;
            while (rest % prime == 0) {
                rest /= prime;
            }
            while (shortest % prime == 0 && isPeriod(shortest / prime)) {
                shortest /= prime;
            }
        }
        return shortest;
    }

private:
    [[nodiscard]] bool isPeriod(std::int64_t steps) const
    {
        return march(state_, steps, tolerance_, stops_).residual <= tolerance_;
    }

    const State& state_;
    std::int64_t count_;
    double tolerance_;
    const Stops& stops_;
};

}  // namespace

March march(const State& state, std::int64_t count, double tolerance, const Stops& stops)
{
    if (count < 0) {
        throwFault("count", count, ">= 0");
    }
    Echo echo(state);
    const Measures measures(state, stops);
    if (std::isinf(measures.size)) {
        return {infinity, -1, {}};
    }
    Marcher marcher(measures, tolerance);
    marcher.run(echo, count);
    return marcher.seen(echo.distance());
}

double Residuals::worst() const
{
    return std::max({periodicity, gap, pressure, penetration, march, demands});
}

Verification verify(const State& state, const Schedule& schedule, double tolerance)
{
    validate(schedule);
    if (state.cells() != schedule.cells) {
        throw std::invalid_argument(fmt::format("state: {} cells: allowed {}, as in the schedule",
                                                state.cells(), schedule.cells));
    }
    Echo echo(state);
    const Measures measures(state, schedule.stops);
    if (std::isinf(measures.size)) {
        return {{infinity, infinity, infinity, infinity, infinity, infinity},
                infinity,
                {},
                1,
                {},
                false};
    }
    Schedule folded = schedule;
    fold(folded);
    Verification result;
    Rows rows(measures, tolerance);
    Companion companion(measures, tolerance, steps(schedule));
    Companion* const beside = folded == schedule ? &companion : nullptr;
    const std::size_t half = isMirrored(folded.phases, folded.stops) ? folded.phases.size() / 2 : 0;
    std::size_t walked = 0;
    for (const Phase& phase : folded.phases) {
        rows.beginPhase(phase.stop);
        walk(echo, phase.contact, true, rows, beside);
        walk(echo, phase.free, false, rows, beside);
        rows.endPhase(result.pressing);
        if (++walked == half) {
            result.isSymmetric = measures.relative(echo.distance(true)) <= tolerance;
        }
    }
    const double distance = echo.distance();
    result.residuals = rows.residuals(distance);
    result.peakStrain = rows.peakStrain();
    March seen = companion.finish(state, distance);
    result.residuals.march = seen.residual;
    result.canonical = std::move(seen.phases);
    const std::int64_t count = steps(schedule);
    const ShortestPeriod shortest(state, count, tolerance, schedule.stops);
    const std::size_t pressed = result.canonical.size();
    result.repetitions =
        count / (pressed > 0 ? shortest.pressing(result.canonical) : shortest.grazing());
    result.canonical.resize(pressed /
                            static_cast<std::size_t>(pressed > 0 ? result.repetitions : 1));
    return result;
}

}  // namespace signorini
