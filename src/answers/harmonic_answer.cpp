#include "harmonic_answer.hpp"

#include <fmt/format.h>

#include "harmonic_contact.hpp"
#include "harmonic_growth.hpp"
#include "harmonic_settled.hpp"

namespace signorini::answers {

std::vector<HarmonicContactOf> HarmonicMotionOf::contacts() const
{
    std::vector<HarmonicContactOf> all;
    for (const HarmonicContact& one : value.contacts) {
        all.push_back({one, bar});
    }
    return all;
}

HarmonicAnswer answerOf(const ExactPeriod& period, const Damping& damping, Excited place,
                        std::int64_t cycles, double amplitude, const Scene& scene,
                        std::int64_t contacts, const Cancel& cancel)
{
    HarmonicAnswer answer{period, damping,        place,    cycles, amplitude,
                          scene,  unitsOf(scene), contacts, {}};
    const Harmonic excitation{place,
                              amplitude / amplitudeUnit(place, answer.bar),
                              0.0,
                              cycles,
                              period.numerator,
                              static_cast<double>(period.denominator)};
    const auto add = [&](const HarmonicCase& given, HarmonicMotion motion) {
        const auto growth = growthOf(given, motion);
        const HarmonicProof proof = enclosed(given, motion);
        answer.motions.push_back({std::move(motion), answer.bar, growth, proof});
    };
    const HarmonicCase given = harmonicCase(damping, excitation, stopsOf(scene));
    if (contacts == 1) {
        for (HarmonicMotion& motion : harmonicContacts(given)) {
            add(given, std::move(motion));
        }
        return answer;
    }
    SettlingSearch search;
    search.mostCycles = std::max(search.mostCycles, cycles);
    search.cancel = cancel;
    if (auto settled = settledHarmonic(damping, excitation, stopsOf(scene), search)) {
        const auto found = static_cast<std::int64_t>(settled->motion.contacts.size());
        answer.settled = {found, settled->given.cycles};
        if (found == contacts && settled->given.cycles == cycles) {
            add(settled->given, std::move(settled->motion));
        }
    }
    return answer;
}

std::optional<std::string> HarmonicAnswer::detail() const
{
    if (!motions.empty()) {
        return std::nullopt;
    }
    if (contacts > 1) {
        return settled ? fmt::format("a bar at rest settles on {} contact{} in {} cycle{}",
                                     settled->first, settled->first == 1 ? "" : "s",
                                     settled->second, settled->second == 1 ? "" : "s")
                       : "a bar at rest settles on no motion that touches a stop";
    }
    const double cell = static_cast<double>(period.numerator % 2 == 0 ? 2 : 1) /
                        static_cast<double>(period.denominator);
    return fmt::format(
        "no motion with one contact in a period flies for {:.6g} s or more: computed, not proved",
        cell * scales(bar).time);
}

}  // namespace signorini::answers
