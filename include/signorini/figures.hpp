#pragma once
/// \file
/// Figures as data, made of answers, and gnuplot, which draws them at run time: a motion, a
/// continuum, the frequency-energy plot (the paper's Fig. 1, with exact modes as curves and
/// families as half-lines), families as a periodic table, the map of where in time motions exist,
/// responses, sweeps and simulations.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "signorini/atlas_database.hpp"
#include "signorini/continuum.hpp"
#include "signorini/figure_data.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/modes.hpp"
#include "signorini/output.hpp"
#include "signorini/response.hpp"
#include "signorini/simulation.hpp"
#include "signorini/sweep.hpp"

namespace signorini {

/// What a figure file holds.
enum class FigureFormat { svg, png, pdf };

/// By the ending of the name: .svg, .png or .pdf.
/// \throws std::invalid_argument for any other ending.
[[nodiscard]] FigureFormat figureFormat(const std::string& path);

/// Draws a figure with gnuplot. \throws BackendUnavailable if gnuplot is missing or fails,
/// FileError if `path` cannot be written.
void drawFigure(const FigureData& figure, FigureFormat format, const std::string& path);

/// A found motion as in the paper's Fig. 3, in SI units: strain and velocity along the bar at t =
/// 0, the displacement u(x, t) over one period, and with the same axis of time the path of the tip
/// beside the wall and the force of the wall. Contact is marked where that force acts. Long motions
/// are thinned to what print can show; of segments with several speeds u(x, t) and the contacts.
/// Panels "words", "strain", "velocity", "displacement", "tip" and "force", or "displacement" and
/// "contact 1", ... \throws std::invalid_argument if the result holds no motion.
[[nodiscard]] FigureData motionFigure(const PeriodicResult& result);

/// The same of a state.
[[nodiscard]] FigureData motionFigure(const State& state, const Schedule& schedule,
                                      const Scene& scene);

/// The same of a forced motion: where a base moves u(0, t) does.
[[nodiscard]] FigureData motionFigure(const ForcedMotion& motion, const Scene& scene);

/// A curve of motions, in SI units, lambda upwards: the force of the wall against time, which tells
/// orbits apart, and strain and velocity at t = 0 along the bar (the paper's Fig. 2), in colour;
/// below, the displacement u(x, t) of the first, the middle and the last member (its Fig. 3).
/// Panels "force", "strain", "velocity", "first", "middle" and "last". \throws
/// std::invalid_argument if the curve has no points.
[[nodiscard]] FigureData continuumFigure(const Continuum& curve);

/// Families as a periodic table: order w against period T, a cell (nu, k) for each, coloured by its
/// least energy, over the curves T = (4a - 2k/w)/|b| on which those of one mode and one k stand.
/// Above order 16 the cells are dots, above 120 nothing is drawn. `families` are sorted as
/// `findFamilies` does, and of order <= maxOrder. Panels "families", "families 2", ...: the axis of
/// T is broken where there is no family for long, unless it is to be `whole`.
[[nodiscard]] FigureData familiesFigure(std::span<const Family> families, std::int64_t maxOrder,
                                        bool isWhole = false);

/// What a moving picture is.
enum class AnimationFormat { gif, mp4 };

/// By the ending of the name: .gif or .mp4. \throws std::invalid_argument for any other ending.
[[nodiscard]] AnimationFormat animationFormat(const std::string& path);

/// Draws figures one after the other, 20 a second; .mp4 needs ffmpeg besides. Errors as above.
void drawFigures(std::span<const FigureData> frames, AnimationFormat format,
                 const std::string& path);

/// A motion over one period: the bar at its stops, coloured by strain (compression red), gaps and
/// displacements magnified by one factor, and u, s, v along it. At most so many frames. Panels
/// "bar", "displacement" and "fields".
[[nodiscard]] std::vector<FigureData> motionFrames(const MotionSamples& samples,
                                                   std::size_t most = 120);

/// A curve of motions over lambda: force on the stops and path of the tip over a period, strain and
/// velocity at t = 0. \throws std::invalid_argument if the curve has no points.
[[nodiscard]] std::vector<FigureData> continuumFrames(const Continuum& curve);

/// The energies of the motions of a set on a grid.
struct EnergyBar {
    double frequencyRatio = 0.0;          ///< [-], omega/omega_1
    double least = 0.0;                   ///< [E_1], > 0
    double most = 0.0;                    ///< [E_1], >= least; may be infinite
    Contact contact = Contact::pressing;  ///< grazing bars are drawn in another style

