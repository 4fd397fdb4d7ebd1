#include "gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

#include "signorini/output.hpp"
#include "solver.hpp"

namespace signorini {

namespace {

/// A temporary file without a name: it vanishes with the last program that has it open, however
/// that ends, and no name of a folder can get into a script.
class NamelessFile {
public:
    NamelessFile()
    {
        std::string name = (temporaryDirectory() / "signorini-XXXXXX").string();
        descriptor_ = mkstemp(name.data());
        if (descriptor_ < 0) {
            fail("create");
        }
        (void)unlink(name.c_str());
        (void)fcntl(descriptor_, F_SETFD, FD_CLOEXEC);
    }
    explicit NamelessFile(std::string_view content) : NamelessFile() { write(content); }
    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;
    ~NamelessFile() { ::close(descriptor_); }

    [[nodiscard]] int descriptor() const { return descriptor_; }

    [[nodiscard]] std::string content() const
    {
        std::string text;
        std::vector<char> block(std::size_t{1} << 16);
        ssize_t count = 0;
        while ((count = pread(descriptor_, block.data(), block.size(),
                              static_cast<off_t>(text.size()))) > 0) {
            text.append(block.data(), static_cast<std::size_t>(count));
        }
        if (count < 0) {
            fail("read");
        }
        return text;
    }

private:
    /// Leaves the file as it is read: from its beginning.
    void write(std::string_view rest) const
    {
        while (!rest.empty()) {
            const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
            if (written < 0 && errno != EINTR) {
                fail("write");
            }
            rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        }
        (void)lseek(descriptor_, 0, SEEK_SET);
    }

    [[noreturn]] static void fail(const char* action)
    {
        throw FileError("temporary file", fmt::format("cannot {}: {}", action,
                                                      std::generic_category().message(errno)));
    }

    int descriptor_ = -1;
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

/// Runs a program and returns its wait status, or -1 if it could not be started.
int spawn(std::vector<std::string> words, const NamelessFile& input, const NamelessFile& output,
          const NamelessFile& messages)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, messages.descriptor(), STDERR_FILENO);
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        return -1;
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/// What a program makes of its input. \throws BackendUnavailable if it is missing or fails.
std::string outputOf(const std::vector<std::string>& words, std::string_view input,
                     const char* missing)
{
    const NamelessFile given(input);
    const NamelessFile output;
    const NamelessFile messages;
    const int status = spawn(words, given, output, messages);
    if (status == -1) {
        throw BackendUnavailable(missing);
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        std::string said = messages.content();
        std::replace(said.begin(), said.end(), '\n', ' ');
        throw BackendUnavailable(fmt::format("{} failed: {}", words.front(), said));
    }
    return output.content();
}

/// gnuplot neither reports a full disk nor treats every name as a file: it writes to standard
/// output, and a complete picture is copied.
std::string drawn(const std::string& terminal, const std::string& script)
{
    // Without the user's own settings; /dev/stdin is read in blocks, "-" byte by byte.
    return outputOf({"gnuplot", "-d", "/dev/stdin"},
                    "set encoding utf8\n" + terminal + script + "\nset output\n",
                    "figures need the program gnuplot, which was not found: install it "
                    "(Debian: gnuplot-nox)");
}

void writeWhole(const std::string& path, const std::string& content, bool isComplete)
{
    if (!isComplete) {
        throw FileError(path, "gnuplot left an incomplete picture (is the disk full?)");
    }
    TextFile target(path);
    target.write(content);
    target.close();
}

}  // namespace

void runGnuplot(const std::string& script, FigureFormat format, double width, double height,
                const std::string& path)
{
    const std::string content = drawn(terminal(format, width, height), script);
    writeWhole(path, content,
               content.size() >= 64 &&
                   content.find(ending(format), content.size() - 64) != std::string::npos);
}

void runGnuplot(const std::string& script, AnimationFormat format, const std::string& path)
{
    const std::string gif = drawn(
        "set terminal gif animate delay 5 loop 0 optimize size 800,640 font 'Sans,11'\n", script);
    const bool isComplete = gif.starts_with("GIF89a") && gif.ends_with('\x3b');
    if (format == AnimationFormat::gif || !isComplete) {
        writeWhole(path, gif, isComplete);
        return;
    }
    // By its name the input can be searched, which reading a GIF needs, as "pipe:0" cannot.
    const std::string mp4 = outputOf(
        {"ffmpeg", "-nostdin", "-v", "error", "-f", "gif", "-i", "/dev/stdin", "-pix_fmt",
         "yuv420p", "-movflags", "frag_keyframe+empty_moov", "-f", "mp4", "pipe:1"},
        gif,
        ".mp4 needs the program ffmpeg, which was not found: install it (Debian: ffmpeg), or ask "
        "for a .gif");
    writeWhole(path, mp4, mp4.find("ftyp") != std::string::npos);
}

}  // namespace signorini
