#include "stepped_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace signorini {

SteppedCells::SteppedCells(std::span<const Segment> segments, const State& state)
    : a_(state.a.begin(), state.a.end()), b_(state.b.begin(), state.b.end())
{
    std::size_t next = 0;
    for (const Segment& segment : segments) {
        const std::size_t first =
            std::exchange(next, next + static_cast<std::size_t>(segment.cells));
        parts_.push_back({first, next - 1, segment.impedance / segments.front().impedance,
                          segment.speed / segments.front().speed,
                          segment.dashpot / segments.front().impedance});
    }
}

double SteppedCells::tip() const
{
    double sum = 0.0;
    for (std::size_t k = 0; k < a_.size(); ++k) {
        sum += b_[k] - a_[k];
    }
    return sum / static_cast<double>(a_.size());
}

double SteppedCells::size() const
{
    double largest = 0.0;
    for (const auto* wave : {&a_, &b_}) {
        for (const double value : *wave) {
            if (!std::isfinite(value)) {
                return std::numeric_limits<double>::infinity();
            }
            largest = std::max(largest, std::abs(value));
        }
    }
    return largest;
}

double SteppedCells::distance(const State& other) const
{
    double largest = 0.0;
    for (std::size_t k = 0; k < a_.size(); ++k) {
        const auto cell = static_cast<Eigen::Index>(k);
        largest =
            std::max({largest, std::abs(a_[k] - other.a[cell]), std::abs(b_[k] - other.b[cell])});
    }
    return largest;
}

void SteppedCells::see(double a, double b, const Part& part)
{
    const double strain = (b - a) / part.speed;
    lowest_ = std::min(lowest_, strain);
    highest_ = std::max(highest_, strain);
}

void SteppedCells::step(bool isHeld)
{
    // Waves meet in a cell, on their way to the next, and where they leave an end.
    for (const Part& part : parts_) {
        for (std::size_t k = part.first; k <= part.last; ++k) {
            see(a_[k], b_[k], part);
            if (k < part.last) {
                see(a_[k], b_[k + 1], part);
            }
        }
    }
    double entering = -b_.front();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = parts_[i];
        const double a = a_[part.last];
        double back = isHeld ? -a : a;
        double onward = 0.0;
        if (i + 1 < parts_.size()) {
            const Part& next = parts_[i + 1];
            const double b = b_[next.first];
            const double v = (2.0 * part.impedance * a + 2.0 * next.impedance * b) /
                             (part.impedance + next.impedance + part.dashpot);
            back = v - a;
            onward = v - b;
        }
        see(entering, b_[part.first], part);
        see(a, back, part);
        for (std::size_t k = part.last; k > part.first; --k) {
            a_[k] = a_[k - 1];
        }
        for (std::size_t k = part.first; k < part.last; ++k) {
            b_[k] = b_[k + 1];
        }
        a_[part.first] = entering;
        b_[part.last] = back;
        entering = onward;
    }
}

}  // namespace signorini
