#pragma once
/// \file
/// Output files named on the command line: checks before any work, staging, and messages that name
/// the option.

#include <string>
#include <vector>

#include "signorini/output.hpp"

namespace signorini::cli {

/// An option that names a file to write, and the name; empty: not given.
struct OutputOption {
    const char* option;
    std::string path;
};

/// \throws std::invalid_argument if two options name one file, or one names standard output.
void validateOutputs(const std::vector<OutputOption>& outputs);

/// Runs `action` and names the option and the user's file in what it throws.
template <typename Action>
auto forFile(const char* option, const std::string& path, Action action)
{
    try {
        return action();
    } catch (const FileError& error) {
        throw FileError(std::string(option) + " " + path, error.reason());
    }
}

/// The name to write to, removed if a signal ends the program; empty if the option was not given.
[[nodiscard]] std::string stage(OutputFiles& files, const OutputOption& output);

}  // namespace signorini::cli
