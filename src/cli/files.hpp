#pragma once
/// \file
/// Files named on the command line: checks before any work, staging, and messages that name the
/// option.

#include <algorithm>
#include <csignal>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "signorini/figures.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

class Given;

/// \throws std::invalid_argument if two of these options name one file, or the folder of a time
/// series, or one names standard output.
void validateOutputs(const Given& given, const std::vector<const char*>& options);

/// Runs `action` and names the option and the user's file in what it throws.
auto forFile(const char* option, const std::string& path, auto action)
{
    try {
        return action();
    } catch (const FileError& error) {
        throw FileError(std::string(option) + " " + path, error.reason());
    }
}

/// Keeps SIGINT, SIGTERM and SIGHUP waiting while it lives.
class SignalsHeld {
public:
    SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    ~SignalsHeld();

private:
    sigset_t before_;
};

/// The files of one call, under temporary names until all of them are written. Those are removed if
/// a signal ends the program.
class Outputs {
public:
    /// Stages those of these options that were given. What `taken` name is not to be used by them.
    /// \throws as `validateOutputs`, FileError if a file could not be written.
    Outputs(const Given& given, const std::vector<const char*>& options,
            const std::vector<const char*>& taken = {});

    [[nodiscard]] bool areWanted() const { return !entries_.empty(); }
    [[nodiscard]] bool has(std::string_view option) const
    {
        return std::any_of(entries_.begin(), entries_.end(),
                           [option](const Entry& entry) { return entry.option == option; });
    }

    /// Calls write(name to write to, what) if the option was given.
    template <typename Write, typename... What>
    void put(std::string_view option, Write write, const What&... what)
    {
        if (has(option)) {
            const Entry& entry = entryOf(option);
            forFile(entry.option, entry.path, [&] { return write(entry.staged, what...); });
        }
    }
    /// Draws what make() makes, a figure or moving pictures, if the option was given.
    template <typename Make>
    void draw(std::string_view option, Make make)
    {
        put(option, [&](const std::string& staged) {
            if constexpr (std::is_same_v<std::invoke_result_t<Make>, FigureData>) {
                drawFigure(make(), figureFormat(entryOf(option).path), staged);
            } else {
                drawFigures(make(), animationFormat(entryOf(option).path), staged);
            }
        });
    }
    /// Writes --motion FILE.csv|.vtk|.pvd, if it was given; sampled(most) are the samples with at
    /// most so many instants. Last of all: beside a .pvd stands a folder, replaced whole, and as no
    /// signal removes a folder, signals wait from here on, until `commit` or the end of this
    /// object.
    void putMotion(const std::function<MotionSamples(std::int64_t most)>& sampled);

    void commit()
    {
        files_.commit();
        held_.reset();
    }

private:
    struct Entry {
        const char* option;
        std::string path;
        std::string staged;
    };

    /// \pre has(option).
    [[nodiscard]] const Entry& entryOf(std::string_view option) const
    {
        return *std::find_if(entries_.begin(), entries_.end(),
                             [option](const Entry& entry) { return entry.option == option; });
    }

    std::optional<SignalsHeld> held_;
    OutputFiles files_;
    std::vector<Entry> entries_;
};

}  // namespace signorini::cli
