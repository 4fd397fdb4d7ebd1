#pragma once
/// \file
/// Text put together piece by piece: scripts, tables, reports.

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace signorini {

using Text = fmt::memory_buffer;

/// Appends formatted text.
template <typename... Args>
void print(Text& text, fmt::format_string<Args...> format, Args&&... args)
{
    fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

}  // namespace signorini
