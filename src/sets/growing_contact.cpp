#include "growing_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "forced_cut.hpp"
#include "harmonic_tip.hpp"

namespace signorini {

namespace {

constexpr double singular = 1e-12;       // 1 - alpha beta that is 0 but for rounding
constexpr double nearlySingular = 1e-9;  // below it pushes are anyone's guess
constexpr double stillMoving = 1e-10;    // v in contact, relative: rounding has spoilt the rows

std::int64_t residuesOf(const SteppedBar& bar, std::int64_t steps)
{
    std::int64_t common = steps;
    for (const Segment& segment : bar.segments) {
        common = std::gcd(common, 2 * segment.cells);
    }
    return common;
}

}  // namespace

GrowingContact::GrowingContact(const SteppedBar& bar, double eta, Excited place,
                               std::int64_t cycles, std::int64_t steps)
    : bar_(bar),
      eta_(eta),
      steps_(steps),
      residues_(residuesOf(bar, steps)),
      members_(steps / residues_),
      fixed_(members_),
      push_(static_cast<std::size_t>(steps)),
      speed_(static_cast<std::size_t>(steps))
{
    for (const Segment& segment : bar.segments) {
        compliance_ += static_cast<double>(segment.cells) /
                       (segment.impedance * static_cast<double>(bar.cells));
    }
    setLinear(place, cycles);
    setKernels();
}

/// v^0 and u(L, 0): the sine is the cosine, a quarter later.
void GrowingContact::setLinear(Excited place, std::int64_t cycles)
{
    using Complex = HarmonicTip::Complex;
    const HarmonicTip tip(bar_, eta_, 2 * steps_);
    const auto cells = static_cast<double>(bar_.cells);
    const Complex move = cells * (tip.turn(2 * cycles) - 1.0);  // of displacements, in a step
    const Complex speed = place == Excited::tip ? tip.turn(cycles) * tip.speedOfForce(2 * cycles)
                                                : move * tip.speedOfBase(2 * cycles);
    const auto parts = [](const Complex& value) { return Plane{value.real(), value.imag()}; };
    usual_ = place == Excited::tip ? 1.0 / (bar_.segments.back().impedance + eta_) : std::abs(move);
    tip_ = parts(speed / move);
    linearPeak_ = std::abs(speed / move);
    for (std::int64_t m = 0; m < steps_; ++m) {
        speed_[static_cast<std::size_t>(m)] = parts(speed * tip.turn(2 * (cycles * m % steps_)));
    }
}

void GrowingContact::setKernels()
{
    const HarmonicTip tip(bar_, eta_, steps_);
    // Harmonics k and k + n/G are the same for one residue.
    std::vector<HarmonicTip::Complex> mobility;
    for (std::int64_t k = 0; k < members_; ++k) {
        mobility.push_back(tip.speedOfForce(k));
    }
    for (std::int64_t i = 0; i < members_; ++i) {
        double sum = 0.0;
        for (std::int64_t k = 0; k < members_; ++k) {
            sum += (mobility[static_cast<std::size_t>(k)] * tip.turn(k * i % members_ * residues_))
                       .real();
        }
        speedOfPush_.push_back(sum / static_cast<double>(members_));
    }
    double place = 0.0;
    for (std::int64_t m = 0; m < steps_; ++m) {
        tipOfPush_.push_back(place);
        if (m % residues_ == 0) {
            place += speedOfPush_[static_cast<std::size_t>(m / residues_)] /
                     static_cast<double>(bar_.cells);
        }
    }
    const double mean = std::accumulate(tipOfPush_.begin(), tipOfPush_.end(), 0.0);
    for (double& value : tipOfPush_) {
        value += (compliance_ - mean) / static_cast<double>(steps_);
    }
}

/// From a contact of one step less. O(n/G).
void GrowingContact::lengthen(std::int64_t contact)
{
    const auto members = static_cast<std::size_t>(members_);
    if (contact == members_) {
        setFree(contact, std::vector<double>(members, 1.0));
        return;
    }
    if (contact == 1) {
        const double alone = 1.0 / (bar_.segments.back().impedance + eta_);  // before waves return
        first_.push.assign(members, 0.0);
        first_.push[0] = 1.0;
        if (!(std::abs(speedOfPush_[0]) > singular * alone)) {
            setFree(contact, first_.push);
            return;
        }
        first_.push[0] = 1.0 / speedOfPush_[0];
        for (const double speed : speedOfPush_) {
            first_.speed.push_back(speed / speedOfPush_[0]);
        }
        last_ = first_;
        return;
    }
    Train shifted = last_;
    std::rotate(shifted.push.rbegin(), shifted.push.rbegin() + 1, shifted.push.rend());
    std::rotate(shifted.speed.rbegin(), shifted.speed.rbegin() + 1, shifted.speed.rend());
    const double alpha = first_.speed[static_cast<std::size_t>(contact - 1)];
    const double beta = shifted.speed[0];
    const double determinant = 1.0 - alpha * beta;
    const auto mix = [](const std::vector<double>& x, double factor, const std::vector<double>& y,
                        double divisor) {
        std::vector<double> sum(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            sum[i] = (x[i] - factor * y[i]) / divisor;
        }
        return sum;
    };
    if (std::abs(determinant) <= singular) {
        const std::vector<double> left = mix(shifted.speed, beta, first_.speed, 1.0);
        isRegular_ = std::all_of(left.begin(), left.end(),
                                 [](double speed) { return std::abs(speed) <= stillMoving; });
        setFree(contact, mix(shifted.push, beta, first_.push, 1.0));
        return;
    }
    isRegular_ = std::abs(determinant) > nearlySingular;
    last_ = {mix(shifted.push, beta, first_.push, determinant),
             mix(shifted.speed, beta, first_.speed, determinant)};
    first_ = {mix(first_.push, alpha, shifted.push, determinant),
              mix(first_.speed, alpha, shifted.speed, determinant)};
}

void GrowingContact::setFree(std::int64_t contact, std::vector<double> push)
{
    fixed_ = contact - 1;
    const double largest = std::abs(*std::max_element(
        push.begin(), push.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }));
    for (double& value : push) {
        value /= largest;
    }
    freePush_ = std::move(push);
}

