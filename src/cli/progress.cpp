#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace signorini::cli {

Progress::Progress(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress()
{
    if (isDirty_) {
        fmt::print(stderr, "\r\033[K");
    }
}

void Progress::show(std::string_view what, double done, double total)
{
    constexpr std::chrono::milliseconds pause{200};
    const Clock::time_point now = Clock::now();
    if (before_ < 0.0) {
        before_ = done;
        start_ = now;
    }
    if (!shown_ || now - last_ < pause) {
        return;
    }
    last_ = now;
    isDirty_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double rate = (done - before_) / seconds;
    const double left = std::ceil((total - done) / rate);
    fmt::print(stderr, "\r{} {:.1f} %, {:.3g} a second, {} left\033[K", what, 100.0 * done / total,
               rate,
               !std::isfinite(left) ? std::string("…")
               : left < 120.0       ? fmt::format("{:.0f} s", left)
               : left < 7200.0      ? fmt::format("{:.0f} min", left / 60.0)
                                    : fmt::format("{:.1f} h", left / 3600.0));
    (void)std::fflush(stderr);
}

}  // namespace signorini::cli
