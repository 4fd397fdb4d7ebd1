#pragma once
/// \file
/// A march of the tests' own: plain cells, one step after the other, and the rule as it is written.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "signorini/verification.hpp"

namespace signorini::test {

/// Of each step: 1 pressed on the wall, -1 on the second stop, 0 neither.
using Marks = std::vector<int>;

/// Phases of a cycle of marks, from the start of the first pressed run.
inline std::vector<Phase> phasesOf(const Marks& marks)
{
    const std::size_t n = marks.size();
    const auto mark = [&](std::size_t m) { return marks[m % n]; };
    std::size_t first = 0;
    while (first < n && mark(first) == 0) {
        ++first;
    }
    if (first == n) {
        return {};
    }
    std::size_t turns = 0;
    for (; turns < n && first == 0 && mark(n - 1 - turns) == mark(0); ++turns) {
    }
    first += turns > 0 ? n - turns : 0;  // the run goes on before the period begins
    std::vector<Phase> phases;
    for (std::size_t m = 0; m < n; ++m) {
        const int here = mark(first + m);
        if (here == 0) {
            ++phases.back().free;
            continue;
        }
        if (m == 0 || mark(first + m - 1) != here) {
            phases.push_back({0, 0, here > 0 ? Stop::right : Stop::left});
        }
        ++phases.back().contact;
    }
    return phases;
}

/// (21)-(25): two waves in plain cells, taken a step further.
inline void takeStep(State& now, bool isHeld)
{
    const Eigen::Index n = now.a.size();
    const double p = now.a[n - 1];
    const double clamped = -now.b[0];
    for (Eigen::Index i = n - 1; i > 0; --i) {
        now.a[i] = now.a[i - 1];
    }
    for (Eigen::Index i = 0; i + 1 < n; ++i) {
        now.b[i] = now.b[i + 1];
    }
    now.a[0] = clamped;
    now.b[n - 1] = isHeld ? -p : p;
}

inline double distance(const State& one, const State& other)
{
    return std::max((one.a - other.a).lpNorm<Eigen::Infinity>(),
                    (one.b - other.b).lpNorm<Eigen::Infinity>());
}

/// The place of the wall and the distance to the second stop, if there is one.
struct Places {
    int wall = 1;
    std::optional<double> second;  ///< in units of p: a free step moves the tip by p
};

/// What is seen of a bar that is taken on by the rule, a step at a time.
struct Seen {
    March march;
    std::int64_t returns = 0;  ///< steps, the least part of all after which the state is back
    Extremes extremes;         ///< all but strains, over all the steps
};

/// Within `tolerance` of a stop the tip is there, at the end of a step or, if that is nearer, at
/// its begin; a push presses if it exceeds `tolerance` of the largest wave. Distances in units of
/// p.
inline Seen marchBySteps(const State& start, std::int64_t count, const Places& places,
                         double tolerance = 0.0)
{
    const auto cells = static_cast<double>(start.cells());
    const double half = 0.5 * cells;
    const double near = tolerance * half;
    const double size =
        std::max(start.a.lpNorm<Eigen::Infinity>(), start.b.lpNorm<Eigen::Infinity>());
    State now = start;
    double opening = places.wall * half + 0.5 * (start.a - start.b).sum();
    Marks marks;
    Seen seen;
    seen.extremes.lowestTip = places.wall - opening / half;
    for (std::int64_t m = 0; m < count; ++m) {
        const double p = now.a[now.a.size() - 1];
        const double push = std::abs(p);
        const double room = p > 0.0 ? opening : places.second ? *places.second - opening : 1e300;
        const double depth = push - room;  // after the step, if it were free
        const bool isHeld = p != 0.0 && depth > 0.0 && room <= near && room < depth;
        if (p != 0.0 && !isHeld && depth > near) {
            seen.march = {depth / half, m, {}};
            return seen;
        }
        const bool isPressed = isHeld && push > tolerance * size;
        marks.push_back(!isPressed ? 0 : p > 0.0 ? 1 : -1);
        Extremes& all = seen.extremes;
        if (isHeld) {
            all.impulse += 2.0 * push / cells;
            all.contactTime += isPressed ? 1.0 / cells : 0.0;
            all.peakForce = std::max(all.peakForce, isPressed ? 2.0 * push : 0.0);
        } else {
            opening -= p;
            all.lowestTip = std::min(all.lowestTip, places.wall - opening / half);
            all.approachSpeed =
                std::max(all.approachSpeed, p != 0.0 && -depth <= near ? 2.0 * push : 0.0);
        }
        takeStep(now, isHeld);
        if (seen.returns == 0 && count % (m + 1) == 0 && distance(now, start) <= tolerance * size) {
            seen.returns = m + 1;
        }
    }
    const double change = distance(now, start);
    seen.march = {size > 0.0 ? change / size : change, -1, phasesOf(marks)};
    return seen;
}

/// Waves in long stretches of one value each, so that whole pieces do the same to the tip.
inline State stretches(std::mt19937_64& draw, std::int64_t cells)
{
    const auto below = [&draw](std::int64_t end) {
        return std::uniform_int_distribution<std::int64_t>(0, end - 1)(draw);
    };
    std::vector<double> waves;
    const bool isRugged = below(3) == 0;
    while (waves.size() < 2 * static_cast<std::size_t>(cells)) {
        const auto value = static_cast<double>(below(5) - 2);
        waves.insert(waves.end(), static_cast<std::size_t>(1 + below(isRugged ? 4 : cells)), value);
    }
    const Eigen::Map<const Eigen::VectorXd> all(waves.data(), 2 * cells);
    return {all.head(cells), all.tail(cells)};
}

/// Shifts a wave so that the tip starts `opening` (a multiple of 1/2) before the wall.
inline void place(State& state, int wall, double opening)
{
    const double half = 0.5 * static_cast<double>(state.cells());
    const double now = wall * half + 0.5 * (state.a - state.b).sum();
    state.a[0] += 2.0 * (opening - now);
}

}  // namespace signorini::test
