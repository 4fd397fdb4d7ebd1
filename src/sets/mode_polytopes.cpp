#include <algorithm>
#include <cmath>
#include <numeric>

#include "faults.hpp"
#include "mode_chains.hpp"
#include "mode_line.hpp"

namespace signorini {

namespace {

/// Places of a motion on a grid with one class: step m is number `rank[m]` of the cycle of shifts
/// by 2N from step 0.
class Cycle {
public:
    explicit Cycle(const Schedule& schedule)
        : schedule_(schedule), steps_(steps(schedule)), rank_(static_cast<std::size_t>(steps_))
    {
        std::int64_t step = 0;
        for (std::int64_t rank = 0; rank < steps_; ++rank) {
            rank_[static_cast<std::size_t>(step)] = rank;
            step = (step + 2 * schedule.cells) % steps_;
        }
        std::int64_t from = 0;
        for (const Phase& phase : schedule.phases) {
            arrivals_.push_back(from);
            releases_.push_back(from + phase.contact);
            from += phase.contact + phase.free;
        }
    }

    /// From each arrival to the next switch; none if that is not a release.
    [[nodiscard]] std::optional<std::vector<ModeChain>> chains() const
    {
        std::vector<ModeChain> result;
        for (const std::int64_t arrival : arrivals_) {
            const auto ahead = [&](std::int64_t step) {
                const std::int64_t distance = rankOf(step) - rankOf(arrival);
                return distance > 0 ? distance : distance + steps_;
            };
            const auto nearer = [&](std::int64_t l, std::int64_t r) { return ahead(l) < ahead(r); };
            const auto release = std::min_element(releases_.begin(), releases_.end(), nearer);
            const auto other = std::min_element(arrivals_.begin(), arrivals_.end(), nearer);
            if (nearer(*other, *release)) {
                return std::nullopt;
            }
            const std::int64_t k = ahead(*release);
            result.push_back({static_cast<std::size_t>(release - releases_.begin()), k,
                              (arrival + 2 * k * schedule_.cells - *release) / steps_});
        }
        return result;
    }

    [[nodiscard]] std::vector<ChainJump> jumps(const std::vector<ModeChain>& chains) const
    {
        std::vector<std::pair<std::int64_t, ChainJump>> placed;
        for (std::size_t i = 0; i < chains.size(); ++i) {
            for (std::int64_t k = 1; k <= chains[i].k; ++k) {
                const std::int64_t at = arrivals_[i] + 2 * k * schedule_.cells;
                placed.push_back({at % steps_, {i, k, at / steps_}});
            }
        }
        std::sort(placed.begin(), placed.end(),
                  [](const auto& l, const auto& r) { return l.first < r.first; });
        std::vector<ChainJump> result;
        result.reserve(placed.size());
        for (const auto& [step, jump] : placed) {
            result.push_back(jump);
        }
        return result;
    }

private:
    [[nodiscard]] std::int64_t rankOf(std::int64_t step) const
    {
        return rank_[static_cast<std::size_t>(step)];
    }

