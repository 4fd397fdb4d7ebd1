#pragma once
/// \file
/// A curve of motions under an exact harmonic, along its frequency.
///
/// Periods are rational: a step goes to a neighbour, its times extrapolated, each front that ends
/// a contact coming back as often as before. Where the pattern changes, or nothing is found, steps
/// are halved down to 1/finest of their length. At a fold the way to the other sheet leads along
/// amplitude, at one period, along the tangent of the equations, whose waves do not change there
/// (harmonic_pattern.hpp). docs/theory.md, section 21.

#include <vector>

#include "harmonic_motion.hpp"
#include "signorini/control.hpp"

namespace signorini {

/// What happens at a named point.
enum class BranchEvent {
    fold,         ///< the curve turns back
    grazing,      ///< the tip comes to touch a stop where it flew, or no longer does
    newContact,   ///< a release parts a contact in two
    lostContact,  ///< two become one
    pin,          ///< another front ends a contact, or none does any more
    end,          ///< not followed further
};

/// "fold", "grazing", "new contact", "lost contact", "pin", "end".
[[nodiscard]] const char* name(BranchEvent event);

struct BranchPoint {
    double frequencyRatio = 0.0;  ///< omega/omega_1 of the excitation
    HarmonicCase given;           ///< its amplitude is that of the motion
    HarmonicMotion motion;
};

/// Between a point and the one that follows.
struct BranchMark {
    BranchEvent event;
    std::size_t after;
    double frequencyRatio = 0.0;
    double amplitude = 0.0;
};

struct HarmonicBranch {
    std::vector<BranchPoint> points;
    std::vector<BranchMark> marks;
};

struct BranchRange {
    double least = 0.5;      ///< omega/omega_1
    double most = 2.0;       ///< the same
    std::int64_t fine = 16;  ///< a power of two
    std::size_t mostPoints = 4000;
    Cancel cancel = {};
};

/// Through a motion of period steps/stepsPerCrossing, at steps + 1, steps + 2, ... and steps - 1,
/// ... \pre it is a motion of that case. \throws as harmonicCase.
[[nodiscard]] HarmonicBranch alongFrequency(const Damping& damping, const Harmonic& excitation,
                                            const Stops& stops, const HarmonicMotion& motion,
                                            const BranchRange& range);

}  // namespace signorini
