#pragma once
/// \file
/// One interface to every back end, and the table of those this library was built with.
///
/// A solver receives a Program and options, and answers with a status and a point. What it claims
/// is recomputed here before it is passed on: a point whose violation exceeds the tolerance is
/// never "optimal". A badly scaled program reaches the back end in its own units, rescaled by
/// powers of two. Solvers hold no state between calls; one object may be used from one thread.

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"
#include "signorini/control.hpp"

namespace signorini {

/// What a solver says of a program.
enum class SolverStatus {
    notRun,      ///< `solve` was not called
    optimal,     ///< x meets every row within the tolerance and minimises the objective
    infeasible,  ///< the solver found that no x meets the rows; a claim, not a proof
    unbounded,   ///< the objective has no lower bound
    limit,       ///< an iteration or time limit was reached first
    cancelled,   ///< `SolverOptions::cancel` was requested
    failed,      ///< anything else; `detail` says what
};

/// "not run", "optimal", "infeasible", "unbounded", "limit", "cancelled", "failed".
[[nodiscard]] std::string_view name(SolverStatus status);

/// Settings that all back ends share. One that a back end cannot honour is refused by name.
struct SolverOptions {
    /// Largest relative violation of a row or bound (see `violation`); smaller costs iterations.
    double tolerance = 1e-7;
    /// [-], most iterations; 0: no limit.
    std::int64_t iterationLimit = 0;
    /// [s], wall time; infinite: no limit.
    double timeLimit = std::numeric_limits<double>::infinity();
    /// Where to start; empty: the back end's own choice.
    std::optional<Eigen::VectorXd> start = std::nullopt;
    /// Ask it to stop from another thread.
    Cancel cancel = {};
};

/// Outcome of one call. Invariant: `x` has n values when the status is optimal.
struct SolverResult {
    SolverStatus status = SolverStatus::notRun;             ///< recomputed claim
    std::string detail = "the solver has not been called";  ///< for people: the native verdict
    Eigen::VectorXd x;       ///< the point, or the last iterate, or empty
    double objective = 0.0;  ///< recomputed at x
    double violation = 0.0;  ///< recomputed at x
    /// Multipliers y (p values) and mu (q values, <= 0) of an optimal x, from back ends with
    /// `Capabilities::duals`; empty otherwise. The reduced costs c - equalities^T y -
    /// inequalities^T mu are >= 0 where x is at its lower bound, <= 0 at its upper, else 0: y_i is
    /// what the objective gains per unit of equalityRhs_i.
    Eigen::VectorXd equalityDuals;
    Eigen::VectorXd inequalityDuals;  ///< see equalityDuals
    std::int64_t iterations = 0;      ///< [-], as the back end counts them
    double setupSeconds = 0.0;        ///< [s], handing the program over
    double solveSeconds = 0.0;        ///< [s], inside the library
};

/// What a back end can be asked for, and what a request needs of it.
struct Capabilities {
    bool quadraticObjective = false;    ///< Program::quadratic
    bool energyEquality = false;        ///< Program::energy
    bool detectsInfeasibility = false;  ///< may answer "infeasible" after a search for a point
    bool duals = false;                 ///< fills the multipliers of a linear program
    bool iterationLimit = false;        ///< SolverOptions::iterationLimit
    bool timeLimit = false;             ///< SolverOptions::timeLimit
    bool start = false;                 ///< SolverOptions::start
    bool cancel = false;                ///< SolverOptions::cancel

    bool operator==(const Capabilities&) const = default;
};

/// What a program needs of a back end.
[[nodiscard]] Capabilities needsOf(const Program& program);

/// Everything that is needed can be had.
[[nodiscard]] bool covers(const Capabilities& can, const Capabilities& needs);

/// The kinds of program that a back end is chosen for where nobody names one.
struct Choice {
    bool linear = false;
    bool quadratic = false;   ///< a quadratic objective, no energy equality
    bool heldEnergy = false;  ///< an energy equality
};

class Solver;

/// One row of the table in solvers/backends.cpp: all that is known of a back end, said once.
struct Backend {
    std::string_view name = {};          ///< as in --solver, e.g. "glpk-simplex"
    std::string_view library = {};       ///< e.g. "GLPK"; empty: part of signorini
    std::string_view option = {};        ///< CMake option that switches it, or empty
    std::string_view purpose = {};       ///< one line for people
    Capabilities can = {};               ///< what it can be asked for
    std::int64_t mostUnknowns = 0;       ///< [-], variables beyond the equalities; 0: any number
    Choice chosenFor = {};               ///< of several rows, the first in this build
    std::string (*version)() = nullptr;  ///< version of the library; null: not in this build
    /// A solver of this row; null for closed-form, which reads schedules directly.
    std::unique_ptr<Solver> (*make)(const Backend& row) = nullptr;

    /// Is it in this build?
    [[nodiscard]] bool available() const { return version != nullptr; }
};

/// A back end, ready to solve.
class Solver {
public:
    explicit Solver(const Backend& row) : row_(row) {}
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;
    virtual ~Solver() = default;

    /// What the table says of it.
    [[nodiscard]] const Backend& row() const { return row_; }
    [[nodiscard]] std::string_view name() const { return row_.name; }
    [[nodiscard]] const Capabilities& capabilities() const { return row_.can; }

    /// Validates, refuses what the back end cannot do, rescales if needed, solves, recomputes what
    /// was claimed.
    /// \throws std::invalid_argument on a malformed program, an option out of range or one that
    /// this back end does not support; std::bad_alloc where memory is short, in the library, too.
    [[nodiscard]] SolverResult solve(const Program& program,
                                     const SolverOptions& options = {}) const;

private:
    /// The library call: fills everything but objective and violation. The program may be a scaled
    /// copy: texts may quote relative numbers only.
    [[nodiscard]] virtual SolverResult run(const Program& program,
                                           const SolverOptions& options) const = 0;

    Backend row_;
};

/// All back ends known to the project, in this build or not.
[[nodiscard]] std::span<const Backend> backends();

/// What --version prints: which version this is, and all back ends, a line each.
[[nodiscard]] std::string versionText();

/// The row of that name.
/// \throws std::invalid_argument for an unknown name, listing the known ones.
[[nodiscard]] const Backend& findBackend(std::string_view name);

/// The rows chosen for programs with these needs, in order, in this build or not.
[[nodiscard]] std::vector<const Backend*> candidates(const Capabilities& needs);

/// The first candidate in this build; null if there is none.
[[nodiscard]] const Backend* preferred(const Capabilities& needs);

/// The same where there must be one. \throws BackendUnavailable, listing the candidates.
[[nodiscard]] const Backend& choose(const Capabilities& needs);

/// \throws std::invalid_argument for a row that solves no programs, BackendUnavailable for one that
/// this build does not contain.
[[nodiscard]] std::unique_ptr<Solver> makeSolver(const Backend& backend);

/// The same for the row of that name. \throws std::invalid_argument for an unknown name.
[[nodiscard]] std::unique_ptr<Solver> makeSolver(std::string_view name);

}  // namespace signorini
