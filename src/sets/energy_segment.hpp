#pragma once
/// \file
/// The motions of one energy in a set of one dimension: one or two.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "vertex_graph.hpp"

namespace signorini {

/// z = from + t way, 0 <= t <= 1, where sum z^2 has a value: |from|^2 + 2 t from.way + t^2 |way|^2.
class EnergySegment {
public:
    /// \pre the ends differ, and the value lies between the least and the most on the segment.
    EnergySegment(std::vector<double> from, std::vector<double> to, double squares)
        : from_(std::move(from)), way_(std::move(to))
    {
        for (std::size_t j = 0; j < from_.size(); ++j) {
            way_[j] -= from_[j];
        }
        const double length = squaresOf(way_);
        const double slope = along(from_);
        const double root =
            std::sqrt(std::max(0.0, slope * slope + length * (squares - squaresOf(from_))));
        // What is at an end, or twice, but for rounding, is there, and once.
        const double rounding = vertexRounding * squares / length;
        for (const double t : {(-slope - root) / length, (-slope + root) / length}) {
            const bool isAgain = !places_.empty() && t <= places_.front() + rounding;
            if (t >= -rounding && t <= 1.0 + rounding && !isAgain) {
                places_.push_back(std::clamp(t, 0.0, 1.0));
            }
        }
    }

    /// t of each, ascending.
    [[nodiscard]] const std::vector<double>& places() const { return places_; }

    [[nodiscard]] std::vector<double> at(double t) const
    {
        std::vector<double> z = from_;
        for (std::size_t j = 0; j < z.size(); ++j) {
            z[j] += t * way_[j];
        }
        return z;
    }

    /// Which of them is nearest to these amplitudes.
    [[nodiscard]] std::size_t nearest(const std::vector<double>& z) const
    {
        const double t = (along(z) - along(from_)) / squaresOf(way_);
        const auto best = std::min_element(places_.begin(), places_.end(), [t](double x, double y) {
            return std::abs(x - t) < std::abs(y - t);
        });
        return static_cast<std::size_t>(best - places_.begin());
    }

private:
    [[nodiscard]] double along(const std::vector<double>& z) const
    {
        return std::inner_product(way_.begin(), way_.end(), z.begin(), 0.0);
    }

    std::vector<double> from_;
    std::vector<double> way_;
    std::vector<double> places_;
};

}  // namespace signorini
