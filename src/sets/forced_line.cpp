#include "forced_line.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini {

namespace {

// Amplitudes beyond this many times the least one of the line count as infinite.
constexpr double farAway = 1e9;
// Rows that are 0 but for rounding, relative to the largest.
constexpr double roundOff = 1e-13;

double size(Plane x)
{
    return std::abs(x.c) + std::abs(x.s);
}

}  // namespace

/// The line while rows cut it.
struct ForcedWaves::Cut {
    ForcedLine line;
    double limit;

    double missed = 0.0;  ///< by the blocking row

    Cut(Plane gap, double size, bool isPlane)
    {
        const double squares = gap.dot(gap);
        line.hasLine = squares > roundOff * roundOff * size * size && std::isfinite(1.0 / squares);
        if (!line.hasLine) {
            return;
        }
        const double length = std::sqrt(squares);
        line.foot = (1.0 / squares) * gap;
        line.direction = (1.0 / length) * Plane{-gap.s, gap.c};
        limit = farAway / length;
        line.low = isPlane ? -limit : 0.0;
        line.high = isPlane ? limit : 0.0;
    }

    /// row . (C, S) >= 0. \return is anything left?
    bool by(Plane row, std::int64_t step)
    {
        const double offset = row.dot(line.foot);
        const double slope = row.dot(line.direction);
        if (offset + slope * line.low >= 0.0 && offset + slope * line.high >= 0.0) {
            return true;
        }
        if (std::abs(slope) * limit <= std::abs(offset)) {
            if (const double lack = -offset / std::sqrt(row.dot(row)); lack > missed) {
                missed = lack;
                line.isBlocked = true;
                line.blocking = step;
            }
            return !line.isEmpty();
        }
        const double t = -offset / slope;
        if (slope > 0.0 && t > line.low) {
            line.low = t;
            line.lowRow = step;
        } else if (slope < 0.0 && t < line.high) {
            line.high = t;
            line.highRow = step;
        }
        return !line.isEmpty();
    }

    [[nodiscard]] ForcedLine result(bool isPlane) const
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        ForcedLine whole = line;
        if (isPlane && line.low == -limit) {
            whole.low = -infinity;
        }
        if (isPlane && line.high == limit) {
            whole.high = infinity;
        }
        return whole;
    }
};

ForcedWaves::ForcedWaves(std::int64_t cells, double rho, std::span<const Excitation> shapes)
    : cells_(cells),
      steps_(shapes.front().steps()),
      classes_(std::gcd(2 * cells, steps_)),
      rho_(rho),
      isPlane_(shapes.size() == 2),
      p_(static_cast<std::size_t>(steps_)),
      kinds_(static_cast<std::size_t>(classes_), ClassKind::damped)
{
    const double admittance = 0.5 * (1.0 + rho);  // 1/(1 + eta)
    const auto of = [&](auto value) {
        return Plane{value(shapes.front()), isPlane_ ? value(shapes.back()) : 0.0};
    };
    for (std::int64_t m = 0; m < steps_; ++m) {
        force_.push_back(of([m](const Excitation& e) { return e.force(m); }));
        fromBase_.push_back(
            of([m, this](const Excitation& e) { return e.baseVelocity(m + cells_); }));
        place_.push_back(of([m](const Excitation& e) { return e.baseDisplacement(m); }));
        fromTip_.push_back(fromBase_.back() - admittance * force_.back());
    }
    for (std::int64_t j = 0; j < classes_; ++j) {
        solveClass(j);
    }
}

void ForcedWaves::setContact(std::int64_t contact)
{
    while (contact_ != contact) {
        const std::int64_t changed = contact > contact_ ? contact_++ : --contact_;
        solveClass(changed % classes_);
    }
}

