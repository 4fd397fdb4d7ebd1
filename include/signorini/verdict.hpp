#pragma once
/// \file
/// The words in which answers about a schedule are given.

#include <string_view>

namespace signorini {

/// What the mathematics answers.
enum class Status {
    found,      ///< a motion, verified
    none,       ///< no motion, proved
    undecided,  ///< neither; `PeriodicResult::detail` says why
};

/// "found", "none", "undecided".
[[nodiscard]] std::string_view name(Status status);

/// Why no motion exists; the first that applies, in this order.
enum class Reason {
    noLiveClass,  ///< ker(W - 1) = 0: only the bar at rest repeats
    contactSign,  ///< the same amplitude would have to push and to pull on the wall
    penetration,  ///< a prefix sum of (12) is positive whatever the amplitudes
    gap,          ///< the tip cannot be at the wall at t = 0: row (31) reads 0 or < 0 = g
    constraints,  ///< motions exist, but none meets the further demands
};

/// "no-live-class", "contact-sign", "penetration", "gap", "constraints".
[[nodiscard]] std::string_view name(Reason reason);

/// Does the wall feel the motion?
enum class Contact {
    pressing,  ///< positive force at some contact step
    grazing,   ///< the tip touches, the force is zero throughout: a linear motion
};

/// "pressing" or "grazing".
[[nodiscard]] std::string_view name(Contact contact);

/// Both ends of the energies E/E_1 that the motions of a set have.
struct EnergyRange {
    double least = 0.0;  ///< [E_1]
    double most = 0.0;   ///< [E_1]
};

}  // namespace signorini
