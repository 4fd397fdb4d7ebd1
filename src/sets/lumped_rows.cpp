#include "lumped_rows.hpp"

#include <cstdlib>
#include <limits>

#include "echo.hpp"
#include "integers.hpp"

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

/// The worst inequality on prefix sums, and the worst flight that does not close.
template <typename Number>
struct LumpedRows::Broken {
    Number most = 0;
    std::int64_t block = -1;
    bool isFloor = false;
    Number open = 0;
    std::optional<std::size_t> phase;

    void see(const Number& excess, std::int64_t number, bool below)
    {
        if (excess > most) {
            most = excess;
            block = number;
            isFloor = below;
        }
    }

    void seeEnd(const Number& rest, std::size_t number)
    {
        const Number size = rest < 0 ? Number(-rest) : rest;
        if (size > open) {
            open = size;
            phase = number;
        }
    }
};

/// The gap row if it is broken, then that of size, else the worst closure, else the worst
/// inequality.
template <typename Number>
std::optional<ExactRow> LumpedRows::violatedRow(const std::vector<Number>& sums,
                                                const Number& denominator) const
{
    Number gap = 0;
    Number size = isCone_ ? Number(-denominator * classes_.schedule.cells) : Number(0);
    for (std::size_t i = 0; i < live_.size(); ++i) {
        gap += sums[i] * classes_.types[live_[i]].windowSum;
        if (isCone_) {
            size += sums[i] * classes_.types[live_[i]].contactMembers;
        }
    }
    if (gap_.factor * gap != denominator * gap_.rhs) {
        return gapRow();
    }
    if (size != 0) {
        return sizeRow();
    }
    Broken<Number> broken;
    std::optional<std::size_t> negative;  // live type
    for (std::size_t i = 0; i < live_.size(); ++i) {
        if (classes_.types[live_[i]].kind == TypeKind::pressing && -sums[i] > broken.most) {
            broken.most = -sums[i];
            negative = i;
        }
    }
    const std::size_t lastPhase = classes_.schedule.phases.size() - 1;
    // factor (a sum) - rhs; only flights between two stops have other factors than 1.
    const auto beyond = [&denominator](const Number& sum, const WaveSum& limit) {
        return limit.rhs == 0 ? sum : Number(limit.factor * sum - denominator * limit.rhs);
    };
    Number prefix = 0;
    std::int64_t block = 0;
    walkFlights(
        classes_,
        [&](const Block& at, std::size_t place, std::int64_t sign) {
            if (sign > 0) {
                prefix += sums[place];
            } else {
                prefix -= sums[place];
            }
            const FlightLimits& flight = limits_[at.phase];
            broken.see(beyond(prefix, flight.most), block, false);
            if (flight.least) {
                broken.see(-beyond(prefix, *flight.least), block, true);
            }
            ++block;
        },
        [&](std::size_t phase) {
            if (phase < lastPhase) {
                broken.seeEnd(beyond(prefix, limits_[phase].end), phase);
            }
            prefix = 0;
        });
    if (broken.phase) {
        return closure(*broken.phase);
    }
    if (broken.block >= 0) {
        return prefixRow(broken.block, broken.isFloor);
    }
    if (negative) {
        return signRow(*negative);
    }
    return std::nullopt;
}

std::optional<ExactRow> LumpedRows::violatedRow(const Homogeneous& point) const
{
    // Every sum below stays within the largest number times this.
    const auto crossing = crossingSum(classes_.schedule);
    const Integer terms =
        (Integer(blockCount(classes_.schedule)) +
         2 * classes_.schedule.cells * (static_cast<std::int64_t>(unknowns()) + 1)) *
            (crossing ? crossing->factor : 1) +
        (crossing ? crossing->rhs : 0) + std::abs(gap_.rhs);
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
    ExactRow row{{}, gap_.rhs, true, gapTag};
    for (const std::size_t t : live_) {
        row.coefficients.push_back(checkedMultiply(gap_.factor, classes_.types[t].windowSum));
    }
    return row;
}

ExactRow LumpedRows::sizeRow() const
{
    ExactRow row{{}, classes_.schedule.cells, true, sizeTag};
    for (const std::size_t t : live_) {
        row.coefficients.push_back(classes_.types[t].contactMembers);
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
    const WaveSum& end = limits_[wanted].end;
    ExactRow row{std::vector<std::int64_t>(live_.size()), end.rhs, true,
                 static_cast<std::int64_t>(wanted)};
    walkFlights(
        classes_,
        [&](const Block& block, std::size_t place, std::int64_t sign) {
            row.coefficients[place] += block.phase == wanted ? sign : 0;
        },
        [](std::size_t) {});
    for (std::int64_t& coefficient : row.coefficients) {
        coefficient = checkedMultiply(coefficient, end.factor);
    }
    return row;
}

/// The prefix sum at the end of the live block in flight of that number, within its limit.
ExactRow LumpedRows::prefixRow(std::int64_t wanted, bool isFloor) const
{
    ExactRow row{std::vector<std::int64_t>(live_.size()), 0, false, prefixTag};
    std::int64_t number = 0;
    std::size_t flight = 0;
    walkFlights(
        classes_,
        [&](const Block& block, std::size_t place, std::int64_t sign) {
            row.coefficients[place] += number <= wanted ? sign : 0;
            flight = number <= wanted ? block.phase : flight;
            ++number;
        },
        [&](std::size_t) {
            if (number <= wanted) {
                std::fill(row.coefficients.begin(), row.coefficients.end(), 0);
            }
        });
    const WaveSum limit = isFloor ? limits_[flight].least.value() : limits_[flight].most;
    const std::int64_t side = isFloor ? 1 : -1;  // an ExactRow says >=
    for (std::int64_t& coefficient : row.coefficients) {
        coefficient = checkedMultiply(coefficient, side * limit.factor);
    }
    row.rhs = side * limit.rhs;
    return row;
}

}  // namespace signorini
