#pragma once
/// \file
/// Files: states and motions in SI units, and a way to write several files atomically.
///
/// Numbers are printed in the shortest form that reads back exactly.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/continuum.hpp"
#include "signorini/control.hpp"
#include "signorini/modes.hpp"
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

    /// The same for a folder of files that belong together: an empty one with a temporary name. A
    /// folder that is there is replaced whole, if it holds nothing but files that end in `ending`.
    /// \throws FileError if it holds others or is none, or as above.
    [[nodiscard]] std::string stageFolder(const std::string& path, const std::string& ending,
                                          const std::string& name = {});

    /// Where `commit` keeps a file for the time it may have to be put back.
    [[nodiscard]] static std::string keptName(const std::string& staged) { return staged + "~"; }

    /// Puts every staged file into place, or none. \throws FileError.
    void commit();

private:
    struct Entry {
        std::string staged;
        std::string target;
        std::string name;
        bool isRegular;  ///< or a folder: put into place by renaming
        bool isFolder = false;
        bool isKept = false;    ///< the former file is at keptName(staged), too
        bool isPlaced = false;  ///< the target is the new file
    };

    static void replace(Entry& entry, bool keepsOld);
    static void restore(const Entry& entry);

    std::vector<Entry> entries_;
};

/// x, a, b, velocity, strain, displacement: row i is x_i = i dx and holds the values on cell i and
/// u(x_i); [m], [-], [-], [m/s], [-], [m] with v = c (a + b), s = b - a, the base standing at
/// `base` [g]. \throws FileError.
void writeStateCsv(const std::string& path, const State& state, const Bar& bar, double base = 0.0);

/// A state from a file.
struct StateReading {
    State state;
    std::int64_t rows = 0;  ///< read
    std::string how;        ///< what was done with them, e.g. "velocity and strain in 57 rows, ..."
    /// [g], where the base stands, if waves come with displacements.
    std::optional<double> base = std::nullopt;
};

/// Most rows of measurements in a file.
inline constexpr std::int64_t maxMeasurements = 1'000'000;

/// Reads a table with a header that names columns, in any order; others are not needed:
///
/// - a, b [-]: the waves, one row per cell, as `writeStateCsv` has them
/// - x [m], velocity [m/s] (or v), strain [-] (or s): measurements at two places or more
/// - x [m], velocity [m/s] (or v), displacement [m] (or u): the same
///
/// the first of these that is there. Measurements stand in ascending x in [0, L]. They are joined
/// by straight lines (constant beyond the ends; u starts from 0 at the clamp and goes on straight
/// at the tip), and cell i gets the mean over it: an average of many, an interpolation of few. N
/// rows at x_i = i dx are the values on the cells, as in our own files.
///
/// Fields are separated by commas, or by semicolons if the header has any. Lines that begin with #
/// are not read, nor is a byte order mark. The file may be a pipe. One that was cut short does not
/// pass: every row has as many fields as the header and ends with a newline.
/// \throws FileError if it cannot be read, std::invalid_argument naming file, line, column and
/// fault if it has no such columns, too few rows or too many (of waves more than `mostCells`, or,
/// if that is not given, than `cells`), or a value that is no finite number or out of place.
[[nodiscard]] StateReading readState(const std::string& path, const Bar& bar, std::int64_t cells,
                                     std::optional<std::int64_t> mostCells = {});

class HarmonicField;

/// Most nodes and instants in a motion file; longer motions are thinned out evenly.
inline constexpr std::int64_t maxMotionNodes = 1001;
inline constexpr std::int64_t maxMotionInstants = 2001;  ///< see maxMotionNodes

/// Several bars at places and instants, in SI units; values instant by instant.
struct BarsSampled {
    std::vector<double> x = {};      ///< along the bars end to end
    std::vector<double> xCell = {};  ///< middle of the cell that ends there
    std::vector<double> times = {};
    std::vector<double> displacements = {};
    std::vector<double> velocities = {};
    std::vector<double> strains = {};
};

