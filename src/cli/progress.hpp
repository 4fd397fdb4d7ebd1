#pragma once
/// \file
/// One line on a terminal that says how far long work has come.

#include <chrono>
#include <string_view>

namespace signorini::cli {

/// Written to standard error if that is a terminal and `wanted`; removed at the end.
class Progress {
public:
    explicit Progress(bool wanted);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// `done` of `total` parts of the work, in words, at most a few times a second: share and time
    /// left, from the second call on.
    void show(std::string_view words, double done, double total);

private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    bool isDirty_ = false;
    double before_ = -1.0;  ///< done when the first call came, perhaps by an earlier run
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

}  // namespace signorini::cli
