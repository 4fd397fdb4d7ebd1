#pragma once
/// \file
/// The rows in the sums S of the live types, as they stand in lumped_set.hpp.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "exact_projection.hpp"
#include "signorini/lumped_set.hpp"
#include "stops.hpp"

namespace signorini {

/// ExactRow::tag: closures carry the number of their phase.
inline constexpr std::int64_t gapTag = -1;
inline constexpr std::int64_t signTag = -2;
inline constexpr std::int64_t prefixTag = -3;
inline constexpr std::int64_t sizeTag = -4;

/// For each type its place among the live ones, or -1.
[[nodiscard]] std::vector<std::ptrdiff_t> placesOf(const ClassTypes& classes);

/// Calls action(block, place, sign) for every live block in flight, and atEnd(phase) after the
/// last block of each flight.
template <typename Action, typename AtEnd>
void walkFlights(const ClassTypes& classes, Action action, AtEnd atEnd)
{
    const std::vector<std::ptrdiff_t> places = placesOf(classes);
    forEachBlock(classes, [&](const Block& block) {
        const std::ptrdiff_t place = places[block.type];
        if (!block.isContact && place >= 0) {
            const auto& signs = classes.types[block.type].signs;
            action(block, static_cast<std::size_t>(place),
                   std::int64_t{signs[static_cast<std::size_t>(block.alpha)]});
        }
        if (block.endsPhase) {
            atEnd(block.phase);
        }
    });
}

/// Indices of the live types.
[[nodiscard]] std::vector<std::size_t> liveTypes(const ClassTypes& classes);

/// d of each live type.
[[nodiscard]] std::vector<std::int64_t> countsOf(const LumpedSet& set);

/// Each number rounded once.
[[nodiscard]] std::vector<double> asDoubles(const RationalVector& x);

/// The rows in the sums S. \throws std::overflow_error where coefficients do not fit in 64 bits.
class LumpedRows : public RowSource {
public:
    LumpedRows(const ClassTypes& classes, const std::vector<std::size_t>& live)
        : classes_(classes),
          live_(live),
          gap_(gapSum(classes.schedule)),
          limits_(flightLimits(classes.schedule)),
          isCone_(signorini::isCone(classes.schedule.stops))
    {
    }

    [[nodiscard]] std::size_t unknowns() const override { return live_.size(); }

    [[nodiscard]] std::optional<ExactRow> violatedRow(const Homogeneous& point) const override;

private:
    template <typename Number>
    [[nodiscard]] std::optional<ExactRow> violatedRow(const std::vector<Number>& sums,
                                                      const Number& denominator) const;
    /// How far prefix sums can break the limits of a flight.
    template <typename Number>
    struct Broken;
    [[nodiscard]] ExactRow gapRow() const;
    [[nodiscard]] ExactRow sizeRow() const;
    [[nodiscard]] ExactRow signRow(std::size_t place) const;
    [[nodiscard]] ExactRow closure(std::size_t wanted) const;
    [[nodiscard]] ExactRow prefixRow(std::int64_t wanted, bool isFloor) const;

    const ClassTypes& classes_;
    const std::vector<std::size_t>& live_;
    WaveSum gap_;
    std::vector<FlightLimits> limits_;
    bool isCone_;
};

/// Bounds on the partial sums Z of one grazing type: P + epsilon Z <= 0 for each of its blocks, P
/// being the prefix sum before it; between other limits where there are two stops. Both signs occur
/// among its blocks. The limits are those of one unit of `unit`: sums may be numerators over it.
template <typename Number>
std::pair<Number, Number> boundsOf(const ClassTypes& classes, const std::vector<Number>& sums,
                                   std::size_t wanted, const Number& unit)
{
    const std::vector<FlightLimits> limits = flightLimits(classes.schedule);
    const Number zero(0);
    Number prefix = zero;
    std::optional<Number> lower;
    std::optional<Number> upper;
    const auto keepBelow = [&upper](const Number& bound) {
        upper = upper ? std::min<Number>(*upper, bound) : bound;
    };
    const auto keepAbove = [&lower](const Number& bound) {
        lower = lower ? std::max<Number>(*lower, bound) : bound;
    };
    walkFlights(
        classes,
        [&](const Block& block, std::size_t place, std::int64_t sign) {
            if (place == wanted) {
                const FlightLimits& flight = limits[block.phase];
                const auto roomTo = [&](const WaveSum& limit) {
                    return Number(unit * Number(limit.rhs) / Number(limit.factor) - prefix);
                };
                const Number above = roomTo(flight.most);
                sign > 0 ? keepBelow(above) : keepAbove(Number(-above));
                if (flight.least) {
                    const Number below = roomTo(*flight.least);
                    sign > 0 ? keepAbove(below) : keepBelow(Number(-below));
                }
            }
            if (sign > 0) {
                prefix += sums[place];
            } else {
                prefix -= sums[place];
            }
        },
        [&](std::size_t) { prefix = zero; });
    return {*lower, *upper};
}

}  // namespace signorini
