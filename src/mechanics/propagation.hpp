#pragma once
/// \file
/// Time stepping without error: a step of the bar is a signed shift.
///
/// Inside the bar a moves one cell right and b one cell left; at the clamp a'_1 = -b_1; at the tip
/// b'_N = -a_N in contact (DD, equation (19)) and b'_N = +a_N in free flight (DN, equation (17)).
/// So the bar is a delay line of 2N values read at the tip, and a step is the echo of one of them
/// (echo.hpp). Values are moved and negated, never added: propagation is exact in floating point.

#include <Eigen/Core>
#include <cstdint>

#include "echo.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"
#include "stops.hpp"

namespace signorini {

/// \throws std::invalid_argument if a and b differ in length or are empty.
void requireWaves(const State& state);

/// The bar as a ring of the 2N values p_m ... p_{m+2N-1}, next to arrive first.
class DelayLine {
public:
    /// O(N). \throws std::invalid_argument if a and b differ in length or are empty.
    explicit DelayLine(const State& state);

    /// p_m, the wave about to reach the tip. O(1).
    [[nodiscard]] double incoming() const { return ring_[head_]; }

    /// One contact step. O(1): the wave goes on as it is.
    static_assert(contactFactor == 1);
    void contactStep() { head_ = head_ + 1 == ring_.size() ? 0 : head_ + 1; }

    /// One free step. O(1).
    void freeStep()
    {
        ring_[head_] *= flightFactor;
        contactStep();
    }

    /// `count` >= 0 contact steps. O(1): contact only turns the ring.
    void contact(std::int64_t count);

    /// `count` >= 0 free steps. O(min(count, 2N)).
    void free(std::int64_t count);

    /// One period of a schedule on the same N cells: applies W of equation (30).
    /// O(sum of min(n_f, 2N) over phases).
    void period(const Schedule& schedule);

    /// a and b at the present instant. O(N).
    [[nodiscard]] State state() const;

    /// max |x - y| over all 2N values, x being the present state. O(N), no copy.
    /// \throws std::invalid_argument if `other` has another number of cells.
    [[nodiscard]] double distance(const State& other) const;

private:
    void echoFlight(std::int64_t count);

    /// p_{now+m}, 0 <= m < 2N.
    [[nodiscard]] double ahead(Eigen::Index m) const
    {
        const Eigen::Index tail = ring_.size() - head_;
        return ring_[m < tail ? head_ + m : m - tail];
    }

    Eigen::VectorXd ring_;
    Eigen::Index head_ = 0;
};

/// The schedule folded, for a state that fits it. \throws std::invalid_argument on an invalid
/// schedule or a state with other cells.
[[nodiscard]] Schedule foldedFor(const State& state, Schedule schedule);

/// Calls visit(p_m, sign of a push) for every step of one period: 1 at the wall, -1 at the second
/// stop, 0 in flight. O(n).
template <typename Visit>
void forEachStep(const State& state, const Schedule& schedule, Visit visit)
{
    DelayLine line(state);
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t step = 0; step < phase.contact; ++step, line.contactStep()) {
            visit(line.incoming(), pushSign(phase.stop));
        }
        for (std::int64_t step = 0; step < phase.free; ++step, line.freeStep()) {
            visit(line.incoming(), 0);
        }
    }
}

}  // namespace signorini