    friend bool operator==(const EnergyBar&, const EnergyBar&) = default;
};

/// What to draw: each span may be empty.
struct FrequencyEnergyPlot {
    std::span<const Mode> modes = {};  ///< curves, with a dot where they leave a linear motion
    /// Half-lines from the least energy upwards, the lower the order w the bolder: they belong to
    /// no grid.
    std::span<const Family> families = {};
    std::span<const Family> onGrid = {};   ///< dots at the least energy
    std::span<const EnergyBar> bars = {};  ///< strokes from least to most, where a grid ends them
};

/// How to draw it.
struct FrequencyEnergyOptions {
    std::optional<double> maxFrequencyRatio = {};  ///< [-], right end; unset: the last item
    std::optional<double> maxEnergyRatio = {};     ///< [E_1], top; unset: `topOf`
    Bar bar = {};                                  ///< whose hertz the upper axis has
    /// The one panel from here to the right end, in place of the whole and its detail.
    std::optional<double> leastFrequencyRatio = {};
    std::int64_t maxOrder = 60;  ///< [-], of the families behind those of an atlas
};

/// [E_1], the top: 50 where none is given.
[[nodiscard]] inline double topOf(const FrequencyEnergyOptions& options)
{
    return options.maxEnergyRatio.value_or(50.0);
}

/// omega/omega_1 = 4/T against E/E_1 (logarithmic): the whole, and once more the part where
/// families crowd, with the names (w, nu, k) of the first ones; of the paper's bar its motion of
/// Figs. 2 and 3 at (8/7, 20). Bars of one frequency that overlap are drawn as one, so the file
/// grows with what can be seen. Panels "whole" and "detail". O(modes + families + bars log bars).
/// \throws std::invalid_argument if a bar or an option is out of range.
[[nodiscard]] FigureData frequencyEnergyFigure(const FrequencyEnergyPlot& plot,
                                               const FrequencyEnergyOptions& options = {});

/// Motions with K contacts on no grid: how long the first contact may last against T, for K = 2 the
/// polygons themselves, and all on the frequency-energy plot beside the modes of one contact.
/// `polytopes` have one K. Panels "contact" and "energy". \throws std::invalid_argument if there
/// are none, or an option is out of range.
[[nodiscard]] FigureData polytopesFigure(std::span<const ModePolytope> polytopes,
                                         const FrequencyEnergyOptions& options);

/// The frequency-energy plot of what a database holds: the families of its schedules as dots, sets
/// of several contacts as bars, linear motions once each; over the exact modes and the families of
/// order 60 at most, whatever the grid. Of segments and of bars in a row, which have no families:
/// panel "energy", a dot at the least energy of each schedule that has motions, all of them where
/// the options give no ends; in hertz or joules where nothing has an omega_1 or E_1.
/// \throws FileError; std::invalid_argument of a uniform bar without a gap > 0 or with two stops,
/// whose modes are others, and on ends in a unit that bars do not have.
[[nodiscard]] FigureData frequencyEnergyFigure(const AtlasDatabase& atlas,
                                               std::optional<std::int64_t> cells,
                                               const FrequencyEnergyOptions& options = {});

/// The existence map: a dot at (t_f, t_c) = (n_f/N, n_c/N), in L/c, for each schedule of one phase
/// that has motions, coloured by its least energy; grazing ones grey. Schedules of one family are a
/// line, its tent; those of order 7 at most have their names. Flights beyond 4 L/c, which only
/// repeat linear motions, are left out. Of segments and of bars in a row those that are undecided
/// are crosses. An atlas without any leaves an empty map. Panel "map"; of bars in a row with
/// several contacts one more for each, "map2", ...
/// \throws FileError.
[[nodiscard]] FigureData existenceFigure(const AtlasDatabase& atlas,
                                         std::optional<std::int64_t> cells);

/// Impulse on the wall and reach of the tip against the frequency of the excitation: motions with
/// contact as dots, large where they attract and small where they repel (their `stability`, if it
/// was tried), the bar without a wall as a line, and behind them the free, undamped motions of the
/// modes, the backbones that they stand on. `bar`: whose scales the axes have, Hz, N s and m.
/// Panels "impulse" and "tip". \throws std::invalid_argument if there is no frequency.
[[nodiscard]] FigureData responseFigure(std::span<const FrequencyResponse> frequencies,
                                        const ResponseRange& range, const Bar& bar);

/// Amplitude against frequency of the excitation: how many motions with at most one contact there
/// are at each place, the amplitude from which the motion without contact meets a stop, and the
/// least one of a motion with contact; between the two edges several coexist. Motions with two
/// contacts are diamonds, the amplitude of the range is a line across. Between two stops only even
/// n: they alone have symmetric motions. Panel "map". Errors as above.
[[nodiscard]] FigureData responseMapFigure(std::span<const FrequencyResponse> frequencies,
                                           const ResponseRange& range, const Bar& bar);

/// Impulse and swing of a sweep against what was varied, upward and downward, with strokes from
/// least to most where the bar does not repeat itself, over the motions of a response, if any (of
/// the same bar and force). Panels "impulse" and "tip". \throws std::invalid_argument if there is
/// no point.
[[nodiscard]] FigureData sweepFigure(std::span<const SweepPoint> points, const SweepRange& range,
                                     const Bar& bar, std::span<const FrequencyResponse> exact);

/// The impulse of each contact against what was varied. Panel "impulse". Errors as above.
[[nodiscard]] FigureData bifurcationFigure(std::span<const SweepPoint> points,
                                           const SweepRange& range, const Bar& bar);

/// What a simulation saw of its tip.
struct SeenTip {
    double time = 0.0;  ///< [L/c], in all
    Stops stops = {};
    std::span<const TipPoint> path = {};
    std::span<const ContactEvent> contacts = {};
    double period = 0.0;  ///< [L/c], of the excitation; 0: none
};

/// The tip beside its stops with its contacts, at the beginning and at the end, or the whole path;
/// and what the stops got in each period of the excitation, of single contacts, too, where there
/// are few. `bar`: whose scales it has. Panels "beginning" and "end", or "tip", and "impulse".
/// \throws std::invalid_argument if the path of the tip was not recorded.
[[nodiscard]] FigureData simulationFigure(const SeenTip& seen, const Bar& bar,
                                          bool isWhole = false);
[[nodiscard]] FigureData simulationFigure(const BarSimulation& simulation,
                                          const Excitation& excitation, const Bar& bar);

}  // namespace signorini
