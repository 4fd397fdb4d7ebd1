#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "arguments.hpp"

namespace signorini::cli {

Progress::Progress(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress()
{
    if (isDirty_) {
        tell("\r\033[K");
    }
}

void Progress::show(std::string_view words, double done, double total)
{
    constexpr std::chrono::milliseconds pause{200};
    const Clock::time_point now = Clock::now();
    if (before_ < 0.0) {
        before_ = done;
        start_ = now;
        return;
    }
    if (!shown_ || now - last_ < pause) {
        return;
    }
    last_ = now;
    isDirty_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double left = (total - done) / (done - before_) * seconds;
    tell(fmt::format("\r{:.1f} %, {}, {} left\033[K", 100.0 * done / total, words,
                     left < 120.0    ? fmt::format("{:.0f} s", std::ceil(left))
                     : left < 7200.0 ? fmt::format("{:.0f} min", left / 60.0)
                                     : fmt::format("{:.1f} h", left / 3600.0)));
}

}  // namespace signorini::cli
