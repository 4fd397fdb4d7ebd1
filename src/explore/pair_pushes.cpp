#include "pair_pushes.hpp"

#include <algorithm>
#include <cmath>

#include "directions.hpp"
#include "harmonic_motion.hpp"

namespace signorini {

namespace {

constexpr double movesNothing = 1e-10;  // pivots that are 0 but for rounding, of a push alone
constexpr double hardlyMoves = 1e-5;    // below it pushes are not looked at here
constexpr double sameRow = 1e-6;        // rows whose common point is not computed here

Plane formOf(std::complex<double> value)
{
    return {value.real(), value.imag()};
}

double innerProduct(const std::vector<double>& x, const std::vector<double>& y, std::size_t count)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += x[i] * y[i];
    }
    return sum;
}

/// What a contact says of another one, or of itself.
const ClosingContact& answerOf(std::span<const ContactPeriod> periods, std::size_t pushing,
                               std::size_t contact)
{
    const std::size_t place = contact == pushing ? 0 : contact < pushing ? contact + 1 : contact;
    return periods[pushing].contacts[place];
}

}  // namespace

PairPushes::PairPushes(std::span<const ContactPeriod> periods, std::size_t first,
                       std::size_t second)
    : periods_(periods),
      contacts_{first, second},
      isSame_(first == second),
      steps_(periods.front().steps),
      columns_(static_cast<std::size_t>(isSame_ ? steps_ : 2 * steps_)),
      heldByFirst_(static_cast<std::size_t>(periods.front().residues), false),
      heldByBoth_(heldByFirst_),
      isFree_(static_cast<std::size_t>(steps_), false)
{
    for (std::size_t contact = 0; contact < periods.size(); ++contact) {
        addContact(contact);
    }
    const auto n = static_cast<std::size_t>(steps_);
    const std::size_t rows = columns_ + 1 + n;
    matrix_.resize(rows * columns_);
    right_.resize(rows);
    const auto shrunk = [&](std::size_t contact, std::int64_t m) {
        const std::complex<double> start{start_[contact].c, start_[contact].s};
        return formOf(start * turnOf(periods_.front().cycles % steps_ * m, steps_));
    };
    for (std::size_t m = 0; m < n; ++m) {
        const auto step = static_cast<std::int64_t>(m);
        for (std::size_t row = m; row < columns_; row += n) {
            const std::size_t contact = contacts_.at(row / n);
            fillRow(row, step, rates_[contact]);
            right_[row] = driven_[contact][m];
        }
        fillRow(columns_ + 1 + m, step, ways_[second]);
        right_[columns_ + 1 + m] = shrunk(second, step);
    }
    fillRow(columns_, 0, ways_[first]);
    right_[columns_] = start_[first];
}

/// What it has by the drive and by pushes.
void PairPushes::addContact(std::size_t contact)
{
    const ContactPeriod& own = periods_[contact];
    const std::complex<double> driven = own.contacts.front().driven;
    std::vector<Plane>& rates = driven_.emplace_back();
    for (std::int64_t m = 0; m < steps_; ++m) {
        rates.push_back(formOf(driven * turnOf(own.cycles % steps_ * m, steps_)));
    }
    start_.push_back(formOf(driven / (turnOf(own.cycles, steps_) - 1.0)));
    auto& taken = rates_.emplace_back();
    auto& ways = ways_.emplace_back();
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t pushing = contacts_.at(side);
        const ClosingContact& answer = answerOf(periods_, pushing, contact);
        ways.at(side) = waysOf(periods_[pushing], answer);
        taken.at(side).resize(static_cast<std::size_t>(steps_), 0.0);
        std::int64_t m = answer.offset;
        for (const double value : answer.byPush) {
            taken.at(side)[static_cast<std::size_t>(m % steps_)] = value;
            m += own.residues;
        }
    }
}

