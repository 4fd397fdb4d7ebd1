#pragma once
/// \file
/// Enclosed numbers say that no motion with one contact under a harmonic is left out.
///
/// Contact [0, tau), tau = (j + sigma) h: for each j the waves are those of two chains, enclosed
/// anew in discs, and what is unknown is one number, theta = omega sigma h where the release is
/// smooth, the argument of A where a front ends it (docs/theory.md, section 21, "The release"). Its
/// range is halved until on each part the gap is not met, a push or the place of the tip is seen to
/// be wrong, or the part lies in the box in which `enclosed` proved that a motion is alone. Nothing
/// is solved, so no root is missed, double ones neither.

#include <optional>
#include <span>
#include <string>

#include "harmonic_proof.hpp"
#include "signorini/control.hpp"

namespace signorini {

/// A motion with one contact and what was proved of it.
struct ProvedHarmonic {
    const HarmonicMotion* motion = nullptr;
    double aloneWithin = 0.0;
};

/// Largest nu + w for which it is tried.
inline constexpr std::int64_t mostCompleteCells = 4'000;

/// Of all motions with one contact in a period.
struct HarmonicCompleteness {
    /// [L/c]: none that flies as long, or longer, is left out; 0: none at all is.
    std::optional<double> flight;
    std::string why;  ///< there is no such time
    /// May the tip stay on a stop for good? Then in as many ways as there are waves that rest
    /// beside it; nothing where rounding does not tell.
    std::optional<bool> rests;
};

/// Of the motions given. In a flight shorter than h the tip does not move: each chain flies at most
/// once, and what that leaves of its wave has R = 0 there. Only where nu divides K and the base
/// moves it may; then there are none at a stop beyond the tip at rest if V h^2/4 < |place| T, V the
/// largest speed of such a flight: the mean of u(L, t) is that of the pushes, and they push it
/// back. With no flight r is what the base sends and, the same at all visits, as much as keeps
/// R >= 0, or more: the tip may rest on a stop at -d, pressed there at rest, if
///
///     |A| q (mu/pi) sin(pi/mu) <= d,   mu = nu/gcd(K, nu),   q = 1, or omega/|sin omega| (base).
///
/// O((nu + w) nu), and O(nu) for each part of a range that holds a root.
[[nodiscard]] HarmonicCompleteness complete(const HarmonicCase& given,
                                            std::span<const ProvedHarmonic> known,
                                            const Cancel& cancel = {});

}  // namespace signorini