    const Schedule& schedule_;
    std::int64_t steps_;
    std::vector<std::int64_t> rank_;
    std::vector<std::int64_t> arrivals_;
    std::vector<std::int64_t> releases_;
};

/// Does a point (T, s, 1), times any number > 0, meet all rows?
bool holds(const ModeRows& rows, const IntegerVector& point)
{
    const auto all = [&point](const std::vector<LinearForm>& forms, auto condition) {
        return std::all_of(forms.begin(), forms.end(),
                           [&](const LinearForm& form) { return condition(valueAt(form, point)); });
    };
    return all(rows.gaps, [](const Integer& value) { return value > 0; }) &&
           all(rows.closures, [](const Integer& value) { return value.is_zero(); }) &&
           all(rows.prefixes, [](const Integer& value) { return value >= 0; }) &&
           valueAt(rows.window, point) > 0;
}

double valueAt(const LinearForm& form, const ModePoint& point)
{
    double value = linear(form.coefficients.front(), point.period, -form.rhs);
    for (std::size_t i = 1; i < form.coefficients.size(); ++i) {
        value = std::fma(static_cast<double>(form.coefficients[i]), point.arrivals[i - 1], value);
    }
    return value;
}

void requireInside(const ModePolytope& polytope, double period)
{
    if (!(period > polytope.lowest.value() && period < polytope.highest.value())) {
        throwFault("period", period,
                   fmt::format("]{}/{}, {}/{}[ [L/c]", polytope.lowest.numerator,
                               polytope.lowest.denominator, polytope.highest.numerator,
                               polytope.highest.denominator));
    }
}

void requireArrivals(const ModePolytope& polytope, const ModePoint& point)
{
    if (point.arrivals.size() + 1 != polytope.chains.size()) {
        throwFault("arrivals", point.arrivals.size(),
                   fmt::format("{} numbers", polytope.chains.size() - 1));
    }
}

/// Closures and signs hold but for rounding.
void requireMotion(const ModeRows& rows, const ModePoint& point)
{
    constexpr double tolerance = 1e-9;
    const auto any = [&point](const std::vector<LinearForm>& forms, auto condition) {
        return std::any_of(forms.begin(), forms.end(),
                           [&](const LinearForm& form) { return condition(valueAt(form, point)); });
    };
    if (any(rows.gaps, [](double value) { return !(value > 0.0); }) ||
        any(rows.closures, [](double value) { return !(std::abs(value) <= tolerance); }) ||
        any(rows.prefixes, [](double value) { return !(value >= -tolerance); })) {
        throw std::invalid_argument(
            "point: outside the polytope: allowed means of the points of its slice");
    }
}

/// Goes through whole arrivals between those of the spanning points.
template <typename Action>
void forEachArrivals(const std::vector<ModePoint>& corners, double unit, IntegerVector& point,
                     std::size_t i, Action action)
{
    if (i + 1 == point.size()) {
        action();
        return;
    }
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end(),
                                                 [i](const ModePoint& l, const ModePoint& r) {
                                                     return l.arrivals[i - 1] < r.arrivals[i - 1];
                                                 });
    const auto last = static_cast<std::int64_t>(std::ceil(high->arrivals[i - 1] * unit));
    for (auto s = static_cast<std::int64_t>(std::floor(low->arrivals[i - 1] * unit)); s <= last;
         ++s) {
        point[i] = s;
        forEachArrivals(corners, unit, point, i + 1, action);
    }
}

}  // namespace

std::optional<ModePolytope> polytopeOf(const Schedule& schedule)
{
    validate(schedule);
    const std::int64_t n = steps(schedule);
    if (std::gcd(2 * schedule.cells, n) != 1) {
        throw std::invalid_argument(
            fmt::format("schedule: gcd(2N, n) = {}: allowed 1", std::gcd(2 * schedule.cells, n)));
    }
    for (const Phase& phase : schedule.phases) {
        if (phase.stop != Stop::right) {
            throw std::invalid_argument("schedule: a phase on the second stop: allowed none");
        }
    }
    Schedule turned = schedule;
    for (std::size_t first = 0; first < schedule.phases.size(); ++first) {
        const Cycle cycle(turned);
        const auto chains = cycle.chains();
        if (!chains) {
            return std::nullopt;
        }
        if (!isListedName(*chains)) {
            std::rotate(turned.phases.begin(), turned.phases.begin() + 1, turned.phases.end());
            continue;
        }
        const std::vector<ChainJump> jumps = cycle.jumps(*chains);
        const auto rows = rowsOf(*chains, jumps);
        PolyhedralCone cone = arrivalCone(chains->size());
        if (!rows || !std::all_of(rows->gaps.begin(), rows->gaps.end(),
                                  [&cone](const auto& gap) { return cutStrictly(cone, gap); })) {
            return std::nullopt;
        }
        IntegerVector point{Integer(n)};
        std::int64_t at = 0;
        for (std::size_t i = 0; i + 1 < turned.phases.size(); ++i) {
            at += turned.phases[i].contact + turned.phases[i].free;
            point.emplace_back(at);
        }
        point.emplace_back(turned.cells);
        return holds(*rows, point) ? polytopeIn(std::move(cone), *chains, jumps) : std::nullopt;
    }
    return std::nullopt;
}

std::vector<ModePoint> slice(const ModePolytope& polytope, double period)
{
    requireInside(polytope, period);
    std::vector<ModePoint> corners;
    for (const auto& low : polytope.vertices) {
        for (const auto& high : polytope.vertices) {
            const double from = low.front().value();
            const double to = high.front().value();
            if (!(from < period && period < to) && !(from == period && low == high)) {
                continue;
            }
            const double share = low == high ? 0.0 : (period - from) / (to - from);
            ModePoint point{period, {}};
            for (std::size_t i = 1; i < low.size(); ++i) {
                point.arrivals.push_back(std::lerp(low[i].value(), high[i].value(), share));
            }
            corners.push_back(std::move(point));
        }
    }
    return corners;
}

