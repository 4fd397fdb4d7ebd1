#pragma once
/// \file
/// The rows of a forced uniform bar, step by step from the law at the tip.

#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "signorini/certificate.hpp"
#include "signorini/schedule.hpp"
#include "signorini/simulation.hpp"

namespace signorini::test {

/// c C + s S + free . z >= limit, or = limit.
struct TrueRow {
    double c = 0.0;
    double s = 0.0;
    std::map<std::int64_t, double> free = {};  ///< class -> factor
    double limit = 0.0;
    bool isEquality = false;

    void add(const TrueRow& other, double factor)
    {
        c += factor * other.c;
        s += factor * other.s;
        for (const auto& [which, value] : other.free) {
            free[which] += factor * value;
        }
    }
    [[nodiscard]] double size() const { return std::abs(c) + std::abs(s); }
};

class TrueRows {
public:
    enum class Kind { damped, held, undamped };

    /// `isMean`: waves that are always held are such that R is 0 on average; else they start at 0.
    TrueRows(const Schedule& schedule, double rho, std::span<const Excitation> shapes, bool isMean)
        : schedule_(schedule),
          rho_(rho),
          shapes_(shapes),
          n_(steps(schedule)),
          classes_(std::gcd(2 * schedule.cells, n_)),
          unit_(static_cast<std::size_t>(n_)),
          waves_(shapes.size(), unit_)
    {
        for (std::size_t k = 0; k < schedule.phases.size(); ++k) {
            for (std::int64_t i = 0; i < schedule.phases[k].contact + schedule.phases[k].free;
                 ++i) {
                phase_.push_back(k);
                isHeld_.push_back(i < schedule.phases[k].contact);
                inPhase_.push_back(i);
            }
        }
        for (std::int64_t j = 0; j < classes_; ++j) {
            solve(j, isMean);
        }
    }

    [[nodiscard]] std::int64_t classes() const { return classes_; }
    [[nodiscard]] Kind kind(std::int64_t m) const { return kinds_[at(m % classes_)]; }
    [[nodiscard]] bool isHeld(std::int64_t m) const { return isHeld_[at(m)]; }
    [[nodiscard]] bool isLast(std::int64_t m) const
    {
        const Phase& phase = schedule_.phases[phase_[at(m)]];
        return inPhase_[at(m)] + 1 == phase.contact + phase.free;
    }
    [[nodiscard]] std::size_t phaseOf(std::int64_t m) const { return phase_[at(m)]; }

    [[nodiscard]] TrueRow wave(std::int64_t m) const
    {
        TrueRow row{waves_.front()[at(m)], waves_.size() > 1 ? waves_.back()[at(m)] : 0.0};
        if (kind(m) != Kind::damped) {
            row.free[m % classes_] = unit_[at(m)];
        }
        return row;
    }
    /// u(L, m).
    [[nodiscard]] TrueRow tip(std::int64_t m) const
    {
        const std::int64_t cells = schedule_.cells;
        TrueRow row = of([&](const Excitation& e) { return e.baseDisplacement(m + cells); });
        for (std::int64_t k = 0; k < 2 * cells; ++k) {
            row.add(wave((m + k) % n_), -1.0 / static_cast<double>(cells));
        }
        return row;
    }
    [[nodiscard]] TrueRow push(std::int64_t m) const
    {
        TrueRow row = of([m](const Excitation& e) { return e.force(m); });
        row.add(wave(m), 2.0);
        return row;
    }
    [[nodiscard]] double place(Stop stop) const
    {
        return stop == Stop::right ? schedule_.stops.right : -schedule_.stops.left->value();
    }

