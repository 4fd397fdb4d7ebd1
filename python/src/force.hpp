#pragma once
/// \file
/// Excitations and forced motions as Python has them.

#include <string>

#include "scene.hpp"
#include "signorini/response.hpp"
#include "signorini/simulation.hpp"

namespace signorini::python {

/// One unit of its amplitude: EA g/L [N] at the tip, g [m] at the base.
[[nodiscard]] double amplitudeUnit(Excited place, const Bar& bar);

/// "tip" or "base". \throws std::invalid_argument for another word.
[[nodiscard]] Excited placeOf(const std::string& force);

/// One motion and its units.
struct MotionOf {
    ForcedMotion value;
    Bar bar;
    bool isOfResponse = false;  ///< or of one schedule: other keys
    std::vector<Segment> segments = {};
};
template <>
struct Members<MotionOf> {
    static constexpr auto list =
        std::tuple{&MotionOf::value, &MotionOf::bar, &MotionOf::isOfResponse, &MotionOf::segments};
};

}  // namespace signorini::python
