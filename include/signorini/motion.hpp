#pragma once
/// \file
/// The motion u(x, t), v(x, t), s(x, t) of a found state over one period.
///
/// With P the running sum of the delay sequence p (propagation.hpp) the field needs no stepping:
///
///     u(x_i, t_m) = -(P(m+N+i) - P(m+N-i)) / N          [g]
///     v on cell i = p_{m+N-i} - p_{m+N+i-1}             [c g/L]
///     s on cell i = -p_{m+N-i} - p_{m+N+i-1}            [g/L]
///
/// so any sample costs O(1) after O(n + N) preparation.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "signorini/schedule.hpp"
#include "signorini/state.hpp"

namespace signorini {

/// Random access to the field of one motion.
class Motion {
public:
    /// O(n + N) time and memory, n the steps of the folded schedule (schedule.hpp): after those the
    /// motion is back at its start. \throws std::invalid_argument if the cells do not match.
    Motion(const State& state, const Schedule& schedule);

    /// N.
    [[nodiscard]] std::int64_t cells() const { return cells_; }
    /// n of the folded schedule: steps after which the motion is back at its start.
    [[nodiscard]] std::int64_t steps() const { return steps_; }

    /// u(x_i, t_m) in units of g; node i in 0..N, instant m in 0..n.
    [[nodiscard]] double displacement(std::int64_t node, std::int64_t instant) const;
    /// v on cell i in 1..N right after t_m, in units of c g/L.
    [[nodiscard]] double velocity(std::int64_t cell, std::int64_t instant) const;
    /// s on cell i in 1..N right after t_m, in units of g/L.
    [[nodiscard]] double strain(std::int64_t cell, std::int64_t instant) const;

private:
    std::int64_t cells_;
    std::int64_t steps_;
    std::vector<double> p_;    ///< p_0 .. p_{n+2N-1}
    std::vector<double> sum_;  ///< P(0) .. P(n+2N)
};

/// 0, k, 2k, ... up to `last`, which is always included, with the least stride k that gives at most
/// `most` >= 2 values: how files and figures thin out long motions.
[[nodiscard]] std::vector<std::int64_t> thinned(std::int64_t last, std::int64_t most);

}  // namespace signorini
