#include "lumped_rows.hpp"

#include <limits>

#include "echo.hpp"

namespace signorini {

/// For each type its place among the live ones, or -1.
std::vector<std::ptrdiff_t> placesOf(const ClassTypes& classes)
{
    std::vector<std::ptrdiff_t> places;
    std::ptrdiff_t next = 0;
    for (const ClassType& type : classes.types) {
        places.push_back(type.isLive() ? next++ : -1);
    }
    return places;
}

std::vector<std::size_t> liveTypes(const ClassTypes& classes)
{
    std::vector<std::size_t> live;
    for (std::size_t t = 0; t < classes.types.size(); ++t) {
        if (classes.types[t].isLive()) {
            live.push_back(t);
        }
    }
    return live;
}

std::vector<std::int64_t> countsOf(const LumpedSet& set)
{
    std::vector<std::int64_t> counts;
    for (const std::size_t t : set.live) {
        counts.push_back(set.classes.types[t].count);
    }
    return counts;
}

std::vector<double> asDoubles(const RationalVector& x)
{
    std::vector<double> result;
    for (const Rational& value : x) {
        result.push_back(static_cast<double>(value));
    }
    return result;
}

/// The gap row if it is broken, else the worst closure, else the worst inequality.
template <typename Number>
std::optional<ExactRow> LumpedRows::violatedRow(const std::vector<Number>& sums,
                                                const Number& denominator) const
{
    Number gap = -denominator * gapSum(classes_.schedule.cells);
    for (std::size_t i = 0; i < live_.size(); ++i) {
        gap += sums[i] * classes_.types[live_[i]].windowSum;
    }
    if (gap != 0) {
        return gapRow();
    }
    const std::size_t lastPhase = classes_.schedule.phases.size() - 1;
    Number worst = 0;
    std::optional<std::size_t> negative;  // live type
    for (std::size_t i = 0; i < live_.size(); ++i) {
        if (classes_.types[live_[i]].kind == TypeKind::pressing && -sums[i] > worst) {
            worst = -sums[i];
            negative = i;
        }
    }
    Number prefix = 0;
    Number worstClosure = 0;
    std::int64_t block = 0;
    std::int64_t worstBlock = -1;
    std::optional<std::size_t> openPhase;
    walkFlights(
        classes_,
        [&](const Block&, std::size_t place, std::int64_t sign) {
            if (sign > 0) {
                prefix += sums[place];
            } else {
                prefix -= sums[place];
            }
            if (prefix > worst) {
                worst = prefix;
                worstBlock = block;
            }
            ++block;
        },
        [&](std::size_t phase) {
            const Number size = prefix < 0 ? Number(-prefix) : prefix;
            if (phase < lastPhase && size > worstClosure) {
                worstClosure = size;
                openPhase = phase;
            }
            prefix = 0;
        });
    if (openPhase) {
        return closure(*openPhase);
    }
    if (worstBlock >= 0) {
        return prefixRow(worstBlock);
    }
    if (negative) {
        return signRow(*negative);
    }
    return std::nullopt;
}

std::optional<ExactRow> LumpedRows::violatedRow(const Homogeneous& point) const
{
    // Every sum below stays within the largest number times this.
    const Integer terms = Integer(blockCount(classes_.schedule)) +
                          2 * classes_.schedule.cells * (static_cast<std::int64_t>(unknowns()) + 1);
    Integer largest = point.denominator;
    for (const Integer& value : point.numerators) {
        largest = std::max<Integer>(largest, abs(value));
    }
    if (largest * terms <= std::numeric_limits<std::int64_t>::max()) {
        std::vector<std::int64_t> small;
        for (const Integer& value : point.numerators) {
            small.push_back(static_cast<std::int64_t>(value));
        }
        return violatedRow(small, static_cast<std::int64_t>(point.denominator));
    }
    return violatedRow(point.numerators, point.denominator);
}

ExactRow LumpedRows::gapRow() const
{
    ExactRow row{{}, gapSum(classes_.schedule.cells), true, gapTag};
    for (const std::size_t t : live_) {
        row.coefficients.push_back(classes_.types[t].windowSum);
    }
    return row;
}

ExactRow LumpedRows::signRow(std::size_t place) const
{
    ExactRow row{std::vector<std::int64_t>(live_.size()), 0, false, signTag};
    row.coefficients[place] = 1;
    return row;
}

ExactRow LumpedRows::closure(std::size_t wanted) const
{
    ExactRow row{std::vector<std::int64_t>(live_.size()), 0, true,
                 static_cast<std::int64_t>(wanted)};
    walkFlights(
        classes_,
        [&](const Block& block, std::size_t place, std::int64_t sign) {
            row.coefficients[place] += block.phase == wanted ? sign : 0;
        },
        [](std::size_t) {});
    return row;
}

/// Minus the prefix sum at the end of the live block in flight of that number is >= 0.
ExactRow LumpedRows::prefixRow(std::int64_t wanted) const
{
    ExactRow row{std::vector<std::int64_t>(live_.size()), 0, false, prefixTag};
    std::int64_t number = 0;
    walkFlights(
        classes_,
        [&](const Block&, std::size_t place, std::int64_t sign) {
            row.coefficients[place] -= number <= wanted ? sign : 0;
            ++number;
        },
        [&](std::size_t) {
            if (number <= wanted) {
                std::fill(row.coefficients.begin(), row.coefficients.end(), 0);
            }
        });
    return row;
}

}  // namespace signorini
