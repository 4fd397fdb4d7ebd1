#pragma once
/// \file
/// All motions of bars in a row of one period with one contact in it: of each contact, and each
/// number of steps for which it is closed, the one of least energy, or of a wish.

#include <functional>

#include "scene_find_answer.hpp"

namespace signorini::answers {

/// A schedule of the period: one contact closed for so many steps.
struct SceneSet {
    static constexpr bool isDictionary = true;
    std::size_t contact = 0;  ///< from 0
    std::int64_t steps = 0;
    Status status = Status::undecided;
    std::optional<std::string> detail = {};  ///< why it is not decided
};

struct SceneQuestionAnswer {
    SceneSchedule period;  ///< in which no contact is closed
    AskedPeriod asked;
    std::optional<double> energy;  ///< [Z_1 delta^2/h], to hold
    std::vector<SceneSet> sets;
    std::vector<SceneFindAnswer> motions;  ///< of sets that have one

    /// Found: at least one motion; undecided: none, and some set undecided; none: proved of every
    /// set.
    [[nodiscard]] Status status() const;
    [[nodiscard]] std::int64_t count(Status status) const;
    [[nodiscard]] QuestionPart question() const;
};

/// What a call asks of a period: O(n) schedules for each contact, each with the limits of the
/// options. \throws std::invalid_argument as SearchInBars and askedOfBars.
[[nodiscard]] Question<SceneQuestionAnswer> periodAsked(const Call& call, const BarsAsked& bars,
                                                        const WavesOf& wavesOf);

/// Starts beside each motion.
void tryStability(SceneQuestionAnswer& answer, const Cancel& cancel);

void describe(auto& d, Type<SceneSet>)
{
    using T = SceneSet;
    d.record("SceneSet", "A schedule with one contact in a period.");
    d.key("contact", "- >= 1", "That closes.", [](const T& s) { return s.contact + 1; });
    d.key("steps", "- >= 1", "For which it is closed.", &T::steps);
    d.key("status", "-", R"("found", "none" or "undecided".)", &T::status);
    d.key("detail", "-", "Why it is not decided.", &T::detail, When::any);
}

void describe(auto& d, Type<SceneQuestionAnswer>)
{
    using T = SceneQuestionAnswer;
    d.record("SceneQuestion", "Motions of bars in a row of one period, with one contact in it.");
    d.key("status", "-", R"("found", "none" or "undecided".)", &T::status);
    describeBars(
        d, [](const T& a) -> const auto& { return a.period.bars; });
    d.key("cells", "- >= 1", "Of all bars.", [](const T& a) { return a.period.cells; });
    d.key("steps", "- >= 2", "n.", [](const T& a) { return stepsOf(a.period.spans); });
    d.key("period", "s > 0", "T.", [](const T& a) { return a.period.period(); });
    d.key("frequency", "Hz > 0", "1/T.", [](const T& a) { return 1.0 / a.period.period(); });
    describeQuestion(d, &T::question);
    describeStrainLimit(d, &T::period);
    d.key("sets", "-", "[dict, ...]: each contact, and each number of steps for it.", &T::sets);
    d.key("motions", "-", "Of those that have one.", [](const T& a) {
        return std::vector<std::reference_wrapper<const SceneFindAnswer>>(a.motions.begin(),
                                                                          a.motions.end());
    });
}

}  // namespace signorini::answers
