#pragma once
// Stepped bars in rationals, by cells that are moved one by one, and existence by cddlib's exact
// linear programming: code that shares nothing with what it judges.

#include <cstdint>
#include <vector>

#include "rational.hpp"
#include "signorini/schedule.hpp"

namespace signorini::test {

/// A segment of exact impedance.
struct ExactSegment {
    std::int64_t cells = 1;
    std::int64_t numerator = 1;
    std::int64_t denominator = 1;
    std::int64_t dashpot = 0;  ///< over 10

    [[nodiscard]] Rational impedance() const { return {numerator, denominator}; }
};

/// As the library is given them.
[[nodiscard]] std::vector<Segment> segmentsOf(const std::vector<ExactSegment>& parts);

/// Has the schedule a motion? All 2N values of the state are unknowns.
[[nodiscard]] bool exists(const std::vector<ExactSegment>& parts, const Schedule& schedule);

/// dim ker(W - 1), exactly.
[[nodiscard]] std::int64_t kernelDimension(const std::vector<ExactSegment>& parts,
                                           const Schedule& schedule);

}  // namespace signorini::test
