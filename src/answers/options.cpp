#include "options.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "faults.hpp"
#include "units.hpp"

namespace signorini::answers {

namespace {

/// "camelCase", "two words", "--an-option": all the same but for their letters.
std::string plain(std::string_view name)
{
    std::string letters;
    for (const char letter : name) {
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0) {
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        }
    }
    return letters;
}

/// All numbers of a text times a factor; two dots are between two of them.
std::string scaled(const std::string& text, double factor)
{
    std::string result;
    for (std::size_t k = 0; k < text.size();) {
        if (std::isdigit(static_cast<unsigned char>(text[k])) == 0) {
            result += text[k++];
            continue;
        }
        const std::string rest = text.substr(k, text.find("..", k) - k);
        char* end = nullptr;
        result += fmt::format("{:.6g}", std::strtod(rest.c_str(), &end) * factor);
        k += static_cast<std::size_t>(end - rest.c_str());
    }
    return result;
}

/// What the library allows, in the unit of the option: a range in other units is scaled as the
/// value was.
std::string allowedOf(const Option& option, const std::string& allowed, const std::string& typed,
                      const std::string& value)
{
    const std::size_t unit = allowed.rfind(" [");
    const auto given = numberIn(typed, option.unit);
    const auto held = numberIn(value, "-");
    if (unit == std::string::npos || !allowed.ends_with(']') || !given || !held || *held == 0.0 ||
        *given == *held) {
        return allowed;
    }
    return fmt::format("{} [{}]", scaled(allowed.substr(0, unit), *given / *held), option.unit);
}

}  // namespace

std::string inOptions(const std::string& message, unsigned questions,
                      const std::function<std::string(std::string_view)>& typed)
{
    constexpr std::string_view is = " = ";
    const std::size_t equals = message.find(is);
    const bool isNone = message.find(notApplied) < message.find(outOfRange);
    const std::string_view verdict = isNone ? notApplied : outOfRange;
    const std::size_t out = message.find(verdict);
    if (equals == std::string::npos || out == std::string::npos || out < equals) {
        return message;
    }
    const std::string field = message.substr(0, equals);
    const std::string value = message.substr(equals + is.size(), out - equals - is.size());
    const std::size_t next = message.find("; ", out);
    const std::string allowed = message.substr(out + verdict.size(), next - out - verdict.size());
    const std::string rest = next == std::string::npos
                                 ? ""
                                 : "; " + inOptions(message.substr(next + 2), questions, typed);
    std::string_view untyped;
    for (const Option& option : options()) {
        if ((option.of & questions) == 0 || field.starts_with("--") ||
            (plain(option.name) != plain(field) && plain(option.field) != plain(field))) {
            continue;
        }
        if (option.takes == Takes::nothing && allowed.starts_with("false ")) {
            return fmt::format("{}{}{}", option.name, notApplied, allowed.substr(5)) + rest;
        }
        const std::string text = shortened(typed(option.name));
        if (!text.empty() && (value == text || numberIn(value, "-"))) {
            return fmt::format("{}{}{}{}{}{}", option.name, is, text, verdict,
                               allowedOf(option, allowed, text, value), rest);
        }
        if (text.empty() && !option.field.empty() && untyped.empty()) {
            untyped = option.name;
        }
    }
    if (!untyped.empty() && numberIn(value, "-")) {  // what holds without it
        return fmt::format("{}{}{}{}{}{}", untyped, is, value, verdict, allowed, rest);
    }
    if (!untyped.empty() && value == "not given") {
        return fmt::format("{} is missing: allowed {}{}", untyped, allowed, rest);
    }
    return message.substr(0, next) + rest;
}

const Option* optionOf(unsigned questions, std::string_view name)
{
    for (const Option& option : options()) {
        if ((option.of & questions) != 0 && option.name == name) {
            return &option;
        }
    }
    return nullptr;
}

