#include "signorini/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace signorini {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t bufferSize = std::size_t{1} << 20;

/// The value times its unit, with -0 shown as 0.
double inUnit(double value, double unit)
{
    return value * unit + 0.0;
}

/// The nodes and instants of a motion that go into a file, in SI units.
class Samples {
public:
    std::vector<std::int64_t> nodes;
    std::vector<std::int64_t> instants;

    Samples(const Motion& motion, const Bar& bar)
        : nodes(thinned(motion.cells(), maxMotionNodes)),
          instants(thinned(motion.steps(), maxMotionInstants)),
          motion_(motion),
          unit_(scales(bar)),
          cellLength_(bar.length / static_cast<double>(motion.cells())),
          stepTime_(unit_.time / static_cast<double>(motion.cells()))
    {
    }

    [[nodiscard]] double x(std::int64_t i) const { return static_cast<double>(i) * cellLength_; }
    [[nodiscard]] double t(std::int64_t m) const { return static_cast<double>(m) * stepTime_; }

    [[nodiscard]] double displacement(std::int64_t i, std::int64_t m) const
    {
        return inUnit(motion_.displacement(i, m), unit_.displacement);
    }
    [[nodiscard]] double velocity(std::int64_t i, std::int64_t m) const
    {
        return inUnit(motion_.velocity(std::max<std::int64_t>(i, 1), m), unit_.velocity);
    }
    [[nodiscard]] double strain(std::int64_t i, std::int64_t m) const
    {
        return inUnit(motion_.strain(std::max<std::int64_t>(i, 1), m), unit_.strain);
    }

private:
    const Motion& motion_;
    Scales unit_;
    double cellLength_;  ///< [m]
    double stepTime_;    ///< [s]
};

template <typename... Args>
void print(TextFile& file, fmt::format_string<Args...> format, Args&&... args)
{
    fmt::memory_buffer line;
    fmt::format_to(std::back_inserter(line), format, std::forward<Args>(args)...);
    file.write({line.data(), line.size()});
}

std::string reasonOf(int error)
{
    return std::generic_category().message(error);
}

/// The file that a name stands for, also where it does not exist yet. \throws FileError on a loop.
fs::path withoutLinks(const std::string& path)
{
    constexpr int most = 40;
    fs::path target = fs::absolute(path).lexically_normal();
    std::error_code error;
    for (int k = 0; fs::is_symlink(fs::symlink_status(target, error)); ++k) {
        if (k == most) {
            throw FileError(path, fmt::format("cannot write: {}", reasonOf(ELOOP)));
        }
        target = (target.parent_path() / fs::read_symlink(target)).lexically_normal();
    }
    return target;
}

/// The fields of one CSV line, without spaces around them.
std::vector<std::string> fieldsOf(const std::string& line)
{
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',') {
            fields.emplace_back();
        } else if (c != ' ' && c != '\t' && c != '\r') {
            fields.back() += c;
        }
    }
    return fields;
}

/// Copies a staged file into a target that cannot be replaced by renaming.
void copyContent(const std::string& from, const std::string& to)
{
    TextFile target(to);
    const int source = open(from.c_str(), O_RDONLY | O_CLOEXEC);
    std::vector<char> block(bufferSize);
    ssize_t count = source < 0 ? -1 : 0;
    while (count >= 0 && (count = read(source, block.data(), block.size())) > 0) {
        target.write({block.data(), static_cast<std::size_t>(count)});
    }
    const int error = errno;
    if (source >= 0) {
        close(source);
    }
    if (count < 0) {
        throw FileError(from, fmt::format("cannot read: {}", reasonOf(error)));
    }
    target.close();
}

}  // namespace

fs::path temporaryDirectory()
{
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    if (error) {
        throw FileError("temporary folder", error.message());
    }
    return folder;
}

TextFile::TextFile(const std::string& path)
    : path_(path), descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666))
{
    if (descriptor_ < 0) {
        fail("open");
    }
    buffer_.reserve(bufferSize);
}

TextFile::~TextFile()
{
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

void TextFile::write(std::string_view text)
{
    buffer_ += text;
    if (buffer_.size() >= bufferSize) {
        flush();
    }
}

void TextFile::flush()
{
    std::string_view rest = buffer_;
    while (!rest.empty()) {
        const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
        if (written < 0 && errno != EINTR) {
            fail("write");
        }
        rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    buffer_.clear();
}

void TextFile::close()
{
    flush();
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) {
        fail("close");
    }
}

void TextFile::fail(const char* action) const
{
    throw FileError(path_, fmt::format("cannot {}: {}", action, reasonOf(errno)));
}

OutputFiles::~OutputFiles()
{
    for (const Entry& entry : entries_) {
        std::error_code ignored;
        fs::remove(entry.staged, ignored);
    }
}

std::string OutputFiles::stage(const std::string& path)
{
    const fs::path target = withoutLinks(path);
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) {
        throw FileError(path, "is a directory");
    }
    const bool isRegular = !fs::exists(status) || fs::is_regular_file(status);
    if (fs::exists(status) && access(target.c_str(), W_OK) != 0) {
        throw FileError(path, fmt::format("cannot write: {}", reasonOf(errno)));
    }
    const fs::path folder = isRegular ? target.parent_path() : temporaryDirectory();
    std::string staged = (folder / ".signorini-XXXXXX").string();
    const int descriptor = mkstemp(staged.data());
    if (descriptor < 0) {
        throw FileError(path, fmt::format("cannot write: {}", reasonOf(errno)));
    }
    // mkstemp keeps its file to the user; a result gets the mode of the file it replaces, or the
    // usual one.
    const mode_t mask = umask(0);
    umask(mask);
    const mode_t mode = fs::is_regular_file(status)
                            ? static_cast<mode_t>(status.permissions()) & 07777U
                            : 0666U & ~mask;
    (void)fchmod(descriptor, mode);
    ::close(descriptor);
    entries_.push_back({staged, target.string(), isRegular});
    return staged;
}

