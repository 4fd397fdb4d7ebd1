#pragma once
/// \file
/// Text put together piece by piece: scripts, tables, reports.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>

namespace signorini {

using Text = fmt::memory_buffer;

/// Appends formatted text.
template <typename... Args>
void print(Text& text, fmt::format_string<Args...> format, Args&&... args)
{
    fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
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

}  // namespace signorini
