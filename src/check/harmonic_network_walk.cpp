#include "harmonic_network_walk.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact_spans.hpp"
#include "harmonic_walk.hpp"
#include "largest.hpp"
#include "network_simulation.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

/// The waves of one part of all steps, and the part [from, to] that it is.
struct Lane {
    NetworkWaves<SteadyHarmonic> waves;
    double from;
    double to;
};

constexpr std::size_t isOpen = ~std::size_t{0};

class HarmonicSteps {
public:
    HarmonicSteps(const HarmonicNetwork& given, NetworkHarmonicMotion& motion,
                  const HarmonicWatch& watch)
        : given_(given),
          network_(given.network),
          motion_(motion),
          watch_(watch),
          laws_(given.network),
          drive_(given.amplitude * turned(-motion.phase)),
          slope_(0.0, given.omega()),
          bars_(driftingBars(given.network))
    {
        for (const HarmonicLane& lane : motion.lanes) {
            lanes_.push_back({{network_, lane.waves}, lane.from, lane.to});
            size_ = std::max(size_, largestOf(lane.waves, &SteadyHarmonic::largest));
        }
        for (const NetworkHarmonicContact& one : motion.contacts) {
            pressing_ |= ContactSet{1} << one.contact;
        }
        stiffest_ = largestOf(network_.rows, &CellRow::impedance);
    }

    void run()
    {
        startDistances();
        defect_ = std::max(defect_, cutsMissed());
        for (std::int64_t m = 0; m < given_.steps; ++m) {
            step_ = static_cast<double>(m);
            if (watch_.state) {
                watch_.state(m, stateAt(m));
            }
            const Complex drive = drive_ * given_.turn(m);
            const auto [force, base] = given_.drive(drive);
            force_.swing = force;
            base_.swing = base;
            for (Lane& lane : lanes_) {
                if (watch_.arrivals) {
                    watch_.arrivals(lane.waves.arriving(), lane.from, lane.to);
                }
                findHeld(step_ + 0.5 * (lane.from + lane.to));
                const NetworkLaw<SteadyHarmonic>& law = laws_.of(closed_);
                for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
                    if (held_[j] != isOpen) {
                        press(law, lane, j);
                    } else {
                        part(law, lane, j);
                    }
                }
                drift(law, lane);
                lane.waves.step(law, force_, base_);
            }
        }
        if (watch_.state) {
            watch_.state(given_.steps, stateAt(given_.steps));
        }
        comeBack();
        motion_.residual =
            std::max({defect_, pull_ / (2.0 * stiffest_ * size_), overlap_ / length()});
    }

    /// Finds how far contacts are open at the start.
    const std::vector<double>& startDistances()
    {
        placeBars();
        const std::vector<double> places = stateAt(0).displacements;
        for (const NetworkContact& contact : network_.contacts) {
            distances_.push_back(
                contact.gap + openingOf(contact, [&](std::size_t node) { return places[node]; }));
        }
        return distances_;
    }

