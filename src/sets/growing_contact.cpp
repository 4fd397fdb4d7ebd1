#include "growing_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "forced_cut.hpp"
#include "harmonic_motion.hpp"

namespace signorini {

namespace {

constexpr double singular = 1e-12;       // 1 - alpha beta that is 0 but for rounding
constexpr double nearlySingular = 1e-9;  // below it pushes are anyone's guess
constexpr double stillMoving = 1e-10;    // v in contact, relative: rounding has spoilt the rows

Plane parts(std::complex<double> value)
{
    return {value.real(), value.imag()};
}

std::vector<double> mixed(const std::vector<double>& x, double factor, const std::vector<double>& y,
                          double divisor)
{
    std::vector<double> sum(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        sum[i] = (x[i] - factor * y[i]) / divisor;
    }
    return sum;
}

}  // namespace

GrowingContact::GrowingContact(ContactPeriod period)
    : period_(std::move(period)),
      members_(period_.steps / period_.residues),
      fixed_(members_),
      push_(static_cast<std::size_t>(period_.steps))
{
    const std::int64_t n = period_.steps;
    const auto turn = [&](std::int64_t m) { return turnOf(period_.cycles % n * m, n); };
    const auto startOf = [&](const ClosingContact& contact) {
        return period_.cycles == 0 ? 0.0 : contact.driven / (turn(1) - 1.0);
    };
    for (const ClosingContact& contact : period_.contacts) {
        start_.push_back(parts(startOf(contact)));
        std::vector<Plane>& speeds = speeds_.emplace_back();
        for (std::int64_t m = 0; m < n; ++m) {
            speeds.push_back(parts(contact.driven * turn(m)));
        }
        ways_.push_back(waysOf(period_, contact));
    }
    linearPeak_ = lengthOf(startOf(period_.contacts.front()));
    measure();
}

std::vector<double> waysOf(const ContactPeriod& period, const ClosingContact& contact)
{
    std::vector<double> ways;
    double way = 0.0;
    for (std::int64_t m = 0; m < period.steps; ++m) {
        ways.push_back(way);
        if (m >= contact.offset && (m - contact.offset) % period.residues == 0) {
            const std::int64_t member = (m - contact.offset) / period.residues;
            way += contact.byPush[static_cast<std::size_t>(member)];
        }
    }
    const double mean = std::accumulate(ways.begin(), ways.end(), 0.0);
    for (double& value : ways) {
        value += (contact.compliance - mean) / static_cast<double>(period.steps);
    }
    return ways;
}

/// O(contacts (n/G)^2).
GrowingContact::Train GrowingContact::trainOf(std::vector<double> push) const
{
    Train train{std::move(push), {}};
    const auto members = static_cast<std::size_t>(members_);
    for (const ClosingContact& contact : period_.contacts) {
        std::vector<double>& speeds = train.speeds.emplace_back(members, 0.0);
        for (std::size_t k = 0; k < members; ++k) {
            for (std::size_t i = 0; i < members && train.push[k] != 0.0; ++i) {
                speeds[(i + k) % members] += train.push[k] * contact.byPush[i];
            }
        }
    }
    return train;
}

/// From a contact of one step less. O(contacts n/G).
void GrowingContact::lengthen(std::int64_t contact)
{
    const auto members = static_cast<std::size_t>(members_);
    if (contact == members_) {
        // The same push in all its steps moves nothing, but a bar that drifts.
        const std::vector<double>& speeds = period_.contacts.front().byPush;
        double moved = 0.0;
        double size = 0.0;
        for (const double speed : speeds) {
            moved += speed;
            size += std::abs(speed);
        }
        if (std::abs(moved) <= singular * size) {
            setFree(contact, trainOf(std::vector<double>(members, 1.0)));
            return;
        }
    }
    if (contact == 1) {
        std::vector<double> push(members, 0.0);
        const double speed = period_.contacts.front().byPush[0];
        const bool moves = std::abs(speed) > singular * period_.alone;
        push[0] = moves ? 1.0 / speed : 1.0;
        first_ = trainOf(std::move(push));
        last_ = first_;
        if (!moves) {
            endRecursion(contact, first_, period_.alone);
        }
        return;
    }
    Train shifted = last_;
    std::rotate(shifted.push.rbegin(), shifted.push.rbegin() + 1, shifted.push.rend());
    for (std::vector<double>& speeds : shifted.speeds) {
        std::rotate(speeds.rbegin(), speeds.rbegin() + 1, speeds.rend());
    }
    const double alpha = first_.speeds[0][static_cast<std::size_t>(contact - 1)];
    const double beta = shifted.speeds[0][0];
    const double determinant = 1.0 - alpha * beta;
    const auto mix = [](const Train& x, double factor, const Train& y, double divisor) {
        Train sum{mixed(x.push, factor, y.push, divisor), {}};
        for (std::size_t c = 0; c < x.speeds.size(); ++c) {
            sum.speeds.push_back(mixed(x.speeds[c], factor, y.speeds[c], divisor));
        }
        return sum;
    };
    if (std::abs(determinant) <= singular) {
        endRecursion(contact, mix(shifted, beta, first_, 1.0), 1.0);
        return;
    }
    isRegular_ = std::abs(determinant) > nearlySingular;
    last_ = mix(shifted, beta, first_, determinant);
    first_ = mix(first_, alpha, shifted, determinant);
}

/// With pushes that leave v = 0 in contact: where dashpots damp all waves they move nothing else,
/// for v takes up no work.
void GrowingContact::endRecursion(std::int64_t contact, Train train, double usual)
{
    double largest = 0.0;
    for (const double speed : train.speeds[0]) {
        largest = std::max(largest, std::abs(speed));
    }
    isRegular_ = largest <= stillMoving * usual;
    setFree(contact, std::move(train));
}

void GrowingContact::setFree(std::int64_t contact, Train train)
{
    fixed_ = contact - 1;
    const double largest =
        std::abs(*std::max_element(train.push.begin(), train.push.end(),
                                   [](double x, double y) { return std::abs(x) < std::abs(y); }));
    for (double& value : train.push) {
        value /= largest;
    }
    freePush_ = std::move(train.push);
}

void GrowingContact::grow()
{
    const std::int64_t residue = contact_ % period_.residues;
    const std::int64_t before = contact_ / period_.residues;
    ++contact_;
    if (residue == 0 && isRegular_ && before < fixed_) {
        lengthen(before + 1);
    }
    if (before >= fixed_ || !isRegular_) {
        return;
    }
    const Plane missing = speed(residue + before * period_.residues);
    for (std::size_t c = 0; c < speeds_.size(); ++c) {
        std::vector<Plane>& speeds = speeds_[c];
        std::int64_t m = residue + period_.contacts[c].offset;
        for (const double taken : last_.speeds[c]) {
            m -= m < period_.steps ? 0 : period_.steps;
            Plane& at = speeds[static_cast<std::size_t>(m)];
            at = at - taken * missing;
            m += period_.residues;
        }
    }
    std::int64_t m = residue;
    for (const double push : last_.push) {
        Plane& at = push_[static_cast<std::size_t>(m)];
        at = at + push * missing;
        m += period_.residues;
    }
    measure();
}

/// Steps of contact of a residue are n_c/G, rounded up in the first n_c mod G residues.
std::int64_t GrowingContact::freeBefore(std::int64_t residue) const
{
    const std::int64_t held = contact_ / period_.residues;
    const std::int64_t longer = std::min(residue, contact_ % period_.residues);
    return longer * std::max<std::int64_t>(held + 1 - fixed_, 0) +
           (residue - longer) * std::max<std::int64_t>(held - fixed_, 0);
}

std::int64_t GrowingContact::freeOf(std::int64_t residue) const
{
    return freeBefore(residue + 1) - freeBefore(residue);
}

std::int64_t GrowingContact::freePushes() const
{
    return freeBefore(period_.residues);
}

template <typename Action>
void GrowingContact::forEachFree(std::int64_t m, Action action) const
{
    const std::int64_t residue = m % period_.residues;
    const std::int64_t member = m / period_.residues;
    const auto first = static_cast<std::size_t>(freeBefore(residue));
    for (std::int64_t q = 0; q < std::min(freeOf(residue), member + 1); ++q) {
        action(first + static_cast<std::size_t>(q),
               freePush_[static_cast<std::size_t>(member - q)]);
    }
}

double GrowingContact::freePush(std::int64_t m, std::span<const double> free) const
{
    double sum = 0.0;
    forEachFree(m, [&](std::size_t k, double value) { sum += free[k] * value; });
    return sum;
}

Plane GrowingContact::placeOf(std::size_t contact) const
{
    const std::vector<double>& ways = ways_[contact];
    Plane place = start_[contact] - ways[0] * push(0);
    for (std::int64_t m = 1; m < contact_; ++m) {
        place = place - ways[static_cast<std::size_t>(period_.steps - m)] * push(m);
    }
    return place;
}

/// Where residues with pushes of their own do not push on average.
Plane GrowingContact::farthestPlace() const
{
    Plane place = this->place();
    const double mean = period_.contacts.front().compliance / static_cast<double>(period_.steps);
    for (std::int64_t m = 0; m < contact_; ++m) {
        if (freeOf(m % period_.residues) > 0) {
            place = place + mean * push(m);
        }
    }
    return place;
}

void GrowingContact::measure()
{
    scale_ = period_.usual;
    for (std::size_t m = 0; m < push_.size(); ++m) {
        scale_ = std::max({scale_, size(push_[m]), size(speeds_[0][m])});
    }
}

bool GrowingContact::isClear() const
{
    for (std::int64_t m = 0; m < contact_; ++m) {
        // Pushes beyond the fixed ones stop what moves there only if the base does not resist.
        if (!isRegular_ ||
            (m / period_.residues < fixed_ && !(size(speed(m)) <= stillMoving * scale_))) {
            return false;
        }
    }
    return true;
}

bool GrowingContact::opens() const
{
    for (std::int64_t m = contact_; m < period_.steps; ++m) {
        if (size(speed(m)) > stillMoving * scale_) {
            return true;
        }
    }
    return false;
}

bool GrowingContact::lineBounds() const
{
    const auto& contacts = period_.contacts;
    return freePushes() == 0 ||
           (contacts.front().gap > 0.0 &&
            std::all_of(contacts.begin(), contacts.end(),
                        [](const ClosingContact& contact) { return contact.gap >= 0.0; }));
}

ForcedLine GrowingContact::line()
{
    const double most = scale_;
    const double nothing = roundOff * most;
    const bool hasFree = freePushes() > 0;
    const double gap = period_.contacts.front().gap;
    ForcedCut cut(hasFree ? farthestPlace() : place(), gap, most, true, gap == 0.0);
    const auto finish = [&] {
        lastRows_ = {cut.result().lowRow, cut.result().highRow};
        return cut.result();
    };
    const auto byPush = [&](const ForcedCondition& condition) {
        const Plane row = push(condition.step);
        return size(row) <= nothing || (hasFree && freeOf(condition.step % period_.residues) > 0) ||
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
    const std::int64_t end =
        opens() ? period_.steps : contact_;  // else ways are 0 but for rounding
    for (std::int64_t m = contact_; m + 1 < end; ++m) {
        way = way - speed(m);
        if (size(way) > nothing && !cut.by(way, {ForcedRule::penetration, m})) {
            return finish();
        }
    }
    for (std::size_t c = 1; c < speeds_.size() && !hasFree; ++c) {
        const double other = period_.contacts[c].gap;
        Plane place = placeOf(c);
        for (std::int64_t m = 0; m < period_.steps; ++m) {
            const bool isRow = size(place) > nothing || other < 0.0;
            if (isRow && !cut.holdsAll(-1.0 * place, -other) &&
                !cut.by(-1.0 * place, {ForcedRule::penetration, m}, -other)) {
                return finish();
            }
            place = place + speeds_[c][index(m)];
        }
    }
    return finish();
}

std::vector<ForcedRow> GrowingContact::rows() const
{
    std::vector<ForcedRow> rows;
    const ClosingContact& own = period_.contacts.front();
    const auto free = static_cast<std::size_t>(freePushes());
    ForcedRow gap{{ForcedRule::gap, 0}, true, place(), {}, own.gap};
    // A push that moves nothing presses the contact open by its mean.
    const double pressed = -own.compliance / static_cast<double>(period_.steps) *
                           std::accumulate(freePush_.begin(), freePush_.end(), 0.0);
    for (std::size_t k = 0; k < free; ++k) {
        gap.free.emplace_back(k, pressed);
    }
    rows.push_back(std::move(gap));
    const double most = scale_;
    const double nothing = roundOff * most;
    const auto put = [&](ForcedRow row) {
        row.plane = size(row.plane) > nothing ? row.plane : Plane{};
        if (size(row.plane) > 0.0 || !row.free.empty() || row.limit > 0.0) {
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
        if (m / period_.residues >= fixed_ && size(speed(m)) > stillMoving * most) {
            rows.push_back({{ForcedRule::work, m}, true, speed(m), {}, 0.0});
        }
    }
    Plane way;
    for (std::int64_t m = contact_; m + 1 < period_.steps; ++m) {
        way = way - speed(m);
        put({{ForcedRule::penetration, m}, false, way, {}, 0.0});
    }
    for (std::size_t c = 1; c < speeds_.size(); ++c) {
        const std::vector<double> freeWays = waysOfFree(c);
        Plane place = placeOf(c);
        for (std::int64_t m = 0; m < period_.steps; ++m) {
            ForcedRow row{
                {ForcedRule::penetration, m}, false, -1.0 * place, {}, -period_.contacts[c].gap};
            for (std::int64_t residue = 0; residue < period_.residues; ++residue) {
                for (std::int64_t q = 0; q < freeOf(residue); ++q) {
                    const std::int64_t begin = residue + q * period_.residues;
                    const double opened = freeWays[index(m + period_.steps - begin)];
                    if (std::abs(opened) > roundOff * own.compliance) {
                        row.free.emplace_back(static_cast<std::size_t>(freeBefore(residue) + q),
                                              opened);
                    }
                }
            }
            put(std::move(row));
            place = place + speeds_[c][index(m)];
        }
    }
    return rows;
}

/// How much farther another contact is open at the beginning of a step by the free push that begins
/// in step 0. O(n n/G).
std::vector<double> GrowingContact::waysOfFree(std::size_t contact) const
{
    std::vector<double> sums(static_cast<std::size_t>(period_.steps), 0.0);
    for (std::size_t i = 0; i < freePush_.size(); ++i) {
        const std::int64_t begin = static_cast<std::int64_t>(i) * period_.residues;
        for (std::int64_t m = 0; m < period_.steps && freePush_[i] != 0.0; ++m) {
            sums[index(m + begin)] += freePush_[i] * ways_[contact][index(m)];
        }
    }
    return sums;
}

}  // namespace signorini
