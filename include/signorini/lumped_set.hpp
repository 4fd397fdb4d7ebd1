#pragma once
/// \file
/// Several contact phases: an exact verdict, and the complete solution set.
///
/// With S the sum of the amplitudes of each live type (below), at most 2K numbers for K
/// phases, a schedule has a motion exactly when some S satisfies, whatever N is,
///
///     sum windowSum S = -N                          the gap row (31)
///     sum over a flight of epsilon S = 0            every flight closes
///     sum from take-off to the end of a block <= 0  no penetration (12)
///     S >= 0 for a pressing type                    pressure (10)
///
/// With other stops the right sides change, and nothing else: of the gap row to N for a gap < 0, 0
/// for none (then sum contactMembers S = N holds the size), N h/g where the period starts on the
/// second stop; a flight from one stop to the other closes with -+N (g + h)/2g, and sums over its
/// blocks have bounds on both sides (docs/theory.md, section 17).
///
/// All coefficients are integers, and the system is decided in rational arithmetic: the verdict
/// depends on no tolerance and on no solver library. The nearest such S to 0 in the metric
/// sum S^2/d gives the motion of least energy, with equal amplitudes S/d in each type.
///
/// The set of all motions: S in this polyhedron, and for each type, independently given S,
///
///     pressing   z >= 0, sum z = S                  a simplex
///     grazing    lower(S) <= Z_j <= upper(S)        a box of partial sums, Z_d = S
///
/// ## Classes and types
///
/// Classes and types for any number of contact phases: the unknowns that are left of (30).
///
/// As in one_phase_set.hpp the n steps of a period fall into G = gcd(2N, n) classes m = alpha G +
/// j. Cut 0..G-1 at every phase boundary modulo G: at most 2K runs of neighbouring classes remain,
/// the
/// **types**. All classes of a type meet contact and free flight in the same alpha, so they share
/// one sign pattern, p_{alpha G + j} = epsilon_alpha z_j. A type is
///
/// - dead: an odd number of free steps per class, p = 0;
/// - blocked: the kernel allows an amplitude, but contact steps ask for both signs, so z = 0;
/// - pressing: it has contact steps; epsilon is taken +1 there, on the second stop -1, so z >= 0;
/// - grazing: it has none, and z is free in sign.

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "signorini/amplitude_set.hpp"
#include "signorini/certificate.hpp"
#include "signorini/motion.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// What the contact steps of a type allow.
enum class TypeKind { dead, blocked, pressing, grazing };

/// A run of neighbouring classes with one sign pattern.
struct ClassType {
    std::int64_t first = 0;           ///< j of its first class
    std::int64_t count = 0;           ///< [-], d, number of classes
    TypeKind kind = TypeKind::dead;   ///< whether amplitudes live on it, and of which sign
    std::vector<std::int8_t> signs;   ///< epsilon_alpha, alpha = 0..nu-1; empty if dead
    std::int64_t windowSum = 0;       ///< [-], sum of epsilon over a window of 2N steps
    std::int64_t contactMembers = 0;  ///< [-], contact steps in each class

    /// Does it carry amplitudes?
    [[nodiscard]] bool isLive() const
    {
        return kind == TypeKind::pressing || kind == TypeKind::grazing;
    }
};

/// The classes of a schedule, type by type.
struct ClassTypes {
    Schedule schedule;                 ///< folded; all counts refer to it
    std::int64_t classes = 0;          ///< [-], G
    std::int64_t members = 0;          ///< [-], nu, steps in a class
    std::int64_t window = 0;           ///< [-], w = 2N/G
    std::int64_t kernelDimension = 0;  ///< [-], dim ker(W - 1): classes that are not dead
    std::vector<ClassType> types;      ///< in ascending order of `first`; together all G classes
};

/// Finds classes and types. O(nu K) time and memory.
/// \throws std::invalid_argument on an invalid schedule.
[[nodiscard]] ClassTypes classTypes(const Schedule& schedule);

/// Steps alpha G + first .. alpha G + first + count - 1: one type in one turn, all of one kind.
struct Block {
    std::int64_t alpha = 0;  ///< 0..nu-1
    std::size_t type = 0;    ///< index into ClassTypes::types
    std::size_t phase = 0;   ///< index into the phases of the schedule
    bool isContact = false;  ///< held, or flying
    bool endsPhase = false;  ///< last block of its phase's flight
};

/// First step of each stretch of contact or flight in turn, and n at the end. O(K).
[[nodiscard]] std::vector<std::int64_t> stretchesOf(const Schedule& schedule);

/// Calls action(block) for every block of one period in the order of time, without storing any.
/// O(nu K).
template <typename Action>
void forEachBlock(const ClassTypes& classes, Action action)
{
    const std::vector<std::int64_t> stretches = stretchesOf(classes.schedule);
    std::size_t stretch = 0;
    for (std::int64_t alpha = 0; alpha < classes.members; ++alpha) {
        for (std::size_t type = 0; type < classes.types.size(); ++type) {
            const ClassType& run = classes.types[type];
            const std::int64_t step = alpha * classes.classes + run.first;
            stretch += step == stretches[stretch + 1] ? 1 : 0;
            const bool isContact = stretch % 2 == 0;
            action(Block{.alpha = alpha,
                         .type = type,
                         .phase = stretch / 2,
                         .isContact = isContact,
                         .endsPhase = !isContact && step + run.count == stretches[stretch + 1]});
        }
    }
}

/// All blocks of one period in the order of time. O(nu K).
[[nodiscard]] std::vector<Block> blocksOf(const ClassTypes& classes);

