#include <algorithm>
#include <map>
#include <numeric>

#include "energy_floor.hpp"
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

/// What rows without free waves leave of (C, S), of one shape with S = 0; only those that scale
/// with it, if so asked. A row that may be 0 leaves all, unless it is broken at once.
std::vector<ExcitationCut> cutsOf(const std::vector<EnclosedRow>& rows, bool isPlane, bool scale)
{
    std::vector<ExcitationCut> cuts;
    const auto add = [&cuts](const EnclosedPlane& plane, double right) {
        if (plane.dot(plane).isPositive() || right > 0.0) {
            cuts.push_back({plane.c, plane.s, 0.0, right});
        }
    };
    for (const EnclosedRow& row : rows) {
        const bool isZero = row.limit.low == 0.0 && row.limit.high == 0.0;
        if (!row.free.empty() || (scale && !isZero)) {
            continue;
        }
        add(row.plane, row.limit.low);
        if (row.isEquality) {
            add(EnclosedPlane{} - row.plane, -row.limit.high);
        }
    }
    if (!isPlane) {
        add({{}, 1.0}, 0.0);
        add({{}, -1.0}, 0.0);
    }
    return cuts;
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
        return forbidJust(cutsOf(*rows, question.shapes.size() > 1, true), 1.0, 0.0);
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
    return forbidJust(cutsOf(*rows, question.shapes.size() > 1, false), amplitude, 0.0);
}

}  // namespace signorini