void PairPushes::fillRow(std::size_t row, std::int64_t step,
                         const std::array<std::vector<double>, 2>& by)
{
    for (std::size_t column = 0; column < columns_; ++column) {
        const auto k = static_cast<std::int64_t>(column);
        const std::int64_t since = (step + 2 * steps_ - k) % steps_;
        matrix_[row * columns_ + column] =
            by.at(k < steps_ ? 0 : 1)[static_cast<std::size_t>(since)];
    }
}

std::size_t PairPushes::columnOf(std::int64_t step) const
{
    return static_cast<std::size_t>(isSame_ ? step : steps_ + step);
}

/// Pushes that move nothing keep to the steps of one residue.
std::size_t PairPushes::residueOf(bool isSecond, std::int64_t step) const
{
    const std::int64_t residues = periods_.front().residues;
    const std::int64_t offset =
        isSecond ? answerOf(periods_, contacts_[0], contacts_[1]).offset % residues : 0;
    return static_cast<std::size_t>((step + residues - offset) % residues);
}

double PairPushes::alone(bool isSecond) const
{
    return periods_[contacts_.at(isSecond ? 1 : 0)].alone;
}

double PairPushes::gapOf(std::size_t contact) const
{
    return periods_[contact].contacts.front().gap;
}

void PairPushes::growFirst()
{
    const auto pivot = static_cast<std::size_t>(contact_++);
    if (!isFirstClear_) {
        return;
    }
    const double value = std::abs(at(pivot, pivot)) / alone(false);
    if (value <= movesNothing) {
        isFree_[pivot] = true;
        heldByFirst_[residueOf(false, contact_ - 1)] = true;
        isFirstClear_ = size(right_[pivot]) <= nearMiss * periods_.front().usual;
    } else if (value <= hardlyMoves) {
        isFirstClear_ = false;
    } else {
        eliminate(pivot);
    }
}

void PairPushes::eliminate(std::size_t pivot)
{
    const double* from = &matrix_[pivot * columns_];
    for (std::size_t row = pivot + 1; row < right_.size(); ++row) {
        double* to = &matrix_[row * columns_];
        const double factor = to[pivot] / from[pivot];
        if (factor == 0.0) {
            continue;
        }
        for (std::size_t k = pivot + 1; k < columns_; ++k) {
            to[k] -= factor * from[k];
        }
        right_[row] = right_[row] - factor * right_[pivot];
    }
}

double PairPushes::placeBy(std::size_t which, std::size_t column) const
{
    const std::size_t row = columns_ + 1 + static_cast<std::size_t>(begin_);
    return which == 0 ? at(columns_, column)
                      : at(row, column) - (isSame_ ? at(columns_, column) : 0.0);
}

void PairPushes::begin(std::int64_t start)
{
    begin_ = start;
    second_ = 0;
    pivots_.clear();
    lower_.clear();
    upper_.clear();
    forward_.clear();
    placesBy_ = {};
    heldByBoth_ = heldByFirst_;
    isClear_ = isFirstClear_;
    const Plane first = right_[columns_];
    const Plane second = right_[columns_ + 1 + static_cast<std::size_t>(start)];
    places_ = {first, isSame_ ? second - first : second};
}

void PairPushes::growSecond()
{
    const std::int64_t step = begin_ + second_++;
    const std::size_t column = columnOf(step);
    if (!isClear_) {
        return;
    }
    const std::size_t count = pivots_.size();
    std::vector<double> above(count);
    std::vector<double> left(count);
    Plane rate = right_[column];
    for (std::size_t i = 0; i < count; ++i) {
        above[i] = at(pivots_[i], column) - innerProduct(lower_[i], above, i);
        left[i] = (at(column, pivots_[i]) - innerProduct(left, upper_[i], i)) / upper_[i][i];
        rate = rate - left[i] * forward_[i];
    }
    const double pivot = at(column, column) - innerProduct(left, above, count);
    const double value = std::abs(pivot) / alone(true);
    if (value <= movesNothing) {
        heldByBoth_[residueOf(true, step)] = true;
        isClear_ = size(rate) <= nearMiss * periods_.front().usual;
        return;
    }
    if (value <= hardlyMoves) {
        isClear_ = false;
        return;
    }
    for (std::size_t which = 0; which < 2; ++which) {
        std::vector<double>& by = placesBy_.at(which);
        by.push_back((placeBy(which, column) - innerProduct(by, above, count)) / pivot);
        places_.at(which) = places_.at(which) - by.back() * rate;
    }
    above.push_back(pivot);
    pivots_.push_back(column);
    lower_.push_back(std::move(left));
    upper_.push_back(std::move(above));
    forward_.push_back(rate);
}

