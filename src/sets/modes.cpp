#include "signorini/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "faults.hpp"
#include "rational.hpp"

namespace signorini {

namespace {

/// x in 1..modulus-1 with x * value = -1 (mod modulus). \pre coprime, modulus >= 2.
std::int64_t negativeInverse(std::int64_t value, std::int64_t modulus)
{
    std::int64_t rest = modulus;
    std::int64_t next = value % modulus;
    std::int64_t factor = 0;  // factor * value = rest (mod modulus)
    std::int64_t nextFactor = 1;
    while (next != 0) {
        const std::int64_t quotient = rest / next;
        rest = std::exchange(next, rest - quotient * next);
        factor = std::exchange(nextFactor, factor - quotient * nextFactor);
    }
    return factor > 0 ? modulus - factor : -factor;
}

/// The gaps between the 2a jumps, in order of position from t_c to T: gap r lasts alpha, or alpha
/// + t_c if it is wide, and epsilon is -1 in even ones. Jump 2i is followed by jump 2(i - Q), or
/// after a wide gap by 2(i - Q + 2a); jump 2a stands at t_c, and "jump 0" is T.
class Gaps {
public:
    Gaps(std::int64_t a, std::int64_t order)
        : count(2 * a), numerator(negativeInverse(order, count)), index_(count)
    {
    }

    const std::int64_t count;      ///< 2a
    const std::int64_t numerator;  ///< Q: alpha = P T - 2Q with 2a P - |b| Q = 1

    /// i of the jump before the present gap.
    [[nodiscard]] std::int64_t index() const { return index_; }

    /// Steps over the present gap. \returns 1 if it is wide, else 0.
    std::int64_t next()
    {
        index_ -= numerator;
        if (index_ < 0) {
            index_ += count;
            return 1;
        }
        return 0;
    }

private:
    std::int64_t index_;
};

/// The mode with t_c = 4a - order T, if the tip stays out of the wall. O(a).
std::optional<Mode> modeOf(std::int64_t a, std::int64_t order)
{
    Gaps gaps(a, order);
    const std::int64_t count = gaps.count;
    const std::int64_t q = gaps.numerator;
    const std::int64_t p = (1 + q * order) / count;
    // At the end of a positive gap the integral of epsilon over the flight is -surplus t_c.
    std::int64_t surplus = 0;       // wide negative gaps less wide positive ones
    std::int64_t surplusAtTwo = 0;  // those before the jump 2 - T floor(2/T)
    for (std::int64_t r = 0; r < count; ++r) {
        if (gaps.index() == 1) {
            surplusAtTwo = surplus;
        }
        surplus += r % 2 == 0 ? gaps.next() : -gaps.next();
        if (surplus < 0) {
            return std::nullopt;
        }
    }
    // The integral of epsilon from 0 to 2, the window of (31), is c t_c - alpha.
    const std::int64_t c = order / count + 1 - surplusAtTwo;
    Mode mode;
    mode.a = a;
    mode.b = -order;
    mode.kappa = (p + c * order) / 2;
    mode.mu = q + c * count;
    mode.lowest = c > 0 ? exactPeriod(mode.mu, mode.kappa) : exactPeriod(2 * q, p);
    mode.lowestEnd = c < 0 ? ModeEnd::jumpsMeet : ModeEnd::energyInfinite;
    mode.highest = {2 * count, order};  // coprime already
    return mode;
}

/// Has the mode a motion with T <= maxPeriod and (kappa T - mu)^2 maxEnergyRatio >= 1? kappa T - mu
/// is monotone (kappa != 0), so the end where it is largest decides; exact.
bool isWithin(const Mode& mode, const ModeBounds& bounds)
{
    const Rational lowest(mode.lowest.numerator, mode.lowest.denominator);
    const Rational highest(mode.highest.numerator, mode.highest.denominator);
    const Rational longest(bounds.maxPeriod);
    if (longest <= lowest) {
        return false;
    }
    const bool isReached = mode.kappa > 0 && longest < highest;  // the ends are no members
    const Rational best = mode.kappa < 0 ? lowest : std::min(longest, highest);
    const Rational root = mode.kappa * best - mode.mu;
    const Rational ratio = root * root * Rational(bounds.maxEnergyRatio);
    return isReached ? ratio >= 1 : ratio > 1;
}

void validate(const ModeBounds& bounds)
{
    Faults faults;
    if (bounds.maxOrder < 1 || bounds.maxOrder > maxModeOrder) {
        faults.add("maxOrder", bounds.maxOrder, fmt::format("whole numbers 1..{}", maxModeOrder));
    }
    faults.requirePositive("maxPeriod", bounds.maxPeriod, "L/c");
    faults.requirePositive("maxEnergyRatio", bounds.maxEnergyRatio, "E_1");
    faults.throwIfAny();
}

/// k T + l, rounded once. \pre |k|, |l| < 2^53.
double linear(std::int64_t k, double period, std::int64_t l)
{
    return std::fma(static_cast<double>(k), period, static_cast<double>(l));
}

void requireInside(const Mode& mode, double period)
{
    // The sign of a sum rounded once is the sign of the sum.
    const auto beyond = [period](const ExactPeriod& end) {
        return linear(end.denominator, period, -end.numerator);
    };
    if (!(beyond(mode.lowest) > 0.0 && beyond(mode.highest) < 0.0)) {
        Faults faults;
        faults.add("period", period,
                   fmt::format("]{}/{}, {}/{}[ [L/c], as t_c = {} {:+} T", mode.lowest.numerator,
                               mode.lowest.denominator, mode.highest.numerator,
                               mode.highest.denominator, 4 * mode.a, mode.b));
        faults.throwIfAny();
    }
}

/// 1/sqrt(E/E_1) > 0.
double inverseRoot(const Mode& mode, double period)
{
    return linear(mode.kappa, period, -mode.mu);
}

}  // namespace

std::string_view name(ModeEnd end)
{
    switch (end) {
        case ModeEnd::contactVanishes:
            return "contact-vanishes";
        case ModeEnd::energyInfinite:
            return "energy-infinite";
        case ModeEnd::jumpsMeet:
            return "jumps-meet";
    }
    throw std::logic_error("unnamed ModeEnd");
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
            if (std::gcd(2 * a, order) != 1) {
                continue;
            }
            const std::optional<Mode> mode = modeOf(a, order);
            if (mode && isWithin(*mode, bounds)) {
                modes.push_back(*mode);
            }
        }
    }
    return modes;
}

