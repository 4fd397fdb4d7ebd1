#include "signorini/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "printing.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t bufferSize = std::size_t{1} << 20;

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

void writeStateCsv(const std::string& path, const State& state, const Bar& bar, double base)
{
    const Scales unit = scales(bar);
    const Eigen::VectorXd v = velocity(state);
    const Eigen::VectorXd s = strain(state);
    const Eigen::VectorXd u = displacement(state);
    const double cellLength = bar.length / static_cast<double>(state.cells());
    writeCsv(path, "x,a,b,velocity,strain,displacement", [&](CsvRows& row) {
        for (Eigen::Index i = 0; i < state.cells(); ++i) {
            row(static_cast<double>(i + 1) * cellLength, inUnit(state.a[i], unit.strain),
                inUnit(state.b[i], unit.strain), inUnit(v[i], unit.velocity),
                inUnit(s[i], unit.strain), inUnit(base + u[i], unit.displacement));
        }
    });
}

}  // namespace signorini
