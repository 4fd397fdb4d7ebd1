#include "harmonic_trial.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "harmonic_march.hpp"

namespace signorini {

namespace {

constexpr double disturbance = 1e-4;  // relative, of each wave
constexpr double mergeTrial = 1e-11;  // of |A|
constexpr double tenTimes = 10.0;
constexpr double stillThere = 1e-9;    // L/c: nearer than rounding and merging let it come
constexpr double otherContact = 0.02;  // L/c from the contact that it should be

}  // namespace

std::optional<bool> comesBack(const HarmonicCase& given, const HarmonicMotion& motion,
                              std::int64_t periods)
{
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> part(-disturbance, disturbance);
    HarmonicMotion beside = motion;
    HarmonicMotion other = motion;
    for (std::size_t k = 0; k < motion.pieces.size(); ++k) {
        const double by = part(generator);
        beside.pieces[k].wave *= 1.0 + by;
        other.pieces[k].wave *= 1.0 - by;
    }
    HarmonicMarch march = HarmonicMarch::of(given, beside, mergeTrial);
    const double side = motion.contacts[0].stop == Stop::right ? 1.0 : -1.0;
    if (side * (march.tip(0.0) - given.placeOf(motion.contacts[0].stop)) > 0.0) {
        march = HarmonicMarch::of(given, other, mergeTrial);  // not beyond the stop
    }
    double counts = motion.contacts[0].impulse;
    for (const HarmonicContact& one : motion.contacts) {
        counts = std::min(counts, 0.05 * one.impulse);
    }
    const double period = given.period();
    double first = 0.0;
    std::size_t seen = 0;
    for (std::int64_t n = 1; n <= periods; ++n) {
        const double end =
            static_cast<double>(n) * period - 0.25 * (period - motion.contacts.back().end);
        march.advance(end);
        march.forget();
        double most = 0.0;
        for (; seen < march.contacts().size() &&
               !(march.isHeld() && seen + 1 == march.contacts().size());
             ++seen) {
            const HarmonicContact& contact = march.contacts()[seen];
            double least = period;
            for (const HarmonicContact& one : motion.contacts) {
                least =
                    std::min(least, std::abs(std::remainder(contact.begin - one.begin, period)));
            }
            // Where the push just fades a disturbed tip may come back for a moment.
            most = contact.impulse > counts ? std::max(most, least) : most;
        }
        if (n <= 4) {
            first = std::max(first, most);
        } else if (most > std::max(tenTimes * first, tenTimes * stillThere) ||
                   most > otherContact) {
            return false;
        } else if (n > periods / 2 && (most < first / tenTimes || most < stillThere)) {
            return true;
        }
    }
    return std::nullopt;
}

}  // namespace signorini
