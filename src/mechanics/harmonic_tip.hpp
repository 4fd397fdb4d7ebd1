#pragma once
/// \file
/// The tip of a bar of several segments without stops, under harmonics of a period of n steps.
///
/// With e^{i omega m}, omega = 2 pi k/n, a wave l' that leaves a joint to the left comes back as
/// G l', and with what a moving base sends as S + G l'. Through 2N_i steps of a segment G turns by
/// e^{-2 i omega N_i}, at the clamp it is -1, and a joint with impedances Z_1, Z_2 and a dashpot d
/// makes of it
///
///     ((Z_2 - d)(1 + G) - Z_1 (1 - G))/D,   S to 2 Z_1 S/D,   D = (Z_2 + d)(1 + G) + Z_1 (1 - G).
///
/// At the tip v = S + (1 + G)(F + (Z - eta) S)/(eta (1 + G) + Z (1 - G)). docs/theory.md, section
/// 19.

#include <complex>
#include <cstdint>
#include <vector>

#include "stepped_bar.hpp"

namespace signorini {

class HarmonicTip {
public:
    using Complex = std::complex<double>;

    /// eta [EA/c of the first segment], the dashpot at the tip. O(n).
    HarmonicTip(const SteppedBar& bar, double eta, std::int64_t steps);

    /// e^{2 pi i k/n}.
    [[nodiscard]] Complex turn(std::int64_t k) const;
    /// v for F = e^{2 pi i k m/n}. O(segments).
    [[nodiscard]] Complex speedOfForce(std::int64_t k) const { return speed(k, 1.0, 0.0); }
    /// v for V = e^{2 pi i k m/n} of the base. O(segments).
    [[nodiscard]] Complex speedOfBase(std::int64_t k) const { return speed(k, 0.0, 1.0); }

private:
    [[nodiscard]] Complex speed(std::int64_t k, double force, double base) const;

    const SteppedBar& bar_;
    double eta_;
    std::vector<Complex> turns_;
};

}  // namespace signorini
