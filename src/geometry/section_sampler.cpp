#include <algorithm>
#include <cmath>
#include <numbers>

#include "section_numbers.hpp"
#include "signorini/amplitude_set.hpp"
#include "sphere_section.hpp"

namespace signorini {

SectionSampler::SectionSampler(const AmplitudeSet& set, double squares, std::uint64_t seed)
    : set_(set), generator_(seed), z_(amplitudesWithSquares(set, squares))
{
    radius_ = std::sqrt(std::max(0.0, squares - leastSquares(set)));
}

const std::vector<double>& SectionSampler::next(int moves)
{
    for (int k = 0; k < moves; ++k) {
        if (set_.count > 2) {
            move();
        }
        if (set_.kind == SetKind::simplex) {
            std::shuffle(z_.begin(), z_.end(), generator_);
        } else if (isSymmetric() && std::bernoulli_distribution()(generator_)) {
            std::reverse(z_.begin(), z_.end());
        }
    }
    return z_;
}

/// Reversed amplitudes have the partial sums S - Z: in the box if its bounds are symmetric.
bool SectionSampler::isSymmetric() const
{
    return set_.kind == SetKind::box &&
           std::abs(set_.lower + set_.upper - set_.sum) <= 1e-15 * std::abs(set_.sum);
}

void SectionSampler::move()
{
    const double mean = set_.sum / static_cast<double>(set_.count);
    std::normal_distribution<double> normal;
    std::vector<double> direction(z_.size());
    for (double& value : direction) {
        value = normal(generator_);
    }
    // At right angles to (1, ..., 1) and to the radius, and as long as the radius.
    const double average = sumOf(direction) / static_cast<double>(z_.size());
    double along = 0.0;
    for (std::size_t j = 0; j < z_.size(); ++j) {
        direction[j] -= average;
        along += direction[j] * (z_[j] - mean);
    }
    const double squares = radius_ * radius_;
    if (!(squares > 0.0)) {
        return;  // equal amplitudes are the only member
    }
    for (std::size_t j = 0; j < z_.size(); ++j) {
        direction[j] -= along / squares * (z_[j] - mean);
    }
    const double length = std::sqrt(squaresOf(direction));
    for (double& value : direction) {
        value *= radius_ / length;
    }
    findArcs(direction);
    const double angle = drawAngle();
    std::vector<double> next(z_.size());
    for (std::size_t j = 0; j < z_.size(); ++j) {
        next[j] = mean + std::cos(angle) * (z_[j] - mean) + std::sin(angle) * direction[j];
        if (set_.kind == SetKind::simplex) {
            next[j] = std::max(next[j], 0.0);
        }
    }
    // Rounding must not add up over many moves.
    const double shift = (sumOf(next) - set_.sum) / static_cast<double>(next.size());
    double reached = 0.0;
    for (double& value : next) {
        value -= shift;
        reached += (value - mean) * (value - mean);
    }
    for (double& value : next) {
        value = mean + (value - mean) * radius_ / std::sqrt(reached);
    }
    z_ = std::move(next);
}

/// A bound level + x cos(angle) + y sin(angle) >= 0 fails within acos(level/A) of the angle
/// opposite to (x, y), A = |(x, y)|.
void SectionSampler::findArcs(const std::vector<double>& direction)
{
    outside_.clear();
    const auto bound = [this](double level, double x, double y) {
        const double size = std::hypot(x, y);
        if (size <= level) {
            return;
        }
        const double half = std::acos(std::clamp(level / size, -1.0, 1.0));
        double start = std::atan2(-y, -x) - half;
        start += start < 0.0 ? 2.0 * std::numbers::pi : 0.0;
        const double end = start + 2.0 * half;
        outside_.push_back({start, std::min(end, 2.0 * std::numbers::pi)});
        if (end > 2.0 * std::numbers::pi) {
            outside_.push_back({0.0, end - 2.0 * std::numbers::pi});
        }
    };
    const double mean = set_.sum / static_cast<double>(set_.count);
    double centre = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (std::size_t j = 0; j + 1 < z_.size() || (j < z_.size() && set_.kind != SetKind::box);
         ++j) {
        const bool isBox = set_.kind == SetKind::box;
        centre = (isBox ? centre : 0.0) + mean;
        x = (isBox ? x : 0.0) + z_[j] - mean;
        y = (isBox ? y : 0.0) + direction[j];
        bound(centre - (isBox ? set_.lower : 0.0), x, y);
        if (isBox) {
            bound(set_.upper - centre, -x, -y);
        }
    }
}

/// Evenly from the angles in no arc; 0, where the walk stands, if rounding leaves none.
double SectionSampler::drawAngle()
{
    std::sort(outside_.begin(), outside_.end(),
              [](const Arc& a, const Arc& b) { return a.start < b.start; });
    std::vector<Arc> inside;
    double reached = 0.0;
    double total = 0.0;
    const auto gapUpTo = [&](double end) {
        if (end > reached) {
            inside.push_back({reached, end});
            total += end - reached;
        }
    };
    for (const Arc& arc : outside_) {
        gapUpTo(arc.start);
        reached = std::max(reached, arc.end);
    }
    gapUpTo(2.0 * std::numbers::pi);
    double rest = std::uniform_real_distribution<double>(0.0, total)(generator_);
    for (const Arc& arc : inside) {
        if (rest <= arc.end - arc.start) {
            return arc.start + rest;
        }
        rest -= arc.end - arc.start;
    }
    return 0.0;
}

}  // namespace signorini
