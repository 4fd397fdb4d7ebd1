#pragma once
/// \file
/// The forced, damped bar with a harmonic that is not sampled: what the simulation tends to as the
/// steps of its excitation become finer. Written from the wave equation, without the library.
///
/// Between two events the wave that arrives at the tip is k + Re(z exp(i w t)): the tip's law
/// (docs/theory.md, section 15) adds a harmonic to a wave and multiplies it, a trip to the base and
/// back turns z by exp(-2iw) and changes the sign. So forces are zero at instants that are written
/// down, and the tip meets the wall at roots that bisection finds to the last digit.

#include <complex>
#include <cstddef>
#include <deque>
#include <vector>

#include "signorini/motion.hpp"

namespace signorini::bench {

/// A force amplitude cos(2 pi t/period - phase) on the tip, a dashpot eta. Units L = c = g = 1.
struct DrivenCase {
    double dashpot = 0.0;    ///< [EA/c], eta
    double amplitude = 0.0;  ///< [EA g/L]
    double phase = 0.0;      ///< [rad]
    double period = 1.0;     ///< [L/c]
};

/// k + Re(z exp(i w t)).
struct HarmonicWave {
    double steady = 0.0;
    std::complex<double> swing;
};

class DrivenMarch {
public:
    /// From a state of cells, its tip not beyond the wall, to a time [L/c].
    DrivenMarch(const State& start, const DrivenCase& one, double end);

    /// u(L) [g], 0 <= time <= end. O(log pieces).
    [[nodiscard]] double tip(double time) const;
    /// Of the wall until a time [EA g/c]. O(log pieces).
    [[nodiscard]] double impulse(double time) const;
    /// Beginnings of contact [L/c].
    [[nodiscard]] const std::vector<double>& arrivals() const { return arrivals_; }

private:
    /// What arrives until a time.
    struct Piece {
        double end;
        HarmonicWave wave;
    };
    /// Where the tip is from a time on: at + the integral of its velocity since; and so the
    /// impulse.
    struct Path {
        double begin;
        double at;
        HarmonicWave velocity;
        double impulse;
        HarmonicWave push;
    };

    [[nodiscard]] double value(const HarmonicWave& wave, double time) const;
    [[nodiscard]] double integral(const HarmonicWave& wave, double from, double to) const;
    [[nodiscard]] std::vector<double> zeros(const HarmonicWave& wave, double from, double to) const;
    [[nodiscard]] const Path& pathAt(double time) const;
    [[nodiscard]] double place(const Path& path, double time) const;
    void advance(bool isHeld, const HarmonicWave& arriving, double until);
    void hold(const HarmonicWave& push, const Piece& piece);
    void fly(const HarmonicWave& push, const Piece& piece);

    double w_;
    double rho_;
    double admittance_;
    HarmonicWave force_;
    std::complex<double> turn_;  ///< of a harmonic that comes back 2 L/c later
    std::deque<Piece> pieces_;
    double time_ = 0.0;
    double tip_ = 0.0;
    double impulse_ = 0.0;
    bool isHeld_ = false;
    std::vector<Path> path_;
    std::vector<double> arrivals_;
};

}  // namespace signorini::bench
