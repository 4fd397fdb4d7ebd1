#pragma once
/// \file
/// What a claim is worth, judged independently of the solvers: residuals and march of
/// verification.hpp, the distance to the exact solution set, the energy. One rule for all.

#include "problems.hpp"
#include "record.hpp"
#include "signorini/motion.hpp"

namespace signorini::bench {

/// A point may be worse than the tolerance asked for by this much and still be right: solvers
/// measure rows, we measure motions.
inline constexpr double allowance = 10.0;
/// From here on a point is wrong rather than inaccurate; x = 0 has an error of 1.
inline constexpr double wrongFrom = 1e-2;

/// Judges a motion that was claimed to answer the problem: residuals, distance and energy, and the
/// outcome they give.
void judgeFound(const Problem& problem, const State& state, double tolerance, Record& record);

/// Judges the claim that there is none.
void judgeNone(const Problem& problem, Record& record);

}  // namespace signorini::bench
