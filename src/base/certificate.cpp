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
    {ForcedRule::rest, "rest"},
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
    // Rows in a run have one multiplier: what was just computed is not computed again.
    std::int64_t last = 0;
    for (const auto* rows : all) {
        for (const Multiplier& m : *rows) {
            if (m.value != last && m.value != -last) {
                last = m.value;
                common = std::gcd(common, last);
            }
        }
    }
    certificate.gap /= common;
    certificate.size /= common;
    std::int64_t quotient = last / common;
    for (auto* rows : all) {
        for (Multiplier& m : *rows) {
            if (m.value != last && m.value != -last) {
                last = m.value;
                quotient = last / common;
            }
            m.value = m.value == last ? quotient : -quotient;
        }
    }
}

}  // namespace signorini
