#include "question_answer.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"

namespace signorini::answers {

std::int64_t stepsNearest(double hertz, std::int64_t cells, const Bar& bar)
{
    const double second = static_cast<double>(cells) / scales(bar).time;  // in steps
    const double wanted = second / hertz;
    if (!(wanted > static_cast<double>(AskedPeriod::leastSteps) - 0.5 &&
          wanted <= static_cast<double>(AskedPeriod::mostSteps))) {
        throwFault(
            "hertz", hertz,
            fmt::format("{}..{} Hz for this bar ({}) on {} cells",
                        second / static_cast<double>(AskedPeriod::mostSteps),
                        second / static_cast<double>(AskedPeriod::leastSteps), sizeOf(bar), cells));
    }
    return std::llround(wanted);
}

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

QuestionAnswer questionOf(const AskedPeriod& asked, std::int64_t cells, const FindOptions& options)
{
    return {asked, {cells, {{1, asked.steps - 1}}}, options.scene.bar, options.energyRatio, {}};
}

}  // namespace signorini::answers