std::string inWords(unsigned questions)
{
    using namespace asks;
    constexpr std::array phrases{
        std::pair{schedule, "NC NF"},
        std::pair{period, "--period, --frequency, --hertz"},
        std::pair{forced, "NC NF of --damping and --force"},
        std::pair{forcedPeriod, "--period, --frequency, --hertz of --damping and --force"},
        std::pair{network, "--scene of more than a bar with stops at its tip"},
        std::pair{atlas, "a range to decide"},
        std::pair{atlasQuery, "a query: --near, --period, --twins"},
    };
    std::string text;
    for (const auto& [question, phrase] : phrases) {
        if ((questions & question) != 0) {
            text += fmt::format("{}{}", text.empty() ? "" : ", or with ", phrase);
        }
    }
    return text;
}

std::string commandsOf(unsigned questions)
{
    using namespace asks;
    constexpr std::array names{
        std::pair{find, "find"},         std::pair{continuum, "continuum"},
        std::pair{families, "families"}, std::pair{modes, "modes"},
        std::pair{mode, "mode"},         std::pair{atlas | atlasQuery, "atlas"},
        std::pair{response, "response"}, std::pair{simulation, "simulate"},
        std::pair{asks::sweep, "sweep"}, std::pair{scene, "scene"},
        std::pair{study, "study"},
    };
    std::vector<std::string_view> those;
    for (const auto& [some, name] : names) {
        if ((questions & some) != 0) {
            those.emplace_back(name);
        }
    }
    return fmt::format("{}", fmt::join(those, ", "));
}

std::string Option::allowed() const
{
    switch (takes) {
        case Takes::whole:
            return fmt::format("whole numbers {}..{}{}", static_cast<std::int64_t>(low),
                               static_cast<std::int64_t>(high),
                               type.ends_with("|auto") ? " or auto" : "");
        case Takes::positive:
            return std::isfinite(high) ? fmt::format("numbers > 0, below {} [{}]", high, unit)
                                       : fmt::format("finite numbers > 0 [{}]", unit);
        case Takes::range:
            return fmt::format("numbers {}..{} [{}]", low, high, unit);
        case Takes::real:
            return fmt::format("finite numbers [{}]", unit);
        case Takes::choice:
            return type;
        case Takes::ending: {
            std::string endings = type.substr(type.find('.'));
            for (std::size_t bar = endings.find('|'); bar != std::string::npos;
                 bar = endings.find('|')) {
                endings.replace(bar, 1,
                                endings.find('|', bar + 1) == std::string::npos ? " or " : ", ");
            }
            return "a name ending in " + endings;
        }
        default:
            return type;
    }
}

std::string Option::meaning() const
{
    const bool hasUnit = unit != "-" && sentence.find('[') == std::string_view::npos;
    return fmt::format("{}{}{}.", sentence, takes == Takes::choice ? ": " + type : "",
                       hasUnit ? fmt::format(" [{}]", unit) : "");
}

bool Option::fits(std::string_view text) const
{
    const auto isOneOf = [this](auto matches) {
        std::string_view rest = type;
        for (std::size_t end = 0; end != std::string_view::npos;
             rest.remove_prefix(end == std::string_view::npos ? 0 : end + 1)) {
            end = rest.find('|');
            if (matches(rest.substr(0, end))) {
                return true;
            }
        }
        return false;
    };
    if (takes == Takes::whole) {
        return (text == "auto" && type.ends_with("|auto")) ||
               wholeIn(text, static_cast<std::int64_t>(low), static_cast<std::int64_t>(high))
                   .has_value();
    }
    if (takes == Takes::choice) {
        return isOneOf([text](std::string_view word) { return word == text; });
    }
    if (takes == Takes::ending) {
        return isOneOf(
            [text](std::string_view word) { return text.ends_with(word.substr(word.find('.'))); });
    }
    if (takes == Takes::positive || takes == Takes::range || takes == Takes::real) {
        const auto value = numberIn(text, unit);
        return value && fits(*value);
    }
    return !text.empty();
}

bool Option::fits(double value) const
{
    return std::isfinite(value) &&
           (takes == Takes::positive ? value > 0.0 && value < high : low <= value && value <= high);
}

}  // namespace signorini::answers
