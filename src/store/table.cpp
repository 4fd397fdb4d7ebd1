#include "table.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "faults.hpp"
#include "signorini/output.hpp"
#include "units.hpp"

namespace signorini {

namespace {

constexpr std::size_t longest = std::size_t{1} << 16;

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

}  // namespace

Table::Table(const std::string& path) : path_(path), line_(longest + 1)
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
    (void)readLine();
    header_.assign(fields_.begin(), fields_.end());
}

bool Table::next()
{
    if (!readLine()) {
        return false;
    }
    if (fields_.size() != header_.size()) {
        refuse(fmt::format(
            "field {} is {}: allowed {} field{}, as in the header, separated by '{}', and "
            "decimal points",
            std::min(header_.size(), fields_.size()) + 1,
            fields_.size() < header_.size() ? "missing" : "too many", header_.size(),
            header_.size() == 1 ? "" : "s", separator_));
    }
    return true;
}

bool Table::readLine()
{
    constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
    while (true) {
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
        if (number_ == 1 && line.starts_with(byteOrderMark)) {
            line.remove_prefix(byteOrderMark.size());
        }
        if (trimmed(line).starts_with('#')) {
            continue;
        }
        if (header_.empty() && line.find(';') != std::string_view::npos) {
            separator_ = ';';
        }
        split(line);
        return true;
    }
}

void Table::split(std::string_view line)
{
    fields_.clear();
    while (true) {
        const std::size_t end = line.find(separator_);
        fields_.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) {
            return;
        }
        line.remove_prefix(end + 1);
    }
}

bool Table::has(std::string_view column) const
{
    return std::find(header_.begin(), header_.end(), column) != header_.end();
}

std::size_t Table::columnOf(std::string_view column, std::string_view allowed) const
{
    const auto times = std::count(header_.begin(), header_.end(), column);
    if (times != 1) {
        refuse(fmt::format("{} column {}: allowed {}, once", times == 0 ? "no" : "more than one",
                           column, allowed));
    }
    return static_cast<std::size_t>(std::find(header_.begin(), header_.end(), column) -
                                    header_.begin());
}

double Table::numberAt(std::size_t column, std::string_view unit) const
{
    if (const auto number = numberIn(fields_[column], unit)) {
        return *number;
    }
    refuse(column, unit.empty() ? "finite numbers" : fmt::format("finite numbers [{}]", unit));
}

void Table::refuse(std::string_view fault) const
{
    throw std::invalid_argument(
        fmt::format("{} line {}: {}", path_, std::max<std::int64_t>(number_, 1), fault));
}

void Table::refuse(std::size_t column, std::string_view allowed) const
{
    refuse(fmt::format("column {} (field {}): '{}': allowed {}", header_[column], column + 1,
                       shortened(fields_[column]), allowed));
}

}  // namespace signorini
