#pragma once
/// \file
/// One builder for each formulation: see formulation.hpp for the rows.

#include "formulation.hpp"

namespace signorini {

/// The state form. Same errors as `formulate`.
[[nodiscard]] Formulated stateForm(const Schedule& schedule, double depth);

/// The reduced form, or the lumped one.
[[nodiscard]] Formulated amplitudeForm(const Schedule& schedule, double depth, bool lumped);

}  // namespace signorini
