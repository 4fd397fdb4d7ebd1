#pragma once
/// \file
/// What the three GLPK back ends share: handing a program over, reading verdict and point back.

#include "common/meaning.hpp"
#include "glpk/guarded.hpp"
#include "solver.hpp"
#include "stopwatch.hpp"

namespace signorini::glpk {

/// The linear part of a program: rows 1..p are the equalities, p+1..p+q the inequalities, and a
/// last one without bounds, because GLPK refuses to solve a problem without rows. `problem` must be
/// new. \throws std::invalid_argument if it exceeds what GLPK accepts, std::bad_alloc.
void fill(Problem& problem, const Program& program);

/// Runs `call`, see Problem::run, and notes its time from the start of `watch`. False if it was
/// cancelled, as the result then says.
template <typename Call>
[[nodiscard]] bool finishes(Problem& problem, Call call, const Stopwatch& watch,
                            SolverResult& result)
{
    try {
        problem.run(call);
    } catch (const Cancelled&) {
        result.status = SolverStatus::cancelled;
        result.detail = "cancelled";
    }
    result.solveSeconds = watch.seconds();
    return result.status != SolverStatus::cancelled;
}

/// Of what glp_simplex or glp_exact returned, and of glp_get_status after a 0.
[[nodiscard]] Meaning simplexMeaning(int code, glp_prob* problem);

/// Reads n values and the multipliers of p + q rows, where `value` and `dual` are GLPK's accessors
/// of the method used, e.g. glp_get_col_prim and glp_get_row_dual. GLPK's multipliers have the sign
/// documented in SolverResult.
void readPoint(glp_prob* problem, const Program& program, double (*value)(glp_prob*, int),
               double (*dual)(glp_prob*, int), SolverResult& result);

}  // namespace signorini::glpk
