#pragma once
/// \file
/// Motions of a network under an exact harmonic, with contacts of any real length.
///
/// Units of the network: a step is 1. The period is n steps and K cycles. At the times m + s, m =
/// 0, 1, ..., the waves of one s follow the law (N) on their own. The places of all beginnings and
/// ends in their steps cut [0, 1] into lanes, on each of which every step has the same contacts
/// closed for all s, and each wave is a constant and one harmonic of s: a vector of both says all.
/// docs/theory.md, section 21.

#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "network_simulation.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// Waves that nothing damps, and that an excitation feeds without end.
class Resonance : public std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// steady + Re(swing e^{i omega s}); as a number of the law (N), whose coefficients are steady.
struct SteadyHarmonic {
    double steady = 0.0;
    std::complex<double> swing = 0.0;

    SteadyHarmonic() = default;
    explicit SteadyHarmonic(double constant, std::complex<double> harmonic = 0.0)
        : steady(constant), swing(harmonic)
    {
    }

    /// Its value where e^{i omega s} is this.
    [[nodiscard]] double at(std::complex<double> turn) const
    {
        return steady + (swing * turn).real();
    }
    /// What no value exceeds in size.
    [[nodiscard]] double largest() const;

    friend SteadyHarmonic operator+(const SteadyHarmonic& x, const SteadyHarmonic& y)
    {
        return SteadyHarmonic(x.steady + y.steady, x.swing + y.swing);
    }
    friend SteadyHarmonic operator-(const SteadyHarmonic& x, const SteadyHarmonic& y)
    {
        return SteadyHarmonic(x.steady - y.steady, x.swing - y.swing);
    }
    friend SteadyHarmonic operator-(const SteadyHarmonic& x) { return SteadyHarmonic() - x; }
    friend SteadyHarmonic operator*(double factor, const SteadyHarmonic& x)
    {
        return SteadyHarmonic(factor * x.steady, factor * x.swing);
    }
    /// \pre one of them is steady.
    friend SteadyHarmonic operator*(const SteadyHarmonic& x, const SteadyHarmonic& y)
    {
        return SteadyHarmonic(x.steady * y.steady, x.steady * y.swing + y.steady * x.swing);
    }
    /// \pre y is steady.
    friend SteadyHarmonic operator/(const SteadyHarmonic& x, const SteadyHarmonic& y)
    {
        return SteadyHarmonic(x.steady / y.steady, x.swing / y.steady);
    }
};

/// A network and what drives it: its driven nodes, or its shaken clamps.
struct HarmonicNetwork {
    Network network;  ///< constant forces on bars that drift only: gaps are those under others
    Excited place = Excited::tip;
    double amplitude = 1.0;   ///< |A|, of the force, or of the displacement of the base
    std::int64_t steps = 0;   ///< n
    std::int64_t cycles = 1;  ///< K

    [[nodiscard]] double omega() const;
    /// e^{i omega m}.
    [[nodiscard]] std::complex<double> turn(std::int64_t m) const;
    /// The integral of e^{i omega s} from one time to another.
    [[nodiscard]] std::complex<double> weight(double from, double to) const;

    struct Drive {
        std::complex<double> force = 0.0;  ///< on the driven nodes
        std::complex<double> base = 0.0;   ///< velocity of the shaken clamps
    };
    /// What a value of the excitation does.
    [[nodiscard]] Drive drive(std::complex<double> excitation) const;
};

/// \throws std::invalid_argument unless n is in 2..mostSteps, K in 1..n/2 and something is driven.
void requireAsked(const HarmonicNetwork& given, std::int64_t mostSteps);

/// One contact of a motion.
struct NetworkHarmonicContact {
    std::size_t contact = 0;  ///< the one that closes
    double begin = 0.0;       ///< in [0, n)
    double end = 0.0;         ///< > begin; beyond n what goes on in the next period
    bool isPinned = false;    ///< is it a front that ends it?
    double impulse = 0.0;     ///< what follows is measured
    double peakForce = 0.0;
    double speed = 0.0;  ///< with which it closes
};

/// Waves at the times s, from <= s <= to, in the order of Network::waves.
struct HarmonicLane {
    double from = 0.0;
    double to = 1.0;
    std::vector<SteadyHarmonic> waves;
};

/// One motion; t = 0 is where the first contact begins.
struct NetworkHarmonicMotion {
    double phase = 0.0;                            ///< [rad], of |A| cos(omega t - phase)
    std::vector<NetworkHarmonicContact> contacts;  ///< one period, as they begin
    std::vector<HarmonicLane> lanes;               ///< from 0 to 1
    /// Displacements at t = 0 of the first nodes of bars that drift, from the left. Empty: the last
    /// one at the first contact stands where that closes, others swing about their places in the
    /// scene.
    std::vector<double> drifts = {};
    double impulse = 0.0;  ///< of all contacts; what follows is measured
    double peakForce = 0.0;
    double speed = 0.0;  ///< the largest with which one closes
    /// Of (l - r)/speed, as in NetworkExtremes (network_walk.hpp).
    double leastStrain = 0.0;
    double mostStrain = 0.0;
    /// [-], the worst defect: waves that do not come back, distance at the start or the end, a
    /// pull, an overlap of any contact; of the largest wave, or of the gap.
    double residual = 0.0;
    /// [-], of a disturbance in a period, if it is known (harmonic_network_growth.hpp).
    std::optional<double> growth = {};

    [[nodiscard]] const NetworkHarmonicContact& first() const { return contacts.front(); }
    /// Of all contacts.
    [[nodiscard]] double contactTime() const;
};

/// A network that constant forces have displaced, and what moves on from there. Forces on bars that
/// drift, which displace them for ever, are still there.
struct StillNetwork {
    Network network;                    ///< without the others, gaps under them
    std::vector<double> displacements;  ///< of the nodes, by the forces

    /// Adds them, and the waves that go with them, to a state that moves about them. O(waves).
    void addShape(NetworkStart& moved) const;
};
[[nodiscard]] StillNetwork underConstantForces(const Network& network);
/// The same by a base, all shaken clamps, that stands elsewhere [delta]; forces stay.
[[nodiscard]] StillNetwork underMovedBase(const Network& network, double base);

}  // namespace signorini
