#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "arguments.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

std::string timeAsText(double seconds)
{
    return seconds < 120.0    ? fmt::format("{:.0f} s", std::ceil(seconds))
           : seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                              : fmt::format("{:.1f} h", seconds / 3600.0);
}

Progress::Progress(bool wanted, std::string words, const std::string& file)
    : words_(std::move(words)), isWanted_(wanted), isTerminal_(isatty(STDERR_FILENO) != 0)
{
    if (!file.empty()) {
        file_.open(file, std::ios::app);
        if (!file_) {
            throw FileError("--progress " + file, "cannot write it");
        }
    }
    if (!wanted && file.empty()) {
        return;
    }
    try {
        writer_ = std::thread([this] { write(); });
    } catch (const std::system_error&) {
        return;  // no thread to be had: no line
    }
}

Progress::~Progress()
{
    {
        const std::lock_guard lock(mutex_);
        isOver_ = true;
    }
    changed_.notify_all();
    if (writer_.joinable()) {
        writer_.join();
    }
}

void Progress::show(double done, double total)
{
    const std::lock_guard lock(mutex_);
    if (before_ < 0.0) {
        before_ = done;
        start_ = Clock::now();
    }
    done_ = std::min(done, total);
    total_ = total;
}

void Progress::show(std::string words, double done, double total)
{
    {
        const std::lock_guard lock(mutex_);
        words_ = std::move(words);
    }
    show(done, total);
}

std::string Progress::line() const
{
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (!(done_ > before_)) {
        return fmt::format("{}, {}", words_, timeAsText(seconds));
    }
    const double left = (total_ - done_) / (done_ - before_) * seconds;
    return fmt::format("{:.1f} %, {}, {} left", 100.0 * done_ / total_, words_, timeAsText(left));
}

void Progress::write()
{
    constexpr std::chrono::milliseconds pause{200};
    const auto start = Clock::now();
    auto toFile = start;
    auto toPeople = start;
    bool isDirty = false;
    const auto isDue = [](Clock::time_point& last, std::chrono::seconds between) {
        const bool isIt = Clock::now() - last >= between;
        last = isIt ? Clock::now() : last;
        return isIt;
    };
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, pause, [this] { return isOver_; })) {
        if (isWanted_ && isTerminal_) {
            tell(fmt::format("\r{}\033[K", line()));
            isDirty = true;
        }
        if (isWanted_ && !isTerminal_ && isDue(toPeople, std::chrono::seconds(10))) {
            tell(line() + "\n");
        }
        if (file_.is_open() && isDue(toFile, std::chrono::seconds(1))) {
            file_ << line() << std::endl;
        }
    }
    if (file_.is_open()) {
        file_ << line() << std::endl;
    }
    if (isDirty) {
        tell("\r\033[K");
    }
}

}  // namespace signorini::cli
