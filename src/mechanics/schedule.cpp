#include "signorini/schedule.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <numeric>
#include <utility>

#include "faults.hpp"
#include "rational.hpp"
#include "verdict_names.hpp"

namespace signorini {

std::string_view name(Stop stop)
{
    return nameIn(stopNames, stop);
}

Fraction simplestFraction(double value)
{
    // Convergents p/q of the continued fraction, and between the last two the semiconvergents: the
    // first that rounds to the value is the simplest.
    const auto rounds = [value](std::int64_t p, std::int64_t q) {
        return static_cast<double>(p) / static_cast<double>(q) == value;
    };
    const Rational exact(value);
    Integer above = numerator(exact);
    Integer below = denominator(exact);
    Fraction before{0, 1};
    Fraction last{1, 0};
    while (true) {
        const auto at = [&](std::int64_t k) {
            return Fraction{before.numerator + k * last.numerator,
                            before.denominator + k * last.denominator};
        };
        const auto whole = static_cast<std::int64_t>(above / below);
        if (const Fraction next = at(whole);
            next.denominator > 0 && rounds(next.numerator, next.denominator)) {
            std::int64_t low = 0;  // does not round to the value
            std::int64_t high = whole;
            while (low + 1 < high) {
                const std::int64_t middle = low + (high - low) / 2;
                const Fraction tried = at(middle);
                (rounds(tried.numerator, tried.denominator) ? high : low) = middle;
            }
            return at(high);
        }
        before = std::exchange(last, at(whole));
        above = std::exchange(below, Integer(above % below));
    }
}

Stops stopsOf(const Scene& scene)
{
    validate(scene);
    const double gap = scene.bar.gap;
    Stops stops;
    stops.right = (gap > 0.0 ? 1 : 0) - (gap < 0.0 ? 1 : 0);
    if (scene.secondStop) {
        stops.left = simplestFraction(*scene.secondStop / scales(scene.bar).displacement);
    }
    return stops;
}

ExactPeriod exactPeriod(std::int64_t numerator, std::int64_t denominator)
{
    const std::int64_t common = std::gcd(numerator, denominator);
    return {numerator / common, denominator / common};
}

void validate(const Schedule& schedule)
{
    Faults faults;
    if (schedule.cells < 1 || schedule.cells > maxCells) {
        faults.add("cells", schedule.cells, fmt::format("1..{}", maxCells));
    }
    if (schedule.phases.empty()) {
        faults.add("phases", 0, "at least one pair of contact and free steps");
    }
    std::int64_t total = 0;
    bool tooLong = false;
    std::size_t number = 0;
    for (const Phase& phase : schedule.phases) {
        ++number;
        const auto check = [&](const char* kind, std::int64_t count) {
            if (count < 1 || count > maxSteps) {
                faults.add(fmt::format("{} steps of phase {}", kind, number), count,
                           fmt::format("1..{}", maxSteps));
                return;
            }
            tooLong = tooLong || count > maxSteps - total;
            total += tooLong ? 0 : count;
        };
        check("contact", phase.contact);
        check("free", phase.free);
        if (phase.stop == Stop::left && !schedule.stops.left) {
            faults.add(fmt::format("phase {}", number),
                       fmt::format("L:{} {}", phase.contact, phase.free),
                       "contacts on the wall where there is no second stop");
        }
    }
    if (tooLong) {
        faults.add("the sum of all steps", "more than 2^62", fmt::format("1..{}", maxSteps));
    }
    const auto& [right, left] = schedule.stops;
    if (right < -1 || right > 1) {
        faults.add("right stop", right, "-1..1, the sign of the gap");
    }
    if (left && !(left->denominator > 0 && left->numerator > -right * left->denominator)) {
        faults.add("left stop", fmt::format("{}/{}", left->numerator, left->denominator),
                   fmt::format("fractions above {}", -right));
    }
    faults.throwIfAny();
}

std::int64_t steps(const Schedule& schedule)
{
    std::int64_t total = 0;
    for (const Phase& phase : schedule.phases) {
        total += phase.contact + phase.free;
    }
    return total;
}

double period(const Schedule& schedule)
{
    return static_cast<double>(steps(schedule)) / static_cast<double>(schedule.cells);
}

double frequencyRatio(const Schedule& schedule)
{
    return 4.0 * static_cast<double>(schedule.cells) / static_cast<double>(steps(schedule));
}

void fold(std::int64_t cells, Phase& phase)
{
    const auto shorten = [](std::int64_t& count, std::int64_t repeat) {
        count = count < repeat ? count : repeat + count % repeat;
    };
    shorten(phase.contact, 2 * cells);
    shorten(phase.free, 4 * cells);
}

void fold(Schedule& schedule)
{
    for (Phase& phase : schedule.phases) {
        fold(schedule.cells, phase);
    }
}

std::string describe(const std::vector<Phase>& phases)
{
    constexpr std::size_t shown = 8;
    std::string text;
    for (std::size_t k = 0; k < phases.size() && k < shown; ++k) {
        text +=
            fmt::format("{}{}({}, {})", k > 0 ? " " : "", phases[k].stop == Stop::left ? "L:" : "",
                        phases[k].contact, phases[k].free);
    }
    if (phases.size() > shown) {
        text += fmt::format(" … {} phases in all", phases.size());
    }
    return text;
}

std::string describe(const Schedule& schedule)
{
    return fmt::format("N = {}, {}", schedule.cells, describe(schedule.phases));
}

}  // namespace signorini