ModePoint middle(const ModePolytope& polytope, double period)
{
    const std::vector<ModePoint> corners = slice(polytope, period);
    ModePoint mean{period, std::vector<double>(polytope.chains.size() - 1, 0.0)};
    for (const ModePoint& corner : corners) {
        for (std::size_t l = 0; l < mean.arrivals.size(); ++l) {
            mean.arrivals[l] += corner.arrivals[l] / static_cast<double>(corners.size());
        }
    }
    return mean;
}

std::vector<double> stretches(const ModePolytope& polytope, const ModePoint& point)
{
    requireArrivals(polytope, point);
    const ChainForms forms(polytope.chains);
    std::vector<double> result;
    for (std::size_t l = 0; l < polytope.chains.size(); ++l) {
        result.push_back(valueAt(forms.contact(l), point));
        result.push_back(valueAt(plus(forms.arrival(l + 1), -1, forms.release(l)), point));
    }
    return result;
}

double energyRatio(const ModePolytope& polytope, double period)
{
    requireInside(polytope, period);
    const double root =
        linear(polytope.kappa, period, -polytope.mu) / static_cast<double>(polytope.divisor);
    return 1.0 / (root * root);
}

EnergyRange energyRange(const ModePolytope& polytope)
{
    return energyLimits(
        {polytope.lowest, polytope.highest, polytope.kappa, polytope.mu, polytope.divisor});
}

std::vector<Schedule> schedulesOf(const ModePolytope& polytope, std::int64_t cells,
                                  std::int64_t steps)
{
    Faults faults;
    faults.requireWhole("cells", cells, maxCells);
    faults.requireWhole("steps", steps, maxSteps);
    faults.throwIfAny();
    const auto isBelow = [](const Integer& p, const Integer& q, const Integer& r,
                            const Integer& s) { return p * s < r * q; };
    std::vector<Schedule> schedules;
    if (!isBelow(polytope.lowest.numerator, polytope.lowest.denominator, steps, cells) ||
        !isBelow(steps, cells, polytope.highest.numerator, polytope.highest.denominator)) {
        return schedules;
    }
    const auto rows = rowsOf(polytope.chains, polytope.jumps);
    const ChainForms forms(polytope.chains);
    const auto corners = slice(polytope, static_cast<double>(steps) / static_cast<double>(cells));
    IntegerVector point(polytope.chains.size() + 1);
    point.front() = steps;
    point.back() = cells;
    forEachArrivals(corners, static_cast<double>(cells), point, 1, [&] {
        if (!holds(*rows, point)) {
            return;
        }
        Schedule schedule{cells, {}};
        for (std::size_t l = 0; l < polytope.chains.size(); ++l) {
            schedule.phases.push_back(
                {static_cast<std::int64_t>(valueAt(forms.contact(l), point)),
                 static_cast<std::int64_t>(
                     valueAt(plus(forms.arrival(l + 1), -1, forms.release(l)), point))});
        }
        // A type that is its own rotation holds each orbit several times.
        std::vector<Phase> least = schedule.phases;
        for (std::size_t first = 1; first < schedule.phases.size(); ++first) {
            std::rotate(schedule.phases.begin(), schedule.phases.begin() + 1,
                        schedule.phases.end());
            least = std::min(least, schedule.phases);
        }
        schedule.phases = std::move(least);
        if (std::find(schedules.begin(), schedules.end(), schedule) == schedules.end()) {
            schedules.push_back(std::move(schedule));
        }
    });
    return schedules;
}

ModeMotion::ModeMotion(const ModePolytope& polytope, const ModePoint& point) : period_(point.period)
{
    requireArrivals(polytope, point);
    amplitude_ = 0.5 * std::sqrt(energyRatio(polytope, point.period));
    requireMotion(rowsOf(polytope.chains, polytope.jumps).value(), point);
    const ChainForms forms(polytope.chains);
    for (std::size_t l = 0; l < polytope.chains.size(); ++l) {
        contacts_.emplace_back(valueAt(forms.arrival(l), point), valueAt(forms.release(l), point));
        contactTime_ += valueAt(forms.contact(l), point);
    }
    double sum = 0.0;
    double before = 0.0;
    for (const ChainJump& jump : polytope.jumps) {
        const double at = valueAt(forms.at(jump), point);
        sum += times_.size() % 2 == 0 ? at - before : before - at;
        times_.push_back(at);
        integrals_.push_back(sum);
        before = at;
    }
}

}  // namespace signorini
