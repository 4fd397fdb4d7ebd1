#pragma once
/// \file
/// A period as people ask for it: in L/c, as a frequency in omega_1, or in Hz.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "description.hpp"
#include "signorini/bar.hpp"
#include "signorini/modes.hpp"

namespace signorini::answers {

/// A number > 0 as people give it: 22/7, 3.14, 3.
struct GivenNumber {
    double value = 0.0;
    std::optional<ExactPeriod> exact;  ///< unless it needs more than 18 digits, or has an exponent
};

/// A finite number > 0, plain or with its unit (units.hpp). \throws std::invalid_argument naming
/// argument, value and range.
[[nodiscard]] double parsePositive(std::string_view name, std::string_view text,
                                   std::string_view unit);
/// \throws the same.
[[nodiscard]] GivenNumber parseNumber(std::string_view name, std::string_view text,
                                      std::string_view unit);
/// The same as an exact fraction of at most 9 digits above and below, in lowest terms.
/// \throws the same.
[[nodiscard]] ExactPeriod parseFraction(std::string_view name, std::string_view text,
                                        std::string_view unit);
/// A number > 0, or such a fraction. \throws the same.
[[nodiscard]] double parseRatio(std::string_view name, std::string_view text,
                                std::string_view unit);
/// "7/2" or "4".
[[nodiscard]] std::string fractionAsText(const ExactPeriod& fraction);

/// What a frequency in Hz depends on: "L = 1 m, c = 1 m/s by default" or, of a bar that was
/// described, "L = 3 m, c = 5000 m/s".
[[nodiscard]] std::string sizeOf(const Bar& bar);

/// A period as it was asked for, and on the grid.
struct AskedPeriod {
    /// Periods of so many steps are within exact arithmetic on every grid.
    static constexpr std::int64_t leastSteps = 2;
    static constexpr std::int64_t mostSteps = 1'000'000'000'000'000;

    std::string option = {};  ///< period, frequency, hertz
    std::string word = {};    ///< what was given
    std::int64_t steps = 0;   ///< [steps], n; 0: on no grid
    bool isRounded = false;   ///< the nearest that the grid has is meant
};

/// What was asked of a period, and what the answer is of.
struct QuestionPart {
    static constexpr bool isDictionary = true;
    AskedPeriod asked;
    double period;                           ///< [s]
    double periodRatio;                      ///< [L/c]
    double frequency;                        ///< [Hz]
    std::optional<double> frequencyRatio;    ///< where there is omega_1
    std::optional<double> energy = {};       ///< [J], to hold
    std::optional<double> energyRatio = {};  ///< E/E_1, to hold

    /// "; asked 0.3 Hz, nearest on this grid 0.28 Hz", or nothing.
    [[nodiscard]] std::string nearest() const;
};

/// As it was given, "--period" too; on no grid.
[[nodiscard]] AskedPeriod askedAs(const std::string& option, const std::string& word);

/// In steps of L/(Nc): the one asked for, exactly, or for hertz the nearest. `option`: period,
/// frequency or hertz as it was typed, "--period" too.
/// \throws std::invalid_argument naming it, if it is no number or not on the grid.
[[nodiscard]] AskedPeriod periodOnGrid(const std::string& option, const std::string& word,
                                       std::int64_t cells, const Bar& bar);

/// The period [L/c] of a motion on no grid, in which an excitation goes through so many cycles; the
/// frequency is that of the excitation, of hertz the nearest of the grid.
/// \throws std::invalid_argument as above, or if it takes more than 9 digits above or below, or
/// more cells than harmonicContacts allows.
[[nodiscard]] ExactPeriod periodExactly(const std::string& option, const std::string& word,
                                        std::int64_t cells, const Bar& bar, std::int64_t cycles);

/// The words of a question.
struct AskedWords {
    static constexpr bool isDictionary = true;
    const AskedPeriod& asked;

    [[nodiscard]] std::optional<std::string> of(std::string_view option) const
    {
        return asked.option == option ? std::optional(asked.word) : std::nullopt;
    }
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
    d.record("QuestionPart", "What was asked, and the answer's: on the grid, if there is one.");
    d.key("asked", "-", "As given.", [](const T& q) { return AskedWords{q.asked}; });
    d.key(
        "steps", "- >= 2", "n, on a grid.",
        [](const T& q) { return q.asked.steps > 0 ? std::optional(q.asked.steps) : std::nullopt; },
        When::any);
    d.key("period", "s > 0", "T.", &T::period);
    d.key("period_ratio", "L/c > 0", "c T/L.", &T::periodRatio);
    d.key("frequency", "Hz > 0", "1/T, or that of the excitation.", &T::frequency);
    d.key("frequency_ratio", "- > 0", "The same in omega_1, where bars have one.",
          &T::frequencyRatio, When::any);
    d.key("energy", "J > 0", "To hold.", &T::energy);
    d.key("energy_ratio", "E_1 > 0", "To hold.", &T::energyRatio);
    d.key(
        "nearest", "Hz > 0", "Frequency of this grid, where the nearest of it is meant.",
        [](const T& q) { return q.asked.isRounded ? std::optional(q.frequency) : std::nullopt; },
        When::any);
}

/// The key that says what was asked.
void describeQuestion(auto& d, auto question)
{
    d.key("question", "-", "What was asked, and the answer's: on the grid, if there is one.",
          question);
}

}  // namespace signorini::answers
