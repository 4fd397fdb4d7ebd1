#pragma once
/// \file
/// Excitations and forced motions as Python has them.

#include <string>

#include "forced_answer.hpp"
#include "scene.hpp"
#include "signorini/response.hpp"
#include "signorini/simulation.hpp"

namespace signorini::python {

/// "tip" or "base". \throws std::invalid_argument for another word.
[[nodiscard]] Excited placeOf(const std::string& force);

using MotionOf = answers::ForcedMotionOf;
template <>
struct Members<MotionOf> {
    static constexpr auto list =
        std::tuple{&MotionOf::value, &MotionOf::bar, &MotionOf::isOfResponse, &MotionOf::segments};
};

}  // namespace signorini::python
