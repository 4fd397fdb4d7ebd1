#pragma once
/// \file
/// Proofs that no motion exists, in integers.
///
/// For equalities A_eq x = b and inequalities A x <= 0 a Farkas certificate is a pair (y, mu >= 0)
/// with A_eq^T y + A^T mu = 0 and b^T y < 0: together they combine the rows into 0 < 0. All rows of
/// the problem are integer once the gap row is multiplied by N/g:
///
///     (30)  (W x - x)_i = 0              i = 0 .. 2N-1 over x = (a_1..a_N, b_1..b_N)
///     (31)  sum(b_i - a_i) = N
///     (10)  -p_m <= 0                    one row per contact step, numbered through all phases
///     (12)  p_m0 + ... + p_m <= 0        one row per free step, numbered through all phases,
///                                        m0 the first free step of its phase
///
/// so the check needs no tolerance. Row (11) is the first row (12) of its phase.

#include <cstdint>
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
    std::int64_t gap = 0;                 ///< y of (31), negative in a proof
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

}  // namespace signorini
