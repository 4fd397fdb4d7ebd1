#include "asked_period.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "faults.hpp"
#include "harmonic_motion.hpp"
#include "units.hpp"

namespace signorini::answers {

namespace {

/// A whole number > 0 of at most 18 digits.
std::optional<std::int64_t> wholeOf(std::string_view digits)
{
    constexpr std::size_t mostDigits = 18;
    return digits.size() <= mostDigits
               ? wholeIn(digits, 1, std::numeric_limits<std::int64_t>::max())
               : std::nullopt;
}

/// A decimal number without an exponent, of at most 18 digits.
std::optional<ExactPeriod> decimalOf(std::string_view text)
{
    std::string digits(text);
    std::size_t places = 0;
    if (const std::size_t point = digits.find('.'); point != std::string::npos) {
        digits.erase(point, 1);
        places = digits.size() - point;
    }
    const auto numerator = wholeOf(digits);
    if (!numerator) {
        return std::nullopt;
    }
    std::int64_t denominator = 1;
    for (; places > 0; --places) {
        denominator *= 10;
    }
    return exactPeriod(*numerator, denominator);
}

/// 4/x: a period in L/c from a frequency in omega_1, and back.
ExactPeriod reciprocal(const ExactPeriod& x)
{
    return exactPeriod(4 * x.denominator, x.numerator);
}

/// Says which period of the grid is nearest, and which grid has the one asked for.
[[noreturn]] void refuseOffGrid(const std::string& option, const std::string& word,
                                const GivenNumber& period, std::int64_t steps, std::int64_t cells,
                                bool isFrequency)
{
    const ExactPeriod grid = exactPeriod(steps, cells);
    const bool isTyped = option.starts_with("--");
    const auto with = [isTyped](const char* name, const auto& value) {
        return isTyped ? fmt::format("--{} {}", name, value) : fmt::format("{}={}", name, value);
    };
    std::string remedy =
        fmt::format("nearest {}", fractionAsText(isFrequency ? reciprocal(grid) : grid));
    if (period.exact && period.exact->denominator <= maxCells) {
        remedy += fmt::format("; {} needs {} or a multiple", word,
                              with("cells", period.exact->denominator));
    }
    constexpr double shortest = 0.08;  // L/c: frequencies above 50 ω₁
    if (isFrequency && period.value < shortest) {
        remedy += "; in Hz it is " + with("hertz", word);
    }
    throwFault(option, word,
               fmt::format("periods of {}..{} whole steps L/({} c) ({})", AskedPeriod::leastSteps,
                           AskedPeriod::mostSteps, cells, remedy));
}

/// The steps of the period that is nearest to a frequency [Hz] on so many cells.
std::int64_t stepsNearest(const std::string& option, double hertz, std::int64_t cells,
                          const Bar& bar)
{
    const double second = static_cast<double>(cells) / scales(bar).time;  // in steps
    const double wanted = second / hertz;
    if (!(wanted > static_cast<double>(AskedPeriod::leastSteps) - 0.5 &&
          wanted <= static_cast<double>(AskedPeriod::mostSteps))) {
        throwFault(
            option, hertz,
            fmt::format("{}..{} Hz for this bar ({}) on {} cells",
                        second / static_cast<double>(AskedPeriod::mostSteps),
                        second / static_cast<double>(AskedPeriod::leastSteps), sizeOf(bar), cells));
    }
    return std::llround(wanted);
}

}  // namespace

std::string sizeOf(const Bar& bar)
{
    const bool isUsual = bar.length == Bar{}.length && bar.waveSpeed == Bar{}.waveSpeed;
    return fmt::format("L = {:.6g} m, c = {:.6g} m/s{}", bar.length, bar.waveSpeed,
                       isUsual ? " by default" : "");
}

double parsePositive(std::string_view name, std::string_view text, std::string_view unit)
{
    const auto value = numberIn(text, unit);
    if (!value || *value <= 0.0) {
        throwFault(name, text.empty() ? "''" : text, fmt::format("finite numbers > 0 [{}]", unit));
    }
    return *value;
}

GivenNumber parseNumber(std::string_view name, std::string_view text, std::string_view unit)
{
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        return {parsePositive(name, text, unit), decimalOf(text)};
    }
    const auto above = wholeOf(text.substr(0, slash));
    const auto below = wholeOf(text.substr(slash + 1));
    if (!above || !below) {
        throwFault(name, text, fmt::format("numbers > 0 like 3.14, 3 or 22/7 [{}]", unit));
    }
    const ExactPeriod exact = exactPeriod(*above, *below);
    return {exact.value(), exact};
}

