#pragma once
/// \file
/// Batches of an atlas in their order, whoever decides them: the threads of this process here, or
/// other processes (src/cli/ranks.hpp). The consumer cannot tell the difference, so neither
/// the number of workers nor their speed can change a result.

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "signorini/atlas_database.hpp"
#include "signorini/control.hpp"

namespace signorini {

/// Batches first, first + stride, first + 2 stride, ... of a range, decided by threads of this
/// process, which run ahead of the consumer by at most two batches each: memory stays flat. Where
/// the system starts fewer threads, those share the work; where none, the consumer does it.
class LocalBatches : public BatchSource {
public:
    /// \throws std::invalid_argument on an invalid range, first < 0, stride < 1 or threads < 1.
    LocalBatches(const AtlasRange& range, std::int64_t threads, Cancel cancel = {},
                 std::int64_t first = 0, std::int64_t stride = 1);
    ~LocalBatches() override;

    /// Threads that decide: those asked for, or as many as there could be.
    [[nodiscard]] std::int64_t threads() const { return std::max<std::int64_t>(1, started_); }

    /// Waits for the next batch. \throws what the thread that decided it has thrown.
    [[nodiscard]] std::optional<AtlasBatch> next() override;
    [[nodiscard]] std::optional<AtlasBatch> ready() override;

private:
    void start(std::int64_t threads);
    void work();
    [[nodiscard]] std::optional<AtlasBatch> decideHere();
    [[nodiscard]] AtlasBatch deliver(std::unique_lock<std::mutex> lock);

    AtlasRange range_;
    std::int64_t stride_;
    std::int64_t end_ = 0;            ///< numbers at and beyond it do not exist
    std::int64_t window_;             ///< [-], batches that may be under way or waiting
    std::int64_t started_ = 0;        ///< threads
    std::vector<std::int8_t> signs_;  ///< room to work in where there are none
    std::mutex mutex_;
    std::condition_variable changed_;
    std::atomic<bool> isEnding_ = false;
    std::int64_t toStart_;    ///< next batch for a thread to take
    std::int64_t toDeliver_;  ///< next batch for the consumer
    std::map<std::int64_t, AtlasBatch> done_;
    std::exception_ptr failure_;
    Cancel cancel_;
    std::vector<std::thread> threads_;
};

}  // namespace signorini
