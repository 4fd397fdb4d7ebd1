// What a simulation holds: its waves, its energy.

#include <algorithm>
#include <cmath>

#include "compensated_sum.hpp"
#include "infinity.hpp"
#include "segment_lines.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

Waves BarSimulation::waves() const
{
    Waves waves = segments_.empty() ? wavesOfEcho() : segments_.front().waves();
    waves.base = base();
    return waves;
}

Waves BarSimulation::wavesOfEcho() const
{
    Waves waves;
    waves.crossing = crossing_;
    const auto put = [](std::vector<Piece>& to, double duration, double value) {
        if (!to.empty() && to.back().value == value) {
            to.back().duration += duration;
        } else {
            to.push_back({duration, value});
        }
    };
    Clock clock = base_;
    double left = crossing_;
    for (std::size_t k = 0; k < echo_.size(); ++k) {
        Piece piece = echo_[k];
        while (left > same_ && piece.duration > 0.0) {
            double lasts = std::min(clock.left, left);
            lasts = piece.duration <= lasts + same_ ? piece.duration : lasts;
            put(waves.a, lasts, clock.value - piece.value);
            piece.duration -= lasts;
            left -= lasts;
            clock.left < infinity ? clock.pass(lasts, same_) : void();
        }
        if (piece.duration > 0.0) {
            put(waves.b, piece.duration, piece.value);
        }
    }
    return waves;
}

std::int64_t BarSimulation::pieces() const
{
    return static_cast<std::int64_t>(segments_.empty() ? echo_.size() : segments_.front().pieces());
}

double BarSimulation::energyRatio() const
{
    return segments_.empty() ? signorini::energyRatio(waves()) : 2.0 * storedSquares() / crossing_;
}

double BarSimulation::merged() const
{
    return (segments_.empty() ? echo_.merged() - mergedBefore_ : segments_.front().merged()) /
           crossing_;
}

double BarSimulation::storedSquares() const
{
    return segments_.empty() ? echo_.squares() : segments_.front().squares();
}

EnergyBalance BarSimulation::balance() const
{
    // What the base does is counted where it is felt, so the energy is that of what left the tip.
    const double unit = 2.0 / crossing_;
    const double squares = storedSquares();
    Sum error;
    for (const double term :
         {squares, -start_, -work_.value, -work_.lost, dissipated_.value, dissipated_.lost}) {
        error.add(term);
    }
    return {unit * work_.total(), unit * dissipated_.total(), unit * error.total(),
            unit * std::max({squares, start_, std::abs(work_.total()), dissipated_.total()})};
}

}  // namespace signorini
