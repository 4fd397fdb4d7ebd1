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

/// The words of a question.
struct AskedWords {
    static constexpr bool isDictionary = true;
    const AskedPeriod& asked;

    [[nodiscard]] std::optional<std::string> of(std::string_view option) const
    {
        return asked.option == option ? std::optional(asked.word) : std::nullopt;
    }
};

/// A question, and a set of motions that answers it, seen in what holds them.
struct QuestionPart {
    static constexpr bool isDictionary = true;
    const QuestionAnswer& of;
};
struct SetPart {
    static constexpr bool isDictionary = true;
    const FindAnswer& of;
};

void describe(auto& d, Type<AskedWords>)
{
    d.record("AskedWords", "A period as it was asked for.");
    for (const char* option : {"period", "frequency", "hertz"}) {
        d.key(
            option, "-", "As given.", [option](const AskedWords& w) { return w.of(option); },
            When::any);
    }
}

void describe(auto& d, Type<QuestionPart>)
{
    using T = QuestionPart;
    d.record("QuestionPart", "What was asked, on the grid.");
    d.key("asked", "-", "As given.", [](const T& q) { return AskedWords{q.of.asked}; });
    d.key("steps", "- >= 2", "n.", [](const T& q) { return q.of.asked.steps; });
    d.key("period", "s > 0", "T.", [](const T& q) { return q.of.seconds(); });
    d.key("period_ratio", "L/c > 0", "c T/L.", [](const T& q) { return period(q.of.period); });
    d.key("frequency", "Hz > 0", "1/T.", [](const T& q) { return 1.0 / q.of.seconds(); });
    d.key("frequency_ratio", "- > 0", "omega/omega_1.",
          [](const T& q) { return frequencyRatio(q.of.period); });
    d.key("energy", "J > 0", "To hold.", [](const T& q) {
        const auto& ratio = q.of.energyRatio;
        return ratio ? std::optional(*ratio * scales(q.of.bar).energy) : std::nullopt;
    });
    d.key("energy_ratio", "E_1 > 0", "To hold.", [](const T& q) { return q.of.energyRatio; });
    d.key(
        "nearest", "Hz > 0", "Frequency of this grid, where it was asked for in Hz.",
        [](const T& q) {
            const bool isRounded = q.of.asked.option == "hertz";
            return isRounded ? std::optional(1.0 / q.of.seconds()) : std::nullopt;
        },
        When::any);
}

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
    d.key("question", "-", "On the grid.", [](const T& q) { return QuestionPart{q}; });
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
