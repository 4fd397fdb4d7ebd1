#pragma once
/// \file
/// The frequency-energy plot: the paper's Fig. 1, with exact modes as curves and the sets of single
/// schedules as bars.

#include <optional>
#include <span>
#include <string>

#include "signorini/figure.hpp"
#include "signorini/modes.hpp"

namespace signorini {

/// The energies of the motions of one schedule.
struct EnergyBar {
    double frequencyRatio = 0.0;          ///< [-], omega/omega_1 = 4N/n
    double least = 0.0;                   ///< [E_1], > 0
    double most = 0.0;                    ///< [E_1], >= least; may be infinite
    Contact contact = Contact::pressing;  ///< grazing bars are drawn in another style
};

/// How to draw it.
struct FrequencyEnergyOptions {
    std::optional<FigureFormat> format;       ///< unset: by the ending of the name
    std::optional<double> maxFrequencyRatio;  ///< [-], right end; unset: where the last item ends
    double maxEnergyRatio = 50.0;             ///< [E_1], top; > 1
};

/// Draws omega/omega_1 = 4/T (linear) against E/E_1 (logarithmic): each mode as a curve, with its
/// family in the key and a dot where it leaves a linear motion; each bar as a vertical stroke from
/// least to most; and the motion of the paper's Figs. 2 and 3 at (8/7, 20). Bars of one frequency
/// that overlap are drawn as one, so the file grows with what can be seen. Both spans may be empty.
/// O(modes + bars log bars).
/// \throws std::invalid_argument if no format is given and the name does not end in .svg, .png or
/// .pdf, or a bar or an option is out of range; BackendUnavailable if gnuplot is missing or fails;
/// FileError if `path` cannot be written.
void writeFrequencyEnergyFigure(const std::string& path, std::span<const Mode> modes,
                                std::span<const EnergyBar> bars,
                                const FrequencyEnergyOptions& options = {});

}  // namespace signorini
