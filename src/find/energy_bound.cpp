#include "energy_bound.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "double_description.hpp"
#include "echo.hpp"
#include "formulation.hpp"
#include "lumped_rows.hpp"
#include "program_rows.hpp"
#include "rational.hpp"
#include "signorini/lumped_set.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// What the sum of S^2/d has to exceed: E/E_1 = 2w/N sum S^2/d at least.
Rational squaresAt(double energyRatio, const ClassTypes& classes)
{
    return Rational(energyRatio) * classes.schedule.cells / (2 * classes.window);
}

std::vector<const ClassType*> liveTypesOf(const ClassTypes& classes)
{
    std::vector<const ClassType*> live;
    for (const ClassType& type : classes.types) {
        if (type.isLive()) {
            live.push_back(&type);
        }
    }
    return live;
}

/// The bound of one combination: c = A^T y, value = y . r.
Rational dualBound(const std::vector<const ClassType*>& live, const RationalVector& c,
                   const Rational& value)
{
    Rational bound = 2 * value;
    for (std::size_t i = 0; i < live.size(); ++i) {
        if (c[i] > 0 || live[i]->kind == TypeKind::grazing) {
            bound -= c[i] * c[i] * live[i]->count;
        }
    }
    return bound;
}

/// The best multiple of the gap row alone, sum windowSum S = -N with a gap > 0.
Rational boundByGap(const std::vector<const ClassType*>& live, const Schedule& schedule)
{
    const WaveSum gap = gapSum(schedule);
    Rational square = 0;
    for (const ClassType* type : live) {
        // Only those that can help to reach the wall count.
        const bool helps = gap.rhs < 0 ? type->windowSum < 0 : type->windowSum > 0;
        if (helps || type->kind == TypeKind::grazing) {
            square += Rational(type->windowSum) * type->windowSum * type->count;
        }
    }
    const Rational wanted = Rational(gap.rhs, gap.factor);
    return square.is_zero() ? Rational(0) : Rational(wanted * wanted / square);
}

bool isWithinReach(const Schedule& folded, std::size_t live)
{
    constexpr std::int64_t mostSteps = 10'000'000;  // of the delay sequence in memory
    return live <= maxLiveTypes && steps(folded) <= mostSteps;
}

/// The rows that hold the nearest point, by their number among equalities and then inequalities;
/// empty without such a point.
std::vector<WeightedRow> rowsOfLeast(const Program& program,
                                     const std::vector<const ClassType*>& live)
{
    const auto rows = ProgramRows::of(program);
    if (!rows) {
        return {};
    }
    std::vector<std::int64_t> counts;
    counts.reserve(live.size());
    for (const ClassType* type : live) {
        counts.push_back(type->count);
    }
    Projection nearest = project(*rows, RationalVector(live.size()), counts);
    if (!nearest.isFeasible) {
        return {};
    }
    std::erase_if(nearest.rows, [&program](const WeightedRow& held) {  // S >= 0: readers know
        return held.row.tag >= program.equalities.rows() + program.inequalities.rows();
    });
    return std::move(nearest.rows);
}

/// The combination that the exact projection leaves, evaluated on the rows of the program.
Rational boundByProjection(const ClassTypes& classes, const std::vector<const ClassType*>& live)
{
    const Program program = formulate(classes.schedule, Formulation::lumped).program;
    RationalVector c(live.size());
    Rational value = 0;
    for (const auto& [row, weight] : rowsOfLeast(program, live)) {
        const std::int64_t k = row.tag;
        const std::int64_t p = program.equalities.rows();
        const bool isEquality = k < p;
        if (!isEquality && weight < 0) {
            return 0;
        }
        const auto& matrix = isEquality ? program.equalities : program.inequalities;
        const double rhs = isEquality ? program.equalityRhs[k] : program.inequalityRhs[k - p];
        const int sign = isEquality ? 1 : -1;  // the program says <=
        for (SparseRows::InnerIterator entry(matrix, isEquality ? k : k - p); entry; ++entry) {
            c[static_cast<std::size_t>(entry.col())] += weight * Rational(entry.value()) * sign;
        }
        value += weight * Rational(rhs) * sign;
    }
    return dualBound(live, c, value);
}

