#pragma once
/// \file
/// All forced, damped motions of one schedule with one contact phase: a line, cut by rows.
///
/// The excitation is C shape_0 + S shape_1, and with damping so is what arrives at the tip:
/// p = C p^0 + S p^1, each sequence the only fixed point of a contraction. What is left of the
/// problem is u(L, 0) = g, a line in the plane of (C, S), and rows that cut it. docs/theory.md,
/// section 15.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "signorini/simulation.hpp"

namespace signorini {

/// A vector of the plane of (C, S).
struct Plane {
    double c = 0.0;
    double s = 0.0;

    friend Plane operator+(Plane x, Plane y) { return {x.c + y.c, x.s + y.s}; }
    friend Plane operator-(Plane x, Plane y) { return {x.c - y.c, x.s - y.s}; }
    friend Plane operator*(double factor, Plane x) { return {factor * x.c, factor * x.s}; }
    [[nodiscard]] double dot(Plane y) const { return c * y.c + s * y.s; }
};

/// What is left of the line: its points foot + t direction, low <= t <= high. The foot is the point
/// nearest to the origin, the direction has length 1, so the amplitude is hypot(|foot|, t).
struct ForcedLine {
    Plane foot;
    Plane direction;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    std::int64_t lowRow = -1;    ///< steps whose rows are met with equality there; -1: none
    std::int64_t highRow = -1;   ///< see lowRow
    bool hasLine = true;         ///< false: u(L, 0) is 0 for any C, S, but for rounding
    bool isBlocked = false;      ///< a row parallel to the line is met nowhere on it ...
    std::int64_t blocking = -1;  ///< ... of such rows the one that is missed by most

    [[nodiscard]] bool isEmpty() const { return !hasLine || isBlocked || low > high; }
    [[nodiscard]] Plane at(double t) const { return foot + t * direction; }
};

/// The sequences of one number of steps and every number of contact steps, one after the other:
/// a further contact step changes one class only.
class ForcedWaves {
public:
    /// \pre one or two shapes of n steps with N steps per crossing, 0 < rho <= 1.
    ForcedWaves(std::int64_t cells, double rho, std::span<const Excitation> shapes);

    /// From the present number of contact steps (0 at first) to another one. O(n) for each step
    /// of the way at most, O(n/G) as a rule.
    void setContact(std::int64_t contact);

    /// Classes that never fly: each keeps an amplitude of its own, which the wall bounds from
    /// below. Their waves are set to where R is 0 on average, the least there can be: then `line`
    /// is empty only if there is no motion, but its points need not be motions.
    [[nodiscard]] std::int64_t heldClasses() const { return held_; }
    /// Classes that fly and nothing damps: their amplitudes are free and not solved for.
    [[nodiscard]] std::int64_t undampedClasses() const { return undamped_; }
    /// p^0_m, p^1_m. \pre there are no undamped classes.
    [[nodiscard]] Plane wave(std::int64_t m) const { return p_[static_cast<std::size_t>(m)]; }
    /// F + 2p in step m.
    [[nodiscard]] Plane push(std::int64_t m) const
    {
        return force_[static_cast<std::size_t>(m)] + 2.0 * wave(m);
    }
    /// u(L, m) [g]. O(N).
    [[nodiscard]] Plane tip(std::int64_t m) const;

    /// The line and what its rows leave of it. O(n); `isHasty`: ends when nothing is left.
    [[nodiscard]] ForcedLine line(bool isHasty);

private:
    struct Cut;
    enum class ClassKind : std::uint8_t { damped, held, undamped };
    void solveClass(std::int64_t first);

    std::int64_t cells_;
    std::int64_t steps_;
    std::int64_t classes_;
    std::int64_t contact_ = 0;
    std::int64_t held_ = 0;
    std::int64_t undamped_ = 0;
    double rho_;
    bool isPlane_;
    std::vector<Plane> force_;     ///< F
    std::vector<Plane> fromBase_;  ///< what every step adds to the wave of 2N steps later ...
    std::vector<Plane> fromTip_;   ///< ... and what a step in flight adds
    std::vector<Plane> place_;     ///< y
    std::vector<Plane> p_;
    std::vector<ClassKind> kinds_;
    std::array<std::int64_t, 2> lastRows_ = {-1, -1};  ///< of the last line
};

}  // namespace signorini
