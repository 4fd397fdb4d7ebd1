#include "resting_tip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "forced_cut.hpp"
#include "infinity.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

constexpr std::size_t mostTriedCorners = 5000;  // of a polygon, evenly chosen from more
constexpr double rounding = 1e-12;              // of pushes that are alike

class RestingTip {
public:
    RestingTip(const ForcedWaves& waves, const Schedule& schedule)
        : waves_(waves),
          steps_(steps(schedule)),
          contact_(schedule.phases.front().contact),
          gap_(waves.tip(0)),
          held_(waves.freeClasses()),
          isHeld_(static_cast<std::size_t>(waves.classes()), false)
    {
        for (const std::int64_t j : held_) {
            isHeld_[static_cast<std::size_t>(j)] = true;
        }
        for (std::int64_t m = 0; m < steps_; ++m) {
            size_ = std::max(size_, size(waves.push(m)));
        }
    }

    /// A unit vector, and the excitation that goes farthest along it.
    struct Corner {
        Plane way;
        double angle = 0.0;
        double reach = 0.0;
    };

    /// Directions in which the step of least push changes, where some excitation is borne.
    [[nodiscard]] std::vector<Corner> corners() const
    {
        std::vector<Corner> all;
        for (std::int64_t j = 0; j < waves_.classes(); ++j) {
            std::vector<std::pair<double, Plane>> around;
            for (std::int64_t m = j; m < steps_; m += waves_.classes()) {
                const Plane push = waves_.push(m) - mean(j);
                around.emplace_back(portable::atan2(push.s, push.c), push);
            }
            std::sort(around.begin(), around.end(),
                      [](const auto& x, const auto& y) { return x.first < y.first; });
            for (std::size_t k = 0; k < around.size(); ++k) {
                const Plane edge = around[(k + 1) % around.size()].second - around[k].second;
                if (const double length = std::sqrt(edge.dot(edge)); length > rounding * size_) {
                    add(all, (1.0 / length) * Plane{-edge.s, edge.c});
                    add(all, (1.0 / length) * Plane{edge.s, -edge.c});
                }
            }
        }
        std::sort(all.begin(), all.end(),
                  [](const Corner& x, const Corner& y) { return x.angle < y.angle; });
        all.erase(std::unique(all.begin(), all.end(),
                              [](const Corner& x, const Corner& y) {
                                  return y.angle - x.angle <= rounding;
                              }),
                  all.end());
        return all;
    }

    void add(std::vector<Corner>& all, Plane way) const
    {
        if (const double reach = reachOf(way); reach > 0.0) {
            all.push_back({way, portable::atan2(way.s, way.c), reach});
        }
    }

    /// How far an excitation may go; infinite: there is no end.
    [[nodiscard]] double reachOf(Plane way) const
    {
        for (std::int64_t m = 0; m < contact_; ++m) {
            if (!isHeld(m) && waves_.push(m).dot(way) < -rounding * size_) {
                return 0.0;
            }
        }
        const auto classes = static_cast<double>(waves_.classes());
        double needed = -classes * gap_.dot(way);
        for (const std::int64_t j : held_) {
            needed += lackOf(j, way);
        }
        return needed > rounding * classes * size_ ? classes / needed : infinity;
    }

    /// The place with its amplitudes: each class presses no more than it has to, and what is left
    /// is shared.
    [[nodiscard]] ForcedCorner at(Plane place) const
    {
        const auto classes = static_cast<double>(waves_.classes());
        ForcedCorner corner{{place.c, place.s}, {}};
        double left = 0.5 * classes * (1.0 + gap_.dot(place));
        for (const std::int64_t j : held_) {
            corner.free.push_back(0.5 * lackOf(j, place));
            left -= corner.free.back();
        }
        for (double& z : corner.free) {
            z += left / static_cast<double>(held_.size());
        }
        return corner;
    }

private:
    [[nodiscard]] bool isHeld(std::int64_t m) const
    {
        return isHeld_[static_cast<std::size_t>(m % waves_.classes())];
    }

    [[nodiscard]] Plane mean(std::int64_t j) const
    {
        Plane sum;
        for (std::int64_t m = j; m < steps_; m += waves_.classes()) {
            sum = sum + waves_.push(m);
        }
        return (static_cast<double>(waves_.classes()) / static_cast<double>(steps_)) * sum;
    }

    /// 2z that R >= 0 needs in a class that is always in contact.
    [[nodiscard]] double lackOf(std::int64_t j, Plane place) const
    {
        double lack = -infinity;
        for (std::int64_t m = j; m < steps_; m += waves_.classes()) {
            lack = std::max(lack, -waves_.push(m).dot(place));
        }
        return lack;
    }

    const ForcedWaves& waves_;
    std::int64_t steps_;
    std::int64_t contact_;
    Plane gap_;
    std::vector<std::int64_t> held_;
    std::vector<bool> isHeld_;  ///< of each class
    double size_ = 0.0;
};

}  // namespace

ForcedPolytope restingTip(const ForcedWaves& waves, const Schedule& schedule, bool isPlane)
{
    const RestingTip tip(waves, schedule);
    std::vector<RestingTip::Corner> corners;
    if (isPlane) {
        corners = tip.corners();
    } else {
        tip.add(corners, {1.0, 0.0});
        tip.add(corners, {-1.0, 0.0});
    }
    ForcedPolytope all;
    double gap = corners.empty() ? infinity : 0.0;  // widest angle without a corner
    std::size_t first = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::size_t next = (k + 1) % corners.size();
        double width = corners[next].angle - corners[k].angle;
        width += next == 0 ? 2.0 * std::numbers::pi : 0.0;
        if (width > gap) {
            gap = width;
            first = next;
        }
    }
    // Rest without excitation is a corner unless excitations of all directions surround it.
    if (gap >= std::numbers::pi * (1.0 - rounding)) {
        all.corners.push_back(tip.at({}));
    }
    const std::size_t stride = 1 + corners.size() / mostTriedCorners;
    for (std::size_t k = 0; k < corners.size(); k += stride) {
        const RestingTip::Corner& corner = corners[(first + k) % corners.size()];
        all.isBounded = all.isBounded && std::isfinite(corner.reach);
        all.corners.push_back(tip.at(std::min(corner.reach, 1e6) * corner.way));
    }
    return all;
}

}  // namespace signorini