std::string familyName(const Mode& mode)
{
    const std::int64_t order = -mode.b;
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

std::vector<ModeJump> jumps(const Mode& mode)
{
    Gaps gaps(mode.a, -mode.b);
    std::vector<ModeJump> result;
    result.reserve(static_cast<std::size_t>(gaps.count));
    for (std::int64_t r = 0; r < gaps.count; ++r) {
        // Just below highest = 2 * 2a/|b|, 2i/T is just above i |b|/(2a).
        result.push_back({gaps.index(), gaps.index() * -mode.b / gaps.count});
        (void)gaps.next();
    }
    return result;
}

double contactTime(const Mode& mode, double period)
{
    requireInside(mode, period);
    return linear(mode.b, period, 4 * mode.a);
}

double energyRatio(const Mode& mode, double period)
{
    requireInside(mode, period);
    const double root = inverseRoot(mode, period);
    return 1.0 / (root * root);
}

EnergyRange energyRange(const Mode& mode)
{
    const auto square = [](std::int64_t value) {
        return static_cast<double>(value) * static_cast<double>(value);
    };
    const auto limit = [&](const ExactPeriod& end) {
        const std::int64_t root = mode.kappa * end.numerator - mode.mu * end.denominator;
        return root == 0 ? std::numeric_limits<double>::infinity()
                         : square(end.denominator) / square(root);
    };
    const auto [least, most] = std::minmax({limit(mode.lowest), limit(mode.highest)});
    return {least, most};
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
    return {cells, {{contact, steps - contact}}};
}

ModeMotion::ModeMotion(const Mode& mode, double period) : period_(period)
{
    requireInside(mode, period);
    amplitude_ = 0.5 / inverseRoot(mode, period);
    Gaps gaps(mode.a, -mode.b);
    const std::int64_t p = (1 - gaps.numerator * mode.b) / gaps.count;
    const double alpha = linear(p, period, -2 * gaps.numerator);
    const double contact = linear(mode.b, period, 4 * mode.a);
    std::int64_t surplus = 0;
    for (const ModeJump& jump : jumps(mode)) {
        const bool isBeforeNegative = times_.size() % 2 == 0;
        times_.push_back(linear(-jump.turns, period, 2 * jump.k));
        const auto turns = static_cast<double>(1 - surplus);
        integrals_.push_back(isBeforeNegative ? turns * contact : turns * contact - alpha);
        surplus += isBeforeNegative ? gaps.next() : -gaps.next();
    }
}

ModeMotion::Place ModeMotion::locate(double t) const
{
    double turns = std::floor(t / period_);
    double time = std::fma(-turns, period_, t);
    if (time < 0.0) {
        turns -= 1.0;
        time += period_;
    } else if (time >= period_) {
        turns += 1.0;
        time -= period_;
    }
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    return {turns, time, static_cast<std::size_t>(after - times_.begin())};
}

double ModeMotion::integral(double t) const
{
    const auto [turns, time, jumps] = locate(t);
    const double whole = turns * contactTime();
    if (jumps == 0) {
        return whole + time;
    }
    const double rest = time - times_[jumps - 1];
    return whole + integrals_[jumps - 1] + (jumps % 2 == 0 ? rest : -rest);
}

double ModeMotion::incoming(double t) const
{
    return locate(t).jumps % 2 == 0 ? amplitude_ : -amplitude_;
}

double ModeMotion::displacement(double x, double t) const
{
    return amplitude_ * (integral(t + 1.0 - x) - integral(t + 1.0 + x));
}

double ModeMotion::velocity(double x, double t) const
{
    return incoming(t + 1.0 - x) - incoming(t + 1.0 + x);
}

double ModeMotion::strain(double x, double t) const
{
    return -incoming(t + 1.0 - x) - incoming(t + 1.0 + x);
}

double ModeMotion::wallForce(double t) const
{
    return locate(t).time < contactTime() ? 2.0 * amplitude_ : 0.0;
}

}  // namespace signorini
