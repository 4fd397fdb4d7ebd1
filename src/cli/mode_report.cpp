#include "mode_report.hpp"

#include <fmt/format.h>

#include <algorithm>

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

/// The lowest place of the tip [g]: u(L, t) is made of straight lines between jumps of p there and
/// those that left it 2L/c before.
double lowestTip(const ModeMotion& motion)
{
    double lowest = 1.0;
    for (const double t : motion.jumpTimes()) {
        lowest = std::min({lowest, motion.displacement(1.0, t), motion.displacement(1.0, t - 2.0)});
    }
    return std::min({lowest, motion.displacement(1.0, 0.0), motion.displacement(1.0, -2.0)});
}

/// |p| is h everywhere, so |s| is at most 2h, which the clamp sees of both signs, and the tip meets
/// the wall with 2h.
Json physicalAsJson(const ModeMotion& motion, const Scales& unit, const Bar& bar)
{
    const double largest = 2.0 * motion.amplitude();
    const double force = largest * bar.axialStiffness * unit.strain;
    return {{"frequency", 1.0 / (motion.period() * unit.time)},
            {"contact_time", motion.contactTime() * unit.time},
            {"peak_force", force},
            {"impulse", force * motion.contactTime() * unit.time},
            {"approach_speed", largest * unit.velocity},
            {"peak_compression", largest * unit.strain},
            {"peak_tension", largest * unit.strain},
            {"tip_lowest", lowestTip(motion) * unit.displacement}};
}

}  // namespace

std::string fractionAsText(const ExactPeriod& period)
{
    return period.denominator == 1 ? fmt::format("{}", period.numerator)
                                   : fmt::format("{}/{}", period.numerator, period.denominator);
}

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

std::string asJson(const Mode& mode, const ModeMotion& motion, const Bar& bar)
{
    const Scales unit = scales(bar);
    const double energy = energyRatio(mode, motion.period());
    Json list = Json::array();
    for (const ModeJump& jump : jumps(mode)) {
        list.push_back({2 * jump.k, -jump.turns});
    }
    Json json = newAnswer();
    json.update(Json{{"status", name(Status::found)},
                     {"bar", barAsJson(bar)},
                     {"mode", identityAsJson(mode)},
                     {"period", motion.period() * unit.time},
                     {"period_ratio", motion.period()},
                     {"frequency", 1.0 / (motion.period() * unit.time)},
                     {"frequency_ratio", 4.0 / motion.period()},
                     {"contact_time", motion.contactTime() * unit.time},
                     {"contact_time_ratio", motion.contactTime()},
                     {"energy", energy * unit.energy},
                     {"energy_ratio", energy},
                     {"jumps", list},
                     {"physical", physicalAsJson(motion, unit, bar)}});
    return asLine(json);
}

std::string asText(const Mode& mode, const ModeMotion& motion, const Bar& bar)
{
    const Scales unit = scales(bar);
    const Json physical = physicalAsJson(motion, unit, bar);
    const auto value = [&physical](const char* name) { return physical[name].get<double>(); };
    const std::string family = familyName(mode);
    const double energy = energyRatio(mode, motion.period());
    return fmt::format(
        "found       mode t_c = {}{}, T in ]{}, {}[ L/c\n"
        "period      {:.10g} s = {:.10g} L/c, {:.6g} Hz, ω/ω₁ = {:.10g}\n"
        "contact     {:.6g} s = {:.10g} L/c\n"
        "energy      {:.6g} J = {:.10g} E₁, 1/√(E/E₁) = {}\n"
        "waves       p = ±{:.6g} g/L with {} jumps in a period\n"
        "force       {:.6g} N on the wall all through contact, impulse {:.6g} N s\n"
        "strain      at most {:.6g} in compression and in tension\n"
        "tip         meets the wall with {:.6g} m/s, goes down to {:.6g} m\n",
        contactAsText(mode), family.empty() ? "" : fmt::format(" ({})", family),
        fractionAsText(mode.lowest), fractionAsText(mode.highest), motion.period() * unit.time,
        motion.period(), value("frequency"), 4.0 / motion.period(), value("contact_time"),
        motion.contactTime(), energy * unit.energy, energy, rootAsText(mode), motion.amplitude(),
        motion.jumpTimes().size(), value("peak_force"), value("impulse"), value("peak_compression"),
        value("approach_speed"), value("tip_lowest"));
}

}  // namespace signorini::cli
