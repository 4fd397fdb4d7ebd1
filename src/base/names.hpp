#pragma once
/// \file
/// Enumerators and their names: one table for each enumeration, read in both directions.

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace signorini {

/// A row of a table.
template <typename Enum>
struct Named {
    Enum value;
    std::string_view name;
};

/// The name of an enumerator.
template <typename Table, typename Enum>
[[nodiscard]] std::string_view nameIn(const Table& table, Enum value)
{
    const auto row = std::find_if(std::begin(table), std::end(table),
                                  [value](const auto& each) { return each.value == value; });
    if (row == std::end(table)) {
        throw std::logic_error("an enumerator without a name");
    }
    return row->name;
}

/// The enumerator of a name, if the table has it.
template <typename Table>
[[nodiscard]] auto valueIn(const Table& table, std::string_view name)
    -> std::optional<decltype(std::begin(table)->value)>
{
    for (const auto& row : table) {
        if (row.name == name) {
            return row.value;
        }
    }
    return std::nullopt;
}

/// All names, "a|b|c", for messages.
template <typename Table>
[[nodiscard]] std::string namesIn(const Table& table)
{
    std::string text;
    for (const auto& row : table) {
        text += text.empty() ? "" : "|";
        text += row.name;
    }
    return text;
}

}  // namespace signorini
