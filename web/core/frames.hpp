#pragma once
/// \file
/// What is drawn of a motion: displacements at places and instants of equal distance, as many as a
/// screen shows, and path of the tip and force of the wall as finely as they are known.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "request.hpp"

namespace signorini::web {

inline constexpr std::int64_t mostPlaces = 300;     ///< stretches of the bar
inline constexpr std::int64_t mostRows = 600;       ///< instants at which all of it is drawn
inline constexpr std::int64_t mostInstants = 2400;  ///< of tip and force

/// Times in L/c, displacements in g, forces in EA g/L.
struct Frames {
    std::int64_t places = 1;
    std::vector<double> times = {};
    std::vector<double> u = {};  ///< time by time, places + 1 of them
    std::vector<double> pathTimes = {};
    std::vector<double> tip = {};
    std::vector<double> force = {};

    explicit Frames(std::int64_t cells) : places(std::min(cells, mostPlaces)) {}

    /// A motion that is known at any time: u(share of the bar, t), force(t) with that sign which is
    /// largest in size until the next instant.
    template <typename U, typename Force>
    void take(double period, std::int64_t steps, U displacement, Force force_at)
    {
        const auto instant = [&](std::int64_t k, std::int64_t count) {
            return period * static_cast<double>(k) / static_cast<double>(count);
        };
        const std::int64_t rows = std::min(steps, mostRows);
        for (std::int64_t k = 0; k <= rows; ++k) {
            times.push_back(instant(k, rows));
            for (std::int64_t i = 0; i <= places; ++i) {
                u.push_back(displacement(static_cast<double>(i) / static_cast<double>(places),
                                         times.back()));
            }
        }
        const std::int64_t stride = (steps + mostInstants - 1) / mostInstants;
        for (std::int64_t m = 0; m <= steps; m = m < steps ? std::min(m + stride, steps) : m + 1) {
            pathTimes.push_back(instant(m, steps));
            tip.push_back(displacement(1.0, pathTimes.back()));
            double most = 0.0;
            for (std::int64_t j = m; j < std::min(m + stride, steps); ++j) {
                const double now = force_at(instant(j, steps));
                most = std::abs(now) > std::abs(most) ? now : most;
            }
            force.push_back(m < steps ? most : force.back());
        }
    }

    void addTo(Reply& reply) const
    {
        reply.json["nodes"] = places + 1;
        reply.add("times", times);
        reply.add("u", u);
        reply.add("path_times", pathTimes);
        reply.add("tip", tip);
        reply.add("force", force);
    }
};

}  // namespace signorini::web
