#pragma once
/// \file
/// Wall time since a moment.

#include <chrono>

namespace signorini {

class Stopwatch {
public:
    /// [s], since construction or the last `restart`.
    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(Clock::now() - start_).count();
    }

    /// [s], as `seconds`, and counts from now on.
    double restart()
    {
        const double elapsed = seconds();
        start_ = Clock::now();
        return elapsed;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace signorini
