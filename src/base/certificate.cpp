#include "signorini/certificate.hpp"

#include <numeric>

namespace signorini {

void divideByCommonFactor(FarkasCertificate& certificate)
{
    std::int64_t common = certificate.gap;
    const auto all = {&certificate.periodicity, &certificate.pressure, &certificate.penetration};
    for (const auto* rows : all) {
        for (const Multiplier& m : *rows) {
            common = std::gcd(common, m.value);
        }
    }
    certificate.gap /= common;
    for (auto* rows : all) {
        for (Multiplier& m : *rows) {
            m.value /= common;
        }
    }
}

}  // namespace signorini
