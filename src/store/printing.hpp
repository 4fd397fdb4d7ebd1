#pragma once
/// \file
/// Numbers in files.

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "signorini/output.hpp"

namespace signorini {

/// The value times its unit, with -0 shown as 0.
inline double inUnit(double value, double unit)
{
    return value * unit + 0.0;
}

template <typename... Args>
void print(TextFile& file, fmt::format_string<Args...> format, Args&&... args)
{
    fmt::memory_buffer line;
    fmt::format_to(std::back_inserter(line), format, std::forward<Args>(args)...);
    file.write({line.data(), line.size()});
}

}  // namespace signorini
