#pragma once
/// \file
/// What the pieces of a motion under a harmonic say, and nothing else of what found it.
///
/// Units as in harmonic_contact.hpp. On each piece the push, the way of the tip and the strain at
/// base and tip are one harmonic (and a constant), of which extremes are known. Inside the bar
/// s = B(t + 1 + x) - r(t + 1 - x), B(t) = V(t - 1) - r(t) what has left the tip 2L/c before: the
/// largest s where B is largest and r least on their own no more than 2L/c apart, or at an end.

#include <complex>
#include <cstdint>

#include "harmonic_contact.hpp"

namespace signorini {

/// e^{2 pi i part/whole}.
[[nodiscard]] std::complex<double> turnOf(std::int64_t part, std::int64_t whole);

/// What is given, on cells of h; amplitudes are for A = 1.
struct HarmonicCase {
    using Complex = std::complex<double>;

    std::int64_t back = 1;    ///< w
    std::int64_t cells = 1;   ///< nu
    std::int64_t cycles = 1;  ///< K
    double step = 0.0;        ///< h
    double omega = 0.0;
    double rho = 1.0;
    double amplitude = 0.0;  ///< |A|
    bool isForce = true;
    Stops stops = {};

    [[nodiscard]] double period() const { return step * static_cast<double>(cells); }
    /// 1/(1 + eta).
    [[nodiscard]] double admittance() const { return 0.5 * (1.0 + rho); }
    /// f.
    [[nodiscard]] double force() const { return isForce ? 1.0 : 0.0; }
    /// y(t + 1), and V(t + 1), what the base adds to r(t + 2).
    [[nodiscard]] Complex place() const { return isForce ? 0.0 : turnOf(cycles * back, 2 * cells); }
    [[nodiscard]] Complex fromBase() const { return Complex(0.0, omega) * place(); }
    /// r(t + 2) of r = wave.
    [[nodiscard]] Complex after(Complex wave, bool isContact) const
    {
        return fromBase() + (isContact ? wave : -rho * wave - admittance() * force());
    }
    /// e^{i omega m h}.
    [[nodiscard]] Complex inCells(std::int64_t m) const { return turnOf(cycles * m, cells); }
};

/// Fills in extremes and residual; strains only where the residual is one of a motion. \pre contact
/// time, phase and pieces are there. O(nu log nu), strains O(nu^2).
void measure(const HarmonicCase& given, HarmonicMotion& motion);

}  // namespace signorini
