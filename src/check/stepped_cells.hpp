#pragma once
/// \file
/// The cells of a stepped bar, as a check moves them.

#include <cstdint>
#include <span>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/motion.hpp"

namespace signorini {

/// Two values in every cell.
class SteppedCells {
public:
    SteppedCells(std::span<const Segment> segments, const State& state);

    /// The wave about to reach the tip [c g/L].
    [[nodiscard]] double arriving() const { return a_.back(); }
    /// u(L) = (1/N) sum (b - a) [g].
    [[nodiscard]] double tip() const;
    /// max |a|, |b|; infinite if a value is not finite.
    [[nodiscard]] double size() const;
    /// Largest difference from another state.
    [[nodiscard]] double distance(const State& other) const;
    /// One step with the tip held, or free. O(N).
    void step(bool isHeld);

    [[nodiscard]] double lowestStrain() const { return lowest_; }    ///< [g/L], while it moved
    [[nodiscard]] double highestStrain() const { return highest_; }  ///< [g/L], while it moved
    /// Of the last segment, relative to the first.
    [[nodiscard]] double tipImpedance() const { return parts_.back().impedance; }

private:
    struct Part {
        std::size_t first;
        std::size_t last;
        double impedance;
        double speed;
        double dashpot;
    };

    void see(double a, double b, const Part& part);

    std::vector<Part> parts_;
    std::vector<double> a_;
    std::vector<double> b_;
    double lowest_ = 0.0;
    double highest_ = 0.0;
};

}  // namespace signorini
