#pragma once
/// \file
/// Figures, drawn by gnuplot at run time: a motion, a continuum, the frequency-energy plot (the
/// paper's Fig. 1, with exact modes as curves and the sets of schedules as bars), and the map of
/// where in time motions exist.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "signorini/atlas_database.hpp"
#include "signorini/continuum.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/modes.hpp"
#include "signorini/response.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// What a figure file holds.
enum class FigureFormat { svg, png, pdf };

/// By the ending of the name: .svg, .png or .pdf.
/// \throws std::invalid_argument for any other ending.
[[nodiscard]] FigureFormat figureFormat(const std::string& path);

/// Draws a found motion as in the paper's Fig. 3: the initial strain and velocity along the bar,
/// the displacement u(x, t) over one period, and the path of the tip beside the wall with the
/// contact phases marked. Long motions are thinned to what print can show. \throws
/// std::invalid_argument if the result holds no motion, BackendUnavailable if gnuplot is missing or
/// fails, FileError if `path` cannot be written.
void drawMotion(const PeriodicResult& result, FigureFormat format, const std::string& path);

/// Draws a curve of motions: strain and velocity at t = 0 along the bar, members stacked upwards by
/// lambda (the paper's Fig. 2), and below the displacement u(x, t) of two members, drawn in black
/// above (its Fig. 3). Long curves are thinned to what print can show.
/// \throws std::invalid_argument if the curve has no points, BackendUnavailable if gnuplot is
/// missing or fails, FileError if `path` cannot be written.
void drawContinuum(const Continuum& curve, FigureFormat format, const std::string& path);

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

/// The frequency-energy plot of the schedules found in a database, as bars [E_min, E_max], with the
/// exact modes as curves.
/// \throws FileError, BackendUnavailable.
void drawFrequencyEnergyPlot(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                             FigureFormat format, const std::string& path);

/// The existence map: a dot at (t_c, t_f) = (n_c/N, n_f/N), in L/c, for each schedule of one phase
/// that has motions, coloured by its least energy; grazing ones grey. An atlas without any leaves
/// an empty map. Errors as above.
void drawExistenceMap(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                      FigureFormat format, const std::string& path);

/// Draws impulse on the wall and reach of the tip against the frequency of the excitation: motions
/// with one contact phase as dots, filled where they attract, open where they repel (their
/// `stability`, if it was tried), and the bar without a wall as a line.
/// \throws std::invalid_argument if there is no frequency; BackendUnavailable, FileError as above.
void drawResponse(std::span<const FrequencyResponse> frequencies, const ResponseRange& range,
                  FigureFormat format, const std::string& path);

/// Draws what a simulation saw: the tip beside the wall with its contacts, at the beginning and at
/// the end, and the impulse of each contact. \throws std::invalid_argument if the path of the tip
/// was not recorded; BackendUnavailable, FileError as above.
void drawSimulation(const BarSimulation& simulation, const Excitation& excitation,
                    FigureFormat format, const std::string& path);

}  // namespace signorini
