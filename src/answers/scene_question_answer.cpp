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

namespace {

SceneQuestionAnswer answerOf(const BarsAsked& bars, std::int64_t steps, const SearchInBars& search,
                             const Watch& watch)
{
    SceneQuestionAnswer answer{scheduleOf(bars.assembly, bars.network, {{0, steps}}), {}, {}};
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
    const std::int64_t steps = stepsAsked(call, bars.assembly, 1);
    const SearchInBars search(call, bars, wavesOf);
    return tried<SceneQuestionAnswer>(
        call, steps, [=](const Watch& watch) { return answerOf(bars, steps, search, watch); });
}

void tryStability(SceneQuestionAnswer& answer, const Cancel& cancel)
{
    for (SceneFindAnswer& motion : answer.motions) {
        tryStability(motion, cancel);
    }
}

}  // namespace signorini::answers