/// A row of (12) at the end of a block, in the sums S, and its multiplier.
struct PrefixMultiplier {
    std::vector<std::int64_t> coefficients;  ///< one per live type
    std::int64_t value = 0;                  ///< [-], > 0
    std::int64_t rhs = 0;                    ///< [-], coefficients . S <= rhs
};

/// Why no S exists: these rows add up to sum s S <= -r with r > 0 and s >= 0 on pressing types,
/// 0 on grazing ones.
struct LumpedAbsence {
    std::int64_t gap = 0;              ///< [-], multiplier of the gap row
    std::int64_t size = 0;             ///< [-], of the row of size, without a gap
    std::vector<Multiplier> closures;  ///< row: number of the phase whose flight closes
    std::vector<PrefixMultiplier> prefixes;
};

/// The verdict on a schedule, and its motion of least energy.
struct LumpedSet {
    ClassTypes classes;
    std::vector<std::size_t> live;         ///< indices of the live types; entry i has the sum S_i
    std::optional<LumpedAbsence> absence;  ///< set exactly when there is no motion
    std::vector<double> leastSums;         ///< [g/L], S of least energy
    double leastEnergy = 0.0;              ///< [E_1], E_min; without a gap of the size of the sums

    /// The live type of S_i.
    [[nodiscard]] const ClassType& type(std::size_t i) const { return classes.types[live[i]]; }
};

/// Most live types and most blocks (`blockCount`) that `lumpedSet` takes on: beyond them exact
/// arithmetic takes minutes. 2K live types suffice for K phases.
inline constexpr std::size_t maxLiveTypes = 32;
inline constexpr std::int64_t maxBlocks = 50'000'000;

/// An upper bound on the blocks of one period, n/G min(2K, G). O(K).
/// \throws std::invalid_argument on an invalid schedule.
[[nodiscard]] std::int64_t blockCount(const Schedule& schedule);

/// How many types carry amplitudes.
[[nodiscard]] std::size_t liveTypeCount(const ClassTypes& classes);

/// Decides a schedule with any number of phases. O(blocks) for each of the few rows that matter.
/// \throws std::invalid_argument on an invalid schedule or one beyond the limits above,
/// std::overflow_error if a proof of absence does not fit in 64 bits.
[[nodiscard]] LumpedSet lumpedSet(const Schedule& schedule);

/// The same, for classes that are known already.
[[nodiscard]] LumpedSet lumpedSetOf(ClassTypes classes);

/// The simplest reason why a schedule that has no motion has none: no class is live, contact steps
/// contradict each other, no amplitude brings the tip to the wall, or else the flights. O(K).
[[nodiscard]] Reason absenceReason(const ClassTypes& classes);

/// What the set of all motions looks like.
struct LumpedShape {
    SetKind kind = SetKind::empty;
    std::int64_t dimension = -1;  ///< [-], exact; -1: empty
    /// [E_1]; most: infinite if the set is unbounded, NaN if not known (a grazing type of several
    /// classes whose box varies with S, or too many vertices)
    EnergyRange energy;
    /// Points S of the polyhedron that span it, the first of least energy.
    std::vector<std::vector<double>> spanning;
    /// All vertices S if there are few enough, otherwise empty.
    std::vector<std::vector<double>> vertices;
    bool isBounded = true;  ///< meaningful when the vertices are known
};

/// Dimension by exact projections, at most two for each live type; vertices by double description
/// up to 512 rays. Grazing types count with d - 1 dimensions if their box has an interior, pressing
/// ones if their sum is not 0 throughout.
[[nodiscard]] LumpedShape shapeOf(const LumpedSet& set);

/// The amplitudes that the live type number `index` may have at given sums S. O(blocks).
/// \throws std::invalid_argument if the set is empty, or sums or index do not fit it.
[[nodiscard]] AmplitudeSet amplitudesAt(const LumpedSet& set, std::span<const double> sums,
                                        std::size_t index);

/// The state at t = 0 of the motion with p_{alpha G + j} = epsilon_alpha z_j, one z per class, dead
/// classes not read. O(N). \throws std::invalid_argument if z does not hold G values.
[[nodiscard]] State motionOf(const ClassTypes& classes, std::span<const double> z);

/// The amplitudes nearest to any state, one per class: for each live class the mean of epsilon p
/// over its w steps in the window of 2N, 0 for the others; those of a motion give it back. O(N).
/// \throws std::invalid_argument if the state has other cells.
[[nodiscard]] std::vector<double> amplitudesOf(const ClassTypes& classes, const State& state);

/// The motion with sums S and equal amplitudes in each type, which have the least energy and the
/// least peak strain for that S. O(N). \throws std::invalid_argument if the sums do not fit.
[[nodiscard]] State equalMotion(const LumpedSet& set, std::span<const double> sums);

/// A motion of most energy: the vertex with the largest squares, each type's amplitudes as far
/// apart as its set allows. O(N + vertices blocks). \throws std::invalid_argument if the set is
/// empty, or its most energy infinite or not known.
[[nodiscard]] State mostEnergyMotion(const LumpedSet& set, const LumpedShape& shape);

/// A random motion, reproducible from the generator: S a random mean of the spanning points, then
/// each type's simplex or box. O(N + blocks). \throws std::invalid_argument if the set is empty.
[[nodiscard]] State drawMotion(const LumpedSet& set, const LumpedShape& shape,
                               std::mt19937_64& generator);

}  // namespace signorini
