#include "scene_question_answer.hpp"

#include <algorithm>

#include "scene_harmonic_answer.hpp"

namespace signorini::answers {

std::int64_t SceneQuestionAnswer::count(Status status) const
{
    return std::count_if(sets.begin(), sets.end(),
                         [status](const SceneSet& set) { return set.status == status; });
}

Status SceneQuestionAnswer::status() const
{
    return count(Status::found) > 0       ? Status::found
           : count(Status::undecided) > 0 ? Status::undecided
                                          : Status::none;
}

QuestionPart SceneQuestionAnswer::question() const
{
    return {asked,
            period.period(),
            period.periodRatio(),
            1.0 / period.period(),
            period.frequencyRatio(),
            energy ? std::optional(period.joules(*energy)) : std::nullopt,
            energy ? period.ratio(*energy) : std::nullopt};
}

namespace {

SceneQuestionAnswer answerOf(const BarsAsked& bars, const AskedPeriod& asked,
                             const SearchInBars& search, const Watch& watch)
{
    const std::int64_t steps = asked.steps;
    SceneQuestionAnswer answer{
        scheduleOf(bars.assembly, bars.network, {{0, steps}}), asked, search.wish.energy, {}, {}};
    const std::size_t contacts = bars.network.contacts.size();
    const auto all = static_cast<double>(contacts) * static_cast<double>(steps - 1);
    for (std::size_t j = 0; j < contacts; ++j) {
        for (std::int64_t m = 1; m < steps; ++m) {
            const ContactSet closed = ContactSet{1} << j;
            SceneSet& set = answer.sets.emplace_back(SceneSet{j, m, Status::undecided, {}});
            if (isRequested(watch.cancel)) {
                set.detail = "interrupted";
                continue;
            }
            SceneFindAnswer found = search.of(bars, {{closed, m}, {0, steps - m}}, watch.cancel);
            set.status = found.status();
            if (set.status == Status::undecided) {
                set.detail = found.motions.detail;
            }
            if (found.isFound()) {
                answer.motions.push_back(std::move(found));
            }
            watch.show(static_cast<double>(answer.sets.size()), all);
        }
    }
    return answer;
}

}  // namespace

Question<SceneQuestionAnswer> periodAsked(const Call& call, const BarsAsked& bars,
                                          const WavesOf& wavesOf)
{
    const AskedPeriod asked = askedOfBars(call, bars.assembly, 1);
    const SearchInBars search(call, bars, wavesOf);
    return tried<SceneQuestionAnswer>(call, asked.steps, [=](const Watch& watch) {
        return answerOf(bars, asked, search, watch);
    });
}

void tryStability(SceneQuestionAnswer& answer, const Cancel& cancel)
{
    for (SceneFindAnswer& motion : answer.motions) {
        tryStability(motion, cancel);
    }
}

}  // namespace signorini::answers
