// States read from CSV files.

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>

#include "faults.hpp"
#include "signorini/output.hpp"

namespace signorini {

namespace {

std::string cannotRead(int error)
{
    return fmt::format("cannot read: {}", std::generic_category().message(error));
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The lines of a table, one after the other, in a bounded amount of memory.
class Table {
public:
    /// \throws FileError. What has no end (a device) is not opened.
    explicit Table(const std::string& path) : path_(path), line_(longest + 1)
    {
        struct stat status = {};
        if (stat(path.c_str(), &status) != 0) {
            throw FileError(path, cannotRead(errno));
        }
        if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode)) {
            throw FileError(path, S_ISDIR(status.st_mode)
                                      ? cannotRead(EISDIR)
                                      : "cannot read: allowed a regular file or a pipe");
        }
        file_.open(path);
        if (!file_) {
            throw FileError(path, cannotRead(errno));
        }
    }

    /// Splits the next line into `fields()`; false at the end.
    /// \throws FileError, std::invalid_argument on a line that is too long or was cut short.
    bool next()
    {
        file_.getline(line_.data(), static_cast<std::streamsize>(line_.size()));
        if (file_.bad()) {
            throw FileError(path_, cannotRead(EIO));
        }
        const auto count = static_cast<std::size_t>(file_.gcount());
        if (count == 0) {
            return false;
        }
        ++number_;
        if (file_.eof()) {
            refuse("its end is missing: allowed only rows that end with a newline");
        }
        if (file_.fail()) {
            refuse(fmt::format("allowed at most {} characters", longest));
        }
        std::string_view line(line_.data(), count - 1);
        if (line.ends_with('\r')) {
            line.remove_suffix(1);
        }
        split(line);
        return true;
    }

    [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }

    /// \throws std::invalid_argument naming file and line.
    [[noreturn]] void refuse(std::string_view fault) const
    {
        throw std::invalid_argument(
            fmt::format("{} line {}: {}", path_, std::max<std::int64_t>(number_, 1), fault));
    }

private:
    static constexpr std::size_t longest = std::size_t{1} << 16;

    void split(std::string_view line)
    {
        fields_.clear();
        while (true) {
            const std::size_t comma = line.find(',');
            fields_.push_back(trimmed(line.substr(0, comma)));
            if (comma == std::string_view::npos) {
                return;
            }
            line.remove_prefix(comma + 1);
        }
    }

    std::string path_;
    std::ifstream file_;
    std::vector<char> line_;
    std::vector<std::string_view> fields_;
    std::int64_t number_ = 0;
};

/// Where the header names a column. \throws std::invalid_argument unless it does so once.
std::size_t columnOf(const Table& table, std::string_view wanted)
{
    const auto& names = table.fields();
    const auto times = std::count(names.begin(), names.end(), wanted);
    if (times != 1) {
        table.refuse(fmt::format("{} column {}: allowed a header with columns a and b",
                                 times == 0 ? "no" : "more than one", wanted));
    }
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), wanted) - names.begin());
}

double numberIn(const Table& table, std::size_t at, std::string_view column)
{
    const std::string_view text = table.fields()[at];
    const char* end = text.data() + text.size();
    double number = 0.0;
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stop != end || !std::isfinite(number)) {
        table.refuse(fmt::format("column {} (field {}): '{}': allowed finite numbers", column,
                                 at + 1, shortened(text)));
    }
    return number;
}

}  // namespace

State readStateCsv(const std::string& path, const Bar& bar, std::int64_t mostCells)
{
    Table table(path);
    (void)table.next();
    const std::size_t atA = columnOf(table, "a");
    const std::size_t atB = columnOf(table, "b");
    const std::size_t columns = table.fields().size();
    const double unit = scales(bar).strain;
    std::vector<double> a;
    std::vector<double> b;
    while (table.next()) {
        if (table.fields().size() != columns) {
            table.refuse(fmt::format(
                "field {} is {}: allowed {} fields, as in the header, and decimal points",
                std::min(columns, table.fields().size()) + 1,
                table.fields().size() < columns ? "missing" : "too many", columns));
        }
        if (static_cast<std::int64_t>(a.size()) == mostCells) {
            table.refuse(fmt::format("allowed at most {} rows, one per cell", mostCells));
        }
        a.push_back(numberIn(table, atA, "a") / unit);
        b.push_back(numberIn(table, atB, "b") / unit);
    }
    if (a.empty()) {
        throw std::invalid_argument(fmt::format("{}: no rows: allowed one per cell", path));
    }
    const auto size = static_cast<Eigen::Index>(a.size());
    return {Eigen::Map<const Eigen::VectorXd>(a.data(), size),
            Eigen::Map<const Eigen::VectorXd>(b.data(), size)};
}

}  // namespace signorini
