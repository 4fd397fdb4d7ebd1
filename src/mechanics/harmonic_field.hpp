#pragma once
/// \file
/// u, v and s of a motion under a harmonic, anywhere and at any time: with y the base,
///
///     u(x, t) = y(t + x) - the integral of r from t + 1 - x to t + 1 + x,
///     v = V(t + x) - r(t + 1 + x) + r(t + 1 - x),   s = V(t + x) - r(t + 1 + x) - r(t + 1 - x).

#include "harmonic_motion.hpp"

namespace signorini {

class HarmonicField {
public:
    HarmonicField(HarmonicCase given, HarmonicMotion motion);

    [[nodiscard]] double period() const { return given_.period(); }
    /// Units of g, c g/L and g/L; x from 0 to 1, t in L/c, any. O(log pieces).
    [[nodiscard]] double displacement(double x, double t) const;
    [[nodiscard]] double velocity(double x, double t) const;
    [[nodiscard]] double strain(double x, double t) const;
    /// Force on the stop that is touched [EA g/L], negative on the second one; 0 in flight.
    [[nodiscard]] double push(double t) const;
    [[nodiscard]] const HarmonicMotion& motion() const { return motion_; }

private:
    [[nodiscard]] double arriving(double t) const;
    /// Of r, from 0.
    [[nodiscard]] double integral(double t) const;
    [[nodiscard]] std::size_t pieceAt(double t) const;

    HarmonicCase given_;
    HarmonicMotion motion_;
    std::complex<double> base_;  ///< y(t) of e^{i omega t}
    std::vector<double> sums_;   ///< of r up to the start of each piece, and of a period
};

}  // namespace signorini
