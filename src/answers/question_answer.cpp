#include "question_answer.hpp"

#include <algorithm>

namespace signorini::answers {

Status QuestionAnswer::status() const
{
    const auto isSome = [this](Status status) {
        return std::any_of(answers.begin(), answers.end(),
                           [status](const auto& a) { return a.result.status == status; });
    };
    return isSome(Status::found)       ? Status::found
           : isSome(Status::undecided) ? Status::undecided
                                       : Status::none;
}

std::optional<std::string> QuestionAnswer::reason() const
{
    if (status() != Status::none) {
        return std::nullopt;
    }
    return answers.empty() ? "period" : "constraints";
}

std::optional<std::string> QuestionAnswer::detail() const
{
    if (status() != Status::none) {
        return std::nullopt;
    }
    return answers.empty() ? "no motion with one contact in a period has this period, on any grid"
                           : "motions with one contact in a period have this period, but none on "
                             "this grid meets the demands";
}

QuestionPart QuestionAnswer::question() const
{
    return {asked,
            seconds(),
            signorini::period(period),
            1.0 / seconds(),
            frequencyRatio(period),
            energyRatio ? std::optional(*energyRatio * scales(bar).energy) : std::nullopt,
            energyRatio};
}

QuestionAnswer questionOf(const AskedPeriod& asked, std::int64_t cells, const FindOptions& options)
{
    return {asked, {cells, {{1, asked.steps - 1}}}, options.scene.bar, options.energyRatio, {}};
}

}  // namespace signorini::answers
