#pragma once
/// \file
/// Every option once: name, kind, unit, range, default, sentence, and the questions that take it.
///
/// The program reads its command line and makes its help by this table, and `inOptions` says a
/// fault of the library in the words of a user.

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace signorini::answers {

/// What can be asked; options belong to some of them. A command asks one or several.
namespace asks {
inline constexpr unsigned schedule = 1U << 0U;      ///< find NC NF
inline constexpr unsigned period = 1U << 1U;        ///< find --period|--frequency|--hertz
inline constexpr unsigned forced = 1U << 2U;        ///< find NC NF --force
inline constexpr unsigned forcedPeriod = 1U << 3U;  ///< find --period --force
inline constexpr unsigned network = 1U << 4U;       ///< find SET:STEPS --scene
inline constexpr unsigned continuum = 1U << 5U;
inline constexpr unsigned families = 1U << 6U;
inline constexpr unsigned modes = 1U << 7U;
inline constexpr unsigned mode = 1U << 8U;
inline constexpr unsigned atlas = 1U << 9U;
inline constexpr unsigned atlasQuery = 1U << 10U;  ///< atlas --near|--period|--twins
inline constexpr unsigned response = 1U << 11U;
inline constexpr unsigned simulation = 1U << 12U;
inline constexpr unsigned sweep = 1U << 13U;
inline constexpr unsigned scene = 1U << 14U;
inline constexpr unsigned freeNetwork = 1U << 16U;  ///< network without a force
inline constexpr unsigned find = schedule | period | forced | forcedPeriod | network | freeNetwork;
inline constexpr unsigned all = (1U << 15U) - 1U;  ///< of a bar or a scene
inline constexpr unsigned study = 1U << 15U;       ///< sweeps of a file
}  // namespace asks

/// What an option is followed by.
enum class Takes {
    nothing,   ///< a flag
    whole,     ///< a whole number low..high, or "auto" where `type` ends with "|auto"
    positive,  ///< a number > 0, below `high` if that is finite
    range,     ///< a number low..high
    real,      ///< any finite number
    choice,    ///< one of the words of `type`, "a|b"
    ending,    ///< the name of a file with one of the endings of `type`, "FILE.a|.b"
    file,      ///< the name of a file
    text       ///< words that the question itself reads
};

struct Option {
    std::string_view name;  ///< "--strain-limit"
    unsigned of;            ///< asks::...
    Takes takes;
    std::string type;  ///< what stands for the value in the help
    std::string_view unit;
    double low;
    double high;
    std::string_view sentence;
    std::string_view usual;  ///< what holds without it, in words or as a value; empty: nothing
    std::string_view field;  ///< what the library calls it in messages

    /// "finite numbers > 0 [m]"
    [[nodiscard]] std::string allowed() const;
    /// Its sentence with the words it may be, or its unit.
    [[nodiscard]] std::string meaning() const;
    /// Is a value of this kind, in this range? Texts that the question reads are not looked into.
    [[nodiscard]] bool fits(std::string_view text) const;
    /// The same of a number, of the kinds that take one.
    [[nodiscard]] bool fits(double value) const;
};

/// What is hardly meant, but in other units: hertz from this ω/ω₁ on, GPa or MPa below this
/// many Pa, percent above this damping ratio.
inline constexpr double likelyHertz = 10.0;
inline constexpr double softestModulus = 1e5;  // rubber is ten times as stiff
inline constexpr double likelyPercent = 1.0;

/// All of them, in the order of the help.
[[nodiscard]] std::span<const Option> options();

/// The one of this name that one of the questions takes; nullptr: none.
[[nodiscard]] const Option* optionOf(unsigned questions, std::string_view name);

/// What keeps an option from the other questions of its command; empty: nothing but their sense.
[[nodiscard]] std::string_view keptBy(std::string_view name);

/// "find, continuum, sweep": the commands that ask some of these questions.
[[nodiscard]] std::string commandsOf(unsigned questions);

/// What makes a call one of these questions: "NC NF", "NC NF or --period, --frequency, --hertz".
[[nodiscard]] std::string inWords(unsigned questions);

/// Faults of the library, "strainLimit = 100 is out of range: allowed ...", in the words of a user:
/// the option as it was typed, its value, and the range in the unit of the option. What was typed
/// after an option is `typed(name)`, empty where it was not given; other messages stay as they are.
[[nodiscard]] std::string inOptions(const std::string& message, unsigned questions,
                                    const std::function<std::string(std::string_view)>& typed);

}  // namespace signorini::answers
