#include "signorini/modes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "faults.hpp"
#include "mode_line.hpp"
#include "names.hpp"
#include "rational.hpp"

namespace signorini {

namespace {

constexpr auto modeEndNames = std::to_array<Named<ModeEnd>>({
    {ModeEnd::contactVanishes, "contact-vanishes"},
    {ModeEnd::energyInfinite, "energy-infinite"},
    {ModeEnd::jumpsMeet, "jumps-meet"},
});

/// What Euclid's algorithm on (2a, r), r = -m mod 2a, says of a mode.
struct ModePattern {
    std::int64_t numerator = 1;  ///< Q of the right neighbour P/Q of m/2a
    std::int64_t turns = 0;      ///< c of docs/theory.md: M - (d_1 + d_3 + ...)
};

/// None unless d_0, d_2, ... are even. \pre gcd(2a, m) = 1.
std::optional<ModePattern> modePattern(std::int64_t count, std::int64_t order)
{
    ModePattern pattern;
    pattern.turns = order / count + 1;
    std::int64_t even = count;
    std::int64_t odd = pattern.turns * count - order;
    std::int64_t convergent = 0;  // numerators of the convergents of 2a/r, two behind and ...
    while (odd > 1) {
        const std::int64_t first = even / odd;
        if (first % 2 != 0) {
            return std::nullopt;
        }
        even %= odd;
        const std::int64_t second = odd / even;
        odd %= even;
        pattern.turns -= second;
        convergent += first * pattern.numerator;
        pattern.numerator += second * convergent;  // ... one behind
    }
    return pattern;
}

ModeLine lineOf(const Mode& mode)
{
    return {mode.lowest, mode.highest, mode.kappa, mode.mu, 1, mode.gapSign};
}

/// Without a gap the energy of a mode is infinite but at one period.
void check(Faults& faults, int gapSign)
{
    if (gapSign != 1 && gapSign != -1) {
        faults.add("gapSign", gapSign, "1 or -1: without a gap there are no modes");
    }
}

void validate(const ModeBounds& bounds)
{
    Faults faults;
    faults.requireWhole("maxOrder", bounds.maxOrder, maxModeOrder);
    faults.requirePositive("maxPeriod", bounds.maxPeriod, "L/c");
    faults.requirePositive("maxEnergyRatio", bounds.maxEnergyRatio, "E_1");
    check(faults, bounds.gapSign);
    faults.throwIfAny();
}

void requireInside(const Mode& mode, double period)
{
    // The sign of a sum rounded once is the sign of the sum.
    const auto beyond = [period](const ExactPeriod& end) {
        return linear(end.denominator, period, -end.numerator);
    };
    if (!(beyond(mode.lowest) > 0.0 && beyond(mode.highest) < 0.0)) {
        throwFault("period", period,
                   fmt::format("]{}/{}, {}/{}[ [L/c], as t_c = {} {:+} T", mode.lowest.numerator,
                               mode.lowest.denominator, mode.highest.numerator,
                               mode.highest.denominator, 4 * mode.a, mode.b));
    }
}

}  // namespace

std::string_view name(ModeEnd end)
{
    return nameIn(modeEndNames, end);
}

std::vector<Mode> findModes(const ModeBounds& bounds)
{
    validate(bounds);
    std::vector<Mode> modes;
    for (std::int64_t order = 1; order <= bounds.maxOrder; order += 2) {
        if (isRequested(bounds.cancel)) {
            break;
        }
        if (bounds.progress) {
            // The work for |b| grows like |b|.
            bounds.progress(std::pow(order, 2), std::pow(bounds.maxOrder, 2));
        }
        for (std::int64_t a = 1; a <= order; ++a) {
            const std::optional<Mode> mode = findMode(a, -order, bounds.gapSign);
            if (mode && isWithin(lineOf(*mode), bounds)) {
                modes.push_back(*mode);
            }
        }
    }
    return modes;
}

std::optional<Mode> findMode(std::int64_t a, std::int64_t b, int gapSign)
{
    Faults faults;
    check(faults, gapSign);
    faults.requireWhole("a", a, maxFamilyOrder);
    if (b > -1 || b < -maxFamilyOrder) {
        faults.add("b", b, fmt::format("whole numbers -{}..-1", maxFamilyOrder));
    }
    faults.throwIfAny();
    const std::int64_t count = 2 * a;
    const std::int64_t order = -b;
    const auto pattern = std::gcd(count, order) == 1 ? modePattern(count, order) : std::nullopt;
    if (!pattern) {
        return std::nullopt;
    }
    const std::int64_t q = pattern->numerator;
    const std::int64_t p = (1 + q * order) / count;
    const std::int64_t c = pattern->turns;
    Mode mode;
    mode.a = a;
    mode.b = b;
    mode.kappa = (p + c * order) / 2;
    mode.mu = q + c * count;
    mode.lowest = c > 0 ? exactPeriod(mode.mu, mode.kappa) : exactPeriod(2 * q, p);
    mode.lowestEnd = c < 0 ? ModeEnd::jumpsMeet : ModeEnd::energyInfinite;
    mode.highest = {2 * count, order};
    if (gapSign < 0) {
        if (c <= 0) {
            return std::nullopt;  // kappa T > mu wherever the pattern is one
        }
        mode.gapSign = gapSign;
        mode.highest = std::exchange(mode.lowest, exactPeriod(2 * q, p));
        mode.lowestEnd = ModeEnd::jumpsMeet;
        mode.highestEnd = ModeEnd::energyInfinite;
    }
    return mode;
}

std::string familyName(const Mode& mode)
{
    const std::int64_t order = -mode.b;
    if (mode.gapSign < 0) {
        return "";
    }
    if (mode.a == 1) {
        return order == 1 ? "main" : fmt::format("higher {}", (order - 1) / 2);
    }
    if (order == 2 * mode.a - 1) {
        return fmt::format("subharmonic {}", mode.a);
    }
    if (mode.a % 3 == 1 && order == 1 + 4 * (mode.a / 3)) {
        return fmt::format("twin {}", mode.a / 3);
    }
    return "";
}

double contactTime(const Mode& mode, double period)
{
    requireInside(mode, period);
    return linear(mode.b, period, 4 * mode.a);
}

double energyRatio(const Mode& mode, double period)
{
    requireInside(mode, period);
    const double root = linear(mode.kappa, period, -mode.mu);
    return 1.0 / (root * root);
}

EnergyRange energyRange(const Mode& mode)
{
    return energyLimits(lineOf(mode));
}

Schedule scheduleOf(const Mode& mode, std::int64_t cells, std::int64_t steps)
{
    Faults faults;
    if (cells < 1 || cells > maxCells) {
        faults.add("cells", cells, fmt::format("1..{}", maxCells));
        faults.throwIfAny();
    }
    const auto isBelow = [cells](const ExactPeriod& end, std::int64_t n) {
        return Integer(end.numerator) * cells < Integer(n) * end.denominator;
    };
    const bool isAboveHighest =
        Integer(mode.highest.numerator) * cells <= Integer(steps) * mode.highest.denominator;
    if (!isBelow(mode.lowest, steps) || isAboveHighest) {
        faults.add("steps", steps,
                   fmt::format("between {} and {} periods of {} cells, both excluded",
                               mode.lowest.value(), mode.highest.value(), cells));
        faults.throwIfAny();
    }
    const std::int64_t contact = 4 * mode.a * cells + mode.b * steps;
    return {cells, {{contact, steps - contact}}, {.right = mode.gapSign}};
}

}  // namespace signorini
