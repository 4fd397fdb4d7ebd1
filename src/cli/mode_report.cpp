#include "mode_report.hpp"

#include <fmt/format.h>

#include "faults.hpp"
#include "report.hpp"

namespace signorini::cli {

namespace {

/// "7T" or "T".
std::string timesT(std::int64_t factor)
{
    return factor == 1 ? "T" : fmt::format("{}T", factor);
}

}  // namespace

std::string contactAsText(const Mode& mode)
{
    return linearAsText(mode.b, -4 * mode.a);
}

std::string linearAsText(std::int64_t factor, std::int64_t less)
{
    if (factor == 0) {
        return fmt::format("{}", -less);
    }
    return factor > 0 ? fmt::format("{} - {}", timesT(factor), less)
                      : fmt::format("{} - {}", -less, timesT(-factor));
}

std::string rootAsText(const Mode& mode)
{
    return linearAsText(mode.kappa, mode.mu);
}

int gapSignOfModes(const Bar& bar)
{
    if (bar.gap == 0.0) {
        Faults faults;
        faults.add("--gap", 0.0,
                   "a gap > 0 or < 0 [m]: without one modes have a single period each, which "
                   "families lists");
        faults.throwIfAny();
    }
    return bar.gap > 0.0 ? 1 : -1;
}

std::string asText(const answers::ModeAnswer& answer)
{
    const auto& [mode, bar, motion] = answer;
    const Scales unit = scales(bar);
    const Physical physical = physicalOf(motion.extremes(), bar);
    const std::string family = familyName(mode);
    const double energy = energyRatio(mode, motion.period());
    return fmt::format(
               "found       mode t_c = {}{}, T in ]{}, {}[ L/c\n"
               "period      {:.10g} s = {:.10g} L/c, ω/ω₁ = {:.10g}\n"
               "contact     {:.6g} s = {:.10g} L/c\n"
               "energy      {:.6g} J = {:.10g} E₁, 1/√(E/E₁) = {}\n"
               "waves       p = ±{:.6g} g/L with {} jumps in a period\n",
               contactAsText(mode), family.empty() ? "" : fmt::format(" ({})", family),
               fractionAsText(mode.lowest), fractionAsText(mode.highest),
               motion.period() * unit.time, motion.period(), 4.0 / motion.period(),
               motion.contactTime() * unit.time, motion.contactTime(), energy * unit.energy, energy,
               rootAsText(mode), motion.amplitude(), motion.jumpTimes().size()) +
           asText(physical);
}

}  // namespace signorini::cli
