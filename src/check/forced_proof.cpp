#include <algorithm>
#include <map>
#include <numeric>

#include "forced_rows.hpp"
#include "rational.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// A combination of rows: what it leaves of the free waves, and its factors.
struct Combination {
    std::map<std::int64_t, Rational> free;
    std::map<std::size_t, Rational> factors;
};

/// x -= factor y; what becomes 0 goes.
template <typename Key>
void subtract(std::map<Key, Rational>& x, const Rational& factor, const std::map<Key, Rational>& y)
{
    for (const auto& [key, value] : y) {
        const auto [at, isNew] = x.try_emplace(key);
        at->second -= factor * value;
        if (at->second.is_zero()) {
            x.erase(at);
        }
    }
}

/// All combinations of the rows in which no free wave is left: a basis, one factor for each row.
/// Most rows hold one free wave or none: elimination keeps to what is not 0, such rows first.
std::vector<RationalVector> combinationsWithoutFree(const std::vector<EnclosedRow>& rows)
{
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&rows](std::size_t i, std::size_t k) {
        return rows[i].free.size() < rows[k].free.size();
    });
    std::vector<std::pair<std::int64_t, Combination>> pivots;  // a wave that no later one holds
    std::vector<RationalVector> basis;
    for (const std::size_t i : order) {
        Combination row{{}, {{i, 1}}};
        for (const auto& [which, factor] : rows[i].free) {
            if (factor != 0) {
                row.free.emplace(which, factor);
            }
        }
        for (const auto& [which, pivot] : pivots) {
            if (const auto found = row.free.find(which); found != row.free.end()) {
                const Rational factor = found->second / pivot.free.at(which);
                subtract(row.free, factor, pivot.free);
                subtract(row.factors, factor, pivot.factors);
            }
        }
        if (!row.free.empty()) {
            const std::int64_t which = row.free.begin()->first;
            pivots.emplace_back(which, std::move(row));
            continue;
        }
        RationalVector& factors = basis.emplace_back(rows.size());
        for (const auto& [which, factor] : row.factors) {
            factors[which] = factor;
        }
    }
    return basis;
}

/// Some number that rounding to a double may have moved by one place to either side.
Interval enclosed(const Rational& number)
{
    return Interval(static_cast<double>(number)).widened();
}

Interval combined(const RationalVector& factors, const std::vector<EnclosedRow>& rows,
                  const auto& value)
{
    Interval sum;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!factors[i].is_zero()) {
            sum = sum + enclosed(factors[i]) * value(rows[i]);
        }
    }
    return sum;
}

/// A combination of vectors that is 0, and what is left of it where that is not certain.
struct Dependency {
    std::vector<Interval> weights;  ///< empty: none is known
    Interval rest;                  ///< |C part| + |S part| is at most its upper end
};

/// Of three vectors of a plane, or two of a line, it is unique up to its size. Fewer may cancel but
/// for rounding.
Dependency dependency(const std::vector<EnclosedPlane>& x, bool isPlane)
{
    if (isPlane && x.size() == 3) {
        return {{x[1].cross(x[2]), x[2].cross(x[0]), x[0].cross(x[1])}, {}};
    }
    if (!isPlane && x.size() == 2) {
        return {{x[1].c, Interval(0.0) - x[0].c}, {}};
    }
    if (x.size() == 1) {
        return {{Interval(1.0)}, x[0].c.magnitude() + x[0].s.magnitude()};
    }
    if (x.size() == 2) {
        const double share = -x[0].dot(x[1]).high / x[1].dot(x[1]).high;
        if (std::isfinite(share)) {
            const EnclosedPlane rest = x[0] + Interval(share) * x[1];
            return {{Interval(1.0), Interval(share)}, rest.c.magnitude() + rest.s.magnitude()};
        }
    }
    return {};
}

std::optional<std::vector<EnclosedRow>> rowsOf(const EnclosedWaves& waves,
                                               std::span<const ForcedCondition> conditions)
{
    std::vector<EnclosedRow> rows{*waves.row({ForcedRule::gap, 0})};
    for (const ForcedCondition& condition : conditions) {
        auto row = waves.row(condition);
        if (!row) {
            return std::nullopt;
        }
        rows.push_back(std::move(*row));
    }
    return rows;
}

