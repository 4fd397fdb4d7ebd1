#pragma once
/// \file
/// Continua k(lambda): curves of motions of one schedule and one energy, the paper's Fig. 2.
///
/// The motions of energy E form the part of the solution set that lies on a sphere, since
/// E/E_1 = (2w/N) sum z^2 (one_phase_set.hpp). Two ways, one answer:
///
/// - geometry (solver "closed-form"): motions that differ in one simplex of amplitudes, and what
///   lies of a box inside such a simplex. Exact paths (sphere_section.hpp), O(N) per point
/// - programs (a back end that holds an energy): any set. Predictor: a step along the chord to the
///   far end; corrector: the motion of this energy that is nearest to it, a nonlinear program.
///   Steps are halved until neighbours are within the resolution asked for and the motion nearest
///   to their middle is near the middle
///
/// Which motions can be joined is a property of the set: where theory knows (one contact phase;
/// several whose vertices are known), it decides before any solver does. Where only finitely many
/// motions have the energy, the answer lists them.
///
/// Without a gap, and with one stop, motions are a convex cone without lines, and those of one
/// energy E = E/E_1 EA L/2 are its cut by a sphere: always connected, and the great circle between
/// two of them stays in it. So there geometry traces every schedule.
///
/// Each point is verified before it is kept. A curve takes 16 N bytes per point.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/control.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/motion.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// Most points of a curve, and most members of a sample.
inline constexpr std::int64_t maxContinuumPoints = 1'000'000;

/// What is to be traced. States are in [g/L].
namespace trace {
/// The split pulse: one rectangular pulse of force on the wall, cut in halves with an ever longer
/// pause between them. Energy and impulse are held, and the force, which is the least peak of this
/// energy but for cells covered in part. No two members are the same but for a shift in time, and
/// in units of time the curve is the same on every grid, to within a cell. At energies that
/// only a pulse of less than two cells has, the second pulse is a smaller one. Where motions do not
/// differ in one simplex of amplitudes, nor in several of one size and fixed sums, which then all
/// carry the same pulses: a path between two members of the solver's choice.
/// Without a gap the impulse is free: the curve holds that of pulses which together take half the
/// contact, and where three or more classes cannot share it goes along the arc between two members.
struct SplitPulse {};
/// A path between two motions.
struct Path {
    State from;
    State to;
};
/// From a motion this way for half a great circle of the set's sphere, sliding along the faces it
/// meets. Only the part of `direction` along the set counts. By geometry only, and with a gap.
struct Walk {
    State from;
    State direction;
};
/// A path between two members drawn at random.
struct RandomPath {
    std::uint64_t seed = 1;
};
/// No curve: members spread over the whole set (`sampleMotions`); lambda numbers them. By geometry
/// only.
struct Sample {
    std::uint64_t seed = 1;
};
}  // namespace trace

using Trace =
    std::variant<trace::SplitPulse, trace::Path, trace::Walk, trace::RandomPath, trace::Sample>;

/// What a curve is to do beyond staying in the set.
struct ContinuumOptions {
    /// Unit of strain limit and peak strains, and where the stops are; a uniform bar.
    Scene scene = {};
    /// [-], 2..1e6, of a curve or a sample. Programs keep more where the resolution asks for it.
    std::int64_t points = 201;
    Trace trace = {};  ///< the split pulse, if nothing is said
    /// "closed-form": geometry; a name from `backends()` that holds an energy: programs; "auto":
    /// geometry where it is exact, otherwise programs.
    std::string solver = "auto";
    double strainLimit = std::numeric_limits<double>::infinity();  ///< [-], > 0: s >= -S
    /// [sqrt(E/E_1)], 1e-6..1: how far neighbours on a curve by programs may be apart, in the norm
    /// of the energy. The finer, the narrower a gap that cannot be jumped, and the longer it takes.
    double resolution = 0.05;
    double tolerance = 1e-7;  ///< largest residual of a point
    Cancel cancel = {};       ///< keeps the points found so far
    std::function<void(double done, double total)> progress = {};  ///< called after each point
};

/// One motion of the curve.
struct ContinuumPoint {
    double lambda = 0.0;
    State state;
    double energyRatio = 0.0;  ///< E/E_1, recomputed
    double residual = 0.0;     ///< the largest of its Residuals, recomputed
    double peakStrain = 0.0;   ///< [-], deepest compression over all x and t
};

/// What lambda is.
enum class Parameter {
    arcLength,  ///< length along the curve in the norm of the energy, E/E_1 = |state|^2
    pause,      ///< [L/c] between the two pulses of force
    number,     ///< 1, 2, ... of members that are no curve
};

/// "arc length", "pause", "number".
[[nodiscard]] std::string_view name(Parameter parameter);

/// The answer. Invariants: found <=> at least the points asked for, or all motions of the energy if
/// they are finitely many, each with a residual within the tolerance; none => `detail` proves that
/// there is no such curve; undecided => `detail` says what stopped it, and `points` holds what was
/// found before.
struct Continuum {
    Status status = Status::undecided;
    std::string detail = "traceContinuum has not been called";
    std::optional<Reason> reason;  ///< why the schedule has no motion of this energy
    /// Can the two ends be joined; without ends, can all motions of this energy be. False is always
    /// proved. True is proved where `components` is known, whatever became of the curve; elsewhere
    /// it is only said of two ends, and claims that there is a curve at this `resolution`: a gap
    /// narrower than it might have been jumped. Empty: not known.
    std::optional<bool> connected;
    std::optional<std::int64_t> components;  ///< of the motions of this energy, if known
    /// [sqrt(E/E_1)], of a curve: the largest distance of neighbours, in the norm of the energy.
    std::optional<double> resolution;
    Schedule schedule;
    Scene scene;
    double energyRatio = 0.0;                ///< E/E_1 asked for
    std::optional<EnergyRange> energyRange;  ///< over the whole set, if known
    std::int64_t dimension = -1;         ///< of the motions of this energy; -1: none or not known
    std::string solver = "closed-form";  ///< who traced; "auto": nobody in this build could have
    Parameter parameter = Parameter::arcLength;
    std::string family;  ///< e.g. "split pulse"
    std::vector<ContinuumPoint> points;
    /// How many of the points are different motions, and not one at different instants: compared to
    /// the last bit (motion.hpp), so rounding may make two of one.
    std::int64_t orbits = 0;
};

/// Traces a curve of motions with E/E_1 = energyRatio.
///
/// \throws std::invalid_argument on invalid input: among it ends that are no motions of the
/// schedule, have another energy, or break the limit; BackendUnavailable if no solver in this
/// build can do what is asked.
[[nodiscard]] Continuum traceContinuum(const Schedule& schedule, double energyRatio,
                                       const ContinuumOptions& options = {});

/// One motion of a curve.
struct Member {
    ContinuumPoint point;
    bool isExact =
        false;  ///< the curve's own motion at this lambda; else the nearest of its points
};

/// The member at a lambda of the curve's range: exact for the split pulse and where a point has it.
/// \throws std::invalid_argument if lambda is out of range, or the curve has no points.
[[nodiscard]] Member memberAt(const Continuum& curve, double lambda);

/// `count` motions spread over the whole set at one energy, the same for the same seed:
/// hit-and-run; without a gap independent draws. One contact phase. Empty if no motion has this
/// energy. \throws
/// std::invalid_argument on invalid input.
[[nodiscard]] std::vector<State> sampleMotions(const Schedule& schedule, double energyRatio,
                                               std::int64_t count, std::uint64_t seed = 1);

}  // namespace signorini
