#include "study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include "arguments.hpp"
#include "given.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t mostCases = 1'000'000;

/// A key and its values as words; a flag has none.
struct Entry {
    std::string option;
    std::vector<std::string> values;
};

std::string wordOf(const std::string& key, const toml::node& node)
{
    if (const auto* text = node.as_string()) {
        return text->get();
    }
    if (const auto* whole = node.as_integer()) {
        return fmt::format("{}", whole->get());
    }
    if (const auto* number = node.as_floating_point()) {
        return fmt::format("{}", number->get());
    }
    throw std::invalid_argument(
        fmt::format("{}: allowed a number, a text such as \"0.1mm\", or true", key));
}

/// May it be a list?
bool isVaried(const std::string& key)
{
    return key == "gap" || key == "damping" || key.starts_with("amplitude");
}

Entry entryOf(const std::string& key, const toml::node& node)
{
    Entry entry{"--" + key, {}};
    const auto* list = node.as_array();
    if (list == nullptr) {
        const auto* flag = node.as_boolean();
        if (flag != nullptr && !flag->get()) {
            throw std::invalid_argument(fmt::format("{} = false: leave it out", key));
        }
        if (flag == nullptr) {
            entry.values.push_back(wordOf(key, node));
        }
        return entry;
    }
    if (!isVaried(key) || list->empty()) {
        throw std::invalid_argument(fmt::format(
            "{} = [...]: allowed one value; of gap, damping and amplitude also several", key));
    }
    for (const toml::node& one : *list) {
        entry.values.push_back(wordOf(key, one));
    }
    return entry;
}

/// Is it an option of study, or one by which a sweep is not over the frequency?
bool isOurs(std::string_view name)
{
    constexpr std::array<std::string_view, 17> ours{
        "over", "frequency", "hertz",  "csv",          "figure",  "bifurcation",
        "help", "resume",    "format", "quiet",        "threads", "verbose",
        "up",   "down",      "rest",   "yield-stress", "progress"};
    return std::find(ours.begin(), ours.end(), name) != ours.end();
}

/// In the order gap, damping, others: the last that vary go fastest.
std::vector<Entry> entriesOf(const std::string& text)
{
    toml::table table;
    try {
        table = toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw std::invalid_argument(fmt::format("line {}, column {}: {}: allowed TOML",
                                                error.source().begin.line,
                                                error.source().begin.column, error.description()));
    }
    std::vector<Entry> entries;
    for (const auto& [key, node] : table) {
        const std::string name(key.str());
        if (isOurs(name)) {
            throw std::invalid_argument(
                fmt::format("{}: allowed the options of sweep over the frequency, and no files "
                            "(those are options of study)",
                            name));
        }
        entries.push_back(entryOf(name, node));
    }
    const auto rank = [](const Entry& entry) {
        return entry.option == "--gap" ? 0 : entry.option == "--damping" ? 1 : 2;
    };
    std::stable_sort(entries.begin(), entries.end(), [&rank](const Entry& one, const Entry& other) {
        return rank(one) < rank(other);
    });
    return entries;
}

}  // namespace

bool isStudyKey(std::string_view name)
{
    return !isOurs(name) &&
           answers::optionOf(answers::asks::sweep, fmt::format("--{}", name)) != nullptr;
}

StudyQuestion studyQuestionOf(const std::string& toml)
{
    const std::vector<Entry> entries = entriesOf(toml);
    StudyQuestion question;
    std::size_t count = 1;
    for (const Entry& entry : entries) {
        question.text +=
            fmt::format("{}{}", question.text.empty() ? "" : " ", entry.option) +
            (isVaried(entry.option.substr(2)) || entry.values.empty() ? std::string()
                                                                      : " " + entry.values.front());
        count *= std::max<std::size_t>(entry.values.size(), 1);
        if (count > mostCases) {
            throw std::invalid_argument(
                fmt::format("gap, damping, amplitude: allowed at most {} sweeps", mostCases));
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        std::vector<std::string> words;
        std::size_t left = k;
        for (std::size_t i = entries.size(); i-- > 0;) {
            words.push_back(entries[i].option);
            if (const std::size_t size = entries[i].values.size(); size > 0) {
                words.push_back(entries[i].values[left % size]);
                left /= size;
            }
        }
        const Given given({"sweep", "", answers::asks::sweep, "", ""}, words);
        try {
            const CommonOptions common(given);
            question.cases.push_back(
                {answers::sweepAsked(given, common.scene(), common.usualCells()),
                 *ForceOptions(given).amplitude});
            if (k == 0) {
                question.restated = common.restated(common.usualCells());
            }
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(given.inOptions(error.what()));
        }
    }
    return question;
}

}  // namespace signorini::cli
