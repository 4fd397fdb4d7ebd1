#pragma once
/// \file
/// Equations (27)-(32) of the paper as sparse matrices, written as they stand.
///
/// For readers, for tests, and for the `state` formulation that the solvers receive. Unknowns are
/// x = (a_1..a_N, b_1..b_N) in scaled units (motion.hpp). Nothing here uses the delay form: the
/// entries follow from the piecewise extensions (21), (22), (24), (25) of the travelling waves.
/// All of it costs O(N) memory, except `inequalities`, whose prefix rows have up to 2N entries.

#include <Eigen/SparseCore>
#include <cstdint>

#include "signorini/schedule.hpp"

namespace signorini {

/// Row-major sparse matrix of doubles; every entry in this header is a small integer.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The arrays of (27)-(28), 4N x 2N each: row j + 2N - 1, j = -2N+1 .. 2N, gives the value of the
/// extended wave on [x_{j-1}, x_j]. Outside [-2N, 2N] the waves repeat, DD with period 2L, DN with
/// period 4L.
struct ExtendedWaves {
    SparseMatrix aDD;  ///< r_1 in contact, (21)
    SparseMatrix bDD;  ///< r_2 in contact, (22)
    SparseMatrix aDN;  ///< r_1 in free flight, (24)
    SparseMatrix bDN;  ///< r_2 in free flight, (25)
};

/// \throws std::invalid_argument if cells is not in 1..maxEquationCells.
[[nodiscard]] ExtendedWaves extendedWaves(std::int64_t cells);

/// Largest N these matrices are built for.
inline constexpr std::int64_t maxEquationCells = 10'000'000;

/// The 2N x 2N maps of (29): state after `count` steps of contact (DD).
/// \throws std::invalid_argument if cells is not in 1..maxEquationCells or count < 0.
[[nodiscard]] SparseMatrix contactMap(std::int64_t cells, std::int64_t count);
/// The same for free flight (DN).
[[nodiscard]] SparseMatrix freeMap(std::int64_t cells, std::int64_t count);

/// W of (30), 2N x 2N: one period. A signed permutation.
/// \throws std::invalid_argument on an invalid schedule or one with N > maxEquationCells.
[[nodiscard]] SparseMatrix periodMap(const Schedule& schedule);

/// The left side of (31) times N/g, 1 x 2N: sum(b_i - a_i). Its right side is N.
[[nodiscard]] SparseMatrix gapRow(std::int64_t cells);

/// The tip in each step, in terms of the state at t = 0: one row per step, one entry +-1 per row.
struct TipRows {
    SparseMatrix pressure;  ///< (10): s(L)/2 in each contact step, all phases in turn
    SparseMatrix velocity;  ///< v(L)/(2c) in each free step, all phases in turn: what (12) adds up
};

/// O(n + N) memory. \throws std::invalid_argument on an invalid schedule, N > maxEquationCells, or
/// more than 10^8 entries.
[[nodiscard]] TipRows tipRows(const Schedule& schedule);

/// C of (32), C x <= 0, one row per step. The paper writes N rows for each time step, and (11) as a
/// step of its own; since the waves are constant on cells, the tip strain does not change inside a
/// step and the tip displacement is linear in it, so N - 1 of the N rows repeat or lie between
/// their neighbours, and (11) is the first row of (12).
struct Inequalities {
    SparseMatrix pressure;     ///< (10): s(L)/2 in each contact step, all phases in turn
    SparseMatrix penetration;  ///< (12): (u(L) - g) N/(2g) after each free step, all phases in turn
};

/// Same errors as `tipRows`; the prefix rows have up to 2N entries each.
[[nodiscard]] Inequalities inequalities(const Schedule& schedule);

}  // namespace signorini
