#include "harmonic_network_settled.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "contact_spans.hpp"
#include "harmonic_network_contact.hpp"
#include "harmonic_network_growth.hpp"
#include "harmonic_network_march.hpp"
#include "harmonic_network_pattern.hpp"
#include "harmonic_network_walk.hpp"
#include "repeated_contacts.hpp"
#include "statics.hpp"

namespace signorini {

namespace {

constexpr double mergeLanes = 1e-8;
constexpr double noWay = 1e-7;            // steps, of a flight or a contact
constexpr std::int64_t firstPeriods = 8;  // until it is looked at

using BegunContacts = std::span<const NetworkHarmonicContact>;

/// Those that lasted, a flight of nothing between two of one contact left out, until one that lasts
/// yet.
std::vector<NetworkHarmonicContact> eventsOf(const std::vector<NetworkHarmonicContact>& all)
{
    std::vector<NetworkHarmonicContact> events;
    for (const NetworkHarmonicContact& one : all) {
        const auto before = std::find_if(events.rbegin(), events.rend(), [&](const auto& other) {
            return other.contact == one.contact;
        });
        if (before != events.rend() && one.begin - before->end < noWay) {
            before->end = one.end;
            before->isPinned = one.isPinned;
        } else {
            events.push_back(one);
        }
    }
    std::erase_if(events,
                  [](const auto& one) { return one.end != 0.0 && one.end - one.begin < noWay; });
    return events;
}

}  // namespace

SettledNetwork settledHarmonic(const HarmonicNetwork& given, const SettlingSearch& search)
{
    const StillCase still = stillOf(given);
    if (driftsAway(still.given.network)) {
        return {.mayRest = false};
    }
    HarmonicNetworkMarch march = HarmonicNetworkMarch::atRest(still.given, mergeLanes);
    const double cycle = static_cast<double>(given.steps) / static_cast<double>(given.cycles);
    const std::int64_t most = std::max(search.mostCycles, given.cycles);
    SettlingPeriod settling(most, search.sameTime);
    std::int64_t done = 0;  // periods
    for (std::int64_t look = firstPeriods; look * given.cycles <= search.cycles;
         look += std::max(look / 4, firstPeriods)) {
        for (; done < look; ++done) {
            if (isRequested(search.cancel) || !march.advance(given.steps)) {
                return {};
            }
        }
        const std::vector<NetworkHarmonicContact> all = eventsOf(march.contacts());
        if (all.size() < 3) {
            continue;
        }
        // Just before the last one began, so that those that begin at one time stay together.
        const double last = all.back().begin - 10.0 * search.sameTime;
        settling.lookAgain();
        for (std::int64_t m = 1; m <= most; ++m) {
            const double period = static_cast<double>(m) * cycle;
            const BegunContacts now = begunIn(all, last - period, last);
            const BegunContacts before = begunIn(all, last - 2.0 * period, last - period);
            if (now.empty() || last - 2.0 * period < 0.0 ||
                std::any_of(now.begin(), now.end(),
                            [](const auto& one) { return one.end == 0.0; }) ||
                !settling.is(m, apart(before, now, period, &NetworkHarmonicContact::contact))) {
                continue;
            }
            SettledNetwork settled{std::ssize(now), m, {}};
            if (m != given.cycles) {
                return settled;
            }
            NetworkHarmonicMotion start;
            const double first = now.front().begin;
            start.phase =
                std::remainder(march.phase() - given.omega() * first, 2.0 * std::numbers::pi);
            for (NetworkHarmonicContact one : now) {
                one.begin -= first;
                one.end -= first;
                start.contacts.push_back(one);
            }
            settled.motion = harmonicNear(still.given, std::move(start));
            if (settled.motion) {
                settled.contacts = std::ssize(settled.motion->contacts);
                measureStrains(still.given, still.displaced, *settled.motion);
                settled.motion->growth = growthOf(still.given, *settled.motion);
                return settled;
            }
        }
    }
    return {};
}

}  // namespace signorini
