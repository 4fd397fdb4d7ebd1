#include "question.hpp"

#include <fmt/format.h>

#include "arguments.hpp"
#include "given.hpp"

namespace signorini::cli {

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

std::pair<std::string, std::string> PeriodQuestion::one() const
{
    refuseIf((period.empty() ? 0 : 1) + (frequency.empty() ? 0 : 1) + (hertz ? 1 : 0) != 1,
             "--period, --frequency, --hertz: allowed one of them");
    return !period.empty()      ? std::pair("--period", period)
           : !frequency.empty() ? std::pair("--frequency", frequency)
                                : std::pair("--hertz", fmt::format("{}", *hertz));
}

answers::AskedSteps PeriodQuestion::ofBars() const
{
    (void)one();
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
    const auto [option, word] = one();
    return answers::periodExactly(option, word, cells, bar, cycles);
}

answers::AskedPeriod PeriodQuestion::on(std::int64_t cells, const Bar& bar) const
{
    const auto [option, word] = one();
    return answers::periodOnGrid(option, word, cells, bar);
}

}  // namespace signorini::cli
