#include "signorini/lumped_set.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "echo.hpp"
#include "faults.hpp"
#include "lumped_rows.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

std::int64_t asInt64(const Integer& value)
{
    if (abs(value) > std::numeric_limits<std::int64_t>::max()) {
        throw std::overflow_error("a multiplier of the proof does not fit in 64 bits");
    }
    return static_cast<std::int64_t>(value);
}

/// From sum weight coefficients = 0 to integer multipliers of the rows as documented: there
/// inequalities point the other way, and rows S >= 0 are left to the reader.
LumpedAbsence absenceOf(const std::vector<WeightedRow>& rows)
{
    RationalVector weights;
    for (const WeightedRow& weighted : rows) {
        weights.push_back(weighted.weight);
    }
    const Homogeneous integers = overCommonDenominator(weights);
    LumpedAbsence absence;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const ExactRow& row = rows[k].row;
        const std::int64_t value = asInt64(integers.numerators[k]);
        if (value == 0 || row.tag == signTag) {
            continue;
        }
        if (row.tag == gapTag) {
            absence.gap = -value;
        } else if (row.tag == sizeTag) {
            absence.size = -value;
        } else if (row.tag == prefixTag) {
            PrefixMultiplier prefix{row.coefficients, value, -row.rhs};
            for (std::int64_t& c : prefix.coefficients) {
                c = -c;
            }
            absence.prefixes.push_back(std::move(prefix));
        } else {
            absence.closures.push_back({row.tag, -value});
        }
    }
    return absence;
}

}  // namespace

std::int64_t blockCount(const Schedule& schedule)
{
    validate(schedule);
    Schedule folded = schedule;
    fold(folded);
    const std::int64_t n = steps(folded);
    const std::int64_t classes = std::gcd(2 * folded.cells, n);
    const auto boundaries = 2 * static_cast<std::int64_t>(folded.phases.size());
    return n / classes * std::min(boundaries, classes);
}

std::size_t liveTypeCount(const ClassTypes& classes)
{
    return liveTypes(classes).size();
}

LumpedSet lumpedSet(const Schedule& schedule)
{
    const std::int64_t blocks = blockCount(schedule);
    if (blocks > maxBlocks) {
        throw std::invalid_argument(
            fmt::format("schedule: {} blocks in a period: allowed at most {}", blocks, maxBlocks));
    }
    return lumpedSetOf(classTypes(schedule));
}

LumpedSet lumpedSetOf(ClassTypes classes)
{
    LumpedSet set;
    set.live = liveTypes(classes);
    set.classes = std::move(classes);
    if (set.live.size() > maxLiveTypes) {
        throw std::invalid_argument(fmt::format("schedule: {} live types: allowed at most {}",
                                                set.live.size(), maxLiveTypes));
    }
    const LumpedRows rows(set.classes, set.live);
    const std::vector<std::int64_t> counts = countsOf(set);
    const Projection nearest = project(rows, RationalVector(set.live.size()), counts);
    if (!nearest.isFeasible) {
        set.absence = absenceOf(nearest.rows);
        return set;
    }
    Rational squares = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        squares += nearest.point[i] * nearest.point[i] / counts[i];
    }
    set.leastSums = asDoubles(nearest.point);
    set.leastEnergy =
        static_cast<double>(energyOf(squares, set.classes.schedule.cells, set.classes.window));
    return set;
}

Reason absenceReason(const ClassTypes& classes)
{
    const auto any = [&classes](auto condition) {
        return std::any_of(classes.types.begin(), classes.types.end(), condition);
    };
    if (classes.kernelDimension == 0) {
        return Reason::noLiveClass;
    }
    if (!any([](const ClassType& type) { return type.isLive(); })) {
        return Reason::contactSign;
    }
    // u(L) = g > 0 needs a negative window sum, g < 0 a positive one, the second stop, too.
    const std::int64_t side = gapSum(classes.schedule).rhs;
    if (side != 0 && !any([side](const ClassType& type) {
            return (type.kind == TypeKind::pressing &&
                    (side < 0 ? type.windowSum < 0 : type.windowSum > 0)) ||
                   (type.kind == TypeKind::grazing && type.windowSum != 0);
        })) {
        return Reason::gap;
    }
    return Reason::penetration;
}

}  // namespace signorini
