#include <algorithm>
#include <array>
#include <map>

#include "forced_rows.hpp"
#include "rational.hpp"

namespace signorini {

namespace {

/// All combinations of the rows in which no free wave is left: a basis, one factor for each row.
std::vector<RationalVector> combinationsWithoutFree(const std::vector<EnclosedRow>& rows)
{
    // A matrix with one row for each row, its free part, beside the identity, is eliminated: what
    // becomes 0 in the free part has its combination in the other one.
    std::map<std::int64_t, std::size_t> columns;
    for (const EnclosedRow& row : rows) {
        for (const auto& [which, factor] : row.free) {
            columns.emplace(which, columns.size());
        }
    }
    std::vector<RationalVector> matrix;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        RationalVector line(columns.size() + rows.size());
        for (const auto& [which, factor] : rows[i].free) {
            line[columns.at(which)] = factor;
        }
        line[columns.size() + i] = 1;
        matrix.push_back(std::move(line));
    }
    const std::size_t rank = reduceRows(matrix, columns.size()).size();
    std::vector<RationalVector> basis;
    for (std::size_t k = rank; k < matrix.size(); ++k) {
        basis.emplace_back(matrix[k].begin() + static_cast<std::ptrdiff_t>(columns.size()),
                           matrix[k].end());
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

}  // namespace

bool forbidsContact(const ForcedQuestion& question, std::span<const ForcedCondition> conditions)
{
    const EnclosedWaves waves(question);
    const auto rows = rowsOf(waves, conditions);
    if (!rows) {
        return false;
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
    const auto isWork = [](const ForcedCondition& c) { return c.rule == ForcedRule::work; };
    if (!conditions.empty() && std::all_of(conditions.begin(), conditions.end(), isWork)) {
        // No excitation but 0 is without work.
        const EnclosedPlane& first = (*rows)[1].plane;
        const Interval volume = isPlane ? first.cross(rows->back().plane) : first.c;
        return volume.isPositive() || volume.isNegative();
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