/// The largest sum of squares of so many steps from 0 to a sum between two bounds, none longer than
/// the cap: between places where a walk is at a bound or an end all steps but one are as long as
/// the cap. Empty if that is more than rational arithmetic can take.
std::optional<Rational> mostOfWalk(std::int64_t count, const Rational& sum, const Rational& lower,
                                   const Rational& upper, const std::optional<Rational>& cap)
{
    constexpr double mostStates = 3e5;
    std::map<Rational, Rational> ways;  // the most squares on the way to a place
    std::vector<Rational> places;
    for (const Rational& anchor : {Rational(0), sum, lower, upper}) {
        places.push_back(anchor);
        const double longest = cap ? static_cast<double>(Rational((upper - lower) / *cap)) : 0.0;
        if (!(longest * static_cast<double>(count) <= mostStates)) {
            return std::nullopt;
        }
        for (int sign = -1; cap && sign <= 1; sign += 2) {
            for (Rational at = anchor + sign * *cap; at >= lower && at <= upper;
                 at += sign * *cap) {
                places.push_back(at);
            }
        }
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    ways.emplace(0, 0);
    for (std::int64_t step = 0; step < count; ++step) {
        std::map<Rational, Rational> next;
        for (const Rational& to : places) {
            const auto first = cap ? ways.lower_bound(to - *cap) : ways.begin();
            const auto last = cap ? ways.upper_bound(to + *cap) : ways.end();
            for (auto from = first; from != last; ++from) {
                const Rational way = to - from->first;
                Rational squares = from->second + way * way;
                const auto [known, isNew] = next.try_emplace(to, squares);
                known->second = isNew ? known->second : std::max(known->second, squares);
            }
        }
        ways = std::move(next);
    }
    const auto end = ways.find(sum);
    return end == ways.end() ? Rational(-1) : end->second;
}

/// All of a sum in one amplitude, or in as many of the size of the cap as it fills; -1: it is more
/// than all of them.
Rational mostOfSimplex(std::int64_t count, const Rational& sum, const std::optional<Rational>& cap)
{
    if (!cap || sum <= *cap) {
        return sum * sum;
    }
    const Rational filled = sum / *cap;
    const Integer full = numerator(filled) / denominator(filled);
    const Rational rest = sum - *cap * full;
    return full > count || (full == count && rest > 0) ? Rational(-1)
                                                       : Rational(full * *cap * *cap + rest * rest);
}

/// No motion with these sums has larger squares; with several vertices of the sums only what holds
/// for all in between, sum z^2 <= max |z| sum |z|. -1: there is none; empty: not known.
std::optional<Rational> mostSquaresAt(const ClassTypes& classes,
                                      const std::vector<const ClassType*>& live,
                                      const RationalVector& sums, bool isOnly,
                                      const std::optional<Rational>& limit)
{
    Rational squares = 0;
    for (std::size_t i = 0; i < live.size(); ++i) {
        const ClassType& type = *live[i];
        const bool isCompressed =
            std::find(type.signs.begin(), type.signs.end(), 1) != type.signs.end();
        const auto cap = isCompressed ? limit : std::nullopt;
        const bool isPressing = type.kind == TypeKind::pressing;
        std::optional<Rational> own;
        if (!isOnly) {
            if (!cap && (!isPressing || limit)) {
                return std::nullopt;
            }
            own = !cap         ? Rational(sums[i] * sums[i])
                  : isPressing ? Rational(*cap * sums[i])
                               : Rational(*cap * *cap * type.count);
        } else if (isPressing) {
            own = mostOfSimplex(type.count, sums[i], cap);
        } else if (type.count == 1) {
            own = cap && abs(sums[i]) > *cap ? Rational(-1) : Rational(sums[i] * sums[i]);
        } else {
            const auto [lower, upper] = boundsOf<Rational>(classes, sums, i, 1);
            own = mostOfWalk(type.count, sums[i], lower, upper, cap);
        }
        if (!own || *own < 0) {
            return own;
        }
        squares += *own;
    }
    return squares;
}

/// The largest squares of all motions, by the vertices of the sums in rational numbers.
std::optional<Rational> mostSquaresOf(const ClassTypes& classes,
                                      const std::vector<const ClassType*>& live,
                                      const std::optional<Rational>& limit)
{
    constexpr std::size_t mostRays = 512;
    const Program program = formulate(classes.schedule, Formulation::lumped).program;
    const auto rows = ProgramRows::of(program);
    const auto corners = rows ? generatorsOf(*rows, mostRays) : std::nullopt;
    if (!corners || !corners->directions.empty() || corners->vertices.empty()) {
        return std::nullopt;
    }
    Rational most = -1;
    for (const Homogeneous& vertex : corners->vertices) {
        const auto here =
            mostSquaresAt(classes, live, asRationals(vertex), corners->vertices.size() == 1, limit);
        if (!here) {
            return std::nullopt;
        }
        most = std::max(most, *here);
    }
    return most;
}

}  // namespace

bool exceedEnergy(const Schedule& schedule, double energyRatio)
{
    const ClassTypes classes = classTypes(schedule);
    const auto live = liveTypesOf(classes);
    const Rational wanted = squaresAt(energyRatio, classes);
    if (boundByGap(live, classes.schedule) > wanted) {
        return true;
    }
    return isWithinReach(classes.schedule, live.size()) &&
           boundByProjection(classes, live) > wanted;
}

std::optional<RationalProof> leastEnergyProof(const Schedule& schedule)
{
    const ClassTypes classes = classTypes(schedule);
    const auto live = liveTypesOf(classes);
    if (!isWithinReach(classes.schedule, live.size()) || isCone(schedule.stops)) {
        return std::nullopt;
    }
    const Program program = formulate(classes.schedule, Formulation::lumped).program;
    std::vector<WeightedRow> held = rowsOfLeast(program, live);
    if (held.empty()) {
        return std::nullopt;
    }
    std::sort(held.begin(), held.end(), [](const WeightedRow& left, const WeightedRow& right) {
        return left.row.tag < right.row.tag;
    });
    // Rows of the projection say >=, those of the program = and <=.
    RationalProof proof;
    const std::int64_t equalities = program.equalities.rows();
    for (const auto& [row, weight] : held) {
        if (row.tag < equalities) {
            proof.equalities.push_back({row.tag, Rational(-weight).str()});
        } else {
            proof.inequalities.push_back({row.tag - equalities, weight.str()});
        }
    }
    return proof;
}

bool stayBelowEnergy(const Schedule& schedule, double energyRatio, double strainLimit)
{
    const ClassTypes classes = classTypes(schedule);
    const auto live = liveTypesOf(classes);
    if (!isWithinReach(classes.schedule, live.size()) || isCone(schedule.stops)) {
        return false;
    }
    const std::optional<Rational> cap =
        std::isfinite(strainLimit) ? std::optional(Rational(strainLimit) / 2) : std::nullopt;
    const auto most = mostSquaresOf(classes, live, cap);
    return most && *most < squaresAt(energyRatio, classes);
}

}  // namespace signorini
