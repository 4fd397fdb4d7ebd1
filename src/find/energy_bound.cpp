#include "energy_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "echo.hpp"
#include "formulation.hpp"
#include "program_rows.hpp"
#include "rational.hpp"
#include "signorini/lumped_set.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// What the sum of S^2/d has to exceed: E/E_1 = 2w/N sum S^2/d at least.
Rational squaresOf(double energyRatio, const ClassTypes& classes)
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
        using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
        for (Rows::InnerIterator entry(matrix, isEquality ? k : k - p); entry; ++entry) {
            c[static_cast<std::size_t>(entry.col())] += weight * Rational(entry.value()) * sign;
        }
        value += weight * Rational(rhs) * sign;
    }
    return dualBound(live, c, value);
}

/// The largest sum of squares of steps between 0, corners -1 or 0 and the end -1, in units of N.
std::int64_t mostOfCorners(std::int64_t count)
{
    constexpr std::int64_t impossible = -1;
    std::array<std::int64_t, 2> best{0, impossible};  // at 0, at -1
    for (std::int64_t j = 0; j < count; ++j) {
        const auto [up, down] = best;
        best = {std::max(up, down < 0 ? impossible : down + 1), std::max(up + 1, down)};
    }
    return best[1];
}

}  // namespace

bool exceedEnergy(const Schedule& schedule, double energyRatio)
{
    const ClassTypes classes = classTypes(schedule);
    const auto live = liveTypesOf(classes);
    const Rational wanted = squaresOf(energyRatio, classes);
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
    if (schedule.phases.size() != 1 || schedule.stops.left || live.size() != 1 ||
        live.front()->windowSum == 0) {
        return false;
    }
    const ClassType& type = *live.front();
    const Rational sum =
        Rational(gapSum(classes.schedule.cells, schedule.stops.right)) / type.windowSum;
    // On a grazing box Z runs from -N to 0, which is as far as from 0 to S.
    if (type.kind == TypeKind::grazing && type.windowSum != 1) {
        return false;
    }
    const bool isBox = type.kind == TypeKind::grazing;
    const Rational wanted = squaresOf(energyRatio, classes);
    if (std::isfinite(strainLimit)) {
        const Rational most = Rational(strainLimit) / 2;
        const Rational reached = most * (isBox ? Rational(most * type.count) : sum);
        if (reached < wanted) {
            return true;
        }
    }
    return sum * sum * (isBox ? mostOfCorners(type.count) : 1) < wanted;
}

}  // namespace signorini
