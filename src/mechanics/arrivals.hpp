#pragma once
/// \file
/// The bar as the tip sees it, without a copy of its state. Inside the bar a moves one cell right
/// and b one cell left; at the clamp a'_1 = -b_1; at the tip b'_N = -a_N in contact (DD, equation
/// (19)) and b'_N = +a_N in free flight (DN, equation (17)). Values are moved and negated, never
/// added: propagation is exact in floating point.
///
/// In 2N steps every value of the state arrives at the tip once; in the next 2N it arrives again,
/// negated if its last step was free. So what arrives is the state with signs, and the signs come
/// in runs as long as the phases: those are kept, the values are read where they are.

#include <algorithm>
#include <deque>
#include <utility>

#include "compensated_sum.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// What arrives in the next steps, `count` of them, lies together in memory and has one sign.
class Arrivals {
public:
    Arrivals(const double* first, std::int64_t count, bool isReversed, bool isNegated);

    [[nodiscard]] std::int64_t count() const { return count_; }
    /// The least and the largest of them.
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    /// p of step k of them.
    [[nodiscard]] double at(std::int64_t k) const
    {
        const double value = first_[isReversed_ ? count_ - 1 - k : k];
        return isNegated_ ? -value : value;
    }
    /// All of them together.
    [[nodiscard]] const CompensatedSum& sum() const { return sum_; }
    /// Where nothing can be said of all of them: is it quicker to ask of each half than of each?
    [[nodiscard]] bool isLong() const { return count_ > 32; }
    /// The earlier half and the later one. O(count).
    [[nodiscard]] std::pair<Arrivals, Arrivals> halves() const;

private:
    const double* first_;
    std::int64_t count_;
    bool isReversed_;
    bool isNegated_;
    double low_;
    double high_;
    CompensatedSum sum_;
};

/// Where the bar is in time. The state must outlive it. Copies are cheap.
class Echo {
public:
    /// O(1). \throws std::invalid_argument if a and b differ in length or are empty.
    explicit Echo(const State& state);

    /// What arrives next, at most `most` >= 1 steps. O(their number).
    [[nodiscard]] Arrivals ahead(std::int64_t most) const;

    /// Takes steps, no more than `ahead` gave: in contact what arrived leaves as it came, in
    /// flight negated. O(1).
    void advance(std::int64_t count, bool isContact);

    /// max |x - start| over all 2N values, x the present state; or |x + start|. O(N).
    [[nodiscard]] double distance(bool toMirrored = false) const;

private:
    struct Run {
        bool isNegated;
        std::int64_t count;
    };
    /// Arrivals that begin at slot p_m of the start and do not cross the end of a wave.
    struct Slots {
        const double* first;  ///< lowest in memory
        std::int64_t count;
        bool isReversed;
        bool isNegated;
    };
    [[nodiscard]] Slots slotsAt(std::int64_t m, std::int64_t most) const;

    const State* state_;
    std::int64_t cells_;
    std::int64_t head_ = 0;
    std::deque<Run> runs_;
};

/// The schedule folded, for a state that fits it. \throws std::invalid_argument on an invalid
/// schedule or a state with other cells.
[[nodiscard]] Schedule foldedFor(const State& state, Schedule schedule);

/// Arrivals are looked at in pieces of this many: they stay in the nearest cache.
inline constexpr std::int64_t pieceSize = 1024;

/// Calls visit(arrivals) for `count` steps of one kind, a piece at a time, and takes them.
template <typename Visit>
void forEachPiece(Echo& echo, std::int64_t count, bool isContact, Visit visit)
{
    while (count > 0) {
        const Arrivals next = echo.ahead(std::min(count, pieceSize));
        visit(next);
        echo.advance(next.count(), isContact);
        count -= next.count();
    }
}

}  // namespace signorini