ExactPeriod parseFraction(std::string_view name, std::string_view text, std::string_view unit)
{
    constexpr std::int64_t most = 999'999'999;
    const auto exact = parseNumber(name, text, unit).exact;
    if (!exact || std::max(exact->numerator, exact->denominator) > most) {
        throwFault(name, text,
                   fmt::format("fractions like 7/2 or decimals > 0 [{}], in lowest terms of at "
                               "most 9 digits above and below",
                               unit));
    }
    return *exact;
}

double parseRatio(std::string_view name, std::string_view text, std::string_view unit)
{
    return text.find('/') == std::string_view::npos ? parsePositive(name, text, unit)
                                                    : parseFraction(name, text, unit).value();
}

std::string fractionAsText(const ExactPeriod& fraction)
{
    return fraction.denominator == 1
               ? fmt::format("{}", fraction.numerator)
               : fmt::format("{}/{}", fraction.numerator, fraction.denominator);
}

std::string QuestionPart::nearest() const
{
    if (!asked.isRounded) {
        return {};
    }
    const bool isHertz = asked.option == "hertz";
    return fmt::format("; asked {} {}, nearest on this grid {:.10g} {}", asked.word,
                       isHertz ? "Hz" : "ω₁", isHertz ? frequency : frequencyRatio.value(),
                       isHertz ? "Hz" : "ω₁");
}

AskedPeriod askedAs(const std::string& option, const std::string& word)
{
    return {option.substr(option.find_first_not_of('-')), word};
}

AskedPeriod periodOnGrid(const std::string& option, const std::string& word, std::int64_t cells,
                         const Bar& bar)
{
    AskedPeriod asked = askedAs(option, word);
    asked.isRounded = asked.option == "hertz";
    if (asked.isRounded) {
        asked.steps = stepsNearest(option, parsePositive(option, word, "Hz"), cells, bar);
        return asked;
    }
    const bool isFrequency = asked.option == "frequency";
    GivenNumber period = parseNumber(option, word, isFrequency ? "ω₁" : "L/c");
    if (isFrequency) {
        period = {4.0 / period.value,
                  period.exact ? std::optional(reciprocal(*period.exact)) : std::nullopt};
    }
    const auto count = static_cast<double>(cells);
    const std::int64_t steps =
        std::llround(std::clamp(period.value * count, static_cast<double>(AskedPeriod::leastSteps),
                                static_cast<double>(AskedPeriod::mostSteps)));
    const double grid = static_cast<double>(steps) / count;
    // To the last digit of a double: so that what an answer prints can be asked again.
    if (!(std::abs(grid - period.value) <= 4e-16 * grid)) {
        refuseOffGrid(option, word, period, steps, cells, isFrequency);
    }
    asked.steps = steps;
    return asked;
}

ExactPeriod periodExactly(const std::string& option, const std::string& word, std::int64_t cells,
                          const Bar& bar, std::int64_t cycles)
{
    ExactPeriod exact;
    if (option.ends_with("period")) {
        exact = parseFraction(option, word, "L/c");
    } else {
        const ExactPeriod one =
            option.ends_with("hertz")
                ? exactPeriod(periodOnGrid(option, word, cells, bar).steps, cells)
                : reciprocal(parseFraction(option, word, "ω₁"));
        exact = exactPeriod(cycles * one.numerator, one.denominator);
    }
    const std::int64_t common = exact.numerator % 2 == 0 ? 2 : 1;
    if (std::max(exact.numerator, 2 * exact.denominator) / common > maxHarmonicCells) {
        throwFault(option, word,
                   fmt::format("periods P/Q in which P and 2Q, in lowest terms, are at most {}; "
                               "this is {} L/c",
                               maxHarmonicCells, fractionAsText(exact)));
    }
    return exact;
}

}  // namespace signorini::answers
