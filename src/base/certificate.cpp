#include "signorini/certificate.hpp"

#include <numeric>

#include "names.hpp"

namespace signorini {

namespace {

constexpr auto ruleNames = std::to_array<Named<ForcedRule>>({
    {ForcedRule::gap, "gap"},
    {ForcedRule::pressure, "pressure"},
    {ForcedRule::held, "held"},
    {ForcedRule::penetration, "penetration"},
    {ForcedRule::secondStop, "second-stop"},
    {ForcedRule::closure, "closure"},
    {ForcedRule::work, "work"},
    {ForcedRule::strain, "strain"},
});

}  // namespace

std::string_view name(ForcedRule rule)
{
    return nameIn(ruleNames, rule);
}

void divideByCommonFactor(FarkasCertificate& certificate)
{
    std::int64_t common = std::gcd(certificate.gap, certificate.size);
    const auto all = {&certificate.periodicity, &certificate.pressure, &certificate.penetration};
    for (const auto* rows : all) {
        for (const Multiplier& m : *rows) {
            common = std::gcd(common, m.value);
        }
    }
    certificate.gap /= common;
    certificate.size /= common;
    for (auto* rows : all) {
        for (Multiplier& m : *rows) {
            m.value /= common;
        }
    }
}

}  // namespace signorini