template <typename Value>
bool PairPushes::solve(Pushed<Value>& pushes, auto read, auto holds) const
{
    pushes.first.assign(static_cast<std::size_t>(contact_), Value{});
    pushes.second.assign(static_cast<std::size_t>(second_), Value{});
    std::vector<Value> found(pivots_.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        found[i] = read(forward_[i]);
    }
    for (std::size_t i = found.size(); i-- > 0;) {
        found[i] = (1.0 / upper_[i][i]) * found[i];
        pushes.second[pivots_[i] - columnOf(begin_)] = found[i];
        if (!holds(found[i])) {
            return false;
        }
        for (std::size_t k = 0; k < i; ++k) {
            found[k] = found[k] - upper_[i][k] * found[i];
        }
    }
    for (auto p = static_cast<std::size_t>(contact_); p-- > 0;) {
        if (isFree_[p]) {
            continue;
        }
        Value sum = read(right_[p]);
        for (auto k = p + 1; k < pushes.first.size(); ++k) {
            sum = sum - at(p, k) * pushes.first[k];
        }
        for (std::size_t i = 0; i < found.size(); ++i) {
            sum = sum - at(p, pivots_[i]) * found[i];
        }
        pushes.first[p] = (1.0 / at(p, p)) * sum;
        if (!holds(pushes.first[p])) {
            return false;
        }
    }
    return true;
}

template <typename Value>
Value PairPushes::taken(const std::array<std::vector<double>, 2>& by, std::int64_t step,
                        const Pushed<Value>& pushes) const
{
    Value sum{};
    const auto add = [&](const std::vector<double>& answer, const std::vector<Value>& values,
                         std::int64_t from) {
        auto since = static_cast<std::size_t>((step + 2 * steps_ - from) % steps_);
        for (const Value& value : values) {
            sum = sum + answer[since] * value;
            since = since == 0 ? answer.size() - 1 : since - 1;
        }
    };
    add(by[0], pushes.first, 0);
    add(by[1], pushes.second, begin_);
    return sum;
}

bool PairPushes::isRefuted() const
{
    if (!isClear_) {
        return false;
    }
    const auto& [first, second] = places_;
    const double usual = periods_.front().usual;
    const double area = first.c * second.s - first.s * second.c;
    const bool isPoint = std::abs(area) > sameRow * size(first) * size(second) &&
                         std::min(size(first), size(second)) > nearMiss * usual;
    if (!isPoint || std::find(heldByBoth_.begin(), heldByBoth_.end(), true) != heldByBoth_.end()) {
        return isRefutedByDirections();
    }
    const double one = gapOf(contacts_[0]);
    const double other = isSame_ ? 0.0 : gapOf(contacts_[1]);
    const Plane place =
        (1.0 / area) * Plane{one * second.s - other * first.s, first.c * other - second.c * one};
    return size(place) == 0.0 || isRefutedAt(place);  // 0: without excitation there is only rest
}

