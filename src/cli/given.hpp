#pragma once
/// \file
/// A command line as the table of options reads it, and the help that it makes.

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "call.hpp"
#include "options.hpp"

namespace signorini::cli {

/// What stands before an option's help.
struct Usage {
    std::string_view command;   ///< "find"
    std::string_view sentence;  ///< what it does
    unsigned questions;         ///< of the table
    std::string_view words;     ///< those that belong to no option: "NC NF ..."; empty: none
    std::string_view ofWords;   ///< a sentence about them
    std::string_view footer = {};
    /// Is an option, without its hyphens, a key of the file that the words name? None: no file has.
    bool (*isKey)(std::string_view) = nullptr;
};

/// The options and words of one call, each checked as far as its row of the table says.
class Given : public answers::Call {
public:
    /// \param asked the words behind the command. \throws std::invalid_argument with one line.
    Given(const Usage& usage, const std::vector<std::string>& asked);

    [[nodiscard]] std::string_view command() const { return usage_.command; }
    [[nodiscard]] bool wantsHelp() const { return wantsHelp_; }
    [[nodiscard]] const std::vector<std::string>& words() const { return words_; }

    [[nodiscard]] bool has(std::string_view option) const override;
    /// Is it an option of this command?
    [[nodiscard]] bool knows(std::string_view option) const;
    [[nodiscard]] std::string text(std::string_view option) const override;
    [[nodiscard]] std::optional<double> number(std::string_view option) const override;
    [[nodiscard]] std::optional<std::int64_t> whole(std::string_view option) const override;
    [[nodiscard]] std::string called(std::string_view option) const override
    {
        return std::string(option);
    }
    [[nodiscard]] std::string with(std::string_view option, const std::string& value) const override
    {
        return fmt::format("{} {}", option, value);
    }
    /// The words after an option that takes several.
    [[nodiscard]] const std::vector<std::string>& all(std::string_view option) const;

    /// The first option given that this question does not take; a value that holds without it is
    /// taken for none. nullptr: they all belong to it.
    [[nodiscard]] const answers::Option* outside(unsigned question) const;
    /// \throws std::invalid_argument if there is one, naming the questions that take it.
    void requireOnly(unsigned question) const;

    /// A fault of the library in the words of this call.
    [[nodiscard]] std::string inOptions(const std::string& message) const;

private:
    [[nodiscard]] const answers::Option& row(std::string_view option) const;
    void take(const answers::Option& option, std::vector<std::string> values);
    void requireOnce() const;
    [[noreturn]] void refuseUnknown(const std::vector<std::string>& words) const;

    Usage usage_;
    std::vector<std::string> words_;
    std::map<std::string, std::vector<std::string>, std::less<>> values_;
    bool wantsHelp_ = false;
};

/// The text of --help.
[[nodiscard]] std::string helpOf(const Usage& usage);

}  // namespace signorini::cli
