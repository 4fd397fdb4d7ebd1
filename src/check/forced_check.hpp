#pragma once
/// \file
/// Checks of forced, damped motions by code that did not find them: the rows of a schedule and a
/// march that decides contact by itself, both on the cells of the bar, and proofs of absence.

#include <cstdint>
#include <span>
#include <vector>

#include "signorini/motion.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// What a walk over one period of the excitation saw. Residuals are relative, 0 for a motion.
struct ForcedWalk {
    double periodicity = 0.0;  ///< change of the state / its largest value
    double gap = 0.0;          ///< |u(L, 0) - g| / g
    double pressure = 0.0;     ///< largest tension between tip and wall / largest value
    double penetration = 0.0;  ///< depth of the tip inside the wall / g
    double balance = 0.0;      ///< work of the excitation - dissipation / the larger
    double march = 0.0;        ///< the march that knows no schedule: change of the state, or depth
    double impulse = 0.0;      ///< int R dt [EA g/c]
    double peakForce = 0.0;    ///< max R [EA g/L]
    double lowest = 0.0;       ///< min u(L) [g]

    [[nodiscard]] double worst() const;
};

/// Walks a state along the schedule (contact, n - contact), and marches it. O(n + N).
/// `tolerance`: how near the wall counts as there [g].
/// \pre N cells = steps per crossing; the excitation has n >= contact steps.
[[nodiscard]] ForcedWalk walkForced(const State& state, std::int64_t contact,
                                    const Damping& damping, const Excitation& excitation,
                                    double tolerance = 1e-9);

/// A condition of a schedule: in contact F + 2p >= 0 in this step; in flight sum of F + 2p from
/// the start of flight to this step <= 0.
struct ForcedRow {
    bool isContact = false;
    std::int64_t step = 0;

    friend bool operator==(const ForcedRow&, const ForcedRow&) = default;
};

/// Do the rows, at most two, forbid any excitation C shape_0 + S shape_1 to bring the tip to the
/// wall? True only if it is certain: -(gap row) is a combination of the rows with factors > 0, and
/// the signs of the factors hold for every rounding of what they are computed from, the numbers
/// of the shapes and rho. O(n). \pre all shapes have as many steps.
[[nodiscard]] bool forbidsContact(std::int64_t cells, std::int64_t contact, double rho,
                                  std::span<const Excitation> shapes,
                                  std::span<const ForcedRow> rows);

}  // namespace signorini
