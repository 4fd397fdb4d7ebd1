#pragma once
/// \file
/// --motion FILE.csv|.vtk|.pvd: u, v, s over one period.

#include <csignal>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "files.hpp"

namespace CLI {
class App;
}

namespace signorini::cli {

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

/// Where a motion goes.
class MotionFile {
public:
    void addTo(CLI::App& command);

    [[nodiscard]] OutputOption option() const { return {"--motion", path_}; }
    /// The folder of a time series, an output like the file.
    [[nodiscard]] OutputOption folderOption() const { return {"--motion", folderOf(path_)}; }
    [[nodiscard]] bool isWanted() const { return !path_.empty(); }

    /// \throws std::invalid_argument on another ending.
    void validate() const;

    /// The samples with at most so many instants.
    using Sampling = std::function<MotionSamples(std::int64_t mostInstants)>;

    /// One call's file, and for .pvd the folder beside it: staged, and written with the others.
    class Staged {
    public:
        Staged(const MotionFile& file, OutputFiles& files);

        /// Writes what was asked for, nothing if nothing was. The last thing before `commit`: from
        /// here to the end of this object signals wait, as a folder is not removed by them.
        void write(const Sampling& sampled);

    private:
        std::string path_;
        OutputFiles& files_;
        std::string staged_;
        std::optional<SignalsHeld> held_;
    };

private:
    /// Empty if there is none.
    static std::string folderOf(const std::string& path);

    std::string path_;
};

}  // namespace signorini::cli
