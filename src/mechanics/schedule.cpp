#include "signorini/schedule.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <numeric>

#include "faults.hpp"

namespace signorini {

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
    }
    if (tooLong) {
        faults.add("the sum of all steps", "more than 2^62", fmt::format("1..{}", maxSteps));
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

std::string describe(const Schedule& schedule)
{
    constexpr std::size_t shown = 8;
    std::string text = fmt::format("N = {},", schedule.cells);
    for (std::size_t k = 0; k < schedule.phases.size() && k < shown; ++k) {
        text += fmt::format(" ({}, {})", schedule.phases[k].contact, schedule.phases[k].free);
    }
    if (schedule.phases.size() > shown) {
        text += fmt::format(" … {} phases in all", schedule.phases.size());
    }
    return text;
}

}  // namespace signorini