/// Is row . (C, S) at the place certainly not what it has to be? \pre a row without free waves
bool isBroken(const EnclosedRow& row, const EnclosedPlane& place)
{
    const Interval value = row.plane.dot(place) - row.limit;
    return value.isNegative() || (row.isEquality && value.isPositive());
}

bool isZero(const Interval& x)
{
    return x.low == 0.0 && x.high == 0.0;
}

/// Do the rows leave no excitation but 0? Two waves that nothing damps can do that, or, if no such
/// wave is in the rows and their right sides are 0, the line of the first row and rows that cut it
/// at 0 from both sides.
bool forbidsExcitation(const std::vector<EnclosedRow>& rows, bool isPlane)
{
    const auto isCertain = [](const Interval& x) { return x.isPositive() || x.isNegative(); };
    const auto across = [&](const EnclosedRow& x, const EnclosedRow& y) {
        return isPlane ? x.plane.cross(y.plane) : x.plane.c;
    };
    bool isBelow = false;
    bool isAbove = false;
    bool areAlone = true;
    for (const EnclosedRow& row : rows) {
        areAlone = areAlone && row.free.empty() && isZero(row.limit);
        const Interval slope = across(rows.front(), row);
        isBelow = isBelow || slope.isPositive() || (row.isEquality && slope.isNegative());
        isAbove = isAbove || slope.isNegative() || (row.isEquality && slope.isPositive());
    }
    if (areAlone && (isPlane ? isBelow && isAbove : isCertain(rows.front().plane.c))) {
        return true;
    }
    const auto isWork = [](const EnclosedRow& r) {
        return r.isEquality && r.free.empty() && isZero(r.limit);
    };
    return rows.size() > 1 && std::all_of(rows.begin() + 1, rows.end(), isWork) &&
           isCertain(across(rows[1], rows.back()));
}

/// One contact phase with fewer steps of flight than classes, and no gap: the tip rests at the
/// wall, so all waves come back as they were but for what the excitation adds, D_m in 2N steps. The
/// pushes R_m >= 0 have the mean of the force, which is 0, so they are 0, and with them all D_m.
/// Two that differ leave C = S = 0.
bool restsWithoutPush(const ForcedQuestion& question)
{
    const Schedule& schedule = question.schedule;
    const std::int64_t n = steps(schedule);
    if (schedule.phases.size() != 1 ||
        schedule.phases.front().free >= std::gcd(2 * schedule.cells, n)) {
        return false;
    }
    const bool isPlane = question.shapes.size() > 1;
    const auto each = [&](auto value) {
        return EnclosedPlane{value(question.shapes.front()),
                             isPlane ? value(question.shapes.back()) : Interval()};
    };
    // F_{m+2N} - F_m, or 2V_{m+N}.
    const auto change = [&](std::int64_t m) {
        return each([&](const Excitation& e) {
            const std::int64_t later = m + schedule.cells;
            return Interval(e.force((m + 2 * schedule.cells) % n)) - Interval(e.force(m)) +
                   Interval(2.0 * e.stepsPerCrossing) * (Interval(e.baseDisplacement(later + 1)) -
                                                         Interval(e.baseDisplacement(later)));
        });
    };
    EnclosedPlane sum;  // of what has the mean 0, but for rounding
    EnclosedPlane first = change(0);
    double area = 0.0;
    double largest = 0.0;
    for (std::int64_t m = 0; m < n; ++m) {
        sum = sum + each([m](const Excitation& e) {
                  return Interval(e.force(m)) + Interval(e.baseDisplacement(m));
              });
        const EnclosedPlane here = change(m);
        largest = std::max({largest, here.c.magnitude().high, here.s.magnitude().high});
        const Interval across = isPlane ? first.cross(here) : here.c * here.c;
        area = std::max({area, across.low, -across.high});
    }
    // What rounding leaves of the mean, for all steps, moves no D_m by as much as one of the two
    // is.
    const double rounding =
        4.0 * static_cast<double>(n) * (sum.c.magnitude().high + sum.s.magnitude().high);
    return area > 8.0 * largest * rounding;
}

}  // namespace

