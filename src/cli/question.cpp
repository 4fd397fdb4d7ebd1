#include "question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "given.hpp"
#include "harmonic_motion.hpp"
#include "hints.hpp"
#include "reports.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

namespace {

constexpr std::int64_t leastSteps = answers::AskedPeriod::leastSteps;
constexpr std::int64_t mostSteps = answers::AskedPeriod::mostSteps;

/// 4/x: a period in L/c from a frequency in omega_1, and back.
ExactPeriod reciprocal(const ExactPeriod& x)
{
    return exactPeriod(4 * x.denominator, x.numerator);
}

/// The nearest number of steps, and whether it is the period itself, to the last digit of a double:
/// so that what an answer prints can be asked again.
struct Rounded {
    std::int64_t steps;
    bool isExact;
};

Rounded rounded(const GivenNumber& period, std::int64_t cells)
{
    const double wanted =
        std::clamp(period.value * static_cast<double>(cells), static_cast<double>(leastSteps),
                   static_cast<double>(mostSteps));
    const std::int64_t steps = std::llround(wanted);
    const double grid = static_cast<double>(steps) / static_cast<double>(cells);
    return {steps, std::abs(grid - period.value) <= 4e-16 * grid};
}

/// Says which period of the grid is nearest, and which grid has the one asked for.
[[noreturn]] void refuseOffGrid(const char* option, const std::string& word,
                                const GivenNumber& period, std::int64_t steps, std::int64_t cells,
                                bool isFrequency)
{
    const ExactPeriod grid = exactPeriod(steps, cells);
    std::string remedy =
        fmt::format("nearest {}", fractionAsText(isFrequency ? reciprocal(grid) : grid));
    if (period.exact && period.exact->denominator <= maxCells) {
        remedy +=
            fmt::format("; {} needs --cells {} or a multiple", word, period.exact->denominator);
    }
    constexpr double shortest = 0.08;  // L/c: frequencies above 50 ω₁
    if (isFrequency && period.value < shortest) {
        remedy += fmt::format("; in Hz it is --hertz {}", word);
    }
    refuse(option, word,
           fmt::format("periods of {}..{} whole steps L/({} c) ({})", leastSteps, mostSteps, cells,
                       remedy));
}

answers::AskedPeriod onGrid(const char* option, const std::string& word, const GivenNumber& period,
                            std::int64_t cells, bool isFrequency)
{
    const Rounded on = rounded(period, cells);
    if (!on.isExact) {
        refuseOffGrid(option, word, period, on.steps, cells, isFrequency);
    }
    return {option + 2, word, on.steps};
}

}  // namespace

PeriodQuestion::PeriodQuestion(const Given& given)
    : period(given.text("--period")),
      frequency(given.text("--frequency")),
      hertz(given.number("--hertz"))
{
}

bool PeriodQuestion::isAsked() const
{
    return !period.empty() || !frequency.empty() || hertz;
}

void PeriodQuestion::requireOne() const
{
    refuseIf((period.empty() ? 0 : 1) + (frequency.empty() ? 0 : 1) + (hertz ? 1 : 0) != 1,
             "--period, --frequency, --hertz: allowed one of them");
}

answers::AskedSteps PeriodQuestion::ofBars() const
{
    requireOne();
    answers::AskedSteps asked{.hertz = hertz};
    if (!period.empty()) {
        asked.period = parseNumber("--period", period, "L/c").value;
    } else if (!frequency.empty()) {
        asked.frequency = parseNumber("--frequency", frequency, "ω₁").value;
    }
    return asked;
}

ExactPeriod PeriodQuestion::exactly(std::int64_t cells, const Bar& bar, std::int64_t cycles) const
{
    requireOne();
    const auto exact = [&] {
        if (!period.empty()) {
            return parseFraction("--period", period, "L/c");
        }
        const ExactPeriod one = hertz ? exactPeriod(on(cells, bar).steps, cells)
                                      : reciprocal(parseFraction("--frequency", frequency, "ω₁"));
        return exactPeriod(cycles * one.numerator, one.denominator);
    }();
    const std::int64_t common = exact.numerator % 2 == 0 ? 2 : 1;
    refuseIf(std::max(exact.numerator, 2 * exact.denominator) / common > maxHarmonicCells,
             "--period, --frequency, --hertz", fractionAsText(exact) + " L/c",
             fmt::format("periods P/Q in which P and 2Q, in lowest terms, are at most {}",
                         maxHarmonicCells));
    return exact;
}

answers::AskedPeriod PeriodQuestion::on(std::int64_t cells, const Bar& bar) const
{
    requireOne();
    if (!period.empty()) {
        return onGrid("--period", period, parseNumber("--period", period, "L/c"), cells, false);
    }
    if (!frequency.empty()) {
        GivenNumber asked = parseNumber("--frequency", frequency, "ω₁");
        asked = {4.0 / asked.value,
                 asked.exact ? std::optional(reciprocal(*asked.exact)) : std::nullopt};
        return onGrid("--frequency", frequency, asked, cells, true);
    }
    return {"hertz", fmt::format("{}", *hertz), answers::stepsNearest(*hertz, cells, bar)};
}

}  // namespace signorini::cli
