#pragma once
/// \file
/// Motions under an exact harmonic over a range of frequencies, and the curves they lie on.

#include <optional>
#include <vector>

#include "harmonic_branch.hpp"
#include "signorini/response.hpp"

namespace signorini {

/// What disturbances do: by how much they grow in a period, if that is known, and whether the bar
/// comes back: as growth says and as was tried, where neither contradicts the other.
struct ExactStability {
    std::optional<double> growth;
    std::optional<bool> attracts;
};

[[nodiscard]] ExactStability exactStability(const HarmonicCase& given,
                                            const HarmonicMotion& motion);

/// A motion, and its period.
struct ExactMotion {
    HarmonicCase given;
    HarmonicMotion motion;
    ExactStability stability;
};

/// All with one contact at one frequency, and where none of them is known to attract, what a bar
/// at rest settles on.
struct ExactFrequency {
    std::int64_t steps = 0;  ///< T is steps/cells [L/c]
    double frequencyRatio = 0.0;
    double linearPeak = 0.0;  ///< max u(L) without stops [g]
    bool touches = false;     ///< would that motion meet a stop?
    std::vector<ExactMotion> motions;
};

/// A curve, and stability at each of its points: tried at the periods of the list and where growth
/// is not known, else as growth says.
struct ExactBranch {
    HarmonicBranch curve;
    std::vector<ExactStability> stability;
};

/// Of a range are read cells, damping, place, amplitude, cycles, frequencies and stops; none if it
/// was cancelled. \throws as stepsOf and harmonicCase.
[[nodiscard]] std::optional<ExactFrequency> exactAt(const ResponseRange& range, std::int64_t steps,
                                                    const Cancel& cancel = {});

/// The curves through all motions of these frequencies, each followed to both ends of the range or
/// of itself; a motion that lies on a curve begins no other.
[[nodiscard]] std::vector<ExactBranch> exactBranches(const ResponseRange& range,
                                                     const std::vector<ExactFrequency>& all,
                                                     const Cancel& cancel = {});

}  // namespace signorini
