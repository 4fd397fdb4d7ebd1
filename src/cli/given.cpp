#include "given.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "arguments.hpp"
#include "hints.hpp"
#include "signorini/schedule.hpp"
#include "units.hpp"

namespace signorini::cli {

namespace {

using answers::Option;
using answers::Takes;

/// "-5", ".5": a word where "-x" would be an option.
bool isNumberOrSet(std::string_view word)
{
    return word.size() > 1 && (std::isdigit(static_cast<unsigned char>(word[1])) != 0 ||
                               word[1] == '.' || word[1] == ':');
}

/// "-inf", "-nan" too: a number where another word would be unknown.
bool looksLikeNumber(std::string_view word)
{
    return word.starts_with('-') &&
           (isNumberOrSet(word) || word == "-inf" || word == "-nan" || word == "-infinity");
}

/// How many words follow an option.
std::size_t valuesOf(const Option& option)
{
    return option.takes == Takes::nothing ? 0
                                          : 1 + static_cast<std::size_t>(std::count(
                                                    option.type.begin(), option.type.end(), ' '));
}

/// Where an option that this command does not take belongs: in its file, or to which commands; or
/// what it was meant to be.
std::string otherwise(const std::string& word, const Usage& usage,
                      const std::vector<std::string>& names)
{
    const std::string name = word.substr(0, word.find('='));
    if (usage.isKey != nullptr && usage.isKey(name.substr(2))) {
        return fmt::format("; allowed in {}: {} = ...", usage.words, name.substr(2));
    }
    unsigned questions = 0;
    for (const Option& option : answers::options()) {
        questions |= option.name == name ? option.of : 0U;
    }
    return questions != 0
               ? fmt::format("; {} is allowed with {}", name, answers::commandsOf(questions))
               : didYouMean(word, names);
}

std::string padded(std::string_view left, std::string_view right)
{
    constexpr std::size_t column = 30;
    std::string text = fmt::format("  {}", left);
    text += text.size() < column ? std::string(column - text.size(), ' ')
                                 : "\n" + std::string(column, ' ');
    return fmt::format("{}{}\n", text, right);
}

}  // namespace

Given::Given(const Usage& usage, const std::vector<std::string>& asked) : usage_(usage)
{
    const auto end = std::find(asked.begin(), asked.end(), "--");
    wantsHelp_ = std::any_of(
        asked.begin(), end, [](std::string_view word) { return word == "-h" || word == "--help"; });
    if (wantsHelp_) {
        return;
    }
    std::vector<std::string> unknown;
    for (auto word = asked.begin(); word != end; ++word) {
        const bool isLong = word->starts_with("--");
        const std::size_t equals = isLong ? word->find('=') : std::string::npos;
        const std::string name = word->substr(0, equals);
        const Option* option = isLong ? answers::optionOf(usage.questions, name) : nullptr;
        if (option != nullptr) {
            std::vector<std::string> values;
            if (equals != std::string::npos) {
                values.push_back(word->substr(equals + 1));
            }
            while (values.size() < valuesOf(*option) && word + 1 != end &&
                   !word[1].starts_with("--")) {
                values.push_back(*++word);
            }
            take(*option, std::move(values));
        } else if (isLong ||
                   (word->starts_with('-') && word->size() > 1 && !isNumberOrSet(*word)) ||
                   usage.words.empty()) {
            unknown.push_back(*word);
        } else {
            words_.push_back(*word);
        }
    }
    if (end != asked.end()) {
        std::vector<std::string>& rest = usage.words.empty() ? unknown : words_;
        rest.insert(rest.end(), end + 1, asked.end());
    }
    if (!unknown.empty()) {
        refuseUnknown(unknown);
    }
    requireOnce();
}

/// \throws std::invalid_argument with all values that are no good.
void Given::take(const Option& option, std::vector<std::string> values)
{
    const std::string name(option.name);
    if (option.takes == Takes::nothing) {
        const std::string value = values.empty() ? "true" : values.front();
        if (value == "false" || value == "0") {
            return;
        }
        refuseIf(value != "true" && value != "1", name, value, "true|false, or no value");
        values.clear();
    } else {
        refuseIf(values.empty() || values.front().empty(), name, "", option.allowed());
        if (!option.fits(values.front())) {
            refuse(name, values.front(), option.allowed());
        }
    }
    std::vector<std::string>& all = values_[name];
    all.insert(all.end(), values.begin(), values.end());
}

/// \throws std::invalid_argument naming one that was given more often than once.
void Given::requireOnce() const
{
    for (const auto& [name, values] : values_) {
        const std::size_t most = valuesOf(row(name));
        if (values.size() > most) {
            throw std::invalid_argument(
                fmt::format("{} is given {} times: allowed once; see signorini --help", name,
                            (values.size() + most - 1) / most));
        }
    }
}

/// Words that are not expected: a number is the step count it was meant to be where a command takes
/// some, another word perhaps one of the names.
void Given::refuseUnknown(const std::vector<std::string>& words) const
{
    std::vector<std::string> names;
    for (const Option& option : answers::options()) {
        if ((option.of & usage_.questions) != 0) {
            names.emplace_back(option.name);
        }
    }
    std::string text;
    std::string hint;
    for (const std::string& word : words) {
        const bool isOfOption = text.find("--") != std::string::npos;
        if (looksLikeNumber(word) && !isOfOption) {
            usage_.words.starts_with("NC")
                ? refuse("step count", word, fmt::format("whole numbers 1..{}", maxSteps))
                : refuse("number", word, "numbers > 0, each after an option that takes it");
        }
        text += (text.empty() ? "" : " ") + shortened(word);
        hint += hint.empty() && word.starts_with("--") ? otherwise(word, usage_, names) : "";
    }
    throw std::invalid_argument(
        hint.empty() ? fmt::format("{} is not expected; see signorini --help", text)
                     : fmt::format("{} is not expected{} (see signorini --help)", text, hint));
}

const Option& Given::row(std::string_view option) const
{
    const Option* found = answers::optionOf(usage_.questions, option);
    if (found == nullptr) {
        throw std::logic_error(fmt::format("{} has no option {}", usage_.command, option));
    }
    return *found;
}

bool Given::knows(std::string_view option) const
{
    return answers::optionOf(usage_.questions, option) != nullptr;
}

bool Given::has(std::string_view option) const
{
    return values_.contains(row(option).name);
}

const std::vector<std::string>& Given::all(std::string_view option) const
{
    static const std::vector<std::string> none;
    const auto found = values_.find(row(option).name);
    return found == values_.end() ? none : found->second;
}

std::string Given::text(std::string_view option) const
{
    const std::vector<std::string>& values = all(option);
    return values.empty() ? "" : values.front();
}

std::optional<double> Given::number(std::string_view option) const
{
    const std::string value = text(option);
    return value.empty() ? std::nullopt : numberIn(value, row(option).unit);
}

std::optional<std::int64_t> Given::whole(std::string_view option) const
{
    const Option& known = row(option);
    const std::string value = text(option);
    return value.empty() ? std::nullopt
                         : wholeIn(value, static_cast<std::int64_t>(known.low),
                                   static_cast<std::int64_t>(known.high));
}

const Option* Given::outside(unsigned question) const
{
    for (const Option& option : answers::options()) {
        const auto given = values_.find(option.name);
        if ((option.of & usage_.questions) != 0 && (option.of & question) == 0 &&
            given != values_.end() && answers::optionOf(question, option.name) == nullptr &&
            (option.usual.empty() || given->second.front() != option.usual)) {
            return &option;
        }
    }
    return nullptr;
}

void Given::requireOnly(unsigned question) const
{
    if (const Option* other = outside(question)) {
        const std::string_view why = answers::keptBy(other->name);
        throw std::invalid_argument(fmt::format(
            "{} clashes with {}: allowed {}{}{}", other->name, answers::inWords(question),
            (question & answers::asks::network) == 0
                ? "with " + answers::inWords(other->of & usage_.questions)
            : (other->of & answers::asks::freeNetwork) != 0
                ? "with NC NF or SET:STEPS without --force"
                : "with one bar, clamped on the left, with stops at its tip",
            why.empty() ? "" : "; ", why));
    }
}

std::string Given::inOptions(const std::string& message) const
{
    return answers::inOptions(message, usage_.questions,
                              [this](std::string_view name) { return text(name); });
}

std::string helpOf(const Usage& usage)
{
    std::string text = fmt::format("{}\nUsage: signorini {} [OPTIONS]{}{}\n", usage.sentence,
                                   usage.command, usage.words.empty() ? "" : " ", usage.words);
    if (!usage.words.empty()) {
        text += "\nPositionals:\n" + padded(usage.words, usage.ofWords);
    }
    text += "\nOptions:\n" + padded("-h,--help", "Print this help message and exit") +
            padded("--version", "Display program version information and exit");
    for (const Option& option : answers::options()) {
        if ((option.of & usage.questions) != 0) {
            const std::string left = fmt::format("{} {}", option.name, option.type);
            std::string right(option.sentence);
            if (option.takes == Takes::ending && right.find("gnuplot") == std::string::npos &&
                option.name != "--motion") {
                right += " (needs gnuplot)";
            }
            if (!option.usual.empty()) {
                right += fmt::format(" ({})", option.usual);
            }
            text += padded(left, right);
        }
    }
    return text + (usage.footer.empty() ? "" : fmt::format("\n{}\n", usage.footer));
}

}  // namespace signorini::cli