    /// None if the schedule has no such condition.
    [[nodiscard]] std::optional<TrueRow> row(const ForcedCondition& condition,
                                             double waveLimit) const
    {
        const std::int64_t m = condition.step;
        if (m < 0 || m >= n_) {
            return std::nullopt;
        }
        const auto& phases = schedule_.phases;
        const Stop stop = phases[phaseOf(m)].stop;
        TrueRow row;
        switch (condition.rule) {
            case ForcedRule::gap:
                row = tip(0);
                row.limit = place(phases.front().stop);
                row.isEquality = true;
                return row;
            case ForcedRule::pressure:
                row.add(push(m), sign(stop));
                return isHeld(m) ? std::optional(row) : std::nullopt;
            case ForcedRule::held:
                for (std::int64_t k = m % classes_; k < n_; k += classes_) {
                    if (!isHeld(k) || phases[phaseOf(k)].stop != stop) {
                        return std::nullopt;
                    }
                    row.add(push(k), sign(stop));
                }
                return row;
            case ForcedRule::penetration:
            case ForcedRule::secondStop:
            case ForcedRule::closure: {
                const bool isSecond = condition.rule == ForcedRule::secondStop;
                row.isEquality = condition.rule == ForcedRule::closure;
                if (isHeld(m) || (isSecond && !schedule_.stops.left) ||
                    (row.isEquality && !isLast(m))) {
                    return std::nullopt;
                }
                for (std::int64_t k = m; !isHeld(k); --k) {
                    row.add(push(k), isSecond ? 1.0 : -1.0);
                }
                const Stop next = phases[(phaseOf(m) + 1) % phases.size()].stop;
                const double to = row.isEquality ? place(next)
                                  : isSecond     ? place(Stop::left)
                                                 : place(Stop::right);
                row.limit = (isSecond ? 1.0 : -1.0) * (to - place(stop)) * 2.0 *
                            static_cast<double>(schedule_.cells) / (1.0 + rho_);
                return row;
            }
            case ForcedRule::work:
                if (kind(m) == Kind::damped) {
                    return std::nullopt;
                }
                row.c = work_[at(m % classes_)].c;
                row.s = work_[at(m % classes_)].s;
                row.isEquality = true;
                return row;
            case ForcedRule::strain:
                row.add(wave(m), -1.0);
                row.limit = -waveLimit;
                return std::isfinite(waveLimit) ? std::optional(row) : std::nullopt;
            case ForcedRule::rest:
                return std::nullopt;
        }
        return std::nullopt;
    }

private:
    static std::size_t at(std::int64_t m) { return static_cast<std::size_t>(m); }
    static double sign(Stop stop) { return stop == Stop::right ? 1.0 : -1.0; }
    template <typename Value>
    [[nodiscard]] TrueRow of(Value value) const
    {
        return {value(shapes_.front()), shapes_.size() > 1 ? value(shapes_.back()) : 0.0};
    }
    /// What comes back of a wave x that arrives in step j, having been written down on its way.
    double goRound(std::int64_t j, double x, const Excitation* e, std::vector<double>& seen) const
    {
        std::int64_t m = j;
        do {
            seen[at(m)] = x;
            x = isHeld(m) ? x : -rho_ * x - (e ? 0.5 * (1.0 + rho_) * e->force(m) : 0.0);
            x += e ? e->baseVelocity(m + schedule_.cells) : 0.0;
            m = (m + 2 * schedule_.cells) % n_;
        } while (m != j);
        return x;
    }
    void solve(std::int64_t j, bool isMean)
    {
        const double back = goRound(j, 1.0, nullptr, unit_);
        bool isAlwaysHeld = true;
        for (std::int64_t m = j; m < n_; m += classes_) {
            isAlwaysHeld = isAlwaysHeld && isHeld(m);
        }
        kinds_.push_back(isAlwaysHeld ? Kind::held : back == 1.0 ? Kind::undamped : Kind::damped);
        TrueRow work;
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            const double gained = goRound(j, 0.0, &shapes_[i], waves_[i]);
            (i == 0 ? work.c : work.s) = gained;
            double start = kinds_.back() == Kind::damped ? gained / (1.0 - back) : 0.0;
            if (isAlwaysHeld && isMean) {
                double sum = 0.0;
                for (std::int64_t m = j; m < n_; m += classes_) {
                    sum += shapes_[i].force(m) + 2.0 * waves_[i][at(m)];
                }
                start = -0.5 * sum * static_cast<double>(classes_) / static_cast<double>(n_);
            }
            goRound(j, start, &shapes_[i], waves_[i]);
        }
        work_.push_back(work);
    }

    Schedule schedule_;
    double rho_;
    std::span<const Excitation> shapes_;
    std::int64_t n_;
    std::int64_t classes_;
    std::vector<double> unit_;                ///< of z = 1
    std::vector<std::vector<double>> waves_;  ///< of each shape
    std::vector<std::size_t> phase_;          ///< of each step
    std::vector<bool> isHeld_;
    std::vector<std::int64_t> inPhase_;
    std::vector<Kind> kinds_;
    std::vector<TrueRow> work_;
};

/// What rows x + y t >= 0 leave of a line; 0 <= 0 but for rounding is met.
class TrueCut {
public:
    void by(double offset, double slope, double size)
    {
        if (std::abs(slope) <= 1e-10 * size) {
            isMissed_ = isMissed_ || offset < -1e-9 * size;
        } else {
            double& end = slope > 0.0 ? low_ : high_;
            const double t = -offset / slope;
            end = slope > 0.0 ? std::max(end, t) : std::min(end, t);
        }
    }
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    /// -1: certainly, 1: certainly not, 0: too near.
    [[nodiscard]] int emptiness() const
    {
        const double near = 1e-7 * (1.0 + std::min(std::abs(low_), std::abs(high_)));
        return isMissed_ || low_ > high_ + near ? 1 : low_ < high_ - near ? -1 : 0;
    }

private:
    double low_ = -1e8;
    double high_ = 1e8;
    bool isMissed_ = false;
};

/// Two ends, those beyond 1e6 being alike.
inline bool isSameEnd(double x, double y)
{
    return (std::abs(x) > 1e6 && std::abs(y) > 1e6 && (x > 0.0) == (y > 0.0)) ||
           std::abs(x - y) <= 1e-6 * (1.0 + std::abs(x));
}

}  // namespace signorini::test
