#pragma once
/// \file
/// Enclosed numbers say that there is a motion under a harmonic, and only one, near given numbers.
///
/// Read of a motion are phase, begin, end and stop of its contacts, and which releases a front ends
/// after which travel; its waves are not. Waves are enclosed anew on every piece of every cell
/// (harmonic_motion.hpp), where they depend on the pattern alone. With y the phase and the times
/// that are free, f(y) = 0 the gaps and the smooth releases, M near the inverse of f', Krawczyk's
///
///     y - M f(y) + (I - M f'(Y))(Y - y)  within  Y
///
/// says that there is one root in the box Y, and only one. On it all signs are enclosed: the push
/// in contact, before and after a release, the way of the tip in flight. docs/theory.md, section
/// 21.

#include <string>

#include "harmonic_motion.hpp"

namespace signorini {

/// What was proved.
struct HarmonicProof {
    bool isProved = false;
    /// [L/c, and rad of the phase], the motion is no further away from the numbers.
    double within = 0.0;
    /// [L/c, rad]: so near there is no other of these contacts, stops and fronts.
    double aloneWithin = 0.0;
    std::string why;  ///< it is not proved
};

/// O(K nu). Not proved are motions with a release or a contact that only just is one, and those
/// where fronts of two contacts meet at one instant.
[[nodiscard]] HarmonicProof enclosed(const HarmonicCase& given, const HarmonicMotion& motion);

}  // namespace signorini