void GrowingContact::grow()
{
    const std::int64_t residue = contact_ % residues_;
    const std::int64_t before = contact_ / residues_;
    ++contact_;
    if (residue == 0 && isRegular_ && before < fixed_) {
        lengthen(before + 1);
    }
    if (before >= fixed_ || !isRegular_) {
        return;
    }
    const Plane missing = speed(residue + before * residues_);
    for (std::int64_t i = 0, m = residue; i < members_; ++i, m += residues_) {
        const auto from = static_cast<std::size_t>(i);
        const auto at = static_cast<std::size_t>(m);
        push_[at] = push_[at] + last_.push[from] * missing;
        speed_[at] = speed_[at] - last_.speed[from] * missing;
    }
}

/// Steps of contact of a residue are n_c/G, rounded up in the first n_c mod G residues.
std::int64_t GrowingContact::freeBefore(std::int64_t residue) const
{
    const std::int64_t held = contact_ / residues_;
    const std::int64_t longer = std::min(residue, contact_ % residues_);
    return longer * std::max<std::int64_t>(held + 1 - fixed_, 0) +
           (residue - longer) * std::max<std::int64_t>(held - fixed_, 0);
}

std::int64_t GrowingContact::freeOf(std::int64_t residue) const
{
    return freeBefore(residue + 1) - freeBefore(residue);
}

std::int64_t GrowingContact::freePushes() const
{
    return freeBefore(residues_);
}

template <typename Action>
void GrowingContact::forEachFree(std::int64_t m, Action action) const
{
    const std::int64_t residue = m % residues_;
    const auto first = static_cast<std::size_t>(freeBefore(residue));
    for (std::int64_t q = 0; q < std::min(freeOf(residue), m / residues_ + 1); ++q) {
        action(first + static_cast<std::size_t>(q),
               freePush_[static_cast<std::size_t>(m / residues_ - q)]);
    }
}

double GrowingContact::freePush(std::int64_t m, std::span<const double> free) const
{
    double sum = 0.0;
    forEachFree(m, [&](std::size_t k, double value) { sum += free[k] * value; });
    return sum;
}

