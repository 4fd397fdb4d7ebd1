#pragma once
/// \file
/// One line on a terminal that says how far long work has come.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace signorini::cli {

/// Written to standard error, by a thread of its own, if that is a terminal and `wanted`; removed
/// at the end. Started after an Interrupt, or a signal may find its thread.
class Progress {
public:
    /// `words` for what is done: the line has the time spent, until `show` knows more.
    Progress(bool wanted, std::string words);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// `done` of `total` parts of the work: share and time left, from the second call on.
    void show(double done, double total);
    /// The same, with other words.
    void show(std::string words, double done, double total);

private:
    using Clock = std::chrono::steady_clock;

    void write();
    [[nodiscard]] std::string line() const;

    std::mutex mutex_;
    std::condition_variable changed_;
    bool isOver_ = false;
    std::string words_;
    double before_ = -1.0;  ///< done when the first call came, perhaps by an earlier run
    double done_ = -1.0;
    double total_ = 0.0;
    Clock::time_point start_ = Clock::now();
    std::thread writer_;
};

}  // namespace signorini::cli
