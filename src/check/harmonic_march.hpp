#pragma once
/// \file
/// The forced, damped bar with a harmonic that is not sampled, event by event. Written from the
/// wave equation: nothing here knows of periods, patterns or grids.
///
/// Between two events the wave that arrives at the tip is k + Re(z e^{i omega t}): the tip's law
/// (harmonic_motion.hpp) adds a harmonic to a wave and multiplies it, and what leaves comes back
/// 2L/c later. So the push is zero at instants that are written down, and the tip meets a stop at
/// roots that bisection finds to the last digit.

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "harmonic_motion.hpp"

namespace signorini {

/// k + Re(z e^{i omega t}).
struct HarmonicWave {
    double steady = 0.0;
    std::complex<double> swing;

    friend HarmonicWave operator-(const HarmonicWave& x, const HarmonicWave& y)
    {
        return {x.steady - y.steady, x.swing - y.swing};
    }
};

/// What arrives at the tip until a time.
struct ArrivingPiece {
    double end = 0.0;  ///< [L/c]
    HarmonicWave wave;
    /// The contact at whose beginning the front left that arrives at its start.
    std::optional<std::size_t> front = {};
};

/// Where the tip is from a time on: at + the integral of its velocity since.
struct TipPath {
    double begin = 0.0;
    double at = 0.0;
    HarmonicWave velocity;
};

class HarmonicMarch {
public:
    /// Of the case omega, rho, |A|, place and stops are read. From u(L, 0), and waves that arrive
    /// until a time: with mergeBelow 2L/c, and what the tip makes of them follows, neighbours that
    /// differ by no more than mergeBelow |A| as one; without, nothing else arrives.
    HarmonicMarch(const HarmonicCase& given, double phase, std::deque<ArrivingPiece> arriving,
                  double tip, std::optional<double> mergeBelow = {});
    /// At rest, pressed on the wall with a gap below 0; a base stands at 0 at first.
    [[nodiscard]] static HarmonicMarch atRest(const HarmonicCase& given, double mergeBelow);
    /// A motion, at the start of its first contact; u(L, 0) is what its waves say.
    [[nodiscard]] static HarmonicMarch of(const HarmonicCase& given, const HarmonicMotion& motion,
                                          double mergeBelow = 0.0);

    void advance(double until);

    /// u(L) [g], since the start or the last forget(). O(log pieces).
    [[nodiscard]] double tip(double time) const;
    /// All so far; of the last one the end is not known while it lasts. `front` counts from the
    /// first contact of all.
    [[nodiscard]] const std::vector<HarmonicContact>& contacts() const { return contacts_; }
    [[nodiscard]] bool isHeld() const { return isHeld_; }
    /// Where the excitation is at t = 0.
    [[nodiscard]] double phase() const { return phase_; }
    /// Of the path of the tip.
    void forget() { path_.erase(path_.begin(), path_.end() - 1); }

private:
    [[nodiscard]] double value(const HarmonicWave& wave, double time) const;
    [[nodiscard]] double integral(const HarmonicWave& wave, double from, double to) const;
    [[nodiscard]] std::vector<double> zeros(const HarmonicWave& wave, double from, double to) const;
    [[nodiscard]] double place(const TipPath& path, double time) const;
    void send(const HarmonicWave& arriving, double until);
    void comeBack(const HarmonicWave& wave, double until);
    void hold(const HarmonicWave& push, const ArrivingPiece& piece, double until);
    void fly(const HarmonicWave& push, const ArrivingPiece& piece, double until);
    void touch(double time, Stop stop);

    HarmonicCase given_;
    double phase_;
    std::optional<double> mergeBelow_;
    HarmonicWave force_;
    std::complex<double> base_;  ///< V(t + 1)
    std::complex<double> turn_;  ///< of a harmonic that comes back 2 L/c later
    std::deque<ArrivingPiece> pieces_;
    double time_ = 0.0;
    double tip_;
    bool isHeld_ = false;
    std::optional<std::size_t> front_;  ///< of what leaves next
    std::vector<TipPath> path_;
    std::vector<HarmonicContact> contacts_;
};

}  // namespace signorini
