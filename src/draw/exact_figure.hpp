#pragma once
/// \file
/// The response to an exact harmonic: curves of motions, not dots.

#include <vector>

#include "exact_response.hpp"
#include "harmonic_field.hpp"
#include "signorini/figure_data.hpp"

namespace signorini {

/// Largest force and impulse against frequency: what attracts full, what repels dashed, what is
/// not known dotted; several contacts in another colour; folds and new contacts named; behind them,
/// if there are any, dots for the motions of a force in steps. \throws std::invalid_argument
/// without frequencies.
[[nodiscard]] plot::FigureData exactFigure(const std::vector<ExactFrequency>& frequencies,
                                           const std::vector<ExactBranch>& branches,
                                           const ResponseRange& range, const Bar& bar,
                                           const std::vector<FrequencyResponse>& staircase = {});

/// A motion over one period, on one axis of time: u(x, t), the tip between its stops, the force on
/// them.
[[nodiscard]] plot::FigureData harmonicFigure(const HarmonicField& motion, const Scene& scene);

}  // namespace signorini
