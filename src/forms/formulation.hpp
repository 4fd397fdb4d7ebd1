#pragma once
/// \file
/// From a schedule to a Program: which unknowns and which rows a solver gets.
///
/// Three formulations of the same set of motions, each a list of unknowns x, rows, and the delay
/// sequence p (motion.hpp) as a linear function of x:
///
/// **state**: the paper's own, x = (a_1..a_N, b_1..b_N, y_1..y_m). The prefix sums of (12) enter as
/// unknowns y_k, so that every row stays sparse:
///
///     (W - 1)(a, b) = 0,   sum(b - a) = N,   -p_m <= 0 in contact,
///     y_k = y_{k-1} + p_k,   -depth <= y_k <= 0 in flight,   y = 0 at the end of a flight
///
/// With other stops the right sides are those of stops.hpp, and p changes its sign where the second
/// one is touched. Without a gap the size is held by one more equality, sum p over contact = N.
///
/// **reduced**: class amplitudes z (lumped_set.hpp) satisfy (30) by themselves, and inside a block
/// of a pressing type the prefix sums are monotone, so that only block ends count. With S the sum
/// of z over a type, Z_j the partial sums of a grazing type, and P a prefix sum at the end of a
/// block, an integer combination of the S:
///
///     sum windowSum S = -N,   z >= 0 if pressing,   -depth <= P <= 0,   P = 0 at the end of a
///     flight P + epsilon Z_j <= 0 and >= -depth  for the block of a grazing type that follows P,
///     written with two bounds  below <= Z_j <= above  per type, so that rows stay linear in number
///
/// **lumped**: only the S, at most 2K unknowns whatever N is. Every S that the reduced rows allow
/// is reached with equal amplitudes z = S/d, which also have the least energy and the least peak
/// strain for that S.
///
/// The closure of the last flight is left out: periodicity implies it once the others close.

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"
#include "signorini/demands.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// p_m = factor * x[column]; factor 0 where p_m = 0 for every motion.
struct DelayTerm {
    Eigen::Index column = 0;  ///< of the unknown
    double factor = 0.0;      ///< +-1, or +-1/d when lumped
};

/// A program, and how to read a motion out of its unknowns.
struct Formulated {
    Program program;                   ///< rows, bounds, objective
    Schedule schedule;                 ///< folded
    std::vector<DelayTerm> delay;      ///< p_0 .. p_{n-1}
    std::vector<std::string> leftOut;  ///< what the program does not contain, for people
};

/// Poses existence of a motion, without objective. `depth` is how far the tip may retreat from the
/// wall, in units in which a free step with wave p moves it by p (N/2 of them are g); infinite: no
/// bound. O(n + N) time and memory; lumped O(nu K).
/// \throws std::invalid_argument on an invalid or too large schedule, or an automatic formulation.
[[nodiscard]] Formulated formulate(const Schedule& schedule, Formulation formulation,
                                   double depth = std::numeric_limits<double>::infinity());

/// The state at t = 0 of the motion with unknowns x: a_i = p_{N-i}, b_i = -p_{N+i-1}. O(N).
[[nodiscard]] State stateOf(const Formulated& formulated, const Eigen::VectorXd& x);

/// The formulation of least size that answers these demands exactly: lumped unless single
/// amplitudes matter (nearest, fixed values, most energy, held energy), then reduced.
[[nodiscard]] Formulation cheapestFormulation(const Demands& demands);

/// The program of a schedule with the demands: bounds for limits, rows for fixed values, one more
/// unknown for the peak strain, a diagonal objective or energy equality. Most energy is no convex
/// objective and is left out. O(n + N).
/// \throws std::invalid_argument on invalid input, or if `formulation` is lumped and does not do.
[[nodiscard]] Formulated pose(const Schedule& schedule, const Demands& demands,
                              Formulation formulation);

/// (2/N) sum of factor^2 per unknown over the window of 2N steps: E/E_1 = sum weight_i x_i^2.
[[nodiscard]] Eigen::VectorXd energyWeights(const Formulated& formulated);

}  // namespace signorini
