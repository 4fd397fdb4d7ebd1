#pragma once
/// \file
/// The response of a bar of several segments: that of its network (contact_response.hpp).

#include <optional>

#include "contact_response.hpp"

namespace signorini {

/// As responseAt, with one contact. \pre a valid range with several segments.
[[nodiscard]] std::optional<FrequencyResponse> steppedResponseAt(const ResponseRange& range,
                                                                 std::int64_t steps,
                                                                 const Cancel& cancel);

}  // namespace signorini
