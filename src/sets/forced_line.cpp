#include "forced_line.hpp"
#include "infinity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "portable.hpp"

namespace signorini {

namespace {

// Amplitudes beyond this many times the least one of the line count as infinite.
constexpr double farAway = 1e9;
// Rows that are 0 but for rounding, relative to the largest.
constexpr double roundOff = 3e-13;
double size(Plane x)
{
    return std::abs(x.c) + std::abs(x.s);
}

}  // namespace

/// The line while rows cut it.
class ForcedWaves::Cut {
public:
    Cut(Plane gap, double size, bool isPlane) : isPlane_(isPlane)
    {
        const double squares = gap.dot(gap);
        line_.hasLine = squares > roundOff * roundOff * size * size && std::isfinite(1.0 / squares);
        if (!line_.hasLine) {
            return;
        }
        const double length = std::sqrt(squares);
        line_.foot = (1.0 / squares) * gap;
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

    /// row . (C, S) = 0. What holds already, but for rounding, holds.
    bool to(Plane row, const ForcedCondition& condition)
    {
        if (line_.low == line_.high &&
            std::abs(row.dot(line_.at(line_.low))) <= roundOff * size(row) * size(line_.foot)) {
            return true;
        }
        return by(row, condition) && by(-1.0 * row, condition);
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
    ForcedLine line_;
    bool isPlane_;
    double far_ = 0.0;
    double missed_ = 0.0;  ///< by the blocking row
};

/// Writes conditions with their free amplitudes.
class ForcedWaves::RowWriter {
public:
    explicit RowWriter(const ForcedWaves& waves)
        : waves_(waves), places_(static_cast<std::size_t>(waves.classes_), none)
    {
        for (const std::int64_t j : waves.freeClasses()) {
            places_[static_cast<std::size_t>(j)] = sum_.size();
            sum_.push_back(0.0);
        }
    }

    void clear() { std::fill(sum_.begin(), sum_.end(), 0.0); }

    /// factor times p_m, what z adds of it, to the present sum.
    void add(std::int64_t m, double factor)
    {
        const std::size_t place = places_[static_cast<std::size_t>(m % waves_.classes_)];
        if (place != none) {
            sum_[place] += factor * waves_.sign(m);
        }
    }

    void put(const ForcedCondition& condition, bool isEquality, Plane plane, double limit = 0.0)
    {
        ForcedRow row{condition, isEquality, plane, {}, limit};
        for (std::size_t k = 0; k < sum_.size(); ++k) {
            if (sum_[k] != 0.0) {
                row.free.emplace_back(k, sum_[k]);
            }
        }
        if (size(plane) > 0.0 || !row.free.empty() || limit != 0.0) {
            rows_.push_back(std::move(row));
        }
    }

    [[nodiscard]] std::vector<ForcedRow> take() { return std::move(rows_); }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    const ForcedWaves& waves_;
    std::vector<std::size_t> places_;  ///< of each class among the free ones
    std::vector<double> sum_;
    std::vector<ForcedRow> rows_;
};

ForcedWaves::ForcedWaves(std::int64_t cells, double rho, std::span<const Excitation> shapes)
    : cells_(cells),
      steps_(shapes.front().steps()),
      classes_(std::gcd(2 * cells, steps_)),
      rho_(rho),
      isPlane_(shapes.size() == 2),
      isContact_(static_cast<std::size_t>(steps_), false),
      p_(static_cast<std::size_t>(steps_)),
      kinds_(static_cast<std::size_t>(classes_), ClassKind::damped),
      work_(static_cast<std::size_t>(classes_))
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
    const Phase phase{contact, steps_ - contact};
    setPhases({&phase, 1});
}

void ForcedWaves::setPhases(std::span<const Phase> phases)
{
    std::int64_t m = 0;
    // One contact phase after another one: only the steps between their ends change.
    const bool isOne = phases.size() == 1 && phases_.size() == 1;
    const std::int64_t before = isOne ? phases_.front().contact : 0;
    for (const Phase& phase : phases) {
        const std::int64_t leave = m + phase.contact;
        for (m = isOne ? std::min(before, leave) : m; m < leave; ++m) {
            changeStep(m, true);
        }
        const std::int64_t end = isOne ? std::max(before, leave) : leave + phase.free;
        for (; m < end; ++m) {
            changeStep(m, false);
        }
    }
    phases_.assign(phases.begin(), phases.end());
}

void ForcedWaves::changeStep(std::int64_t m, bool isContact)
{
    if (isContact_[static_cast<std::size_t>(m)] != isContact) {
        isContact_[static_cast<std::size_t>(m)] = isContact;
        solveClass(m % classes_);
    }
}

std::vector<std::int64_t> ForcedWaves::freeClasses() const
{
    std::vector<std::int64_t> all;
    for (std::int64_t j = 0; j < classes_; ++j) {
        if (kindOf(j) != ClassKind::damped) {
            all.push_back(j);
        }
    }
    return all;
}

int ForcedWaves::sign(std::int64_t m) const
{
    if (kindOf(m) == ClassKind::damped) {
        return 0;
    }
    int result = 1;
    for (std::int64_t at = m % classes_; at != m; at = (at + 2 * cells_) % steps_) {
        result = isContact_[static_cast<std::size_t>(at)] ? result : -result;
    }
    return result;
}

void ForcedWaves::solveClass(std::int64_t first)
{
    const std::int64_t stride = 2 * cells_ % steps_;
    const std::int64_t members = steps_ / classes_;
    const auto goRound = [&](Plane p, auto see) {
        std::int64_t m = first;
        for (std::int64_t k = 0; k < members; ++k) {
            const auto at = static_cast<std::size_t>(m);
            see(at, p);
            p = isContact_[at] ? p + fromBase_[at] : fromTip_[at] - rho_ * p;
            m += stride;
            m -= m >= steps_ ? steps_ : 0;
        }
        return p;
    };
    std::int64_t flights = 0;
    Plane push;
    const Plane around = goRound({}, [&](std::size_t at, Plane p) {
        flights += isContact_[at] ? 0 : 1;
        push = push + force_[at] + 2.0 * p;
    });
    // Around the class a wave is multiplied by (-rho)^flights; its deviation from 1 is what holds
    // the class in place.
    const double decay = static_cast<double>(flights) * portable::log(rho_);
    const double grip = flights % 2 == 0 ? -portable::expm1(decay) : 1.0 + portable::exp(decay);
    ClassKind& kind = kinds_[static_cast<std::size_t>(first)];
    held_ -= kind == ClassKind::held ? 1 : 0;
    undamped_ -= kind == ClassKind::undamped ? 1 : 0;
    kind = flights == 0 ? ClassKind::held : grip <= 0.0 ? ClassKind::undamped : ClassKind::damped;
    held_ += kind == ClassKind::held ? 1 : 0;
    undamped_ += kind == ClassKind::undamped ? 1 : 0;
    work_[static_cast<std::size_t>(first)] = around;
    const Plane start = kind == ClassKind::held       ? (-0.5 / static_cast<double>(members)) * push
                        : kind == ClassKind::undamped ? Plane{}
                                                      : (1.0 / grip) * around;
    goRound(start, [this](std::size_t at, Plane p) { p_[at] = p; });
}

Plane ForcedWaves::tip(std::int64_t m) const
{
    Plane sum;
    for (std::int64_t left = 2 * cells_, at = m % steps_; left > 0; at = 0) {
        const std::int64_t end = std::min(steps_, at + left);
        left -= end - at;
        // Four sums at a time: each alone waits for its last addition.
        const Plane* p = p_.data();
        std::array<Plane, 3> others{};
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

template <typename Visit>
bool ForcedWaves::forEachContact(Visit visit) const
{
    std::int64_t m = 0;
    for (const Phase& phase : phases_) {
        for (const std::int64_t end = m + phase.contact; m < end; ++m) {
            if (!visit(ForcedCondition{ForcedRule::pressure, m}, push(m))) {
                return false;
            }
        }
        m += phase.free;
    }
    return true;
}

/// The sums over each beginning of a flight, written so that they are >= 0; `begin` before each
/// flight. The last one of a period is 0 by periodicity and left out.
template <typename Begin, typename Visit>
bool ForcedWaves::forEachFlight(Begin begin, Visit visit) const
{
    std::int64_t m = 0;
    for (const Phase& phase : phases_) {
        m += phase.contact;
        const std::int64_t end = m + phase.free;
        begin();
        Plane prefix;
        for (; m < end && m + 1 < steps_; ++m) {
            prefix = prefix - push(m);
            const auto rule = m + 1 < end ? ForcedRule::penetration : ForcedRule::closure;
            if (!visit(ForcedCondition{rule, m}, prefix)) {
                return false;
            }
        }
    }
    return true;
}

/// Of the waves, with which sums are compared that may be 0 but for rounding.
double ForcedWaves::sizeOfWaves() const
{
    double largest = 0.0;
    for (std::int64_t m = 0; m < steps_; ++m) {
        largest = std::max(largest, size(wave(m)));
    }
    return largest;
}

ForcedLine ForcedWaves::line(bool isHasty, double waveLimit)
{
    // A sample of the waves tells how large numbers are.
    double scale = size(wave(0));
    for (std::int64_t m = 0; m < steps_; m += 1 + steps_ / 16) {
        scale = std::max(scale, size(wave(m)) + size(place_[static_cast<std::size_t>(m)]));
    }
    Cut cut(tip(0), scale, isPlane_);
    if (cut.isEmpty()) {
        return cut.result();
    }
    const auto finish = [&] {
        lastRows_ = {cut.result().lowRow, cut.result().highRow};
        return cut.result();
    };
    // In a class that is held all the time a row fixes no more than the class's own amplitude.
    const auto isFree = [this](std::int64_t m) {
        return held_ > 0 && kindOf(m) == ClassKind::held;
    };
    const auto byContact = [&](const ForcedCondition& condition, Plane row) {
        return isFree(condition.step) || cut.by(row, condition) || !isHasty;
    };
    // What left nothing of the schedule before is likely to leave nothing of this one.
    for (const auto& last : lastRows_) {
        if (isHasty && last && last->rule == ForcedRule::pressure &&
            isContact_[static_cast<std::size_t>(last->step)] &&
            !byContact(*last, push(last->step))) {
            return finish();
        }
    }
    if (!forEachContact(byContact)) {
        return finish();
    }
    const double least = roundOff * sizeOfWaves();
    const auto byFlight = [&](const ForcedCondition& condition, Plane row) {
        const bool isLeft =
            size(row) <= least || (condition.rule == ForcedRule::closure ? cut.to(row, condition)
                                                                         : cut.by(row, condition));
        return isLeft || !isHasty;
    };
    if (!forEachFlight([] {}, byFlight) || waveLimit == infinity) {
        return finish();
    }
    for (std::int64_t m = 0; m < steps_; ++m) {
        cut.by(-1.0 * wave(m), {ForcedRule::strain, m}, -waveLimit);
    }
    return finish();
}

std::vector<ForcedRow> ForcedWaves::rows(double waveLimit) const
{
    RowWriter writer(*this);
    const double dx = 1.0 / static_cast<double>(cells_);
    for (std::int64_t m = 0; m < 2 * cells_; ++m) {
        writer.add(m % steps_, -dx);
    }
    writer.put({ForcedRule::gap, 0}, true, tip(0), 1.0);
    const double least = roundOff * std::max(sizeOfWaves(), size(force_.front()));
    for (const std::int64_t j : freeClasses()) {
        writer.clear();
        if (const Plane work = work_[static_cast<std::size_t>(j)]; size(work) > least) {
            writer.put({ForcedRule::work, j}, true, work);
        }
    }
    forEachContact([&](const ForcedCondition& condition, Plane row) {
        writer.clear();
        writer.add(condition.step, 2.0);
        writer.put(condition, false, row);
        return true;
    });
    forEachFlight([&] { writer.clear(); },
                  [&](const ForcedCondition& condition, Plane row) {
                      writer.add(condition.step, -2.0);
                      writer.put(condition, condition.rule == ForcedRule::closure,
                                 size(row) > least ? row : Plane{});
                      return true;
                  });
    for (std::int64_t m = 0; m < steps_ && waveLimit < infinity; ++m) {
        writer.clear();
        writer.add(m, -1.0);
        writer.put({ForcedRule::strain, m}, false, -1.0 * wave(m), -waveLimit);
    }
    return writer.take();
}

}  // namespace signorini