bool forbidsContact(const ForcedQuestion& question, std::span<const ForcedCondition> conditions)
{
    if (conditions.size() == 1 && conditions.front().rule == ForcedRule::rest) {
        return canRest(question.schedule.phases, question.schedule.stops) &&
               restsWithoutPush(question);
    }
    const EnclosedWaves waves(question);
    const auto rows = rowsOf(waves, conditions);
    if (!rows) {
        return false;
    }
    if (canRest(question.schedule.phases, question.schedule.stops)) {
        return forbidsExcitation(*rows, question.shapes.size() > 1);
    }
    const std::vector<RationalVector> basis = combinationsWithoutFree(*rows);
    std::vector<EnclosedPlane> left;
    left.reserve(basis.size());
    for (const RationalVector& factors : basis) {
        left.push_back({combined(factors, *rows, [](const EnclosedRow& r) { return r.plane.c; }),
                        combined(factors, *rows, [](const EnclosedRow& r) { return r.plane.s; })});
    }
    const auto [weights, rest] = dependency(left, question.shapes.size() > 1);
    if (weights.empty()) {
        return false;
    }
    // 0 = sum factor row >= sum factor limit > 0, if all inequalities have factors > 0. What
    // rounding leaves of the 0 is less than the right side for all amplitudes that are looked at.
    std::vector<Interval> factors(rows->size());
    Interval right;
    for (std::size_t i = 0; i < rows->size(); ++i) {
        for (std::size_t k = 0; k < basis.size(); ++k) {
            factors[i] = factors[i] + enclosed(basis[k][i]) * weights[k];
        }
        right = right + factors[i] * (*rows)[i].limit;
    }
    const Interval slack = Interval(mostForcedAmplitude) * rest;
    const auto proves = [&](const Interval& sign) {
        for (std::size_t i = 0; i < rows->size(); ++i) {
            if (!(*rows)[i].isEquality && !(sign * factors[i]).isPositive()) {
                return false;
            }
        }
        return (sign * right - slack).isPositive();
    };
    return proves(Interval(1.0)) || proves(Interval(-1.0));
}

bool forbidsAmplitude(const ForcedQuestion& question, double amplitude,
                      std::span<const ForcedCondition> conditions)
{
    const EnclosedWaves waves(question);
    const auto rows = rowsOf(waves, conditions);
    if (!rows) {
        return false;
    }
    const bool isPlane = question.shapes.size() > 1;
    if (!conditions.empty() && forbidsExcitation(*rows, isPlane)) {
        return true;
    }
    if (std::any_of(rows->begin(), rows->end(),
                    [](const EnclosedRow& row) { return !row.free.empty(); })) {
        return false;
    }
    // The places with gap . (C, S) = N and |(C, S)| = A: across the gap row by +-sqrt(A^2|gap|^2 -
    // N^2), over |gap|^2.
    const EnclosedRow& gap = rows->front();
    const EnclosedPlane across{Interval(0.0) - gap.plane.s, gap.plane.c};
    const Interval squares = gap.plane.dot(gap.plane);
    const Interval reach =
        Interval(amplitude) * Interval(amplitude) * squares - gap.limit * gap.limit;
    if (reach.isNegative()) {
        return true;
    }
    if (!isPlane) {
        return reach.isPositive();
    }
    const Interval away = reach.root();
    const auto isMissed = [&](double side) {
        const Interval over = Interval(1.0) / squares;
        const EnclosedPlane place =
            over * (gap.limit * gap.plane + (Interval(side) * away) * across);
        return std::any_of(rows->begin() + 1, rows->end(),
                           [&](const EnclosedRow& row) { return isBroken(row, place); });
    };
    return squares.isPositive() && isMissed(1.0) && isMissed(-1.0);
}

}  // namespace signorini
