#include "stops.hpp"

#include <algorithm>
#include <numeric>

#include "echo.hpp"
#include "integers.hpp"

namespace signorini {

namespace {

/// factor x = rhs in lowest terms.
WaveSum reduced(std::int64_t factor, std::int64_t rhs)
{
    const std::int64_t common = std::gcd(factor, rhs);
    return {factor / common, rhs / common};
}

}  // namespace

Fraction placeOf(const Stops& stops, Stop stop)
{
    return stop == Stop::right
               ? Fraction{stops.right, 1}
               : Fraction{-stops.left.value().numerator, stops.left.value().denominator};
}

double restingStrain(const Stops& stops, double base)
{
    double place = std::min(base, static_cast<double>(stops.right));
    if (stops.left) {
        place = std::max(place, -stops.left->value());
    }
    return place - base;
}

WaveSum gapSum(const Schedule& schedule)
{
    const Fraction place = placeOf(schedule.stops, schedule.phases.front().stop);
    return reduced(place.denominator, checkedMultiply(-place.numerator, schedule.cells));
}

std::optional<WaveSum> crossingSum(const Schedule& schedule)
{
    const auto& [right, left] = schedule.stops;
    if (!left) {
        return std::nullopt;
    }
    const std::int64_t way = checkedAdd(right * left->denominator, left->numerator);
    return reduced(checkedMultiply(2, left->denominator), checkedMultiply(way, schedule.cells));
}

bool canRest(std::span<const Phase> phases, const Stops& stops)
{
    return stops.right == 0 && std::all_of(phases.begin(), phases.end(), [](const Phase& phase) {
               return phase.stop == Stop::right;
           });
}

bool isMirrored(std::span<const Phase> phases, const Stops& stops)
{
    const std::size_t half = phases.size() / 2;
    return stops.left && *stops.left == Fraction{stops.right, 1} && phases.size() % 2 == 0 &&
           std::equal(phases.begin(), phases.begin() + static_cast<std::ptrdiff_t>(half),
                      phases.begin() + static_cast<std::ptrdiff_t>(half),
                      [](const Phase& one, const Phase& other) {
                          return one.contact == other.contact && one.free == other.free &&
                                 one.stop != other.stop;
                      });
}

std::vector<FlightLimits> flightLimits(const Schedule& schedule)
{
    const auto crossing = crossingSum(schedule);
    std::vector<FlightLimits> limits;
    for (std::size_t k = 0; k < schedule.phases.size(); ++k) {
        const Stop from = schedule.phases[k].stop;
        const Stop to = schedule.phases[(k + 1) % schedule.phases.size()].stop;
        FlightLimits all;
        if (crossing) {
            const WaveSum back{crossing->factor, -crossing->rhs};
            all.most = from == Stop::right ? WaveSum{} : *crossing;
            all.least = from == Stop::right ? back : WaveSum{};
            all.end = from == to ? WaveSum{} : from == Stop::right ? back : *crossing;
        }
        limits.push_back(all);
    }
    return limits;
}

}  // namespace signorini
