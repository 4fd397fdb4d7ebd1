#pragma once
/// \file
/// Motions of a network under an exact harmonic with any contacts in a period, from a start nearby.
///
/// A pattern says which contacts there are and which release a front ends: that is whole steps
/// after the beginning of contact at which the front left. Each beginning and each smooth release
/// has a place of its own in a step, and these places cut a step into lanes (harmonic_network.hpp).
/// In a lane every step has its contacts closed for good, so its waves are A times what (N) comes
/// back to after a period, which depends on the pattern alone. With S smooth releases K + S numbers
/// are open, arg A, c_2 ... c_K, and tau_k where smooth:
///
///     distance(c_k) = gap + Re(A sum over lanes of G_k (e^{i omega to} - e^{i omega from})/(i
///     omega)) = 0,   push(tau_k) = Re(A P_k e^{i omega tau_k}) = 0,
///
/// G_k what waves at t = 0 and rates until c_k make of the distance: Newton converges to rounding.
/// docs/theory.md, section 21.

#include <optional>

#include "harmonic_network.hpp"

namespace signorini {

/// The motion near a start, of which phase and contacts are read, measured; none if Newton
/// does not come to one, or its waves fade too slowly. \pre nothing pulls but the harmonic, and
/// constant forces at bars that drift. O(lanes (n nodes periods + M)) for each pattern tried.
[[nodiscard]] std::optional<NetworkHarmonicMotion> harmonicNear(const HarmonicNetwork& given,
                                                                NetworkHarmonicMotion start);

}  // namespace signorini
