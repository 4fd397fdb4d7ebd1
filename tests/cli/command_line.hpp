#pragma once
/// \file
/// Runs the program signorini as people and scripts do.

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "folder.hpp"

namespace signorini::test {

namespace fs = std::filesystem;
using nlohmann::json;

inline std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs the program in a folder of its own.
class CommandLine {
public:
    struct Outcome {
        int status;
        std::string out;
        std::string err;
        double peakKilobytes;  ///< most memory that this one call held
    };

    [[nodiscard]] Outcome run(const std::string& arguments, const std::string& prefix = "") const
    {
        const std::string base = folder_.path().string() + "-std";
        const std::string command = "cd '" + folder_.path().string() + "' && " + prefix + " '" +
                                    SIGNORINI_PROGRAM + "' " + arguments + " >" + base + "out 2>" +
                                    base + "err </dev/null";
        const auto [status, peak] = shell(command);
        Outcome outcome{status, contentOf(base + "out"), contentOf(base + "err"), peak};
        fs::remove(base + "out");
        fs::remove(base + "err");
        return outcome;
    }

    [[nodiscard]] json find(const std::string& arguments, int status) const
    {
        const Outcome outcome = run("find " + arguments + " --format json");
        INFO(arguments << "\n" << outcome.err);
        REQUIRE(outcome.status == status);
        return json::parse(outcome.out);
    }

    [[nodiscard]] fs::path file(const char* name) const { return folder_.path() / name; }
    [[nodiscard]] std::ptrdiff_t files() const { return folder_.files(); }

private:
    /// Exit status and peak memory [kB] of one command.
    static std::pair<int, double> shell(const std::string& command)
    {
        malloc_trim(0);  // a child's peak begins with the heap it is forked with
        const pid_t child = fork();
        if (child == 0) {
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
        int status = 0;
        rusage usage{};
        if (child < 0 || wait4(child, &status, 0, &usage) != child) {
            throw std::system_error(errno, std::generic_category(), "sh");
        }
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                static_cast<double>(usage.ru_maxrss)};
    }

    Folder folder_;
};

/// The numbers of a table with a header, one array a row.
inline std::vector<json> rowsOf(const std::string& csv)
{
    std::vector<json> rows;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        rows.push_back(json::parse("[" + line + "]"));
    }
    return rows;
}

/// The cells of a row of a table; the last may be empty.
inline std::vector<std::string> cellsOf(const std::string& row)
{
    std::vector<std::string> cells;
    std::istringstream rest(row + ",");
    for (std::string cell; std::getline(rest, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

inline std::ptrdiff_t lines(const std::string& text)
{
    return std::count(text.begin(), text.end(), '\n');
}

}  // namespace signorini::test
