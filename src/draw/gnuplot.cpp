#include "gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "signorini/motion.hpp"
#include "signorini/output.hpp"
#include "signorini/solver.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// A folder that vanishes with all it holds.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string pattern = (temporaryDirectory() / "signorini-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) {
            throw FileError(
                pattern, fmt::format("cannot create: {}", std::generic_category().message(errno)));
        }
        path_ = pattern;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }

    [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

private:
    fs::path path_;
};

std::string terminal(FigureFormat format, double width, double height)
{
    constexpr double pixelsPerCm = 80.0;  // about 200 dpi in print
    constexpr double svgUnitsPerCm = 60.0;
    switch (format) {
        case FigureFormat::svg:
            return fmt::format(
                "set terminal svg size {:.0f},{:.0f} dynamic font 'Sans,15' background '#ffffff'\n",
                width * svgUnitsPerCm, height * svgUnitsPerCm);
        case FigureFormat::png:
            return fmt::format("set terminal pngcairo size {:.0f},{:.0f} font 'Sans,20' lw 2\n",
                               width * pixelsPerCm, height * pixelsPerCm);
        case FigureFormat::pdf:
            return fmt::format("set terminal pdfcairo size {}cm,{}cm font 'Sans,9'\n", width,
                               height);
    }
    throw std::logic_error("unnamed FigureFormat");
}

/// What stands in the last bytes of a complete picture.
std::string_view ending(FigureFormat format)
{
    switch (format) {
        case FigureFormat::svg:
            return "</svg>";
        case FigureFormat::png:
            return "IEND";
        case FigureFormat::pdf:
            return "%%EOF";
    }
    throw std::logic_error("unnamed FigureFormat");
}

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs gnuplot and returns its wait status, or -1 if it could not be started.
int spawnGnuplot(const std::string& script, const std::string& messages)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    std::string program = "gnuplot";
    std::string defaults = "-d";  // without the user's own settings
    std::string argument = script;
    const std::array<char*, 4> arguments{program.data(), defaults.data(), argument.data(), nullptr};
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        return -1;
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

void runGnuplot(const std::string& script, FigureFormat format, double width, double height,
                const std::string& path)
{
    // gnuplot neither reports a full disk nor treats every name as a file: it writes to a name of
    // ours, and a complete picture is copied.
    const TemporaryFolder folder;
    const std::string scriptFile = folder.file("figure.gp");
    const std::string messages = folder.file("messages.txt");
    const std::string picture = folder.file("picture");
    TextFile file(scriptFile);
    file.write("set encoding utf8\n" + terminal(format, width, height) + "set output '" + picture +
               "'\n" + script + "\nset output\n");
    file.close();
    const int status = spawnGnuplot(scriptFile, messages);
    if (status == -1) {
        throw BackendUnavailable(
            "figures need the program gnuplot, which was not found: install it "
            "(Debian: gnuplot-nox)");
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        std::string said = contentOf(messages);
        std::replace(said.begin(), said.end(), '\n', ' ');
        throw BackendUnavailable(fmt::format("gnuplot failed: {}", said));
    }
    const std::string content = contentOf(picture);
    if (content.size() < 64 ||
        content.find(ending(format), content.size() - 64) == std::string::npos) {
        throw FileError(picture, "gnuplot left an incomplete picture (is the disk full?)");
    }
    TextFile target(path);
    target.write(content);
    target.close();
}

std::string viridis(std::size_t stops)
{
    constexpr std::array colours{"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
                                 "#28ae80", "#5ec962", "#addc30", "#fde725"};
    std::string text = "set palette defined (";
    for (std::size_t k = 0; k < std::min(stops, colours.size()); ++k) {
        text += fmt::format("{}{} '{}'", k == 0 ? "" : ", ", k, colours.at(k));
    }
    return text + ")\n";
}

std::vector<std::int64_t> evenly(std::int64_t last, std::int64_t most)
{
    std::vector<std::int64_t> values = thinned(last, most);
    if (values.size() > 2 && values.back() - values[values.size() - 2] != values[1]) {
        values.pop_back();
    }
    return values;
}

}  // namespace signorini
