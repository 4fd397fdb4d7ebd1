#include "mode_words.hpp"

#include <fmt/format.h>

namespace signorini::cli {

namespace {

/// "7T" or "T".
std::string timesT(std::int64_t factor)
{
    return factor == 1 ? "T" : fmt::format("{}T", factor);
}

Json fraction(const ExactPeriod& period)
{
    return {period.numerator, period.denominator};
}

}  // namespace

std::string contactAsText(const Mode& mode)
{
    return fmt::format("{} - {}", 4 * mode.a, timesT(-mode.b));
}

std::string rootAsText(const Mode& mode)
{
    return mode.kappa > 0 ? fmt::format("{} - {}", timesT(mode.kappa), mode.mu)
                          : fmt::format("{} - {}", -mode.mu, timesT(-mode.kappa));
}

Json identityAsJson(const Mode& mode)
{
    Json json{{"contact", {4 * mode.a, mode.b}},
              {"period_range", {fraction(mode.lowest), fraction(mode.highest)}},
              {"inverse_sqrt_energy", {mode.kappa, mode.mu}},
              {"family", nullptr}};
    if (const std::string family = familyName(mode); !family.empty()) {
        json["family"] = family;
    }
    return json;
}

}  // namespace signorini::cli
