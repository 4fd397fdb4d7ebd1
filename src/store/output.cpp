#include "signorini/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
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
