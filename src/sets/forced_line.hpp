#pragma once
/// \file
/// All forced, damped motions of one schedule: a plane of excitations, cut by rows.
///
/// The excitation is C shape_0 + S shape_1, and with damping so is what arrives at the tip:
/// p = C p^0 + S p^1, each sequence the only fixed point of a contraction. What is left of the
/// problem is u(L, 0) = g, a line in the plane of (C, S), and rows that cut it. Where nothing damps
/// the waves of a class of steps, they keep an amplitude z of their own. Other stops change right
/// sides and signs of rows, no waves. docs/theory.md, sections 15 and 17.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "signorini/certificate.hpp"
#include "signorini/schedule.hpp"
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
    std::optional<ForcedCondition> lowRow;   ///< what is met with equality there
    std::optional<ForcedCondition> highRow;  ///< see lowRow
    bool hasLine = true;                     ///< false: u(L, 0) is 0 for any C, S, but for rounding
    /// Of the conditions parallel to the line that are met nowhere on it the one missed by most.
    std::optional<ForcedCondition> blocking;
    bool canRest = false;  ///< is t = 0 the bar at rest, which is not looked for?

    [[nodiscard]] bool isEmpty() const
    {
        return !hasLine || blocking || low > high || (canRest && low == high);
    }
    [[nodiscard]] Plane at(double t) const { return foot + t * direction; }
};

/// A condition as a row: plane . (C, S) + free . z >= limit, or = limit.
struct ForcedRow {
    ForcedCondition condition;
    bool isEquality = false;
    Plane plane;
    /// Which z, counted among the free classes, and its factor.
    std::vector<std::pair<std::size_t, double>> free;
    double limit = 0.0;
};

/// The sequences of one number of steps and any phases; for one phase of every number of contact
/// steps, one after the other: a further contact step changes one class only.
class ForcedWaves {
public:
    /// \pre one or two shapes of n steps with N steps per crossing, 0 < rho <= 1.
    ForcedWaves(std::int64_t cells, double rho, std::span<const Excitation> shapes,
                const Stops& stops = {});

    /// From the present phases to others of n steps in all. O(n/G) for each step that changes.
    void setPhases(std::span<const Phase> phases);

    /// Classes that never fly: each keeps an amplitude of its own, which the wall bounds from
    /// below. Their waves are set to where R is 0 on average, the least there can be: then, if
    /// `boundsHeld`, `line` is empty only if there is no motion, but its points need not be
    /// motions.
    [[nodiscard]] std::int64_t heldClasses() const { return held_; }
    /// Is one stop touched, at a distance that such waves only add to? Then rows scale with the
    /// excitation, the second stop apart.
    [[nodiscard]] bool boundsHeld() const;
    /// Classes that fly and nothing damps: their amplitudes are free as well. Their waves are
    /// those that start from 0.
    [[nodiscard]] std::int64_t undampedClasses() const { return undamped_; }
    /// Both, ascending.
    [[nodiscard]] std::vector<std::int64_t> freeClasses() const;
    /// G, of all classes; step m is one of class m mod G.
    [[nodiscard]] std::int64_t classes() const { return classes_; }
    /// p^0_m, p^1_m.
    [[nodiscard]] Plane wave(std::int64_t m) const { return p_[static_cast<std::size_t>(m)]; }
    /// What a free amplitude of 1 adds to p_m: 1 or -1; 0 where the class of m has none.
    [[nodiscard]] int sign(std::int64_t m) const;
    /// F + 2p in step m.
    [[nodiscard]] Plane push(std::int64_t m) const
    {
        return force_[static_cast<std::size_t>(m)] + 2.0 * wave(m);
    }
    /// u(L, m) [g]. O(N).
    [[nodiscard]] Plane tip(std::int64_t m) const;

    /// The line and what the conditions leave of it, no wave beyond the limit [g/L]. O(n);
    /// `isHasty`: ends when nothing is left. \pre undampedClasses() is 0, and heldClasses(), unless
    /// boundsHeld().
    [[nodiscard]] ForcedLine line(bool isHasty,
                                  double waveLimit = std::numeric_limits<double>::infinity());

    /// All conditions, the place of the tip at t = 0 the first. O(n) rows with as many entries as
    /// there are free classes. One that is 0 >= 0 or 0 = 0 but for rounding is left out.
    [[nodiscard]] std::vector<ForcedRow> rows(double waveLimit) const;

private:
    class RowWriter;
    enum class ClassKind : std::uint8_t { damped, held, undamped };

    [[nodiscard]] ClassKind kindOf(std::int64_t m) const
    {
        return kinds_[static_cast<std::size_t>(m % classes_)];
    }
    void changeStep(std::int64_t m, bool isContact);
    void solveClass(std::int64_t first);
    [[nodiscard]] double sizeOfWaves() const;
    template <typename Visit>
    bool forEachContact(Visit visit) const;
    template <typename Begin, typename Visit>
    bool forEachFlight(Begin begin, Visit visit) const;
    /// That is touched in a step, or was last.
    [[nodiscard]] Stop stopAt(std::int64_t m) const;
    [[nodiscard]] double startPlace() const;
    [[nodiscard]] bool isMirroredMotion() const;

    std::int64_t cells_;
    std::int64_t steps_;
    std::int64_t classes_;
    std::int64_t held_ = 0;
    std::int64_t undamped_ = 0;
    double rho_;
    bool isPlane_;
    Stops stops_;
    double way_;  ///< sum of the pushes of a flight from stop to stop; infinite: one stop
    std::vector<Phase> phases_;
    std::size_t closures_ = 0;     ///< flights that do not close by themselves
    std::vector<bool> isContact_;  ///< of each step
    std::vector<Plane> force_;     ///< F
    std::vector<Plane> fromBase_;  ///< what every step adds to the wave of 2N steps later ...
    std::vector<Plane> fromTip_;   ///< ... and what a step in flight adds
    std::vector<Plane> place_;     ///< y
    std::vector<Plane> p_;
    std::vector<ClassKind> kinds_;
    std::vector<double> grips_;  ///< of damped classes, what a wave loses around them; 1 of others
    std::vector<std::int64_t> changed_;  ///< classes that are to be solved anew
    std::vector<Plane> work_;            ///< of each free class: what its waves gain once around
    std::array<std::optional<ForcedCondition>, 2> lastRows_;  ///< of the last line
};

}  // namespace signorini
