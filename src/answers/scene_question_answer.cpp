#include "scene_question_answer.hpp"

#include <algorithm>

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

SceneQuestionAnswer questionOf(const Assembly& assembly, const Network& network, std::int64_t steps,
                               const NetworkWish& wish, const FindOptions& options,
                               const std::function<void(double, double)>& show)
{
    SceneQuestionAnswer answer{scheduleOf(assembly, network, {{0, steps}}), {}, {}};
    const std::size_t contacts = network.contacts.size();
    const auto all = static_cast<double>(contacts) * static_cast<double>(steps - 1);
    for (std::size_t j = 0; j < contacts; ++j) {
        for (std::int64_t m = 1; m < steps; ++m) {
            const ContactSet closed = ContactSet{1} << j;
            SceneSet& set = answer.sets.emplace_back(SceneSet{j, m, Status::undecided, {}});
            if (isRequested(options.cancel)) {
                set.detail = "interrupted";
                continue;
            }
            SceneFindAnswer found =
                answerOf(assembly, network, {{closed, m}, {0, steps - m}}, wish, options);
            set.status = found.status();
            if (set.status == Status::undecided) {
                set.detail = found.motions.detail;
            }
            if (found.isFound()) {
                answer.motions.push_back(std::move(found));
            }
            show(static_cast<double>(answer.sets.size()), all);
        }
    }
    return answer;
}

void tryStability(SceneQuestionAnswer& answer, const Cancel& cancel)
{
    for (SceneFindAnswer& motion : answer.motions) {
        tryStability(motion, cancel);
    }
}

}  // namespace signorini::answers
