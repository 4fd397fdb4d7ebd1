#include "atlas_batches.hpp"

#include <chrono>
#include <new>
#include <system_error>
#include <utility>

#include "faults.hpp"

namespace signorini {

namespace {

/// How often a waiting consumer asks whether it is cancelled.
constexpr std::chrono::milliseconds pauseBetweenLooks{20};

}  // namespace

LocalBatches::LocalBatches(const AtlasRange& range, std::int64_t threads, Cancel cancel,
                           std::int64_t first, std::int64_t stride)
    : range_(range),
      stride_(stride),
      window_(2 * threads * stride),
      toStart_(first),
      toDeliver_(first),
      cancel_(std::move(cancel))
{
    validate(range);
    Faults faults;
    const auto check = [&faults](const char* field, std::int64_t value, std::int64_t least) {
        if (value < least) {
            faults.add(field, value, fmt::format("whole numbers >= {}", least));
        }
    };
    check("threads", threads, 1);
    check("first", first, 0);
    check("stride", stride, 1);
    faults.throwIfAny();
    end_ = batchesOf(range);
    start(threads);
}

void LocalBatches::start(std::int64_t threads)
{
    try {
        for (; started_ < threads; ++started_) {
            threads_.emplace_back([this] { work(); });
        }
    } catch (const std::system_error&) {
        return;  // the limit of processes or of memory: those that run do the work
    } catch (const std::bad_alloc&) {
        return;
    }
}

LocalBatches::~LocalBatches()
{
    isEnding_ = true;
    {
        const std::lock_guard lock(mutex_);  // none is between looking at isEnding_ and its sleep
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) {
        thread.join();
    }
}

void LocalBatches::work()
{
    const Cancel ends = [this] { return isEnding_ || isRequested(cancel_); };
    std::vector<std::int8_t> signs;
    while (!ends()) {
        std::int64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return isEnding_ || toStart_ - toDeliver_ < window_; });
            if (isEnding_ || toStart_ >= end_ || failure_) {
                return;
            }
            number = toStart_;
            toStart_ += stride_;
        }
        try {
            std::optional<AtlasBatch> batch = decideBatch(range_, number, signs, ends);
            if (!batch) {
                return;
            }
            const std::lock_guard lock(mutex_);
            done_.emplace(number, *std::move(batch));
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
        }
        changed_.notify_all();
    }
}

std::optional<AtlasBatch> LocalBatches::decideHere()
{
    if (toDeliver_ >= end_ || isRequested(cancel_)) {
        return std::nullopt;
    }
    std::optional<AtlasBatch> batch = decideBatch(range_, toDeliver_, signs_, cancel_);
    toDeliver_ += stride_;
    return batch;
}

std::optional<AtlasBatch> LocalBatches::next()
{
    if (started_ == 0) {
        return decideHere();
    }
    std::unique_lock lock(mutex_);
    const auto isReady = [this] { return failure_ || done_.contains(toDeliver_); };
    if (toDeliver_ >= end_) {
        return std::nullopt;
    }
    while (!isRequested(cancel_) && !isReady()) {
        changed_.wait_for(lock, pauseBetweenLooks);
    }
    if (isRequested(cancel_)) {
        return std::nullopt;
    }
    if (failure_) {
        std::rethrow_exception(failure_);
    }
    return deliver(std::move(lock));
}

std::optional<AtlasBatch> LocalBatches::ready()
{
    std::unique_lock lock(mutex_);
    return done_.contains(toDeliver_) ? std::optional(deliver(std::move(lock))) : std::nullopt;
}

AtlasBatch LocalBatches::deliver(std::unique_lock<std::mutex> lock)
{
    auto node = done_.extract(toDeliver_);
    toDeliver_ += stride_;
    lock.unlock();
    changed_.notify_all();
    return std::move(node.mapped());
}

}  // namespace signorini