void OutputFiles::commit()
{
    // Targets that can fail half way come first: renaming does not.
    for (const Entry& entry : entries_) {
        if (!entry.isRegular) {
            copyContent(entry.staged, entry.target);
            fs::remove(entry.staged);
        }
    }
    for (const Entry& entry : entries_) {
        if (entry.isRegular) {
            std::error_code error;
            fs::rename(entry.staged, entry.target, error);
            if (error) {
                throw FileError(entry.target, fmt::format("cannot replace: {}", error.message()));
            }
        }
    }
    entries_.clear();
}

void writeStateCsv(const std::string& path, const State& state, const Bar& bar)
{
    const Scales unit = scales(bar);
    const Eigen::VectorXd v = velocity(state);
    const Eigen::VectorXd s = strain(state);
    const Eigen::VectorXd u = displacement(state);
    const double cellLength = bar.length / static_cast<double>(state.cells());
    TextFile file(path);
    file.write("x,a,b,velocity,strain,displacement\n");
    for (Eigen::Index i = 0; i < state.cells(); ++i) {
        print(file, "{},{},{},{},{},{}\n", static_cast<double>(i + 1) * cellLength,
              inUnit(state.a[i], unit.strain), inUnit(state.b[i], unit.strain),
              inUnit(v[i], unit.velocity), inUnit(s[i], unit.strain),
              inUnit(u[i], unit.displacement));
    }
    file.close();
}

State readStateCsv(const std::string& path, const Bar& bar)
{
    std::ifstream file(path);
    if (!file || fs::is_directory(path)) {
        throw FileError(path, fmt::format("cannot read: {}", reasonOf(file ? EISDIR : errno)));
    }
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = fieldsOf(line);
    const auto column = [&](const char* wanted) {
        const auto at = std::find(names.begin(), names.end(), wanted);
        if (at == names.end()) {
            throw std::invalid_argument(fmt::format(
                "{} line 1: no column {}: allowed a header with columns a and b", path, wanted));
        }
        return static_cast<std::size_t>(at - names.begin());
    };
    const std::size_t atA = column("a");
    const std::size_t atB = column("b");
    const double unit = scales(bar).strain;
    std::vector<double> a;
    std::vector<double> b;
    while (std::getline(file, line)) {
        const std::vector<std::string> fields = fieldsOf(line);
        const auto value = [&](std::size_t at) {
            double number = 0.0;
            const std::string text = at < fields.size() ? fields[at] : "";
            const auto [stop, error] =
                std::from_chars(text.data(), text.data() + text.size(), number);
            if (error != std::errc{} || stop != text.data() + text.size() ||
                !std::isfinite(number)) {
                throw std::invalid_argument(fmt::format("{} line {}: '{}': allowed finite numbers",
                                                        path, a.size() + 2, text));
            }
            return number / unit;
        };
        const double next = value(atA);
        b.push_back(value(atB));
        a.push_back(next);
    }
    if (a.empty()) {
        throw std::invalid_argument(fmt::format("{}: no rows: allowed one per cell", path));
    }
    const auto size = static_cast<Eigen::Index>(a.size());
    return {Eigen::Map<const Eigen::VectorXd>(a.data(), size),
            Eigen::Map<const Eigen::VectorXd>(b.data(), size)};
}

void writeMotionCsv(const std::string& path, const Motion& motion, const Bar& bar)
{
    const Samples samples(motion, bar);
    TextFile file(path);
    file.write("time,x,displacement,velocity,strain\n");
    for (const std::int64_t m : samples.instants) {
        for (const std::int64_t i : samples.nodes) {
            print(file, "{},{},{},{},{}\n", samples.t(m), samples.x(i), samples.displacement(i, m),
                  samples.velocity(i, m), samples.strain(i, m));
        }
    }
    file.close();
}

void writeMotionVtk(const std::string& path, const Motion& motion, const Bar& bar)
{
    const Samples samples(motion, bar);
    TextFile file(path);
    print(file,
          "# vtk DataFile Version 3.0\n"
          "signorini: motion of a bar until it repeats; x in m along X, time in s along Y\n"
          "ASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS {} {} 1\n",
          samples.nodes.size(), samples.instants.size());
    print(file, "X_COORDINATES {} double\n", samples.nodes.size());
    for (const std::int64_t i : samples.nodes) {
        print(file, "{}\n", samples.x(i));
    }
    print(file, "Y_COORDINATES {} double\n", samples.instants.size());
    for (const std::int64_t m : samples.instants) {
        print(file, "{}\n", samples.t(m));
    }
    print(file, "Z_COORDINATES 1 double\n0\nPOINT_DATA {}\n",
          samples.nodes.size() * samples.instants.size());
    const auto writeField = [&](const char* name, auto value) {
        print(file, "SCALARS {} double 1\nLOOKUP_TABLE default\n", name);
        for (const std::int64_t m : samples.instants) {
            for (const std::int64_t i : samples.nodes) {
                print(file, "{}\n", (samples.*value)(i, m));
            }
        }
    };
    writeField("displacement", &Samples::displacement);
    writeField("velocity", &Samples::velocity);
    writeField("strain", &Samples::strain);
    file.close();
}

}  // namespace signorini
