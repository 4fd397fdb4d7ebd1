#include "harmonic_answer.hpp"

#include <fmt/format.h>

#include "harmonic_growth.hpp"

namespace signorini::answers {

HarmonicAnswer answerOf(const ExactPeriod& period, const Damping& damping, Excited place,
                        std::int64_t cycles, double amplitude, const Scene& scene)
{
    HarmonicAnswer answer{period, damping, place, cycles, amplitude, scene, unitsOf(scene), {}};
    const Harmonic excitation{place,
                              amplitude / amplitudeUnit(place, answer.bar),
                              0.0,
                              cycles,
                              period.numerator,
                              static_cast<double>(period.denominator)};
    for (HarmonicMotion& motion : harmonicContacts(damping, excitation, stopsOf(scene))) {
        const auto growth = growthOf(damping, excitation, motion);
        answer.motions.push_back({std::move(motion), answer.bar, growth});
    }
    return answer;
}

std::optional<std::string> HarmonicAnswer::detail() const
{
    if (!motions.empty()) {
        return std::nullopt;
    }
    const double cell = static_cast<double>(period.numerator % 2 == 0 ? 2 : 1) /
                        static_cast<double>(period.denominator);
    return fmt::format(
        "no motion with one contact in a period flies for {:.6g} s or more: computed, not proved",
        cell * scales(bar).time);
}

}  // namespace signorini::answers
