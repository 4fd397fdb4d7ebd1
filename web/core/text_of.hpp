#pragma once
/// \file
/// Text that is written to a file and read back: in the browser the file is in memory.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "signorini/output.hpp"

namespace signorini::web {

/// A file that is gone when it goes out of scope.
class ScratchFile {
public:
    ScratchFile() : path_((temporaryDirectory() / "signorini-web.csv").string()) {}
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ~ScratchFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
};

template <typename Write>
std::string textOf(Write write)
{
    const ScratchFile file;
    write(file.path());
    std::ifstream stream(file.path());
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

}  // namespace signorini::web
