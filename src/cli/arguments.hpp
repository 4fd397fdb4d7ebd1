#pragma once
/// \file
/// Words of the command line turned into numbers, with one line of text when they are wrong.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/schedule.hpp"

namespace CLI {
class App;
}

namespace signorini::cli {

/// Exit status of the program.
enum ExitStatus : int {
    exitFound = 0,        ///< found / done
    exitNone = 1,         ///< proved: none exists
    exitWrongUse = 2,     ///< an argument is wrong; nothing was written
    exitUndecided = 3,    ///< a limit or numerics stood in the way
    exitUnavailable = 4,  ///< a file, database or back end could not be used
};

/// The exit status that tells a verdict.
[[nodiscard]] ExitStatus exitStatusOf(Status status);

/// Writes to standard output, whole or with an error. \throws FileError.
void writeOut(std::string_view text);

/// Words for people, to standard error. Where they cannot be written they are lost, not the work.
void tell(std::string_view text) noexcept;

/// Stops the removal of temporary files from being skipped when a signal ends the program: files
/// staged later under `path` are removed by the handlers of SIGINT, SIGTERM and SIGHUP.
void removeOnSignal(const std::string& path);

/// A whole number in [low, high]. \throws std::invalid_argument naming argument, value and range.
[[nodiscard]] std::int64_t parseWhole(std::string_view name, std::string_view text,
                                      std::int64_t low, std::int64_t high);

/// A finite number > 0. \throws std::invalid_argument naming argument, value and range.
[[nodiscard]] double parsePositive(std::string_view name, std::string_view text,
                                   std::string_view unit);

/// A finite number. \throws std::invalid_argument naming argument, value and range.
[[nodiscard]] double parseReal(std::string_view name, std::string_view text, std::string_view unit);

/// The options every command shares, as words; empty means not given.
struct CommonOptions {
    std::string cells;
    std::string length;
    std::string waveSpeed;
    std::string axialStiffness;
    std::string gap;
    std::string young;
    std::string density;
    std::string area;
    std::string format;
    std::string threads;
    bool quiet = false;

    /// Adds them to a command.
    void addTo(CLI::App& command);

    /// \throws std::invalid_argument on a wrong value or a clash.
    [[nodiscard]] std::int64_t parseCells() const;
    [[nodiscard]] Bar parseBar() const;
    [[nodiscard]] bool wantsJson() const;
    [[nodiscard]] std::int64_t parseThreads() const;
    /// For a command that works on one thread: says so where more were allowed.
    void useOneThread(std::string_view command) const;
};

/// NC NF [NC NF ...]. \throws std::invalid_argument on a wrong value or an odd number of words.
[[nodiscard]] std::vector<Phase> parsePhases(const std::vector<std::string>& words);

}  // namespace signorini::cli