private:
    /// Of beginnings and ends in their steps from where lanes meet.
    [[nodiscard]] double cutsMissed() const
    {
        double missed = 0.0;
        for (const NetworkHarmonicContact& one : motion_.contacts) {
            for (const double time : {one.begin, one.end}) {
                const double place = time - std::floor(time);
                double apart = std::min(place, 1.0 - place);
                for (const Lane& lane : lanes_) {
                    apart = std::min(apart, std::abs(place - lane.from));
                }
                missed = std::max(missed, apart);
            }
        }
        return missed;
    }

    /// Which contact of the motion is closed at this time, by contact.
    void findHeld(double time)
    {
        const auto period = static_cast<double>(given_.steps);
        std::swap(before_, held_);
        std::fill(held_.begin(), held_.end(), isOpen);
        closed_ = 0;
        for (std::size_t k = 0; k < motion_.contacts.size(); ++k) {
            const NetworkHarmonicContact& one = motion_.contacts[k];
            if ((one.begin <= time && time < one.end) || time + period < one.end) {
                held_[one.contact] = k;
                closed_ |= ContactSet{1} << one.contact;
            }
        }
        for (std::size_t j = 0; j < held_.size(); ++j) {
            if (held_[j] != isOpen && held_[j] != before_[j]) {
                meet(j);
            }
        }
    }

    /// Its distance is to be 0.
    void meet(std::size_t j)
    {
        defect_ = std::max(defect_, std::abs(distances_[j]) / length());
        motion_.contacts[held_[j]].speed = speeds_[j];
    }

    /// What is at the end of the period is to be as at its start.
    void comeBack()
    {
        for (std::size_t i = 0; i < lanes_.size(); ++i) {
            const std::vector<SteadyHarmonic> after = lanes_[i].waves.waves();
            const std::vector<SteadyHarmonic>& before = motion_.lanes[i].waves;
            for (std::size_t k = 0; k < after.size(); ++k) {
                defect_ = std::max(defect_, (after[k] - before[k]).largest() / size_);
            }
        }
        for (std::size_t k = 0; k < drifts_.size(); ++k) {
            defect_ = std::max(defect_, std::abs(drifts_[k] - startDrifts_[k]) / length());
        }
        findHeld(0.5 * (lanes_.front().from + lanes_.front().to));
        for (const NetworkHarmonicContact& one : motion_.contacts) {
            motion_.impulse += one.impulse;
            motion_.peakForce = std::max(motion_.peakForce, one.peakForce);
            motion_.speed = std::max(motion_.speed, one.speed);
        }
    }

    /// Of what distances are compared with.
    [[nodiscard]] double length() const
    {
        return std::max(size_, std::abs(network_.contacts[motion_.first().contact].gap));
    }

    /// Means over the cells.
    [[nodiscard]] NetworkStart stateAt(std::int64_t m) const
    {
        NetworkStart now{std::vector<double>(network_.waves(), 0.0), {}};
        for (const Lane& lane : lanes_) {
            const Complex weight = given_.weight(lane.from, lane.to);
            const std::vector<SteadyHarmonic> values = lane.waves.waves();
            for (std::size_t i = 0; i < values.size(); ++i) {
                now.waves[i] +=
                    (values[i].swing * weight).real() + values[i].steady * (lane.to - lane.from);
            }
        }
        now.displacements = displacementsOf(network_, now.waves, drifts_);
        for (std::size_t node = 0; node < now.displacements.size(); ++node) {
            const auto clamp = displacementOf(network_, node).clamp;
            if (clamp && network_.nodes[*clamp].isShaken && given_.place != Excited::tip) {
                now.displacements[node] += (drive_ * given_.turn(m)).real();
            }
        }
        return now;
    }

    /// As the motion says (NetworkHarmonicMotion::drifts).
    void placeBars()
    {
        if (!motion_.drifts.empty()) {
            drifts_ = startDrifts_ = motion_.drifts;
            return;
        }
        const std::size_t first = motion_.first().contact;
        const auto [force, base] = given_.drive(drive_);
        const std::span<const SteadyHarmonic> arriving = lanes_.front().waves.arriving();
        for (const std::size_t bar : bars_) {
            const LinearForm<SteadyHarmonic>& velocity =
                laws_.of(0).velocity(network_.bars[bar].firstNode);
            const SteadyHarmonic rate =
                velocity.at(arriving, SteadyHarmonic(0.0, force), SteadyHarmonic(0.0, base));
            drifts_.push_back((rate.swing / slope_).real());
        }
        const auto touched = driftsOf(network_, first);
        if (!touched.empty()) {
            const std::vector<double> places = stateAt(0).displacements;
            const NetworkContact& contact = network_.contacts[first];
            const double distance =
                contact.gap + openingOf(contact, [&](std::size_t node) { return places[node]; });
            drifts_[static_cast<std::size_t>(touched.back().first)] -=
                touched.back().second * distance;
        }
        startDrifts_ = drifts_;
    }

    void press(const NetworkLaw<SteadyHarmonic>& law, const Lane& lane, std::size_t j)
    {
        NetworkHarmonicContact& one = motion_.contacts[held_[j]];
        const SteadyHarmonic push = law.push(j).at(lane.waves.arriving(), force_, base_);
        const HarmonicBounds seen =
            boundsOf(push.swing, given_.omega() * lane.from, given_.omega() * lane.to);
        pull_ = std::max(pull_, -seen.least - push.steady);
        one.peakForce = std::max(one.peakForce, seen.most + push.steady);
        one.impulse += integral(push, lane);
        see(j, lane, 0.0, {}, push);
    }

    /// What bars that drift go.
    void drift(const NetworkLaw<SteadyHarmonic>& law, const Lane& lane)
    {
        for (std::size_t k = 0; k < bars_.size(); ++k) {
            const std::size_t node = network_.bars[bars_[k]].firstNode;
            drifts_[k] +=
                integral(law.velocity(node).at(lane.waves.arriving(), force_, base_), lane);
        }
    }

    /// A distance that is `least` and a speed and a harmonic, and a push.
    void see(std::size_t j, const Lane& lane, double least, const SteadyHarmonic& way,
             const SteadyHarmonic& push)
    {
        constexpr int instants = 4;
        if (watch_.path == nullptr || !contains(pressing_, j)) {
            return;
        }
        for (int k = 0; k <= instants; ++k) {
            const double s = lane.from + (lane.to - lane.from) * k / instants;
            const Complex turn = turned(given_.omega() * s);
            watch_.path->push_back(
                {j, step_ + s, least + way.steady * (s - lane.from) + (way.swing * turn).real(),
                 push.at(turn)});
        }
    }

    /// The distance of a contact that is open.
    void part(const NetworkLaw<SteadyHarmonic>& law, const Lane& lane, std::size_t j)
    {
        const SteadyHarmonic rate = openingOf(network_.contacts[j], [&](std::size_t node) {
            return law.velocity(node).at(lane.waves.arriving(), force_, base_);
        });
        overlap_ = std::max(overlap_, -leastWay(rate, lane) - distances_[j]);
        speeds_[j] = -(rate.swing * turned(given_.omega() * lane.to)).real() - rate.steady;
        const SteadyHarmonic way(rate.steady, rate.swing / slope_);
        const double start = (way.swing * turned(given_.omega() * lane.from)).real();
        see(j, lane, distances_[j] - start, way, {});
        distances_[j] += integral(rate, lane);
    }

    /// The least that this rate adds up to within a lane: at its ends, or where the rate is 0.
    [[nodiscard]] double leastWay(const SteadyHarmonic& rate, const Lane& lane) const
    {
        double least = std::min(0.0, integral(rate, lane));
        const double size = lengthOf(rate.swing);
        if (!(std::abs(rate.steady) < size)) {
            return least;
        }
        const double apart = portable::acos(-rate.steady / size);
        for (double angle : {apart, -apart}) {
            angle -= angleOf(rate.swing) + given_.omega() * lane.from;
            angle -= 2.0 * std::numbers::pi * std::floor(angle / (2.0 * std::numbers::pi));
            const double until = lane.from + angle / given_.omega();
            if (until < lane.to) {
                least = std::min(least, integral(rate, lane.from, until));
            }
        }
        return least;
    }

    /// Over the part of a lane.
    [[nodiscard]] double integral(const SteadyHarmonic& z, const Lane& lane) const
    {
        return integral(z, lane.from, lane.to);
    }
    [[nodiscard]] double integral(const SteadyHarmonic& z, double from, double to) const
    {
        const Complex turn = turned(given_.omega() * to) - turned(given_.omega() * from);
        return z.steady * (to - from) + (z.swing / slope_ * turn).real();
    }

    const HarmonicNetwork& given_;
    const Network& network_;
    NetworkHarmonicMotion& motion_;
    const HarmonicWatch& watch_;
    double step_ = 0.0;
    NetworkLaws<SteadyHarmonic> laws_;
    ContactSet pressing_ = 0;  ///< at some time
    ContactSet closed_ = 0;
    std::vector<std::size_t> held_ = std::vector<std::size_t>(network_.contacts.size(), isOpen);
    std::vector<std::size_t> before_ = held_;
    std::vector<double> speeds_ = std::vector<double>(network_.contacts.size(), 0.0);
    Complex drive_;
    Complex slope_;  ///< i omega
    SteadyHarmonic force_;
    SteadyHarmonic base_;
    std::vector<Lane> lanes_;
    std::vector<std::size_t> bars_;  ///< that drift
    std::vector<double> drifts_;     ///< displacements of their first nodes
    std::vector<double> startDrifts_;
    std::vector<double> distances_;
    double size_ = 0.0;  ///< of the largest wave
    double defect_ = 0.0;
    double stiffest_ = 0.0;
    double pull_ = 0.0;
    double overlap_ = 0.0;
};

}  // namespace

void measure(const HarmonicNetwork& given, NetworkHarmonicMotion& motion,
             const HarmonicWatch& watch)
{
    motion.impulse = 0.0;
    motion.peakForce = 0.0;
    motion.speed = 0.0;
    for (NetworkHarmonicContact& one : motion.contacts) {
        one.impulse = 0.0;
        one.peakForce = 0.0;
    }
    HarmonicSteps(given, motion, watch).run();
}

std::vector<double> startDistances(const HarmonicNetwork& given, NetworkHarmonicMotion motion)
{
    const HarmonicWatch none;
    return HarmonicSteps(given, motion, none).startDistances();
}

}  // namespace signorini
