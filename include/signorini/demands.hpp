#pragma once
/// \file
/// What a user may ask for beyond existence: which motion of the set, and within which limits.
///
/// Every demand is linear or diagonal-quadratic in the delay sequence p (motion.hpp). The
/// strain is s(x, t) = -(P(t + L - x) + P(t + L + x)) with P(t) = p_m in step m (c = 1), so over
/// all x and all t, also inside steps, the deepest compression is exactly
///
///     -min s = 2 max_m p_m,
///
/// reached at the clamp, x = 0, whatever the motion: a strain limit is a bound on each p_m and
/// couples nothing. (At the instants t_m alone only sums p_k + p_l with odd k - l occur.)

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// Which unknowns the problem is posed in.
enum class Formulation {
    automatic,  ///< whatever the request needs least of
    state,      ///< the paper's a and b, equations (30)-(32) as they stand
    reduced,    ///< class amplitudes
    lumped,     ///< sums of class amplitudes
    joints,     ///< waves at joints and tip, of a bar of several segments
    kernel,     ///< coordinates of ker(W - 1), of a bar of several segments
};

/// "auto", "state", "reduced", "lumped", "joints", "kernel".
[[nodiscard]] std::string_view name(Formulation formulation);

/// Which motion of the solution set to return.
enum class Objective {
    automatic,      ///< least energy, with a held energy least peak strain, where that costs
                    ///< nothing, otherwise any
    any,            ///< whichever the route finds first
    minEnergy,      ///< least E
    maxEnergy,      ///< most E: exact in closed form, otherwise the best one found
    minPeakStrain,  ///< least deepest compression over all x and t
    maxImpulse,     ///< most impulse on the wall over a period
    nearest,        ///< least squared distance of (a, b) to a given state
};

/// "auto", "any", "min-energy", "max-energy", "min-peak-strain", "max-impulse", "nearest".
[[nodiscard]] std::string_view name(Objective objective);

/// One of the two travelling waves.
enum class Wave { a, b };

/// A prescribed value of the state at t = 0.
struct FixedValue {
    Wave wave = Wave::a;    ///< which wave
    std::int64_t cell = 1;  ///< 1..N
    double value = 0.0;     ///< [g/L]
};

/// Demands in scaled units; the defaults demand nothing.
struct Demands {
    Objective objective = Objective::automatic;  ///< which motion of the set
    std::optional<State> target = std::nullopt;  ///< for Objective::nearest
    /// [g/L], S > 0: s >= -S for all x and t.
    double strainLimit = std::numeric_limits<double>::infinity();
    /// [g], lowest displacement of the tip allowed, < 1.
    double tipFloor = -std::numeric_limits<double>::infinity();
    std::vector<FixedValue> fixed = {};                ///< prescribed parts of the initial state
    std::optional<double> energyRatio = std::nullopt;  ///< E/E_1 to hold

    /// Is any motion of the schedule acceptable?
    [[nodiscard]] bool areLimits() const;
    /// Is an energy held and something else made least, which no program is asked to do at once?
    [[nodiscard]] bool needsExactRoute() const;
};

/// Checks ranges, sizes and finiteness for a schedule. \throws std::invalid_argument, all faults.
void validate(const Demands& demands, const Schedule& schedule);

/// The largest relative violation of the limits by a state: of the strain limit and the held energy
/// relative to them, of the tip floor relative to the gap, of a fixed value relative to it or to
/// g/L, whichever is larger. 0 if all are met. Independent of how the state was found. O(N + min(n,
/// 12N)).
[[nodiscard]] double violation(const Demands& demands, const State& state, const Extremes& seen,
                               double energyRatio);
/// Of a bar of one segment, measured here.
[[nodiscard]] double violation(const Demands& demands, const State& state,
                               const Schedule& schedule);

}  // namespace signorini
