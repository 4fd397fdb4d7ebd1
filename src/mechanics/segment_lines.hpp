#pragma once
/// \file
/// The waves of a bar of several segments off any grid: two queues of pieces for each segment.

#include <span>
#include <vector>

#include "signorini/simulation.hpp"
#include "stepped_bar.hpp"

namespace signorini {

/// Of the waves of a bar those in each of its segments. O(pieces).
[[nodiscard]] std::vector<Waves> partsOf(const Waves& waves, std::span<const Segment> segments);

/// The waves under way. Unit of time: the step in which a wave crosses a cell.
class SegmentLines {
public:
    /// \throws std::invalid_argument unless the crossing of the waves is the number of cells.
    SegmentLines(const SteppedBar& bar, const Waves& start, double mergeBelow);

    /// p, the wave that arrives at the tip.
    [[nodiscard]] double atTip() const { return lines_.back().a.front().value; }
    /// The wave that arrives at the base.
    [[nodiscard]] double atBase() const { return lines_.front().b.front().value; }
    /// How long all waves that arrive anywhere stay the same.
    [[nodiscard]] double lasts() const;
    /// Goes on for no longer than that, but for `same`: the tip sends q, the base moves with V.
    /// Returns what the dashpots of the joints took, the integral of d v^2. O(segments).
    double pass(double duration, double q, double baseVelocity, double same);

    /// The state.
    [[nodiscard]] Waves waves() const;
    /// sum of Z times duration times value^2.
    [[nodiscard]] double squares() const;
    [[nodiscard]] std::size_t pieces() const;
    /// PieceQueue::merged of all.
    [[nodiscard]] double merged() const;

private:
    /// One segment: right-going waves in the order in which they leave it, and left-going ones.
    struct Line {
        PieceQueue a;
        PieceQueue b;
        double impedance;
        double dashpot;  ///< at the joint after it
    };

    std::vector<Line> lines_;
    std::vector<JointWeights> joints_;
    double crossing_;
};

}  // namespace signorini
