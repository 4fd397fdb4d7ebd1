#pragma once
/// \file
/// Numbers in files.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "signorini/output.hpp"
#include "text.hpp"

namespace signorini {

/// The value times its unit, with -0 shown as 0.
inline double inUnit(double value, double unit)
{
    return value * unit + 0.0;
}

template <typename... Args>
void print(TextFile& file, fmt::format_string<Args...> format, Args&&... args)
{
    Text line;
    print(line, format, std::forward<Args>(args)...);
    file.write({line.data(), line.size()});
}

/// The rows of a table: each call writes one, with a field for each value. What is not known is
/// empty, truth is 1 or 0, an enumerator its name.
class CsvRows {
public:
    explicit CsvRows(TextFile& file) : file_(file) {}

    template <typename... Values>
    void operator()(const Values&... values)
    {
        (add(values), ...);
        line_[line_.size() - 1] = '\n';  // in place of the last comma
        file_.write({line_.data(), line_.size()});
        line_.clear();
    }

private:
    template <typename Value>
    void add(const Value& value)
    {
        if constexpr (requires { value.has_value(); }) {
            value ? add(*value) : print(line_, ",");
        } else if constexpr (std::is_same_v<Value, bool>) {
            print(line_, "{:d},", value);
        } else if constexpr (std::is_enum_v<Value>) {
            print(line_, "{},", name(value));
        } else {
            print(line_, "{},", value);
        }
    }

    TextFile& file_;
    Text line_;
};

/// Writes a table: its header, and what add(rows) calls rows with. \throws FileError.
template <typename Add>
void writeCsv(const std::string& path, std::string_view header, Add add)
{
    TextFile file(path);
    print(file, "{}\n", header);
    CsvRows rows(file);
    add(rows);
    file.close();
}

}  // namespace signorini
