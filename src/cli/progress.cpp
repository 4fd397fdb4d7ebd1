#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "arguments.hpp"

namespace signorini::cli {

namespace {

std::string timeAsText(double seconds)
{
    return seconds < 120.0    ? fmt::format("{:.0f} s", std::ceil(seconds))
           : seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                              : fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

Progress::Progress(bool wanted, std::string words) : words_(std::move(words))
{
    if (!wanted || isatty(STDERR_FILENO) == 0) {
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
    bool isDirty = false;
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, pause, [this] { return isOver_; })) {
        tell(fmt::format("\r{}\033[K", line()));
        isDirty = true;
    }
    if (isDirty) {
        tell("\r\033[K");
    }
}

}  // namespace signorini::cli
