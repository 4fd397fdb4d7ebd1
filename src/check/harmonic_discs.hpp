#pragma once
/// \file
/// The numbers of a harmonic case and the waves of its cells, enclosed: what proofs of its motions
/// share (harmonic_proof.hpp, harmonic_complete.hpp).

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "disc.hpp"
#include "harmonic_motion.hpp"

namespace signorini {

/// Units as in harmonic_motion.hpp; the case's own doubles, rho and |A| among them, are exact.
class HarmonicDiscs {
public:
    explicit HarmonicDiscs(const HarmonicCase& given)
        : given_(given),
          place_(given.place(), angleError),
          integrate_({0.0, -1.0 / given.omega}, 4.0 * relativeError / given.omega)
    {
    }

    /// e^{i angle} of all angles up to `within` away.
    [[nodiscard]] static Disc turn(double angle, double within = 0.0)
    {
        const double turns = std::abs(angle) / (4.0 * std::numbers::pi);
        return {turned(angle), angleError * std::max(1.0, turns) + within};
    }

    /// y(t + 1) of A = 1.
    [[nodiscard]] const Disc& place() const { return place_; }
    /// 1/(i omega).
    [[nodiscard]] const Disc& integrate() const { return integrate_; }
    /// i omega z.
    [[nodiscard]] Disc slope(const Disc& z) const
    {
        return Disc({0.0, given_.omega}, relativeError * given_.omega) * z;
    }
    /// R of r = wave, both of A = 1 where e^{i omega t} = 1.
    [[nodiscard]] Disc push(const Disc& wave) const
    {
        return Disc(2.0) * wave + Disc(given_.force());
    }

    /// kappa, cell by cell, in contact in those of which isHeld(m) is true: what goes once around
    /// comes back the same. Radii that are not finite: a wave that is always in contact is free.
    /// O(nu).
    template <typename IsHeld>
    [[nodiscard]] std::vector<Disc> waves(const IsHeld& isHeld) const
    {
        const Disc back = {std::conj(given_.inCells(given_.back)), angleError};
        const Disc base = given_.isForce ? Disc(0.0) : slope(place_);
        const Disc force = given_.admittance() * given_.force();
        std::vector<Disc> all(static_cast<std::size_t>(given_.cells));
        Disc factor = 1.0;
        Disc wave = 0.0;
        for (int round = 0; round < 2; ++round) {
            std::int64_t m = 0;
            for (std::int64_t k = 0; k < given_.cells; ++k) {
                const bool isContact = isHeld(m);
                all[static_cast<std::size_t>(m)] = wave;
                wave = back * (base + (isContact ? wave : Disc(-given_.rho) * wave - force));
                if (round == 0) {
                    factor = back * (isContact ? Disc(1.0) : Disc(-given_.rho)) * factor;
                }
                m = (m + given_.back) % given_.cells;
            }
            wave = round == 0 ? wave / (Disc(1.0) - factor) : wave;
        }
        return all;
    }

    static constexpr double angleError = 8e-15;  ///< of an angle below 4 pi, sine and cosine

private:
    static constexpr double relativeError = 1e-15;

    const HarmonicCase& given_;
    Disc place_;
    Disc integrate_;
};

}  // namespace signorini
