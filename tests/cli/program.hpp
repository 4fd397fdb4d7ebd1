#pragma once
/// \file
/// Runs the program signorini as people and scripts do.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "catch.hpp"

namespace signorini::test {

namespace fs = std::filesystem;
using nlohmann::json;

inline std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs the program in a folder of its own.
class Program {
public:
    Program() : folder_(fs::temp_directory_path() / ("signorini-cli-" + std::to_string(getpid())))
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() { fs::remove_all(folder_); }

    struct Outcome {
        int status;
        std::string out;
        std::string err;
    };

    [[nodiscard]] Outcome run(const std::string& arguments, const std::string& prefix = "") const
    {
        const std::string base = folder_.string() + "-std";
        const std::string command = "cd '" + folder_.string() + "' && " + prefix + " '" +
                                    SIGNORINI_PROGRAM + "' " + arguments + " >" + base + "out 2>" +
                                    base + "err </dev/null";
        const int status = std::system(command.c_str());
        Outcome outcome{WEXITSTATUS(status), contentOf(base + "out"), contentOf(base + "err")};
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

    [[nodiscard]] fs::path file(const char* name) const { return folder_ / name; }
    [[nodiscard]] std::ptrdiff_t files() const
    {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

private:
    fs::path folder_;
};

inline std::ptrdiff_t lines(const std::string& text)
{
    return std::count(text.begin(), text.end(), '\n');
}

}  // namespace signorini::test
