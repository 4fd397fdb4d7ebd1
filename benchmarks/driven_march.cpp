#include "driven_march.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::bench {

namespace {

constexpr double atWall = 1e-12;  // [g]

}  // namespace

DrivenMarch::DrivenMarch(const State& start, const DrivenCase& one, double end)
    : w_(2.0 * std::numbers::pi / one.period),
      rho_((1.0 - one.dashpot) / (1.0 + one.dashpot)),
      admittance_(1.0 / (1.0 + one.dashpot)),
      force_{0.0, std::polar(one.amplitude, -one.phase)},
      turn_(std::polar(1.0, -2.0 * w_))
{
    // What runs to the right arrives first, its end at the tip first; what runs to the left comes
    // back from the base with the other sign.
    const auto cells = static_cast<double>(start.cells());
    for (Eigen::Index i = start.a.size(); i-- > 0;) {
        pieces_.push_back({1.0 - static_cast<double>(i) / cells, {start.a[i], {}}});
        tip_ -= start.a[i] / cells;
    }
    for (Eigen::Index i = 0; i < start.b.size(); ++i) {
        pieces_.push_back({1.0 + static_cast<double>(i + 1) / cells, {-start.b[i], {}}});
        tip_ += start.b[i] / cells;
    }
    isHeld_ = tip_ >= 1.0 - atWall;
    while (time_ < end) {
        const Piece piece = pieces_.front();
        const HarmonicWave push{2.0 * piece.wave.steady, 2.0 * piece.wave.swing + force_.swing};
        isHeld_ ? hold(push, piece) : fly(push, piece);
        if (time_ >= piece.end) {
            pieces_.pop_front();
        }
    }
}

double DrivenMarch::value(const HarmonicWave& wave, double time) const
{
    return wave.steady + (wave.swing * std::polar(1.0, w_ * time)).real();
}

double DrivenMarch::integral(const HarmonicWave& wave, double from, double to) const
{
    const std::complex<double> turned = std::polar(1.0, w_ * to) - std::polar(1.0, w_ * from);
    return wave.steady * (to - from) + (wave.swing * turned).imag() / w_;
}

/// Where the wave changes its sign, ascending.
std::vector<double> DrivenMarch::zeros(const HarmonicWave& wave, double from, double to) const
{
    std::vector<double> all;
    const double size = std::abs(wave.swing);
    if (size <= std::abs(wave.steady)) {
        return all;
    }
    const double angle = std::acos(-wave.steady / size);
    const double turn = 2.0 * std::numbers::pi / w_;
    for (const double side : {-angle, angle}) {
        const double first = (side - std::arg(wave.swing)) / w_;
        for (double t = first + turn * std::ceil((from - first) / turn); t < to; t += turn) {
            if (t > from) {
                all.push_back(t);
            }
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

double DrivenMarch::place(const Path& path, double time) const
{
    return path.at + integral(path.velocity, path.begin, time);
}

/// The tip obeys one law until a time; what leaves it comes back 2 L/c later.
void DrivenMarch::advance(bool isHeld, const HarmonicWave& arriving, double until)
{
    Path path{time_, tip_, {}, impulse_, {}};
    HarmonicWave leaving{-arriving.steady, -arriving.swing};
    if (isHeld) {
        path.push = {2.0 * arriving.steady, 2.0 * arriving.swing + force_.swing};
    } else {
        path.velocity = {2.0 * admittance_ * arriving.steady,
                         admittance_ * (2.0 * arriving.swing + force_.swing)};
        leaving = {rho_ * arriving.steady, rho_ * arriving.swing + admittance_ * force_.swing};
    }
    pieces_.push_back({until + 2.0, {-leaving.steady, -leaving.swing * turn_}});
    tip_ = place(path, until);
    impulse_ += integral(path.push, time_, until);
    path_.push_back(path);
    time_ = until;
}

/// Held until the wall would have to pull.
void DrivenMarch::hold(const HarmonicWave& push, const Piece& piece)
{
    double until = piece.end;
    for (const double zero : zeros(push, time_, piece.end)) {
        if (value(push, 0.5 * (zero + std::min(piece.end, zero + 1e-6))) < 0.0) {
            until = zero;
            break;
        }
    }
    const double middle = 0.5 * (time_ + std::min(until, time_ + 1e-6));
    if (value(push, middle) < 0.0) {
        isHeld_ = false;
        return;
    }
    tip_ = 1.0;
    advance(true, piece.wave, until);
    isHeld_ = until == piece.end;
}

/// Free until the tip comes to the wall.
void DrivenMarch::fly(const HarmonicWave& push, const Piece& piece)
{
    const HarmonicWave velocity{admittance_ * push.steady, admittance_ * push.swing};
    const Path path{time_, tip_, velocity, impulse_, {}};
    std::vector<double> turns = zeros(velocity, time_, piece.end);
    turns.push_back(piece.end);
    double from = time_;
    for (const double to : turns) {
        // The tip goes one way from here to there.
        if (place(path, to) >= 1.0 && value(velocity, 0.5 * (from + to)) > 0.0) {
            double low = from;
            double high = to;
            while (low < 0.5 * (low + high) && 0.5 * (low + high) < high) {
                const double middle = 0.5 * (low + high);
                (place(path, middle) >= 1.0 ? high : low) = middle;
            }
            advance(false, piece.wave, high);
            arrivals_.push_back(high);
            tip_ = 1.0;
            isHeld_ = true;
            return;
        }
        from = to;
    }
    advance(false, piece.wave, piece.end);
}

const DrivenMarch::Path& DrivenMarch::pathAt(double time) const
{
    const auto after = std::upper_bound(path_.begin() + 1, path_.end(), time,
                                        [](double t, const Path& path) { return t < path.begin; });
    return *(after - 1);
}

double DrivenMarch::tip(double time) const
{
    return place(pathAt(time), time);
}

double DrivenMarch::impulse(double time) const
{
    const Path& path = pathAt(time);
    return path.impulse + integral(path.push, path.begin, time);
}

}  // namespace signorini::bench
