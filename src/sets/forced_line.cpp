#include "forced_line.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "forced_cut.hpp"
#include "infinity.hpp"
#include "portable.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

constexpr double nearlyNothing = 1e-4;  // of the largest waves: what rounding may have left

}  // namespace

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

    /// sign times the present sum.
    void put(const ForcedCondition& condition, bool isEquality, Plane plane, double limit = 0.0,
             double sign = 1.0)
    {
        ForcedRow row{condition, isEquality, plane, {}, limit};
        for (std::size_t k = 0; k < sum_.size(); ++k) {
            if (sum_[k] != 0.0) {
                row.free.emplace_back(k, sign * sum_[k]);
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

ForcedWaves::ForcedWaves(std::int64_t cells, double rho, std::span<const Excitation> shapes,
                         const Stops& stops)
    : cells_(cells),
      steps_(shapes.front().steps()),
      classes_(std::gcd(2 * cells, steps_)),
      rho_(rho),
      isPlane_(shapes.size() == 2),
      stops_(stops),
      way_(stops.left
               ? static_cast<double>(2 * cells) * (stops.right + stops.left->value()) / (1.0 + rho)
               : infinity),
      isContact_(static_cast<std::size_t>(steps_), false),
      p_(static_cast<std::size_t>(steps_)),
      kinds_(static_cast<std::size_t>(classes_), ClassKind::damped),
      grips_(static_cast<std::size_t>(classes_), 1.0),
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
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    for (const std::int64_t j : changed_) {
        solveClass(j);
    }
    changed_.clear();
    closures_ = (isMirroredMotion() ? phases_.size() / 2 : phases_.size()) - 1;
}

Stop ForcedWaves::stopAt(std::int64_t m) const
{
    std::size_t k = 0;
    for (std::int64_t end = phases_[k].contact + phases_[k].free; end <= m;) {
        ++k;
        end += phases_[k].contact + phases_[k].free;
    }
    return phases_[k].stop;
}

double ForcedWaves::startPlace() const
{
    return placeOf(stops_, phases_.front().stop).value();
}

bool ForcedWaves::boundsHeld() const
{
    const Stop first = phases_.front().stop;
    return pushSign(first) * startPlace() > 0.0 &&
           std::all_of(phases_.begin(), phases_.end(),
                       [first](const Phase& phase) { return phase.stop == first; });
}

/// Are the second half of the schedule and of the excitation the first, mirrored? Then so are the
/// waves, if none has an amplitude of its own, the tip is on the other side half a period later,
/// and half of the flights close by themselves.
bool ForcedWaves::isMirroredMotion() const
{
    constexpr double alike = 1e-14;
    if (held_ + undamped_ > 0 || !isMirrored(phases_, stops_)) {
        return false;
    }
    const auto half = static_cast<std::size_t>(steps_ / 2);
    double largest = 0.0;
    double differs = 0.0;
    for (std::size_t m = 0; m < half; ++m) {
        for (const auto* part : {&force_, &fromBase_, &place_}) {
            largest = std::max(largest, size((*part)[m]));
            differs = std::max(differs, size((*part)[m] + (*part)[m + half]));
        }
    }
    return differs <= alike * static_cast<double>(steps_) * largest;
}

void ForcedWaves::changeStep(std::int64_t m, bool isContact)
{
    if (isContact_[static_cast<std::size_t>(m)] != isContact) {
        isContact_[static_cast<std::size_t>(m)] = isContact;
        changed_.push_back(m % classes_);
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
    grips_[static_cast<std::size_t>(first)] = kind == ClassKind::damped ? grip : 1.0;
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

/// Visits rows that are >= a limit.
template <typename Visit>
bool ForcedWaves::forEachContact(Visit visit) const
{
    std::int64_t m = 0;
    for (const Phase& phase : phases_) {
        const double sign = pushSign(phase.stop);
        for (const std::int64_t end = m + phase.contact; m < end; ++m) {
            if (!visit(ForcedCondition{ForcedRule::pressure, m}, sign * push(m))) {
                return false;
            }
        }
        m += phase.free;
    }
    return true;
}

/// The sums of -push over each beginning of a flight, or of push: what is >= a limit, or equal to
/// it; `begin` before each flight. Those that periodicity closes are left out.
template <typename Begin, typename Visit>
bool ForcedWaves::forEachFlight(Begin begin, Visit visit) const
{
    std::int64_t m = 0;
    for (std::size_t k = 0; k < phases_.size(); ++k) {
        m += phases_[k].contact;
        const std::int64_t last = m + phases_[k].free - 1;
        const Stop from = phases_[k].stop;
        const Stop to = phases_[(k + 1) % phases_.size()].stop;
        const double toWall = from == Stop::right ? 0.0 : way_;
        const double toSecond = way_ - toWall;
        begin();
        Plane prefix;
        for (; m < last; ++m) {
            prefix = prefix - push(m);
            if (!visit(ForcedCondition{ForcedRule::penetration, m}, prefix, -toWall) ||
                (toSecond < infinity &&
                 !visit(ForcedCondition{ForcedRule::secondStop, m}, -1.0 * prefix, -toSecond))) {
                return false;
            }
        }
        prefix = prefix - push(m);
        const double end = from == to ? 0.0 : from == Stop::right ? way_ : -way_;
        if (k < closures_ && !visit(ForcedCondition{ForcedRule::closure, m}, prefix, end)) {
            return false;
        }
        ++m;
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
    const Plane gap = tip(0);
    double source = 0.0;
    if (size(gap) < nearlyNothing * scale) {
        // The rounding of what drives them is divided by what waves lose.
        source = (size(force_.front()) + size(fromTip_.front())) /
                 *std::min_element(grips_.begin(), grips_.end());
    }
    ForcedCut cut(gap, startPlace(), std::max(scale, source), isPlane_, canRest(phases_, stops_));
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
    // A wall that need not push, whatever the excitation, leaves a row that is 0 but for rounding.
    const double nothing = roundOff * scale;
    const auto byContact = [&](const ForcedCondition& condition, Plane row) {
        return size(row) <= nothing || isFree(condition.step) || cut.by(row, condition) || !isHasty;
    };
    // What left nothing of the schedule before is likely to leave nothing of this one.
    for (const auto& last : lastRows_) {
        if (isHasty && last && last->rule == ForcedRule::pressure &&
            isContact_[static_cast<std::size_t>(last->step)] &&
            !byContact(*last, pushSign(stopAt(last->step)) * push(last->step))) {
            return finish();
        }
    }
    if (!forEachContact(byContact)) {
        return finish();
    }
    const double least = roundOff * sizeOfWaves();
    const auto byFlight = [&](const ForcedCondition& condition, Plane row, double limit) {
        // Beside waves that are always held rows have to scale.
        const bool isLeft = (held_ > 0 && limit != 0.0) || (size(row) <= least && limit == 0.0) ||
                            (condition.rule == ForcedRule::closure ? cut.to(row, condition, limit)
                                                                   : cut.by(row, condition, limit));
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
    writer.put({ForcedRule::gap, 0}, true, tip(0), startPlace());
    const double least = roundOff * std::max(sizeOfWaves(), size(force_.front()));
    for (const std::int64_t j : freeClasses()) {
        writer.clear();
        if (const Plane work = work_[static_cast<std::size_t>(j)]; size(work) > least) {
            writer.put({ForcedRule::work, j}, true, work);
        }
    }
    forEachContact([&](const ForcedCondition& condition, Plane row) {
        writer.clear();
        writer.add(condition.step, 2.0 * pushSign(stopAt(condition.step)));
        writer.put(condition, false, size(row) > least ? row : Plane{});
        return true;
    });
    forEachFlight([&] { writer.clear(); },
                  [&](const ForcedCondition& condition, Plane row, double limit) {
                      // The row of the second stop follows that of the wall in the same step.
                      const bool isSecond = condition.rule == ForcedRule::secondStop;
                      if (!isSecond) {
                          writer.add(condition.step, -2.0);
                      }
                      writer.put(condition, condition.rule == ForcedRule::closure,
                                 size(row) > least ? row : Plane{}, limit, isSecond ? -1.0 : 1.0);
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
