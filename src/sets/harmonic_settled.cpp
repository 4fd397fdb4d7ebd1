#include "harmonic_settled.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "harmonic_march.hpp"
#include "harmonic_pattern.hpp"
#include "repeated_contacts.hpp"

namespace signorini {

namespace {

constexpr double mergeBelow = 1e-10;
constexpr double noFlight = 1e-7;       // L/c
constexpr std::int64_t firstLook = 30;  // cycles

using Contacts = std::span<const HarmonicContact>;

/// Contacts of one period, counted from its first beginning.
HarmonicStart startOf(const std::vector<HarmonicContact>& all, const HarmonicCase& given,
                      double phase, Contacts contacts)
{
    const double first = contacts.front().begin;
    HarmonicStart start;
    start.phase = std::remainder(phase - given.omega * first, 2.0 * std::numbers::pi);
    const auto offset = static_cast<std::int64_t>(contacts.data() - all.data());
    const auto count = static_cast<std::int64_t>(contacts.size());
    for (HarmonicContact one : contacts) {
        if (one.isPinned) {
            // A front that left so many periods ago is one of this period.
            const std::int64_t which = static_cast<std::int64_t>(one.front) - offset;
            const std::int64_t periods = (which - ((which % count) + count) % count) / count;
            one.travel =
                one.end - all[one.front].begin + static_cast<double>(periods) * given.period();
            one.front = static_cast<std::size_t>(((which % count) + count) % count);
        }
        one.begin -= first;
        one.end -= first;
        start.contacts.push_back(one);
    }
    return start;
}

}  // namespace

std::optional<SettledHarmonic> settledHarmonic(const Damping& damping, const Harmonic& excitation,
                                               const Stops& stops, const SettlingSearch& search)
{
    HarmonicCase one = harmonicCase(damping, excitation, stops);
    const double cycle = one.period() / static_cast<double>(one.cycles);
    HarmonicMarch march = HarmonicMarch::atRest(one, mergeBelow);
    SettlingPeriod settling(search.mostCycles, search.sameTime);
    std::int64_t done = 0;
    for (std::int64_t look = firstLook; look <= search.cycles;
         look += std::max(look / 4, firstLook)) {
        for (; done < look; ++done) {
            if (isRequested(search.cancel) ||
                march.contacts().size() >
                    maxHarmonicContacts * static_cast<std::size_t>(done + 1)) {
                return std::nullopt;
            }
            march.advance(static_cast<double>(done + 1) * cycle);
            march.forget();
        }
        const std::vector<HarmonicContact> all = joined(march.contacts(), noFlight);
        if (all.size() < 3) {
            continue;
        }
        settling.lookAgain();
        for (std::int64_t m = 1; m <= search.mostCycles && 3 * m < look; ++m) {
            const double period = static_cast<double>(m) * cycle;
            // Cut where the tip is free.
            const double last = all[all.size() - 2].end + 1e-9;
            const Contacts now = begunIn(all, last - period, last);
            const Contacts before = begunIn(all, last - 2.0 * period, last - period);
            if (now.empty() ||
                !settling.is(m, apart(before, now, period, &HarmonicContact::stop))) {
                continue;
            }
            Harmonic whole = excitation;
            whole.steps *= m;
            whole.stepsPerCrossing *= static_cast<double>(excitation.cycles);
            whole.cycles = m;
            const HarmonicCase given = harmonicCase(damping, whole, stops);
            if (auto motion = harmonicNear(given, startOf(all, given, march.phase(), now))) {
                return SettledHarmonic{given, std::move(*motion)};
            }
        }
    }
    return std::nullopt;
}

}  // namespace signorini
