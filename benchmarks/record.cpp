#include "record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "signorini/output.hpp"

namespace signorini::bench {

namespace {

/// The text columns, before those of figures.
constexpr std::array textColumns{
    std::pair{"suite", &Record::suite},           std::pair{"case", &Record::problem},
    std::pair{"back_end", &Record::backEnd},      std::pair{"formulation", &Record::formulation},
    std::pair{"setting", &Record::setting},       std::pair{"outcome", &Record::outcome},
    std::pair{"claim", &Record::claim},           std::pair{"detail", &Record::detail},
    std::pair{"provenance", &Record::provenance},
};

/// Always in quotes where a reader could stumble; a record stays one line.
std::string quoted(std::string text)
{
    std::replace(text.begin(), text.end(), '\n', ' ');
    if (text.find_first_of(",\"") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result.append(c == '"' ? 2 : 1, c);
    }
    return result + '"';
}

std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> cells(1);
    bool inQuotes = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && inQuotes && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += '"';
            ++i;
        } else if (c == '"') {
            inQuotes = !inQuotes;
        } else if (c == ',' && !inQuotes) {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

}  // namespace

double Record::figure(std::string_view name) const
{
    const auto found = figures.find(name);
    return found == figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

Record identified(std::string suite, std::string problem, std::string backEnd,
                  std::string formulation, std::string setting)
{
    Record record;
    record.suite = std::move(suite);
    record.problem = std::move(problem);
    record.backEnd = std::move(backEnd);
    record.formulation = std::move(formulation);
    record.setting = std::move(setting);
    return record;
}

std::string keyOf(const Record& record)
{
    return fmt::format("{}/{}/{}/{}/{}", record.suite, record.problem, record.backEnd,
                       record.formulation, record.setting);
}

std::string csvHeader()
{
    std::string header;
    for (const auto& [name, member] : textColumns) {
        header += fmt::format("{}{}", header.empty() ? "" : ",", name);
    }
    for (const char* name : figureColumns) {
        header += fmt::format(",{}", name);
    }
    return header;
}

std::string csvLine(const Record& record)
{
    for (const auto& [name, value] : record.figures) {
        if (std::find(figureColumns.begin(), figureColumns.end(), name) == figureColumns.end()) {
            throw std::logic_error("no column " + name);
        }
    }
    std::string line;
    for (const auto& [name, member] : textColumns) {
        line += fmt::format("{}{}", member == &Record::suite ? "" : ",", quoted(record.*member));
    }
    for (const char* name : figureColumns) {
        const auto found = record.figures.find(name);
        line += found == record.figures.end() ? "," : fmt::format(",{}", found->second);
    }
    return line;
}

std::optional<Record> parseCsvLine(const std::string& line)
{
    const std::vector<std::string> cells = split(line);
    if (cells.size() != textColumns.size() + figureColumns.size()) {
        return std::nullopt;
    }
    Record record;
    auto cell = cells.begin();
    for (const auto& [name, member] : textColumns) {
        record.*member = *cell++;
    }
    for (const char* name : figureColumns) {
        double value = 0.0;
        const std::string& text = *cell++;
        if (std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc()) {
            record.figures[name] = value;
        }
    }
    return record;
}

std::vector<Record> readTable(const std::string& path)
{
    std::vector<Record> table;
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) {
        return table;
    }
    if (line != csvHeader()) {
        throw FileError(path, "has other columns than this program writes");
    }
    while (std::getline(file, line)) {
        if (std::optional<Record> record = parseCsvLine(line)) {
            table.push_back(std::move(*record));
        }
    }
    return table;
}

}  // namespace signorini::bench
