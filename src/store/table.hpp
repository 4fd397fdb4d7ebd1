#pragma once
/// \file
/// Tables of text as people and instruments write them: a header that names columns, a row a line.

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// The rows of a table, one after the other, in a bounded amount of memory. Lines that begin with #
/// are not read, nor is a byte order mark; fields are separated by commas, or by semicolons if the
/// header has any.
class Table {
public:
    /// Reads the header. What has no end (a device) is not opened.
    /// \throws FileError, std::invalid_argument as `next` does.
    explicit Table(const std::string& path);

    /// Reads the next row; false at the end.
    /// \throws FileError, std::invalid_argument naming file and line, on a line that is too long or
    /// was cut short, or a row with another number of fields than the header.
    bool next();

    /// Does the header name a column?
    [[nodiscard]] bool has(std::string_view column) const;

    /// Where it does. \throws std::invalid_argument, with what is allowed, unless it does so once.
    [[nodiscard]] std::size_t columnOf(std::string_view column,
                                       std::string_view allowed = "a header that names it") const;

    /// The number of the row in a column, in a unit of which a field may have a kin ("210GPa").
    /// \throws std::invalid_argument naming file, line and column if it is none, or not finite.
    [[nodiscard]] double numberAt(std::size_t column, std::string_view unit = {}) const;

    /// \throws std::invalid_argument naming file and line.
    [[noreturn]] void refuse(std::string_view fault) const;

    /// The same for a field of the row.
    [[noreturn]] void refuse(std::size_t column, std::string_view allowed) const;

private:
    bool readLine();
    void split(std::string_view line);

    std::string path_;
    std::ifstream file_;
    std::vector<char> line_;
    std::vector<std::string_view> fields_;
    std::vector<std::string> header_;
    char separator_ = ',';
    std::int64_t number_ = 0;
};

}  // namespace signorini
