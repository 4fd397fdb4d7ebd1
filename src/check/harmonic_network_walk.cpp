#include "harmonic_network_walk.hpp"

#include <algorithm>
#include <cmath>

#include "harmonic_walk.hpp"
#include "largest.hpp"
#include "network_simulation.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

/// The waves of one part of all steps, and the part [from, to] that it is.
struct Lane {
    NetworkWaves<Complex> waves;
    std::int64_t held;  ///< steps of contact
    double from;
    double to;
};

class HarmonicSteps {
public:
    HarmonicSteps(const HarmonicNetwork& given, NetworkHarmonicMotion& motion,
                  const HarmonicWatch& watch)
        : given_(given),
          network_(given.network),
          motion_(motion),
          watch_(watch),
          open_(network_, 0),
          closed_(network_, ContactSet{1} << motion.contact),
          drive_(given.amplitude * turned(-motion.phase)),
          slope_(0.0, given.omega())
    {
        const double whole = std::floor(motion.release);
        const double part = motion.release - whole;
        const auto held = static_cast<std::int64_t>(whole);
        lanes_.push_back({{network_, motion.late}, held, part, 1.0});
        if (part > 0.0) {
            lanes_.insert(lanes_.begin(), {{network_, motion.early}, held + 1, 0.0, part});
        }
        const auto sizeOf = [](Complex wave) { return lengthOf(wave); };
        size_ = std::max(largestOf(motion.early, sizeOf), largestOf(motion.late, sizeOf));
        stiffest_ = largestOf(network_.rows, &CellRow::impedance);
    }

    void run()
    {
        startDistances();
        double defect = std::abs(distances_[motion_.contact]) / length();
        for (std::int64_t m = 0; m < given_.steps; ++m) {
            step_ = static_cast<double>(m);
            if (watch_.state) {
                watch_.state(m, stateAt(m));
            }
            const Complex drive = drive_ * given_.turn(m);
            const auto [force, base] = given_.drive(drive);
            force_ = force;
            base_ = base;
            for (Lane& lane : lanes_) {
                if (watch_.arrivals) {
                    watch_.arrivals(lane.waves.arriving(), lane.from, lane.to);
                }
                const bool isHeld = m < lane.held;
                const NetworkLaw<Complex>& law = isHeld ? closed_ : open_;
                for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
                    if (isHeld && j == motion_.contact) {
                        press(law, lane);
                    } else {
                        part(law, lane, j);
                    }
                }
                lane.waves.step(law, force_, base_);
            }
        }
        if (watch_.state) {
            watch_.state(given_.steps, stateAt(given_.steps));
        }
        if (watch_.path != nullptr) {
            watch_.path->push_back({step_ + 1.0, distances_[motion_.contact], 0.0});
        }
        for (const Lane& lane : lanes_) {
            const std::vector<Complex> after = lane.waves.waves();
            const std::vector<Complex>& before =
                lane.from == 0.0 && lanes_.size() > 1 ? motion_.early : motion_.late;
            for (std::size_t i = 0; i < after.size(); ++i) {
                defect = std::max(defect, lengthOf(after[i] - before[i]) / size_);
            }
        }
        motion_.residual = std::max({defect, std::abs(distances_[motion_.contact]) / length(),
                                     pull_ / (2.0 * stiffest_ * size_), overlap_ / length()});
    }

private:
    /// Of what distances are compared with.
    [[nodiscard]] double length() const
    {
        return std::max(size_, std::abs(network_.contacts[motion_.contact].gap));
    }

    /// Means over the cells.
    [[nodiscard]] NetworkStart stateAt(std::int64_t m) const
    {
        NetworkStart now{std::vector<double>(motion_.late.size(), 0.0), {}};
        for (const Lane& lane : lanes_) {
            const Complex weight =
                (turned(given_.omega() * lane.to) - turned(given_.omega() * lane.from)) / slope_;
            const std::vector<Complex> values = lane.waves.waves();
            for (std::size_t i = 0; i < values.size(); ++i) {
                now.waves[i] += (values[i] * weight).real();
            }
        }
        now.displacements = displacementsOf(network_, now.waves, {});
        for (std::size_t node = 0; node < now.displacements.size(); ++node) {
            const auto clamp = displacementOf(network_, node).clamp;
            if (clamp && network_.nodes[*clamp].isShaken && given_.place != Excited::tip) {
                now.displacements[node] += (drive_ * given_.turn(m)).real();
            }
        }
        return now;
    }

    void startDistances()
    {
        const std::vector<double> places = stateAt(0).displacements;
        for (const NetworkContact& contact : network_.contacts) {
            distances_.push_back(
                contact.gap + openingOf(contact, [&](std::size_t node) { return places[node]; }));
        }
    }

    void press(const NetworkLaw<Complex>& law, const Lane& lane)
    {
        const Complex push = law.push(motion_.contact).at(lane.waves.arriving(), force_, base_);
        const HarmonicBounds seen =
            boundsOf(push, given_.omega() * lane.from, given_.omega() * lane.to);
        pull_ = std::max(pull_, -seen.least);
        motion_.peakForce = std::max(motion_.peakForce, seen.most);
        motion_.impulse += integral(push, lane);
        see(lane, 0.0, 0.0, push);
    }

    /// A distance that is `least` and a harmonic, and a push.
    void see(const Lane& lane, double least, Complex way, Complex push)
    {
        constexpr int instants = 4;
        for (int k = 0; watch_.path != nullptr && k <= instants; ++k) {
            const double s = lane.from + (lane.to - lane.from) * k / instants;
            const Complex turn = turned(given_.omega() * s);
            watch_.path->push_back({step_ + s, least + (way * turn).real(), (push * turn).real()});
        }
    }

    /// The distance of a contact that is open.
    void part(const NetworkLaw<Complex>& law, const Lane& lane, std::size_t j)
    {
        const Complex rate = openingOf(network_.contacts[j], [&](std::size_t node) {
            return law.velocity(node).at(lane.waves.arriving(), force_, base_);
        });
        const Complex way = rate / slope_;
        const double begin = given_.omega() * lane.from;
        const HarmonicBounds seen = boundsOf(way, begin, given_.omega() * lane.to);
        const double start = (way * turned(begin)).real();
        overlap_ = std::max(overlap_, start - seen.least - distances_[j]);
        if (j == motion_.contact) {
            see(lane, distances_[j] - start, way, 0.0);
            motion_.speed = -(rate * turned(given_.omega() * lane.to)).real();
        }
        distances_[j] += integral(rate, lane);
    }

    /// Of Re(z e^{i omega s}) over the part of a lane.
    [[nodiscard]] double integral(Complex z, const Lane& lane) const
    {
        return (z / slope_ *
                (turned(given_.omega() * lane.to) - turned(given_.omega() * lane.from)))
            .real();
    }

    const HarmonicNetwork& given_;
    const Network& network_;
    NetworkHarmonicMotion& motion_;
    const HarmonicWatch& watch_;
    double step_ = 0.0;
    NetworkLaw<Complex> open_;
    NetworkLaw<Complex> closed_;
    Complex drive_;
    Complex slope_;  ///< i omega
    Complex force_;
    Complex base_;
    std::vector<Lane> lanes_;
    std::vector<double> distances_;
    double size_ = 0.0;  ///< of the largest wave
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
    HarmonicSteps(given, motion, watch).run();
}

}  // namespace signorini
