#pragma once
/// \file
/// The picture of a study.

#include "signorini/figure_data.hpp"
#include "study_answer.hpp"

namespace signorini {

/// The worst impulse of each sweep: a field for each amplitude and gap, a panel for each damping
/// ratio; frequencies are written in the fields. In SI units.
/// \throws std::invalid_argument if there is no point.
[[nodiscard]] FigureData studyFigure(const answers::StudyAnswer& answer);

}  // namespace signorini
