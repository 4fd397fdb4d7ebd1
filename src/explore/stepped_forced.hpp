#pragma once
/// \file
/// Forced, damped motions of one schedule of a bar of several segments.
///
/// A period of n steps takes a state x to W x + C f_0 + S f_1, and with damping W is a contraction:
/// x = C x_0 + S x_1, (1 - W) x_i = f_i. What is left is as for a uniform bar (response.hpp): u(L,
/// 0) = g is a line in the plane (C, S), and R >= 0 and u(L) <= g cut it. The dashpot at the tip is
/// that of a uniform bar of the first material. docs/theory.md, section 19.

#include <vector>

#include "forced_line.hpp"
#include "signorini/response.hpp"
#include "stepped_bar.hpp"

namespace signorini {

/// Largest number of cells: a matrix of 2N x 2N is factored.
inline constexpr std::int64_t maxForcedCells = 1000;

class SteppedForced {
public:
    /// O(N^3 + n N). \throws std::invalid_argument on an invalid schedule, scene, damping or
    /// forcing, a gap that is not > 0, a second stop, a shape, more than maxForcedCells cells or
    /// maxSteppedSteps steps.
    SteppedForced(const Schedule& schedule, const Scene& scene, const Damping& damping,
                  const Forcing& forcing);

    /// What is left of the plane. Status none is not claimed, as rounding is not enclosed: then it
    /// is undecided, and `detail` says so; also where hardly anything damps some waves.
    [[nodiscard]] const ForcedSet& set() const { return set_; }
    /// The motion at (C, S) = foot + t direction, marched by a simulation that decides contact by
    /// itself. O(n N). \pre the set is not empty.
    [[nodiscard]] ForcedMotion at(double t) const;
    /// \pre the set is not empty.
    [[nodiscard]] ForcedMotion leastAmplitude() const;
    /// At most two, by ascending impulse. \pre the set is not empty.
    [[nodiscard]] std::vector<ForcedMotion> ofAmplitude(double amplitude) const;

private:
    /// What a step sees of an excitation.
    struct Step {
        Plane push;  ///< R in contact
        Plane tip;   ///< u(L) at its end
    };

    [[nodiscard]] bool solve();
    [[nodiscard]] Plane watch();
    void cut(Plane gap);
    void bound(Plane row, double limit, bool isEquality);

    SteppedBar bar_;
    ForcedSet set_;
    std::vector<Excitation> shapes_;
    std::vector<bool> isContact_;  ///< of each step
    std::vector<State> states_;    ///< x_0, x_1
    std::vector<Step> steps_;
};

}  // namespace signorini
