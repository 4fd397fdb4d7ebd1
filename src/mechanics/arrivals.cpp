#include "arrivals.hpp"

#include <algorithm>

#include "echo.hpp"
#include "faults.hpp"

namespace signorini {

namespace {

using Values = Eigen::Map<const Eigen::ArrayXd>;

}  // namespace

Arrivals::Arrivals(const double* first, std::int64_t count, bool isReversed, bool isNegated)
    : first_(first), count_(count), isReversed_(isReversed), isNegated_(isNegated)
{
    // Eight at a time, as pairs: a tree of sums, and two running sums with what their roundings
    // lost (Knuth's two-sum).
    using Two = Eigen::Array2d;
    Two lows = Two::Constant(*first);
    Two highs = lows;
    Two total = Two::Zero();
    Two lost = Two::Zero();
    std::int64_t k = 0;
    for (; k + 8 <= count; k += 8) {
        const Two p = Eigen::Map<const Two>(first + k);
        const Two q = Eigen::Map<const Two>(first + k + 2);
        const Two r = Eigen::Map<const Two>(first + k + 4);
        const Two s = Eigen::Map<const Two>(first + k + 6);
        lows = lows.min(p.min(q).min(r.min(s)));
        highs = highs.max(p.max(q).max(r.max(s)));
        const Two term = (p + q) + (r + s);
        const Two next = total + term;
        const Two taken = next - total;
        lost += (total - (next - taken)) + (term - taken);
        total = next;
    }
    double least = lows.minCoeff();
    double most = highs.maxCoeff();
    CompensatedSum sum(total[0]);
    for (const double part : {total[1], lost[0], lost[1]}) {
        sum.add(part);
    }
    for (; k < count; ++k) {
        least = std::min(least, first[k]);
        most = std::max(most, first[k]);
        sum.add(first[k]);
    }
    low_ = isNegated ? -most : least;
    high_ = isNegated ? -least : most;
    sum_.add(sum, isNegated ? -1.0 : 1.0);
}

std::pair<Arrivals, Arrivals> Arrivals::halves() const
{
    const std::int64_t earlier = count_ / 2;
    const std::int64_t later = count_ - earlier;
    return {{first_ + (isReversed_ ? later : 0), earlier, isReversed_, isNegated_},
            {first_ + (isReversed_ ? 0 : earlier), later, isReversed_, isNegated_}};
}

Echo::Echo(const State& state) : state_(&state), cells_(state.cells()), runs_{{false, 2 * cells_}}
{
    if (state.a.size() != state.b.size() || state.a.size() == 0) {
        throw std::invalid_argument(
            fmt::format("state: a has {} cells and b {}: allowed two arrays of equal length >= 1",
                        state.a.size(), state.b.size()));
    }
}

Echo::Slots Echo::slotsAt(std::int64_t m, std::int64_t most) const
{
    // p_m is a_{N-m} and then -b_{m-N+1}.
    const bool isRight = m < cells_;
    const std::int64_t count = std::min(most, (isRight ? cells_ : 2 * cells_) - m);
    return isRight ? Slots{state_->a.data() + (cells_ - m - count), count, true, false}
                   : Slots{state_->b.data() + (m - cells_), count, false, true};
}

Arrivals Echo::ahead(std::int64_t most) const
{
    const Run& run = runs_.front();
    const Slots slots = slotsAt(head_, std::min(most, run.count));
    return {slots.first, slots.count, slots.isReversed, slots.isNegated != run.isNegated};
}

void Echo::advance(std::int64_t count, bool isContact)
{
    const bool isNegated = runs_.front().isNegated == isContact;
    runs_.front().count -= count;
    if (runs_.front().count == 0) {
        runs_.pop_front();
    }
    if (!runs_.empty() && runs_.back().isNegated == isNegated) {
        runs_.back().count += count;
    } else {
        runs_.push_back({isNegated, count});
    }
    head_ = (head_ + count) % (2 * cells_);
}

double Echo::distance(bool toMirrored) const
{
    double largest = 0.0;
    std::int64_t at = head_;
    std::int64_t m = 0;
    for (const Run& run : runs_) {
        for (std::int64_t left = run.count; left > 0;) {
            Slots was = slotsAt(m, left);
            const Slots is = slotsAt(at, was.count);
            was = slotsAt(m, is.count);
            const Values before(was.first, was.count);
            const Values now(is.first, is.count);
            const bool isSame = ((is.isNegated != run.isNegated) == was.isNegated) != toMirrored;
            const double sign = isSame ? 1.0 : -1.0;
            const double apart = is.isReversed == was.isReversed
                                     ? (before - sign * now).abs().maxCoeff()
                                     : (before - sign * now.reverse()).abs().maxCoeff();
            largest = std::max(largest, apart);
            m += is.count;
            at = (at + is.count) % (2 * cells_);
            left -= is.count;
        }
    }
    return largest;
}

Schedule foldedFor(const State& state, Schedule schedule)
{
    validate(schedule);
    requireCells(state, schedule.cells);
    fold(schedule);
    return schedule;
}

}  // namespace signorini