void ForcedWaves::solveClass(std::int64_t first)
{
    const std::int64_t stride = 2 * cells_ % steps_;
    const std::int64_t members = steps_ / classes_;
    const std::int64_t contactMembers =
        contact_ > first ? (contact_ - first + classes_ - 1) / classes_ : 0;
    const std::int64_t flights = members - contactMembers;
    // Around the class a wave is multiplied by (-rho)^flights; its deviation from 1 is what holds
    // the class in place.
    const double decay = static_cast<double>(flights) * std::log(rho_);
    const double grip = flights % 2 == 0 ? -std::expm1(decay) : 1.0 + std::exp(decay);
    ClassKind& kind = kinds_[static_cast<std::size_t>(first)];
    held_ -= kind == ClassKind::held ? 1 : 0;
    undamped_ -= kind == ClassKind::undamped ? 1 : 0;
    kind = flights == 0 ? ClassKind::held : grip <= 0.0 ? ClassKind::undamped : ClassKind::damped;
    held_ += kind == ClassKind::held ? 1 : 0;
    undamped_ += kind == ClassKind::undamped ? 1 : 0;
    if (kind == ClassKind::undamped) {
        return;
    }
    const auto goRound = [&](Plane p, auto see) {
        std::int64_t m = first;
        for (std::int64_t k = 0; k < members; ++k) {
            const auto at = static_cast<std::size_t>(m);
            see(at, p);
            p = m < contact_ ? p + fromBase_[at] : fromTip_[at] - rho_ * p;
            m += stride;
            m -= m >= steps_ ? steps_ : 0;
        }
        return p;
    };
    Plane push;
    const Plane around = goRound({}, [&](std::size_t at, Plane p) {
        push = kind == ClassKind::held ? push + force_[at] + 2.0 * p : push;
    });
    const double share = kind == ClassKind::held ? -0.5 / static_cast<double>(members) : 1.0 / grip;
    goRound(share * (kind == ClassKind::held ? push : around),
            [this](std::size_t at, Plane p) { p_[at] = p; });
}

Plane ForcedWaves::tip(std::int64_t m) const
{
    Plane sum;
    for (std::int64_t left = 2 * cells_, at = m % steps_; left > 0; at = 0) {
        const std::int64_t end = std::min(steps_, at + left);
        left -= end - at;
        // Four sums at a time: each alone waits for its last addition.
        const Plane* p = p_.data();
        Plane others[3];
        for (; at + 4 <= end; at += 4) {
            sum = sum + p[at];
            others[0] = others[0] + p[at + 1];
            others[1] = others[1] + p[at + 2];
            others[2] = others[2] + p[at + 3];
        }
        sum = sum + others[0] + others[1] + others[2];
        for (; at < end; ++at) {
            sum = sum + p[at];
        }
    }
    return place_[static_cast<std::size_t>((m + cells_) % steps_)] -
           (1.0 / static_cast<double>(cells_)) * sum;
}

ForcedLine ForcedWaves::line(bool isHasty)
{
    // A sample of the waves tells how large numbers are.
    double scale = size(wave(0));
    for (std::int64_t m = 0; m < steps_; m += 1 + steps_ / 16) {
        scale = std::max(scale, size(wave(m)) + size(place_[static_cast<std::size_t>(m)]));
    }
    Cut cut(tip(0), scale, isPlane_);
    if (!cut.line.hasLine) {
        return cut.line;
    }
    // In a class that is held all the time a row fixes no more than the class's own amplitude.
    const auto isFree = [this](std::int64_t m) {
        return held_ > 0 && kinds_[static_cast<std::size_t>(m % classes_)] == ClassKind::held;
    };
    const auto cutByContact = [&](std::int64_t m) { return isFree(m) || cut.by(push(m), m); };
    const auto finish = [&] {
        lastRows_ = {cut.line.lowRow, cut.line.highRow};
        return cut.result(isPlane_);
    };
    // What left nothing of the schedule before is likely to leave nothing of this one.
    for (const std::int64_t m : lastRows_) {
        if (isHasty && m >= 0 && m < contact_ && !cutByContact(m)) {
            return finish();
        }
    }
    for (std::int64_t m = 0; m < contact_; ++m) {
        if (!cutByContact(m) && isHasty) {
            return finish();
        }
    }
    // The last prefix is 0 for every motion, and others may be: what is left of them is rounding.
    double largest = 0.0;
    for (std::int64_t m = contact_; m < steps_; ++m) {
        largest = std::max(largest, size(wave(m)));
    }
    Plane prefix;
    for (std::int64_t m = contact_; m + 1 < steps_; ++m) {
        prefix = prefix - push(m);
        if (size(prefix) > roundOff * largest && !cut.by(prefix, m) && isHasty) {
            return finish();
        }
    }
    return finish();
}

}  // namespace signorini
