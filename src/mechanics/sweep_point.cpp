#include "sweep_point.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace signorini {

namespace {

/// A piece of a wave, and when it is at the tip [crossings].
struct Passing {
    double begin;
    double end;
    double value;
};

/// One wave at the tip, from a time on.
std::vector<Passing> passing(const std::vector<Waves>& states, std::vector<Piece> Waves::*wave,
                             double from)
{
    std::vector<Passing> all;
    for (std::size_t k = 0; k < states.size(); ++k) {
        double at = from + static_cast<double>(k);
        for (const Piece& piece : states[k].*wave) {
            const double end = at + piece.duration / states[k].crossing;
            all.push_back({at, end, piece.value});
            at = end;
        }
    }
    return all;
}

}  // namespace

double largestStrain(const std::vector<Waves>& states)
{
    constexpr double same = 1e-9;
    const std::vector<Passing> arriving = passing(states, &Waves::a, 0.0);
    const std::vector<Passing> leaving = passing(states, &Waves::b, -1.0);
    double worst = 0.0;
    // Of the arriving pieces in sight those that none after them exceeds, the largest first.
    for (const double sign : {1.0, -1.0}) {
        std::deque<const Passing*> inSight;
        auto next = arriving.begin();
        for (const Passing& left : leaving) {
            for (; next != arriving.end() && next->begin < left.end + 2.0 - same; ++next) {
                while (!inSight.empty() && sign * inSight.back()->value <= sign * next->value) {
                    inSight.pop_back();
                }
                inSight.push_back(&*next);
            }
            while (!inSight.empty() && inSight.front()->end <= left.begin + same) {
                inSight.pop_front();
            }
            if (!inSight.empty()) {
                worst = std::max(worst, sign * (inSight.front()->value - left.value));
            }
        }
    }
    return worst;
}

namespace {

/// What of a wave lies between two times of arrival.
std::vector<Piece> between(const std::vector<Piece>& wave, double from, double to)
{
    std::vector<Piece> part;
    double at = 0.0;
    for (const Piece& piece : wave) {
        const double lasts = std::min(at + piece.duration, to) - std::max(at, from);
        if (lasts > 0.0) {
            part.push_back({lasts, piece.value});
        }
        at += piece.duration;
    }
    return part;
}

}  // namespace

Waves partOf(const Waves& waves, double begin, double crossing)
{
    const double before = waves.crossing - begin - crossing;  // towards the tip
    return {crossing, between(waves.a, before, before + crossing),
            between(waves.b, begin, begin + crossing)};
}

}  // namespace signorini
