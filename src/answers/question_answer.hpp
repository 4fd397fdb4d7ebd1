#pragma once
/// \file
/// What `find` says of a period, whatever the schedule.

#include <algorithm>
#include <iterator>

#include "asked_period.hpp"
#include "find_answer.hpp"

namespace signorini::answers {

/// All sets of motions of a period.
struct QuestionAnswer {
    AskedPeriod asked;
    Schedule period;  ///< any schedule with this period
    Bar bar;
    std::optional<double> energyRatio;  ///< to hold
    std::vector<FindAnswer> answers;    ///< one for each set

    /// [s]
    [[nodiscard]] double seconds() const { return signorini::period(period) * scales(bar).time; }
    [[nodiscard]] QuestionPart question() const;
    /// Found: at least one motion; undecided: none, and some set undecided; none: proved of every
    /// set.
    [[nodiscard]] Status status() const;
    /// "period" or "constraints", if there is none.
    [[nodiscard]] std::optional<std::string> reason() const;
    /// The same in a sentence.
    [[nodiscard]] std::optional<std::string> detail() const;
};

/// \pre the options have passed `findPeriodic`.
[[nodiscard]] QuestionAnswer questionOf(const AskedPeriod& asked, std::int64_t cells,
                                        const FindOptions& options);

/// A set of motions that answers a question, seen in what holds it.
struct SetPart {
    static constexpr bool isDictionary = true;
    const FindAnswer& of;
};

void describe(auto& d, Type<SetPart>)
{
    using T = SetPart;
    d.record("SetPart", "A set of motions with one contact in the period.");
    d.key("schedule", "-", "That has all of it.", [](const T& s) { return s.of.result.schedule; });
    d.key("family", "-", "That it is.", [](const T& s) { return s.of.result.set.family; });
    d.key("energy_ratio_range", "-", "(least, most) E/E_1.",
          [](const T& s) { return s.of.energies(); });
    d.key("status", "-", "Of the demands in this set.",
          [](const T& s) { return s.of.result.status; });
    d.key("reason", "-", "Why there is no motion.", [](const T& s) { return s.of.reason(); });
}

void describe(auto& d, Type<QuestionAnswer>)
{
    using T = QuestionAnswer;
    d.record("QuestionData", "All motions of one period, one of each set.");
    d.key("bar", "-", "Asked about.", &T::bar);
    d.key("status", "-", R"("found", "none" or "undecided".)", &T::status);
    d.key("cells", "- >= 1", "N.", [](const T& q) { return q.period.cells; });
    describeQuestion(d, &T::question);
    d.key("sets", "-", "Every set of motions with one contact in this period.", [](const T& q) {
        std::vector<SetPart> sets;
        for (const FindAnswer& answer : q.answers) {
            sets.push_back({answer});
        }
        return sets;
    });
    d.key(
        "motions", "-", "One of each set that has one.",
        [](const T& q) {
            std::vector<std::reference_wrapper<const FindAnswer>> found;
            std::copy_if(q.answers.begin(), q.answers.end(), std::back_inserter(found),
                         [](const FindAnswer& a) { return a.result.status == Status::found; });
            return found;
        },
        When::found);
    d.key("reason", "-", "Why there is none, in a word.", &T::reason, When::none);
    d.key("detail", "-", "The same in a sentence.", &T::detail, When::any);
}

}  // namespace signorini::answers
