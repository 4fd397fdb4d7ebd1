#pragma once
/// \file
/// A bar of several segments, and the one law by which its waves go on for a step.
///
/// A wave crosses every cell in one step. Where two segments meet, both have one velocity v and the
/// forces on the joint balance, with Z the impedances and d a dashpot that holds the joint:
///
///     Z_1 (2a - v) + Z_2 (2b - v) = d v,   b' = v - a,   a' = v - b
///
/// with a and b arriving from the left and from the right, b' and a' leaving. The energy
/// Z (a^2 + b^2) of all cells changes by -d v^2 alone. At the clamp a' = V - b, V the velocity of
/// the base; at the tip q = -p in contact. docs/theory.md,
/// section 19.
///
/// Units: velocities a, b in c g/L with c that of the first segment and L = N c dt the length of a
/// bar of its material with the same travel time; impedances relative to the first segment.

#include <cstdint>
#include <span>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

class Faults;

/// Do waves have one speed in all segments, so that cells are equally long?
[[nodiscard]] bool haveOneSpeed(std::span<const Segment> segments);

/// v = 2 (left a + right b)/all, in whole numbers: left : right : all = Z_1 : Z_2 : Z_1 + Z_2 + d.
struct JointWeights {
    std::int64_t left = 1;
    std::int64_t right = 1;
    std::int64_t all = 2;  ///< <= 2^51

    /// v of the joint, a arriving from the left and b from the right.
    [[nodiscard]] double velocity(double a, double b) const
    {
        return 2.0 * (static_cast<double>(left) * a + static_cast<double>(right) * b) /
               static_cast<double>(all);
    }

    friend bool operator==(const JointWeights&, const JointWeights&) = default;
};

/// The weights of a joint. Every number is read as the simplest fraction that rounds to it, so 1.3
/// is 13/10; where no common denominator below 2^50 exists they are rounded to 15 digits.
/// \pre impedances > 0, dashpot >= 0, all finite.
[[nodiscard]] JointWeights jointWeights(double left, double right, double dashpot);

/// The segments of a bar, clamp first, and the joints between them.
struct SteppedBar {
    std::vector<Segment> segments;     ///< impedances relative to the first
    std::vector<JointWeights> joints;  ///< one fewer
    std::int64_t cells = 0;            ///< N
};

/// Widest range of impedances and dashpots, relative to the first segment.
inline constexpr double mostImpedance = 1e9;

/// 1/mostImpedance..mostImpedance, for speeds, too.
[[nodiscard]] constexpr bool isImpedance(double value)
{
    return value >= 1.0 / mostImpedance && value <= mostImpedance;
}

/// Adds a fault of gravity [m/s^2] that is not finite, or strains a bar by more than 1e6.
void requireWeight(Faults& faults, double gravity, double length, double waveSpeed);

/// \throws std::invalid_argument unless there are segments of at least one cell each, with
/// impedances and speeds in 1/mostImpedance..mostImpedance, dashpots in 0..mostImpedance and none
/// after the last segment, and no more than maxCells cells.
[[nodiscard]] SteppedBar steppedBar(std::span<const Segment> segments);

/// \throws std::invalid_argument unless the bar has so many cells.
void requireCells(const SteppedBar& bar, std::int64_t cells);

/// A uniform bar of the first material with the same travel time: its scales are those of the
/// scene. \pre a valid scene.
[[nodiscard]] Bar firstMaterial(const Scene& scene);

/// The same, with Young's modulus only if it is that of all segments: where waves are as fast in
/// all of them, they are of one material and of different cross-sections.
[[nodiscard]] Bar unitsOfBar(const Scene& scene);

/// Is a bar of these segments the uniform one: are all alike, without dashpots?
[[nodiscard]] bool isUniform(std::span<const Segment> segments);

}  // namespace signorini
