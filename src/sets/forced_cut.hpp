#pragma once
/// \file
/// A line in the plane of excitations while rows cut it.

#include <algorithm>
#include <cmath>

#include "forced_line.hpp"
#include "infinity.hpp"

namespace signorini {

/// Rows that are 0 but for rounding, relative to the largest.
inline constexpr double roundOff = 3e-13;

[[nodiscard]] inline double size(Plane x)
{
    return std::abs(x.c) + std::abs(x.s);
}

/// The line while rows cut it.
class ForcedCut {
public:
    /// gap . (C, S) = place.
    ForcedCut(Plane gap, double place, double size, bool isPlane, bool canRest) : isPlane_(isPlane)
    {
        line_.canRest = canRest;
        const double squares = gap.dot(gap);
        line_.hasLine = squares > roundOff * roundOff * size * size && std::isfinite(1.0 / squares);
        if (!line_.hasLine) {
            return;
        }
        const double length = std::sqrt(squares);
        line_.foot = (place / squares) * gap;
        line_.direction = (1.0 / length) * Plane{-gap.s, gap.c};
        far_ = farAway / length;
        line_.low = isPlane ? -far_ : 0.0;
        line_.high = isPlane ? far_ : 0.0;
    }

    [[nodiscard]] bool isEmpty() const { return line_.isEmpty(); }

    /// row . (C, S) >= limit. \return is anything left?
    bool by(Plane row, const ForcedCondition& condition, double limit = 0.0)
    {
        const double offset = row.dot(line_.foot) - limit;
        const double slope = row.dot(line_.direction);
        if (offset + slope * line_.low >= 0.0 && offset + slope * line_.high >= 0.0) {
            return true;
        }
        if (std::abs(slope) * far_ <= std::abs(offset)) {
            if (const double lack = -offset / std::sqrt(row.dot(row)); lack > missed_) {
                missed_ = lack;
                line_.blocking = condition;
            }
            return !isEmpty();
        }
        const double t = -offset / slope;
        if (slope > 0.0 && t > line_.low) {
            line_.low = t;
            line_.lowRow = condition;
        } else if (slope < 0.0 && t < line_.high) {
            line_.high = t;
            line_.highRow = condition;
        }
        return !isEmpty();
    }

    /// Is a row along the line, but for rounding?
    [[nodiscard]] bool isParallel(Plane row) const
    {
        constexpr double parallel = 1e-12;
        return std::abs(row.dot(line_.direction)) <= parallel * size(row);
    }
    /// Is row . (C, S) the limit on all of the line? So it is where a flight ends at another stop
    /// whatever the excitation.
    [[nodiscard]] bool holdsAll(Plane row, double limit) const
    {
        constexpr double near = 1e-9;
        return isParallel(row) &&
               std::abs(row.dot(line_.foot) - limit) <= near * std::max(size(row), std::abs(limit));
    }

    /// row . (C, S) = value. What holds already, but for rounding, holds.
    bool to(Plane row, const ForcedCondition& condition, double value = 0.0)
    {
        const double least = roundOff * (size(row) * size(line_.foot) + std::abs(value));
        if (line_.low == line_.high && std::abs(row.dot(line_.at(line_.low)) - value) <= least) {
            return true;
        }
        return by(row, condition, value) && by(-1.0 * row, condition, -value);
    }

    [[nodiscard]] ForcedLine result() const
    {
        ForcedLine whole = line_;
        if (isPlane_ && line_.low == -far_) {
            whole.low = -infinity;
        }
        if (isPlane_ && line_.high == far_) {
            whole.high = infinity;
        }
        return whole;
    }

private:
    // Amplitudes beyond this many times the least one of the line count as infinite.
    static constexpr double farAway = 1e9;
    ForcedLine line_;
    bool isPlane_;
    double far_ = 0.0;
    double missed_ = 0.0;  ///< by the blocking row
};

}  // namespace signorini
