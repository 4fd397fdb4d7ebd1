#pragma once
/// \file
/// A network whose contacts are open, at the frequencies of a period of n steps.
///
/// What enters a channel arrives after its delay d, and scatters (N): with S the scattering and D =
/// diag e^{-2 pi i k d/n}, what arrives is w = D (S w + s), s what pushes and the drive send.

#include <Eigen/Core>
#include <complex>
#include <cstdint>
#include <vector>

#include "harmonic_network.hpp"

namespace signorini {

class OpenNetwork {
public:
    using Complex = std::complex<double>;
    using Vector = Eigen::VectorXcd;

    /// O(n + channels^2). \pre no constant forces.
    explicit OpenNetwork(const HarmonicNetwork& given);

    [[nodiscard]] Eigen::Index channels() const
    {
        return static_cast<Eigen::Index>(delays_.size());
    }
    /// e^{2 pi i m/n}. \pre 0 <= m < n.
    [[nodiscard]] Complex turn(std::int64_t m) const { return turns_[static_cast<std::size_t>(m)]; }
    /// e^{2 pi i k m/n}. \pre k, m >= 0.
    [[nodiscard]] Complex power(std::int64_t k, std::int64_t m) const
    {
        const auto n = static_cast<std::int64_t>(turns_.size());
        return turns_[static_cast<std::size_t>((k % n) * (m % n) % n)];
    }

    /// What a push of 1 at a contact sends into the channels, and what A = 1 sends.
    [[nodiscard]] Vector sentBy(std::size_t contact) const;
    [[nodiscard]] Vector sentByDrive() const;
    /// What is done about waves without damping.
    enum class Undamped {
        leftOut,  ///< unless something excites them
        refused,
    };
    /// w, for the k-th frequency. O(channels^3). \throws Resonance if undamped waves resonate, or
    /// are refused.
    [[nodiscard]] Vector arriving(std::int64_t k, const Vector& sent,
                                  Undamped undamped = Undamped::leftOut) const;
    /// The same where a constant push of 1 holds the network still: of a bar that is held twice
    /// waves of frequency 0 do not tell how far it is stretched. A bar that drifts goes as fast as
    /// its dashpots say.
    [[nodiscard]] Vector arrivingStill(std::size_t contact) const;
    /// At which that push widens its own contact: 1/D of each side that drifts. Of bars without
    /// dashpots, on which no mean push is left, D is 1.
    [[nodiscard]] double driftRate(std::size_t contact) const;
    /// Waves of one that stand on these displacements of the nodes, and of bars that go with such
    /// speeds, by channel.
    [[nodiscard]] std::vector<double> evenWaves(std::span<const double> displacements,
                                                std::span<const double> speeds) const;
    /// Of nodes, under forces that have no resultant on bars that drift, whose first nodes stay.
    [[nodiscard]] std::vector<double> shapeUnder(const std::vector<double>& forces) const;
    /// Dashpots of a bar.
    [[nodiscard]] double dashpotsOf(std::size_t bar) const;
    /// The rate of a contact's distance, when this arrives while a contact pushes with 1.
    [[nodiscard]] Complex rateByPush(std::size_t contact, const Vector& arriving,
                                     std::size_t pushing) const;
    /// The same while A = 1 excites it.
    [[nodiscard]] Complex rateByDrive(std::size_t contact, const Vector& arriving) const;
    /// By how much a constant push of 1 at a contact widens the distance at another, or its own.
    [[nodiscard]] double compliance(std::size_t contact, std::size_t pushing) const;

private:
    [[nodiscard]] Complex force() const { return given_.place == Excited::tip ? 1.0 : 0.0; }
    [[nodiscard]] Complex base() const
    {
        return given_.place == Excited::tip ? 0.0 : Complex(0.0, given_.omega());
    }
    [[nodiscard]] double impedance(std::size_t node) const;
    [[nodiscard]] Complex rate(std::size_t contact, const Vector& arriving) const;
    /// Its nodes displaced by a constant push of 1 at a contact, and by dashpots of bars that it
    /// sets in motion.
    [[nodiscard]] std::vector<double> shapeUnderPush(std::size_t contact) const;
    /// Speeds of these, by bar.
    [[nodiscard]] std::vector<double> speedsUnderPush(std::size_t contact) const;

    const HarmonicNetwork& given_;
    const Network& network_;
    NetworkLaw<double> law_;
    std::vector<std::int64_t> delays_;  ///< steps until a wave arrives, by channel
    Eigen::MatrixXd scatter_;
    std::vector<Complex> turns_;  ///< e^{2 pi i m/n}
};

}  // namespace signorini
