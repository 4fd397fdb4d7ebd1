#pragma once
/// \file
/// Proofs that no motion exists, in integers.
///
/// For equalities A_eq x = b and inequalities A x <= 0 a Farkas certificate is a pair (y, mu >= 0)
/// with A_eq^T y + A^T mu = 0 and b^T y < 0: together they combine the rows into 0 < 0. All rows of
/// the problem are integer once the gap row is multiplied by N/g:
///
///     (30)  (W x - x)_i = 0              i = 0 .. 2N-1 over x = (a_1..a_N, b_1..b_N)
///     (31)  sum(b_i - a_i) = N                one wall; -N where it presses at rest, 0 for no gap
///     (10)  -p_m <= 0                    one row per contact step, numbered through all phases
///     (12)  p_m0 + ... + p_m <= 0        one row per free step, numbered through all phases,
///                                        m0 the first free step of its phase
///     size  p summed over all contact = N     only without a gap, where every multiple of a motion
///                                             is one and 0 is to be excluded; steps that folding
///                                             (schedule.hpp) leaves out are not counted
///
/// so the check needs no tolerance. They are the rows of scenes with one stop. Row (11) is the
/// first row (12) of its phase.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// The multiplier of one row; rows that are not listed have multiplier 0.
struct Multiplier {
    std::int64_t row = 0;    ///< zero-based
    std::int64_t value = 0;  ///< [-], >= 0 on inequalities

    friend bool operator==(const Multiplier&, const Multiplier&) = default;
};

/// Integer multipliers of the rows above, in ascending order of the row.
struct FarkasCertificate {
    std::int64_t gap = 0;                 ///< y of (31), negative in a proof with a gap
    std::int64_t size = 0;                ///< y of the row of size, negative in a proof without
    std::vector<Multiplier> periodicity;  ///< y of (30)
    std::vector<Multiplier> pressure;     ///< mu of (10)
    std::vector<Multiplier> penetration;  ///< mu of (12)
};

/// The same proof in least integers. O(rows listed).
void divideByCommonFactor(FarkasCertificate& certificate);

/// Integer multipliers of the rows of a program, ascending; others are 0.
struct InfeasibilityProof {
    std::vector<Multiplier> equalities;    ///< y
    std::vector<Multiplier> inequalities;  ///< mu >= 0
};

/// What a forced motion obeys.
enum class ForcedRule {
    gap,          ///< u(L, 0) = g, or -h on the second stop; part of every proof, not listed
    pressure,     ///< R >= 0 in this step of contact; on the second stop -R >= 0
    held,         ///< the same on average in this step and every 2N later, all of them in contact
    penetration,  ///< u(L) <= g at the end of this step of flight
    secondStop,   ///< u(L) >= -h there
    closure,      ///< u(L) = g, or -h, at the end of this step, the last of a flight
    work,         ///< no work on the waves that pass the tip in this step and every 2N later, which
                  ///< nothing damps: so they come back as they were
    strain,       ///< no compression beyond the limit by the wave that arrives in this step
    rest,         ///< the tip rests at the wall, as n_f < G, and presses on it by 0 on average
};

/// "gap", "pressure", "held", "penetration", "second-stop", "closure", "work", "strain",
/// "rest".
[[nodiscard]] std::string_view name(ForcedRule rule);

/// A rule in one step, as it appears in a proof.
struct ForcedCondition {
    ForcedRule rule = ForcedRule::gap;
    std::int64_t step = 0;  ///< zero-based, from the start of the first contact

    friend bool operator==(const ForcedCondition&, const ForcedCondition&) = default;
};

/// The multiplier of one row, of any size.
struct RationalMultiplier {
    std::int64_t row = 0;  ///< zero-based
    std::string value;     ///< "p/q" or "p", in lowest terms

    friend bool operator==(const RationalMultiplier&, const RationalMultiplier&) = default;
};

/// Rational multipliers of the rows of a program, ascending; others are 0.
struct RationalProof {
    std::vector<RationalMultiplier> equalities;    ///< y
    std::vector<RationalMultiplier> inequalities;  ///< mu >= 0
};

/// The multiplier of a condition at a contact.
struct ContactMultiplier {
    std::size_t contact = 0;  ///< zero-based, from left to right
    std::int64_t step = 0;    ///< zero-based, from the start of the schedule
    double value = 0.0;       ///< of any sign where the condition is an equality, else >= 0

    friend bool operator==(const ContactMultiplier&, const ContactMultiplier&) = default;
};

/// The multiplier of a limit on strain where two waves of a row of N cells pass each other: those
/// that arrive at its right end in a step p and at its left end in a step q, |p - q| <= N, whole
/// periods left out.
struct StrainMultiplier {
    std::size_t row = 0;     ///< zero-based, from left to right
    std::int64_t right = 0;  ///< p, zero-based, from the start of the schedule
    std::int64_t left = 0;   ///< q
    double value = 0.0;      ///< >= 0

    friend bool operator==(const StrainMultiplier&, const StrainMultiplier&) = default;
};

/// Multipliers that bound the energy of all motions of a schedule from below (docs/theory.md,
/// section 20). With x the waves at t = 0, S the step and x_m = S ... S x,
///
///     sum y (x_n - x) + sum of places x distances + sum of pushes x pushes
///         + sum of strains x (strain + limit) = eta . x - delta >= 0
///
/// for every motion, so that its energy sum Z x^2 is at least delta^2/(sum eta^2/Z), whatever was
/// rounded in finding them. A bound that is huge says that there is no motion.
struct EnergyFloor {
    std::vector<double> periodicity;        ///< y: a wave each, row by row: right-going, left-going
    std::vector<ContactMultiplier> places;  ///< of distances when a step begins: 0 next to a closed
                                            ///< step, else >= 0
    std::vector<ContactMultiplier> pushes;  ///< in closed steps, >= 0
    std::vector<StrainMultiplier> strains = {};  ///< of a limit, if there is one

    friend bool operator==(const EnergyFloor&, const EnergyFloor&) = default;
};

}  // namespace signorini