/// The nodes and instants of a motion that go into a file, in SI units. At a node velocity and
/// strain are those of the cell that ends there (at the clamp of the first one).
class MotionSamples {
public:
    /// Over `Motion::steps`: one period unless the schedule has flights of 4N steps and more, which
    /// only repeat. Refers to the motion.
    MotionSamples(const Motion& motion, const Scene& scene,
                  std::int64_t mostInstants = maxMotionInstants);
    /// One period on the nodes of N cells; velocity and strain are those in the middle of a cell.
    /// Refers to the motion.
    MotionSamples(const ModeMotion& motion, const Bar& bar, std::int64_t cells,
                  std::int64_t mostInstants = maxMotionInstants);
    /// The same of a motion under an exact harmonic.
    MotionSamples(const HarmonicField& motion, Scene scene, std::int64_t cells,
                  std::int64_t mostInstants = maxMotionInstants);
    /// What was sampled elsewhere.
    explicit MotionSamples(BarsSampled sampled);

    [[nodiscard]] std::size_t nodes() const { return x_.size(); }
    [[nodiscard]] std::size_t instants() const { return times_.size(); }
    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const Bar& bar() const { return scene_.bar; }
    [[nodiscard]] double x(std::size_t node) const { return x_[node]; }               ///< [m]
    [[nodiscard]] double xCell(std::size_t node) const { return xCell_[node]; }       ///< [m]
    [[nodiscard]] double time(std::size_t instant) const { return times_[instant]; }  ///< [s]
    [[nodiscard]] double displacement(std::size_t node, std::size_t instant) const;   ///< [m]
    [[nodiscard]] double velocity(std::size_t node, std::size_t instant) const;       ///< [m/s]
    [[nodiscard]] double strain(std::size_t node, std::size_t instant) const;         ///< [-]
    /// EA s, with EA that of the node's segment [N].
    [[nodiscard]] double force(std::size_t node, std::size_t instant) const;

private:
    using Field = std::function<double(std::size_t node, std::size_t instant)>;
    template <typename Functions>
    void sample(const Functions& motion, std::int64_t cells, std::int64_t mostInstants);

    Scene scene_;
    std::vector<double> x_;
    std::vector<double> xCell_;  ///< middle of the cell that ends there, at the clamp of the first
    std::vector<double> times_;
    Field displacement_;  ///< in scaled units, like the others
    Field velocity_;
    Field strain_;
    std::vector<double> stiffness_;  ///< EA at each node, relative to the first segment
};

/// time, x, displacement, velocity, strain, x_cell; instant by instant; [s], [m], [m], [m/s], [-],
/// [m]. The displacement is that of x, velocity and strain are those of x_cell, the middle of a
/// cell: at nodes fronts pass and they jump.
/// \throws FileError.
void writeMotionCsv(const std::string& path, const MotionSamples& samples);

/// The same as a legacy VTK rectilinear grid (x, t), for ParaView. \throws FileError.
void writeMotionVtk(const std::string& path, const MotionSamples& samples);

/// Most instants of a time series: a file each.
inline constexpr std::int64_t maxSeriesInstants = 401;

/// A ParaView time series: the collection `path` (.pvd) and, in the existing empty folder `folder`,
/// a .vtu file per instant, which the collection finds in `name` beside itself. The bar is a strip
/// L/20 high whose points stand where the bar is; cells carry velocity [m/s], strain [-] and force
/// EA s [N], tension > 0; points the vector displacement [m] (with "Warp By Vector" the motion is
/// seen larger). Part 1 is the wall, displaced by g from the tip at rest, to warp alike.
/// \throws FileError.
void writeMotionSeries(const std::string& path, const std::string& folder, const std::string& name,
                       const MotionSamples& samples);

/// One row per point: lambda, a_1..a_N, b_1..b_N, the waves as strains [-]. \throws FileError.
void writeContinuumCsv(const std::string& path, const Continuum& curve);

}  // namespace signorini
