#include "minimum_error.hpp"

#include <cmath>
#include <limits>

namespace signorini {

std::optional<double> minimumError(const Program& program, const Eigen::VectorXd& x,
                                   const Solver& linear, const SolverOptions& options)
{
    Program tangent = program;
    tangent.linear = program.linear + program.quadratic.cwiseProduct(x);
    tangent.quadratic.resize(0);
    const SolverResult lowest = linear.solve(tangent, options);
    if (lowest.status == SolverStatus::unbounded) {
        return std::numeric_limits<double>::infinity();
    }
    if (lowest.status != SolverStatus::optimal) {
        return std::nullopt;
    }
    // Rows met within a tolerance only can turn the sign: its size is the error all the same.
    const double rounding = 1e-15 * tangent.linear.cwiseAbs().dot(x.cwiseAbs());
    const double gap = std::abs(tangent.linear.dot(x - lowest.x)) + rounding;
    return std::sqrt(gap / program.quadratic.dot(x.cwiseAbs2()));
}

}  // namespace signorini
