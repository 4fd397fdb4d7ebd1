#pragma once
/// \file
/// What conditions through 0 leave of the plane (C, S).

#include <optional>

#include "forced_cut.hpp"

namespace signorini {

/// Conditions that miss by less than this part of their size refute nothing.
inline constexpr double nearMiss = 1e-7;

/// What rows leave of all directions (C, S), or of the two of a line through 0.
class Directions {
public:
    Directions(std::optional<Plane> normal, double nothing) : nothing_(nothing)
    {
        if (normal) {
            along_ = {-normal->s, normal->c};
            low_ = *along_;
            high_ = -1.0 * *along_;
        }
    }

    /// One of the two of a line, while it is left.
    [[nodiscard]] std::optional<Plane> only() const
    {
        return along_ && low_.has_value() != high_.has_value() ? (low_ ? low_ : high_)
                                                               : std::nullopt;
    }

    /// row . (C, S) >= 0. \return is anything left?
    bool by(Plane row)
    {
        if (size(row) <= nothing_) {
            return true;
        }
        const auto leaves = [&](const std::optional<Plane>& way) {
            return way && row.dot(*way) >= -nearMiss * size(row) * size(*way);
        };
        if (along_) {
            low_ = leaves(low_) ? low_ : std::nullopt;
            high_ = leaves(high_) ? high_ : std::nullopt;
            return low_ || high_;
        }
        if (!low_) {
            low_ = Plane{row.s, -row.c};
            high_ = -1.0 * *low_;
            return true;
        }
        const bool hasLow = leaves(low_);
        const bool hasHigh = leaves(high_);
        if (!hasLow && !hasHigh) {
            return false;
        }
        low_ = hasLow ? low_ : Plane{row.s, -row.c};
        high_ = hasHigh ? high_ : Plane{-row.s, row.c};
        return true;
    }

private:
    double nothing_;
    std::optional<Plane> along_;  ///< of a line
    std::optional<Plane> low_;    ///< of a line: is it left? Else its ends, the turn from low to
    std::optional<Plane> high_;   ///< high being to the left
};

}  // namespace signorini
