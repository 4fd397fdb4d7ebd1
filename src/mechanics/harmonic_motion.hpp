#pragma once
/// \file
/// A motion under an exactly harmonic force or base, contacts of any real length.
///
/// Units L = c = 1, displacements in |g|. The excitation is Re(A e^{i omega t}), K cycles in
/// T = n/N. With G = gcd(2N, n), w = 2N/G, nu = n/G a crossing to and fro takes w cells of time
/// h = 2/w, a period nu, and the wave r that arrives at the tip obeys
///
///     r(t + 2) = r(t) + V(t + 1) in contact,   -rho r(t) - f(t)/(1 + eta) + V(t + 1) in flight,
///
/// the push is R = f + 2r, and u(L, t) = y(t + 1) - the integral of r from t to t + 2.
/// docs/theory.md, section 21.

#include <complex>
#include <cstdint>
#include <vector>

#include "signorini/motion.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// The wave that arrives at the tip up to a time, from the end of the piece before.
struct HarmonicPiece {
    double end = 0.0;           ///< [L/c]
    std::complex<double> wave;  ///< [g/L], r = Re(wave e^{i omega t})
};

/// One contact of a motion.
struct HarmonicContact {
    double begin = 0.0;  ///< [L/c]
    double end = 0.0;    ///< [L/c], begin < end < the next begin
    Stop stop = Stop::right;
    bool isPinned = false;   ///< is it a front that ends it?
    std::size_t front = 0;   ///< the contact at whose beginning that front left
    double travel = 0.0;     ///< [L/c], from there to the end, 2i mod T, on its i-th return
    double impulse = 0.0;    ///< [EA g/c] > 0
    double peakForce = 0.0;  ///< [EA g/L]
    double speed = 0.0;      ///< [c g/L], with which the tip came
};

/// One motion; t = 0 is the start of the first contact.
struct HarmonicMotion {
    double phase = 0.0;                     ///< [rad], of |A| cos(omega t - phase), in ]-pi, pi]
    std::vector<HarmonicContact> contacts;  ///< one period T, ascending, the first from 0
    std::vector<HarmonicPiece> pieces;      ///< one period T
    Extremes extremes;                      ///< of it
    /// [-], the worst defect of law, gap, flight and inequalities, taken from the pieces alone.
    double residual = 0.0;
};

/// Residual of a motion, at most; motions nearer than this to a bound are taken as touching it.
inline constexpr double harmonicTolerance = 1e-9;

/// Largest nu and w.
inline constexpr std::int64_t maxHarmonicCells = 20'000;

/// Most contacts in a period.
inline constexpr std::int64_t maxHarmonicContacts = 60;

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
    [[nodiscard]] Complex place() const;
    [[nodiscard]] Complex fromBase() const { return Complex(0.0, omega) * place(); }
    /// r(t + 2) of r = wave.
    [[nodiscard]] Complex after(Complex wave, bool isContact) const
    {
        return fromBase() + (isContact ? wave : -rho * wave - admittance() * force());
    }
    /// R of r = wave.
    [[nodiscard]] Complex push(Complex wave) const { return 2.0 * wave + force(); }
    /// e^{i omega m h}.
    [[nodiscard]] Complex inCells(std::int64_t m) const;
    /// e^{i omega t}.
    [[nodiscard]] Complex at(double time) const;
    /// u(L) at a stop. \pre it is there.
    [[nodiscard]] double placeOf(Stop stop) const;
};

/// Reads of the harmonic place, amplitude, cycles and the period T = steps/stepsPerCrossing [L/c].
/// \throws std::invalid_argument unless the damping ratio is in ]0, maxDampingRatio], amplitude
/// finite and > 0, stepsPerCrossing whole, cycles, nu and w in 1..maxHarmonicCells.
[[nodiscard]] HarmonicCase harmonicCase(const Damping& damping, const Harmonic& excitation,
                                        const Stops& stops = {});

/// e^{i angle}.
[[nodiscard]] std::complex<double> turned(double angle);
/// e^{2 pi i part/whole}.
[[nodiscard]] std::complex<double> turnOf(std::int64_t part, std::int64_t whole);
/// |z|.
[[nodiscard]] double lengthOf(std::complex<double> z);
/// The angle of z, in ]-pi, pi].
[[nodiscard]] double angleOf(std::complex<double> z);

}  // namespace signorini
