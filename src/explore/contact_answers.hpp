#pragma once
/// \file
/// What a network whose contacts are open answers to pushes at one of them, once in a period of n
/// steps, and to what excites it: a harmonic staircase, or the harmonic itself.

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "growing_contact.hpp"
#include "network_simulation.hpp"
#include "open_network.hpp"

namespace signorini {

/// How a harmonic excites.
enum class Drive {
    inSteps,  ///< constant in each step
    exactly   ///< then pushes and waves are harmonics, too, of the time since the step began
};

class ContactAnswers {
public:
    using Complex = OpenNetwork::Complex;

    /// Keeps references. O((n/G)^2) for each contact and, for each frequency, channels^3.
    /// \throws Resonance if waves resonate; in steps also if nothing damps some waves of the
    /// period, or what a push moves. \pre as OpenNetwork; in steps no bar drifts.
    ContactAnswers(const HarmonicNetwork& given, const OpenNetwork& open, std::size_t contact,
                   Drive drive);

    /// What grows; under the harmonic itself without other contacts.
    [[nodiscard]] const ContactPeriod& period() const { return period_; }

    /// Pushes in all steps that keep the contact closed: the still one and, for A = 1, a harmonic.
    struct Permanent {
        double still = 0.0;
        Complex swing = 0.0;
        double upTo = 0.0;  ///< A, beyond which it would pull, or another contact close
    };
    /// None where its sides do not press on each other at rest, where a harmonic cannot move it, or
    /// where another contact is closed at rest, too.
    [[nodiscard]] std::optional<Permanent> permanent() const;

    /// The waves at t = 0 under the excitation (C, S) and pushes in the first steps. O(cells
    /// n_c/G).
    [[nodiscard]] NetworkStart startOf(Plane place, const std::vector<double>& pushes) const;
    /// The same for the excitation A and pushes that are a constant and a harmonic, to which waves
    /// are added that are the same in all steps, by channel; in the order of Network::waves.
    [[nodiscard]] std::vector<SteadyHarmonic> wavesOf(Complex excitation,
                                                      const std::vector<SteadyHarmonic>& pushes,
                                                      std::span<const SteadyHarmonic> even) const;

private:
    /// At which a push of 1 widens the distance of a contact, by frequency; for k = 0 its own.
    [[nodiscard]] std::vector<Complex> rates(std::size_t contact) const;
    [[nodiscard]] ClosingContact askOf(std::size_t contact,
                                       const std::vector<Complex>& spectrum) const;
    void requireWork(std::span<const Complex> rates) const;
    [[nodiscard]] std::vector<std::int64_t> offsets() const;
    [[nodiscard]] std::vector<double> inTime(const std::vector<Complex>& spectrum,
                                             std::int64_t offset) const;
    /// visit(channel, m): wave by wave, in which channel it arrives and when.
    void forEachWave(auto visit) const;
    template <typename Value>
    [[nodiscard]] Value arriving(Eigen::Index channel, std::int64_t m,
                                 const std::vector<Value>& pushes) const;
    [[nodiscard]] std::int64_t offsetOf(Eigen::Index channel) const
    {
        return offsets_[given_.network.nodeOf(static_cast<std::size_t>(channel))];
    }
    /// The rate of a distance under A = 1.
    [[nodiscard]] Complex driven(std::size_t contact) const;

    const HarmonicNetwork& given_;
    const OpenNetwork& open_;
    std::size_t contact_;
    Complex inSteps_;  ///< of a harmonic of the network as the drive has it in step 0
    ContactPeriod period_;
    Eigen::MatrixXcd answers_;    ///< what arrives, by channel and frequency up to n/(2 G), for a
                                  ///< push of 1
    OpenNetwork::Vector driven_;  ///< what arrives in step 0 for A = 1
    std::vector<std::int64_t> offsets_;                ///< steps mod G from the contact, by node
    mutable std::vector<std::vector<double>> byPush_;  ///< by channel, at its offset + i G; made
                                                       ///< for the first motion
};

}  // namespace signorini
