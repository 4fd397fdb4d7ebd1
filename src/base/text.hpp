#pragma once
/// \file
/// Text put together piece by piece: scripts, tables, reports.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace signorini {

using Text = fmt::memory_buffer;

/// Appends formatted text.
template <typename... Args>
void print(Text& text, fmt::format_string<Args...> format, Args&&... args)
{
    fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

/// Takes a number and the mark behind it from the front of a text. \return were they there?
template <typename Number>
bool takeNumberBefore(std::string_view& text, char mark, Number& value)
{
    const std::string digits(text.substr(0, text.find(mark)));
    const char* const end = digits.c_str() + digits.size();
    if (digits.empty() || digits.size() == text.size()) {
        return false;
    }
    // libc++ reads whole numbers only by from_chars.
    if constexpr (requires { std::from_chars(end, end, value); }) {
        const auto [stop, error] = std::from_chars(digits.c_str(), end, value);
        if (error != std::errc{} || stop != end) {
            return false;
        }
    } else {
        char* stop = nullptr;
        value = std::strtod(digits.c_str(), &stop);
        if (stop != end) {
            return false;
        }
    }
    text.remove_prefix(digits.size() + 1);
    return true;
}

/// The text with blanks for control characters: a name of a file may hold any, and a terminal or a
/// script that reads lines obeys them.
inline std::string onOneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(),
        [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
    return text;
}

/// The text in double quotes, as gnuplot and JSON read it.
inline std::string quoted(const std::string& words)
{
    std::string text = "\"";
    for (const char c : words) {
        text += c == '"' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
    }
    return text + "\"";
}

}  // namespace signorini
