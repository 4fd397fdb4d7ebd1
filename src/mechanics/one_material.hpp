#pragma once
/// \file
/// What is known of the material of a bar of several segments.

#include "signorini/bar.hpp"

namespace signorini {

/// firstMaterial (stepped_bar.hpp), with Young's modulus only if it is that of all segments: where
/// waves are as fast in all of them, they are of one material and of different cross-sections.
[[nodiscard]] Bar unitsOfBar(const Scene& scene);

}  // namespace signorini