bool PairPushes::isRefutedAt(Plane place) const
{
    const double usual = periods_.front().usual * size(place);
    double largest = usual / std::max(alone(false), alone(true));
    Pushed<double> pushes;
    const bool press = solve(
        pushes, [place](Plane form) { return form.dot(place); },
        [&largest](double push) {
            largest = std::max(largest, std::abs(push));
            return push >= -nearMiss * largest;
        });
    if (!press) {
        return true;
    }
    for (std::size_t contact = 0; contact < periods_.size(); ++contact) {
        const double gap = gapOf(contact);
        double shrunk = start_[contact].dot(place) - taken(ways_[contact], 0, pushes);
        for (std::int64_t m = 0; m < steps_; ++m) {
            if (shrunk - gap > nearMiss * (usual + std::abs(gap) + std::abs(shrunk))) {
                return true;
            }
            shrunk += driven_[contact][static_cast<std::size_t>(m)].dot(place) -
                      taken(rates_[contact], m, pushes);
        }
    }
    return false;
}

bool PairPushes::isRefutedByDirections() const
{
    Pushed<Plane> pushes;
    (void)solve(
        pushes, [](Plane form) { return form; }, [](Plane) { return true; });
    double largest = 0.0;
    for (const auto* list : {&pushes.first, &pushes.second}) {
        for (const Plane push : *list) {
            largest = std::max(largest, size(push));
        }
    }
    const double usual = periods_.front().usual;
    const bool isLine = isSame_ && size(places_[1]) > nearMiss * usual;
    Directions left(isLine ? std::optional(places_[1]) : std::nullopt,
                    nearMiss * std::max(largest * alone(false), usual));
    for (const bool isSecond : {false, true}) {
        const std::vector<Plane>& list = isSecond ? pushes.second : pushes.first;
        for (std::size_t k = 0; k < list.size(); ++k) {
            const std::int64_t step = static_cast<std::int64_t>(k) + (isSecond ? begin_ : 0);
            if (!heldByBoth_[residueOf(isSecond, step)] && !left.by(alone(isSecond) * list[k])) {
                return true;
            }
        }
    }
    bool opens = false;
    const std::int64_t second = begin_ + second_;
    if (penetrates(pushes, false, contact_, isSame_ ? begin_ : steps_, left, opens) ||
        penetrates(pushes, true, second, isSame_ ? steps_ : steps_ + begin_, left, opens)) {
        return true;
    }
    return !opens || staysAway(pushes, left);
}

/// Is there no direction left in which a flight of a contact keeps clear of it?
bool PairPushes::penetrates(const Pushed<Plane>& pushes, bool isSecond, std::int64_t from,
                            std::int64_t to, Directions& left, bool& opens) const
{
    const std::size_t contact = contacts_.at(isSecond ? 1 : 0);
    Plane way;
    for (std::int64_t m = from; m < to; ++m) {
        const std::int64_t step = m % steps_;
        const Plane rate =
            driven_[contact][static_cast<std::size_t>(step)] - taken(rates_[contact], step, pushes);
        opens = opens || size(rate) > nearMiss * periods_.front().usual;
        way = way - rate;
        if (m + 1 < to && !left.by(way)) {
            return true;
        }
    }
    return false;
}

/// Pushes that move nothing press the contact open by their mean, and least where those of their
/// residues are 0 together.
bool PairPushes::staysAway(const Pushed<Plane>& pushes, Directions& left) const
{
    const std::optional<Plane> only = left.only();
    if (!only || !(gapOf(contacts_[0]) > 0.0)) {
        return false;
    }
    const ClosingContact& own = periods_[contacts_[0]].contacts.front();
    const double mean = own.compliance / static_cast<double>(steps_);
    Plane place = places_[0];
    for (const bool isSecond : {false, true}) {
        const std::vector<Plane>& list = isSecond ? pushes.second : pushes.first;
        for (std::size_t k = 0; k < list.size(); ++k) {
            const std::int64_t step = static_cast<std::int64_t>(k) + (isSecond ? begin_ : 0);
            if (heldByBoth_[residueOf(isSecond, step)]) {
                place = place + mean * list[k];
            }
        }
    }
    return place.dot(*only) <= nearMiss * size(place) * size(*only);
}

}  // namespace signorini
