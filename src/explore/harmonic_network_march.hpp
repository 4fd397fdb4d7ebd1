#pragma once
/// \file
/// A network under an exact harmonic from any waves on, event by event; no period, no pattern.
///
/// Steps follow each other lane by lane (harmonic_network.hpp). Within a lane pushes of closed
/// contacts and rates of open ones are a constant and a harmonic: a push is 0 at instants that are
/// written down, and a distance is 0 at a root that bisection finds between two instants at which
/// its rate is 0. An event cuts its lane in two.

#include <vector>

#include "harmonic_network.hpp"

namespace signorini {

class HarmonicNetworkMarch {
public:
    /// From waves, distances and closed contacts at t = 0, the excitation being |A| cos(omega t -
    /// phase). Once a period neighbours become one lane where the shorter one's length times what
    /// they differ by is at most mergeBelow times the largest wave. \pre nothing
    /// pulls but the harmonic, and constant forces at bars that drift.
    HarmonicNetworkMarch(const HarmonicNetwork& given, double phase,
                         const std::vector<HarmonicLane>& lanes, std::vector<double> distances,
                         ContactSet closed, double mergeBelow);
    /// At rest, a base standing at 0 at first.
    [[nodiscard]] static HarmonicNetworkMarch atRest(const HarmonicNetwork& given,
                                                     double mergeBelow);

    /// Whole steps. \return false: too many events, lanes, or steps of lanes to go on.
    [[nodiscard]] bool advance(std::int64_t steps);

    /// As they began; `end` is 0 while one lasts. Those closed at the start have a negative begin.
    [[nodiscard]] const std::vector<NetworkHarmonicContact>& contacts() const { return contacts_; }
    [[nodiscard]] double phase() const { return phase_; }
    /// As they are now.
    [[nodiscard]] std::vector<HarmonicLane> lanes() const;

private:
    struct Lane {
        double from;
        double to;
        std::complex<double> weight;  ///< integral of e^{i omega s} over it
        NetworkWaves<SteadyHarmonic> waves;

        [[nodiscard]] double integral(const SteadyHarmonic& z) const
        {
            return z.steady * (to - from) + (z.swing * weight).real();
        }
    };
    /// What happens first in a lane.
    struct Event {
        double at;
        std::size_t contact;
    };

    void setLaw();
    void add(double from, double to, NetworkWaves<SteadyHarmonic> waves);
    bool stepLane(std::size_t k);
    [[nodiscard]] SteadyHarmonic rateOf(std::size_t contact, const Lane& lane) const;
    [[nodiscard]] Event firstEvent(const Lane& lane) const;
    [[nodiscard]] double release(const SteadyHarmonic& push, const Lane& lane) const;
    [[nodiscard]] double closure(const SteadyHarmonic& rate, const Lane& lane,
                                 double distance) const;
    [[nodiscard]] std::vector<double> turns(const SteadyHarmonic& z, const Lane& lane) const;
    [[nodiscard]] double value(const SteadyHarmonic& z, double s) const;
    void change(const Event& event, const Lane& lane);
    void merge();

    const HarmonicNetwork& given_;
    double phase_;
    double mergeBelow_;
    std::complex<double> drive_;
    std::vector<Lane> lanes_;
    std::vector<double> distances_;
    std::vector<std::size_t> lasting_;  ///< by contact, of those that are closed
    ContactSet closed_ = 0;
    std::int64_t step_ = 0;
    std::int64_t laneSteps_ = 0;
    SteadyHarmonic force_;
    SteadyHarmonic base_;
    NetworkLaws<SteadyHarmonic> laws_;
    const NetworkLaw<SteadyHarmonic>* law_ = nullptr;  ///< of `closed_`
    std::vector<NetworkHarmonicContact> contacts_;
};

/// What a motion that is not quite one does in a period: its contacts as they should be. None: too
/// many events.
[[nodiscard]] std::vector<NetworkHarmonicContact> contactsAfter(
    const HarmonicNetwork& given, const NetworkHarmonicMotion& motion);

}  // namespace signorini
