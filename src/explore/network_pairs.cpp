#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "contact_answers.hpp"
#include "forced_case.hpp"
#include "harmonic_motion.hpp"
#include "network_find.hpp"
#include "network_forced.hpp"
#include "pair_pushes.hpp"
#include "two_contacts.hpp"

namespace signorini {

namespace {

/// What all contacts of an open network answer to pushes at each of them; none: nothing damps some
/// waves, or bars drift.
std::vector<ContactPeriod> answersOf(const HarmonicNetwork& given)
{
    std::vector<ContactPeriod> periods;
    if (!driftingBars(given.network).empty()) {
        return periods;
    }
    HarmonicNetwork still = given;
    still.network = underConstantForces(given.network).network;
    const OpenNetwork open(still);
    try {
        for (std::size_t contact = 0; contact < given.network.contacts.size(); ++contact) {
            periods.push_back(ContactAnswers(still, open, contact, Drive::inSteps).period());
        }
    } catch (const Resonance&) {
        periods.clear();
    }
    return periods;
}

/// All schedules with a contact at the first place of a network and then one at the second.
class NetworkPairs {
public:
    NetworkPairs(FrequencyResponse& response, const HarmonicNetwork& given,
                 const PairQuestion& question, const Cancel& cancel)
        : response_(response),
          given_(given),
          question_(question),
          cancel_(cancel),
          periods_(answersOf(given))
    {
    }

    /// Do waves of the open network say what a push does?
    [[nodiscard]] bool areAnswered() const { return !periods_.empty(); }

    /// \return false if it was cancelled.
    bool run(std::size_t first, std::size_t second)
    {
        std::optional<PairPushes> pushes;
        if (areAnswered()) {
            pushes.emplace(periods_, first, second);
        }
        const std::int64_t n = given_.steps;
        const std::int64_t shortest = first == second ? shortestFlight : 1;
        for (std::int64_t contact = 1; contact < n; ++contact) {
            if (pushes) {
                pushes->growFirst();
            }
            for (std::int64_t free = shortest; contact + free < n; ++free) {
                const std::int64_t left = n - contact - free;
                const std::int64_t longest =
                    first == second ? std::min(contact, left - shortest) : left - shortest;
                if (pushes && longest > 0) {
                    pushes->begin(contact + free);
                }
                for (std::int64_t other = 1; other <= longest; ++other) {
                    if (isRequested(cancel_)) {
                        return false;
                    }
                    if (pushes) {
                        pushes->growSecond();
                    }
                    const Phase one{contact, free, static_cast<Stop>(first)};
                    const Phase next{other, left - other, static_cast<Stop>(second)};
                    const bool isOther = first != second || one > next;
                    if (isOther && !(pushes && pushes->isRefuted())) {
                        addPair(response_, {given_.network.cells(), {one, next}, question_.stops},
                                question_);
                    }
                }
            }
        }
        return true;
    }

private:
    FrequencyResponse& response_;
    const HarmonicNetwork& given_;
    const PairQuestion& question_;
    const Cancel& cancel_;
    std::vector<ContactPeriod> periods_;
};

}  // namespace

bool addTwoContacts(FrequencyResponse& response, const HarmonicNetwork& given,
                    const PairQuestion& question, const Cancel& cancel)
{
    NetworkPairs pairs(response, given, question, cancel);
    const std::size_t contacts = given.network.contacts.size();
    const double schedules = twoContactSchedules(given.steps, contacts);
    if (!pairs.areAnswered() && schedules > maxDecidedPairs) {
        addUndecided(response, fmt::format("waves that nothing damps may rest in {} steps: of "
                                           "schedules with two contacts at most {} are decided",
                                           given.steps, maxDecidedPairs));
        response.undecided += static_cast<std::int64_t>(schedules) - 1;
        return true;
    }
    for (std::size_t first = 0; first < contacts; ++first) {
        for (std::size_t second = first; second < contacts; ++second) {
            if (!pairs.run(first, second)) {
                return false;
            }
        }
    }
    return true;
}

std::optional<FrequencyResponse> pairResponse(const HarmonicNetwork& given, double band,
                                              const Cancel& cancel)
{
    requireAsked(given, maxStaircaseSteps);
    const auto decide = [&given](const Schedule& schedule) {
        const std::vector<ContactSpan> spans = spansOf(schedule);
        const auto hasGap = [&given](const ContactSpan& span) {
            const auto contact = static_cast<std::size_t>(std::countr_zero(span.closed));
            return span.closed != 0 && given.network.contacts[contact].gap != 0.0;
        };
        if (std::none_of(spans.begin(), spans.end(), hasGap)) {
            ForcedSet set;
            set.detail = "two contacts without a gap, whose conditions are nearly the same";
            return set;
        }
        return forcedScene(given.network, spans, {given.place, given.cycles, {}},
                           usualEnergy(given.network, spans));
    };
    const auto isTwice = [&given](const ForcedMotion& motion) {
        const std::int64_t back =
            march(given.network, claimOf(spansOf(motion.schedule), motion)).repeats;
        return back > 0 && given.steps / back % 2 == 0;
    };
    FrequencyResponse response;
    response.steps = given.steps;
    if (!addTwoContacts(response, given, {given.amplitude, band, {}, decide, isTwice}, cancel)) {
        return std::nullopt;
    }
    return response;
}

}  // namespace signorini
