#pragma once
/// \file
/// Files: states and motions in SI units, and a way to write several files whole or not at all.
///
/// Numbers are printed in the shortest form that reads back exactly.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/continuum.hpp"
#include "signorini/control.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// Where temporary files go. \throws FileError if the system names no usable folder.
[[nodiscard]] std::filesystem::path temporaryDirectory();

/// Writes text to one file through a buffer. Every failure throws FileError, that of closing too.
class TextFile {
public:
    /// Creates the file or empties it.
    explicit TextFile(const std::string& path);
    TextFile(const TextFile&) = delete;
    TextFile& operator=(const TextFile&) = delete;
    ~TextFile();

    /// Appends text.
    void write(std::string_view text);
    /// Flushes and closes; must be called for the file to count as written.
    void close();

private:
    void flush();
    [[noreturn]] void fail(const char* action) const;

    std::string path_;
    int descriptor_ = -1;
    std::string buffer_;
};

/// Where the file of a name goes: absolute, and without links even if they lead to what does not
/// exist yet. \throws FileError on a loop, a missing folder, a name too long.
[[nodiscard]] std::filesystem::path outputPlace(const std::string& path);

/// Whether two names stand for one file, through links of every kind. \throws FileError.
[[nodiscard]] bool isSameOutput(const std::string& path, const std::string& other);

/// A set of files that appear together: each is written under a temporary name beside its target,
/// and `commit` renames all of them into place; if one cannot be, those before it are put back.
/// What is not committed is removed. Existing files keep their permissions, symbolic links are
/// followed, and a target that is no regular file (a pipe) receives its content at `commit`, after
/// all others are in place: only what has gone into such a target cannot be taken back.
class OutputFiles {
public:
    OutputFiles() = default;
    OutputFiles(const OutputFiles&) = delete;
    OutputFiles& operator=(const OutputFiles&) = delete;
    ~OutputFiles();

    /// The temporary name to write to; errors of `commit` call the file `name`, or else its path.
    /// \throws FileError if `path` is a directory or read-only, or its folder does not exist or
    /// cannot be written to.
    [[nodiscard]] std::string stage(const std::string& path, const std::string& name = {});

    /// Where `commit` keeps a file for the time it may have to be put back.
    [[nodiscard]] static std::string keptName(const std::string& staged) { return staged + "~"; }

    /// Puts every staged file into place, or none. \throws FileError.
    void commit();

private:
    struct Entry {
        std::string staged;
        std::string target;
        std::string name;
        bool isRegular;
        bool isKept = false;    ///< the former file is at keptName(staged), too
        bool isPlaced = false;  ///< the target is the new file
    };

    static void replace(Entry& entry, bool keepsOld);
    static void restore(const Entry& entry);

    std::vector<Entry> entries_;
};

/// x, a, b, velocity, strain, displacement: row i is x_i = i dx and holds the values on cell i and
/// u(x_i); [m], [-], [-], [m/s], [-], [m] with v = c (a + b), s = b - a. \throws FileError.
void writeStateCsv(const std::string& path, const State& state, const Bar& bar);

/// Reads columns a and b of such a file, wherever they stand; the numbers in other columns are not
/// needed. The file may be a pipe. A file that was cut short does not pass: every row has as many
/// fields as the header and ends with a newline. At most `mostCells` rows are read.
/// \throws FileError if it cannot be read, std::invalid_argument naming file, line, column and
/// fault if it has no such columns, no rows or too many, or a value that is no finite number.
[[nodiscard]] State readStateCsv(const std::string& path, const Bar& bar,
                                 std::int64_t mostCells = maxCells);

/// Most nodes and instants in a motion file; longer motions are thinned out evenly.
inline constexpr std::int64_t maxMotionNodes = 1001;
inline constexpr std::int64_t maxMotionInstants = 2001;  ///< see maxMotionNodes

/// time, x, displacement, velocity, strain over `Motion::steps`, one period unless the schedule has
/// flights of 4N steps and more, which only repeat; instant by instant; [s], [m], [m],
/// [m/s], [-]. At node i velocity and strain are those of cell i (cell 1 at the clamp).
/// \throws FileError.
void writeMotionCsv(const std::string& path, const Motion& motion, const Bar& bar);

/// The same as a legacy VTK rectilinear grid (x, t), for ParaView. \throws FileError.
void writeMotionVtk(const std::string& path, const Motion& motion, const Bar& bar);

/// One row per point: lambda, a_1..a_N, b_1..b_N, the waves as strains [-]. \throws FileError.
void writeContinuumCsv(const std::string& path, const Continuum& curve);

}  // namespace signorini
