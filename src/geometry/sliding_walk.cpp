#include <algorithm>
#include <cmath>
#include <numbers>

#include "faults.hpp"
#include "portable.hpp"
#include "sphere_section.hpp"

namespace signorini {

/// Amplitudes [sum z] below this are on the face: two that reach it together differ by rounding.
constexpr double negligible = 1e-15;

/// A radius [sum z] below this is that of a point: rounding makes 1e-17 of 0.
constexpr double shrunk = 1e-10;

SlidingWalk::SlidingWalk(const SphereSection& section, std::span<const double> from,
                         std::span<const double> direction)
    : section_(section),
      z_(from.begin(), from.end()),
      wish_(direction.begin(), direction.end()),
      active_(from.size(), false)
{
    if (z_.size() != wish_.size() || static_cast<std::int64_t>(z_.size()) != section.count) {
        throw std::invalid_argument(fmt::format(
            "direction = {} amplitudes is out of range: allowed {}", wish_.size(), section.count));
    }
    for (double& value : z_) {
        value = value > negligible ? value : 0.0;
    }
    settle();
    if (!leaveEqualAmplitudes()) {
        findTangent();
    }
}

/// Where all amplitudes that are not zero are equal, the sphere of their face is this point alone,
/// and no zero may grow in proportion to the angle: sum z^2 would fall.
/// But a great circle of the whole sphere that starts along the face curves into the set: the zeros
/// grow as 1 - cos(angle).
bool SlidingWalk::leaveEqualAmplitudes()
{
    constexpr double rounding = 1e-9;
    double members = 0.0;
    double sum = 0.0;
    for (std::size_t j = 0; j < z_.size(); ++j) {
        members += z_[j] > 0.0 ? 1.0 : 0.0;
        sum += z_[j] > 0.0 ? wish_[j] : 0.0;
    }
    double squares = 0.0;
    tangent_.assign(z_.size(), 0.0);
    for (std::size_t j = 0; j < z_.size(); ++j) {
        if (z_[j] > 0.0 && std::abs(z_[j] * members - 1.0) > rounding) {
            return false;
        }
        tangent_[j] = z_[j] > 0.0 ? wish_[j] - sum / members : 0.0;
        squares += tangent_[j] * tangent_[j];
    }
    const auto count = static_cast<double>(z_.size());
    centre_ = 1.0 / count;
    radius_ = std::sqrt(std::max(0.0, 1.0 / members - centre_));
    if (!(squares > 1e-24 && radius_ > shrunk)) {
        return false;
    }
    for (double& value : tangent_) {
        value /= std::sqrt(squares);
    }
    wish_ = tangent_;
    return true;
}

/// Moves the amplitudes that are not active back onto sum 1 and sum z^2 = rho: setting one to zero
/// costs what it was, 1e-8 where the sphere of the others shrinks to a point.
void SlidingWalk::settle()
{
    double members = 0.0;
    double sum = 0.0;
    for (std::size_t j = 0; j < z_.size(); ++j) {
        members += active_[j] ? 0.0 : 1.0;
        sum += active_[j] ? 0.0 : z_[j];
    }
    const double mean = sum / members;
    double squares = 0.0;
    for (std::size_t j = 0; j < z_.size(); ++j) {
        squares += active_[j] ? 0.0 : (z_[j] - mean) * (z_[j] - mean);
    }
    const double wanted = std::sqrt(std::max(0.0, section_.ratio - 1.0 / members));
    const double scale = squares > 0.0 ? wanted / std::sqrt(squares) : 1.0;
    for (std::size_t j = 0; j < z_.size(); ++j) {
        if (!active_[j]) {
            const double settled = 1.0 / members + scale * (z_[j] - mean);
            z_[j] = settled > negligible ? settled : 0.0;
        }
    }
}

/// The part of the wish that keeps sum and sum z^2, without the active amplitudes. Those that are
/// zero and would become negative become active. Leaving one out changes the others, so this
/// repeats until nothing is left out.
void SlidingWalk::findTangent()
{
    const std::size_t count = z_.size();
    for (bool changed = true; changed;) {
        changed = false;
        double members = 0.0;
        double sum = 0.0;
        for (std::size_t j = 0; j < count; ++j) {
            members += active_[j] ? 0.0 : 1.0;
            sum += active_[j] ? 0.0 : wish_[j];
        }
        centre_ = 1.0 / std::max(members, 1.0);
        double along = 0.0;
        double squares = 0.0;
        for (std::size_t j = 0; j < count; ++j) {
            const double out = active_[j] ? 0.0 : z_[j] - centre_;
            along += out * wish_[j];
            squares += out * out;
        }
        radius_ = std::sqrt(squares);
        tangent_.assign(count, 0.0);
        double length = 0.0;
        for (std::size_t j = 0; j < count; ++j) {
            if (!active_[j]) {
                const double out = z_[j] - centre_;
                tangent_[j] =
                    wish_[j] - sum * centre_ - (squares > 0.0 ? along / squares * out : 0.0);
                length += tangent_[j] * tangent_[j];
            }
        }
        length = std::sqrt(length);
        canMove_ = length > 1e-12 && radius_ > shrunk;
        for (std::size_t j = 0; canMove_ && j < count; ++j) {
            tangent_[j] /= length;
            if (!active_[j] && z_[j] <= 0.0 && tangent_[j] < 0.0) {
                active_[j] = changed = true;
            }
        }
    }
}

/// On the circle z_j = centre + out cos(t) + radius tangent sin(t), the first t > 0 at which an
/// amplitude falls through zero.
double SlidingWalk::angleToFace(std::size_t& meets) const
{
    constexpr double turn = 2.0 * std::numbers::pi;
    double first = turn;
    meets = z_.size();
    for (std::size_t j = 0; j < z_.size(); ++j) {
        const double cosine = z_[j] - centre_;
        const double sine = radius_ * tangent_[j];
        const double swing = portable::hypot(cosine, sine);
        if (active_[j] || swing <= centre_) {
            continue;
        }
        // At the face already, but for rounding, and falling: now, not after a whole turn.
        constexpr double rounding = 1e-7;
        const double falls = portable::atan2(sine, cosine) + portable::acos(-centre_ / swing);
        const bool isNow = sine < 0.0 && falls <= 0.0 && falls > -rounding;
        const double angle = isNow ? 0.0 : falls <= 0.0 ? falls + turn : falls;
        if (angle < first) {
            first = angle;
            meets = j;
        }
    }
    return first;
}

const std::vector<double>& SlidingWalk::advance(double length)
{
    while (canMove_ && length > 0.0) {
        std::size_t meets = 0;
        const double face = angleToFace(meets);
        const double angle = std::min(length / radius_, face);
        const double c = portable::cos(angle);
        const double s = portable::sin(angle);
        for (std::size_t j = 0; j < z_.size(); ++j) {
            if (active_[j]) {
                continue;
            }
            const double out = z_[j] - centre_;
            const double next = centre_ + c * out + s * radius_ * tangent_[j];
            z_[j] = next > negligible ? next : 0.0;
            tangent_[j] = c * tangent_[j] - s * out / radius_;
        }
        length -= angle * radius_;
        if (angle == face && meets < z_.size()) {
            z_[meets] = 0.0;
            active_[meets] = true;
            settle();
        }
        wish_ = tangent_;
        findTangent();
    }
    return z_;
}

}  // namespace signorini
