#pragma once
/// \file
/// Says how far long work has come.

#include <chrono>
#include <condition_variable>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>

#include "arguments.hpp"
#include "interrupt.hpp"
#include "watch.hpp"

namespace signorini::cli {

/// "12 s", "3 min", "1.5 h".
[[nodiscard]] std::string timeAsText(double seconds);

/// One line on standard error that is written anew, where that is a terminal, and removed at the
/// end; a line each ten seconds where it is none; with a file a line each second there, and a last
/// one. By a thread of its own, if `wanted` or there is a file. Started after an Interrupt, or a
/// signal may find its thread.
class Progress {
public:
    /// `words` for what is done: the line has the time spent, until `show` knows more.
    /// \throws FileError if the file cannot be written.
    Progress(bool wanted, std::string words, const std::string& file = {});
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
    bool isWanted_;
    bool isTerminal_;
    std::ofstream file_;
    double before_ = -1.0;  ///< done when the first call came, perhaps by an earlier run
    double done_ = -1.0;
    double total_ = 0.0;
    Clock::time_point start_ = Clock::now();
    std::thread writer_;
};

/// Work that signals end, and of which it is said how far it has come.
auto watched(const CommonOptions& common, const char* words, const auto& work)
{
    const Interrupt interrupt;
    Progress progress(!common.quiet, words, common.progressFile);
    return work(answers::Watch{interrupt.cancel(), [&progress](double done, double total) {
                                   progress.show(done, total);
                               }});
}

/// The same; `isInterrupted` says whether it was told to end.
auto watched(const CommonOptions& common, const char* words, const auto& work, bool& isInterrupted)
{
    return watched(common, words, [&](const answers::Watch& watch) {
        auto answer = work(watch);
        isInterrupted = isRequested(watch.cancel);
        return answer;
    });
}

}  // namespace signorini::cli
