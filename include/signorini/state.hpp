#pragma once
/// \file
/// The state of the bar at one instant: two travelling waves, constant on each cell.
///
/// Equation (26) gives r_1, r_2 the constant values a_i, b_i on cell i. The state keeps them scaled
/// so that
///
///     v/c = a + b,   s = b - a,
///
/// that is, without the factor 1/sqrt(1 + c^2) of (14), and in units of g/L: every number of the
/// library is dimensionless, and only files, figures and `Scales` know metres and seconds.

#include <Eigen/Core>
#include <cstdint>

namespace signorini {

/// Right-going and left-going wave, N values each; cell i of the paper is entry i - 1.
struct State {
    Eigen::VectorXd a;  ///< [g/L], right-going wave r_1
    Eigen::VectorXd b;  ///< [g/L], left-going wave r_2

    /// N.
    [[nodiscard]] std::int64_t cells() const { return a.size(); }

    friend bool operator==(const State&, const State&) = default;
};

/// v on each cell, in units of c g/L. O(N).
[[nodiscard]] Eigen::VectorXd velocity(const State& state);

/// s = u_x on each cell, in units of g/L. O(N).
[[nodiscard]] Eigen::VectorXd strain(const State& state);

/// u at x_i = i dx, i = 1..N, in units of g; u(0) = 0. The last entry is the tip. O(N).
[[nodiscard]] Eigen::VectorXd displacement(const State& state);

/// E/E_1 = (2/N) sum(a_i^2 + b_i^2); conserved by contact and free steps alike. O(N).
[[nodiscard]] double energyRatio(const State& state);

/// The same state on a grid with `factor` >= 1 times as many cells; a schedule with `factor` times
/// as many steps then gives the same motion, drawn finer. O(factor N).
[[nodiscard]] State refined(const State& state, std::int64_t factor);

/// max |a_i|, |b_i|: the size that residuals are relative to. O(N).
[[nodiscard]] double amplitude(const State& state);

}  // namespace signorini