Plane GrowingContact::tip() const
{
    Plane place = tip_;
    for (std::int64_t m = 0; m < contact_; ++m) {
        const std::int64_t later = m == 0 ? 0 : steps_ - m;
        place = place -
                tipOfPush_[static_cast<std::size_t>(later)] * push_[static_cast<std::size_t>(m)];
    }
    return place;
}

/// u(L, 0) where residues with pushes of their own do not push on average.
Plane GrowingContact::highestTip() const
{
    Plane place = tip();
    for (std::int64_t m = 0; m < contact_; ++m) {
        if (freeOf(m % residues_) > 0) {
            place = place + (compliance_ / static_cast<double>(steps_)) * push(m);
        }
    }
    return place;
}

double GrowingContact::scale() const
{
    double largest = usual_;
    for (std::size_t m = 0; m < push_.size(); ++m) {
        largest = std::max({largest, size(push_[m]), size(speed_[m])});
    }
    return largest;
}

std::optional<ForcedLine> GrowingContact::line()
{
    const double most = scale();
    for (std::int64_t m = 0; m < contact_; ++m) {
        // Pushes beyond the fixed ones stop what moves there only if the base does not resist.
        if (!isRegular_ || (m / residues_ < fixed_ && !(size(speed(m)) <= stillMoving * most))) {
            return std::nullopt;
        }
    }
    const double nothing = roundOff * most;
    const bool hasFree = contact_ > fixed_ * residues_;
    ForcedCut cut(hasFree ? highestTip() : tip(), 1.0, most, true, false);
    const auto finish = [&] {
        lastRows_ = {cut.result().lowRow, cut.result().highRow};
        return cut.result();
    };
    const auto byPush = [&](const ForcedCondition& condition) {
        const Plane row = push(condition.step);
        return size(row) <= nothing || (hasFree && freeOf(condition.step % residues_) > 0) ||
               cut.by(row, condition);
    };
    if (cut.isEmpty()) {
        return cut.result();
    }
    // What left nothing of the schedule before is likely to leave nothing of this one.
    for (const auto& last : lastRows_) {
        if (last && last->rule == ForcedRule::pressure && !byPush(*last)) {
            return finish();
        }
    }
    for (std::int64_t m = 0; m < contact_; ++m) {
        if (!byPush({ForcedRule::pressure, m})) {
            return finish();
        }
    }
    Plane way;
    for (std::int64_t m = contact_; m + 1 < steps_; ++m) {
        way = way - speed(m);
        if (size(way) > nothing && !cut.by(way, {ForcedRule::penetration, m})) {
            return finish();
        }
    }
    return finish();
}

std::vector<ForcedRow> GrowingContact::rows() const
{
    std::vector<ForcedRow> rows;
    const auto free = static_cast<std::size_t>(freePushes());
    ForcedRow gap{{ForcedRule::gap, 0}, true, tip(), {}, 1.0};
    // A push that moves nothing presses the tip back by its mean.
    const double pressed = -compliance_ / static_cast<double>(steps_) *
                           std::accumulate(freePush_.begin(), freePush_.end(), 0.0);
    for (std::size_t k = 0; k < free; ++k) {
        gap.free.emplace_back(k, pressed);
    }
    rows.push_back(std::move(gap));
    const double most = scale();
    const double nothing = roundOff * most;
    const auto put = [&](ForcedRow row) {
        row.plane = size(row.plane) > nothing ? row.plane : Plane{};
        if (size(row.plane) > 0.0 || !row.free.empty()) {
            rows.push_back(std::move(row));
        }
    };
    for (std::int64_t m = 0; m < contact_; ++m) {
        ForcedRow row{{ForcedRule::pressure, m}, false, push(m), {}, 0.0};
        forEachFree(m, [&row](std::size_t k, double value) {
            if (value != 0.0) {
                row.free.emplace_back(k, value);
            }
        });
        put(std::move(row));
        if (m / residues_ >= fixed_ && size(speed(m)) > stillMoving * most) {
            rows.push_back({{ForcedRule::work, m}, true, speed(m), {}, 0.0});
        }
    }
    Plane way;
    for (std::int64_t m = contact_; m + 1 < steps_; ++m) {
        way = way - speed(m);
        put({{ForcedRule::penetration, m}, false, way, {}, 0.0});
    }
    return rows;
}

}  // namespace signorini
