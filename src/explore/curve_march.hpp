#pragma once
/// \file
/// Curves of motions of one energy by nonlinear programs: whatever the motions are of.
///
/// Neighbours on a curve are at most a resolution apart, and the motion nearest to the middle
/// between two neighbours is near the middle: isolated motions never pass for a curve.

#include <algorithm>
#include <cstdint>
#include <string>

#include "solver.hpp"

namespace signorini {

/// In which a motion is landed on, that its residual may be `tolerance`: a back end takes no finer.
[[nodiscard]] inline double landingTolerance(double tolerance)
{
    constexpr double finest = 1e-12;
    return std::max(finest, 0.01 * tolerance);
}

/// What a back end must be able to do here.
inline constexpr Capabilities continuumNeeds{
    .quadraticObjective = true, .energyEquality = true, .start = true};

/// Motions of one energy as unknowns x, and the curve that is made of them.
class CurveOfMotions {
public:
    CurveOfMotions() = default;
    CurveOfMotions(const CurveOfMotions&) = delete;
    CurveOfMotions& operator=(const CurveOfMotions&) = delete;
    virtual ~CurveOfMotions() = default;

    /// The motion nearest to some unknowns.
    [[nodiscard]] virtual SolverResult land(const Eigen::VectorXd& predicted) = 0;
    /// In the norm of the energy.
    [[nodiscard]] virtual double distance(const Eigen::VectorXd& x,
                                          const Eigen::VectorXd& y) const = 0;
    /// False: known to lie in different components.
    [[nodiscard]] virtual bool mayJoin(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const
    {
        return x.size() == y.size();
    }
    /// Verifies a motion and adds it to the curve; false if the curve ends here, undecided.
    [[nodiscard]] virtual bool keep(const Eigen::VectorXd& x) = 0;
    /// Forgets all that was kept.
    virtual void restart() = 0;
    /// Length of the curve so far.
    [[nodiscard]] virtual double reached() const = 0;
    [[nodiscard]] virtual bool isCancelled() = 0;
    /// Undecided.
    virtual void stop(std::string why) = 0;
    /// Found.
    virtual void finish() = 0;
    [[nodiscard]] virtual bool isFinished() const = 0;
};

/// What is asked of a curve.
struct MarchOptions {
    std::int64_t points = 201;
    double resolution = 0.05;  ///< of neighbours, over the norm of a motion
    double tolerance = 1e-7;   ///< in which the end is met, likewise
    double norm = 1.0;         ///< of all motions: the root of their energy
};

/// From one motion to another, in steps that are made shorter where the set bends or ends.
void marchTo(CurveOfMotions& curve, const MarchOptions& options, Eigen::VectorXd start,
             Eigen::VectorXd end);

/// From a motion to another one of the solver's choice, which differs with the seed. It may lie in
/// another component: then others are tried, each nearer.
void joinMembers(CurveOfMotions& curve, const MarchOptions& options, const Eigen::VectorXd& start,
                 std::uint64_t seed);

}  // namespace signorini
