#include <mpi.h>

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "bytes.hpp"
#include "ranks.hpp"

namespace signorini::cli {

namespace {

/// Sends a text from rank 0 to all, and returns it: what workers are called to, as a number or a
/// few, a mark, and what they are of; an empty one sends them home.
std::string broadcast(std::string text)
{
    auto size = static_cast<std::int64_t>(text.size());
    MPI_Bcast(&size, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
    text.resize(static_cast<std::size_t>(size));
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD);
    return text;
}

/// What a message means.
enum Tag : int {
    tagBatch = 1,  ///< worker to rank 0: a batch
    tagEnd = 2,    ///< worker to rank 0: no more will come
    tagStop = 3,   ///< rank 0 to worker: no more are needed
};

/// MPI waits by spinning, which would take the core from a thread that decides.
void rest()
{
    std::this_thread::sleep_for(std::chrono::microseconds(100));
}

/// What has arrived from a rank, or from anyone.
struct Arrived {
    std::string bytes;
    int tag;
};
std::optional<Arrived> arrived(int rank)
{
    int hasArrived = 0;
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status status;
    MPI_Improbe(rank, MPI_ANY_TAG, MPI_COMM_WORLD, &hasArrived, &message, &status);
    if (hasArrived == 0) {
        return std::nullopt;
    }
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Arrived all{std::string(static_cast<std::size_t>(size), ' '), status.MPI_TAG};
    MPI_Mrecv(all.bytes.data(), size, MPI_BYTE, &message, MPI_STATUS_IGNORE);
    return all;
}

/// Rank 0's view of the work of all.
class SharedBatches : public BatchSource {
public:
    SharedBatches(int count, const AtlasRange& range, std::int64_t threads, Cancel cancel,
                  std::int64_t first)
        : count_(count),
          first_(first),
          toDeliver_(first),
          end_(batchesOf(range)),
          cancel_(cancel),
          own_(range, threads, std::move(cancel), first, count),
          hasEnded_(static_cast<std::size_t>(count), false)
    {
    }

    /// Takes what is still on its way, so that no worker waits for ever.
    ~SharedBatches() override
    {
        for (int rank = 1; rank < count_; ++rank) {
            MPI_Send(nullptr, 0, MPI_BYTE, rank, tagStop, MPI_COMM_WORLD);
        }
        for (int rank = 1; rank < count_; ++rank) {
            while (!hasEnded_[static_cast<std::size_t>(rank)]) {
                (void)receive(rank);
                rest();
            }
        }
    }

    std::optional<AtlasBatch> next() override
    {
        if (toDeliver_ >= end_) {
            return std::nullopt;
        }
        if (owner() == 0) {
            ++toDeliver_;
            return own_.next();
        }
        while (!isRequested(cancel_) && !hasEnded_[static_cast<std::size_t>(owner())]) {
            if (std::optional<AtlasBatch> batch = ready()) {
                return batch;
            }
            rest();
        }
        return std::nullopt;
    }

    std::optional<AtlasBatch> ready() override
    {
        if (toDeliver_ >= end_) {
            return std::nullopt;
        }
        std::optional<AtlasBatch> batch = owner() == 0 ? own_.ready() : receive(owner());
        toDeliver_ += batch ? 1 : 0;
        return batch;
    }

private:
    /// Who decides the next batch.
    [[nodiscard]] int owner() const { return static_cast<int>((toDeliver_ - first_) % count_); }

    /// A batch of that rank if one has arrived; notes its end.
    std::optional<AtlasBatch> receive(int rank)
    {
        const std::optional<Arrived> message = arrived(rank);
        if (!message) {
            return std::nullopt;
        }
        if (message->tag == tagEnd) {
            hasEnded_[static_cast<std::size_t>(rank)] = true;
            return std::nullopt;
        }
        answers::Reader from{message->bytes};
        return answers::take<AtlasBatch>(from);
    }

    int count_;
    std::int64_t first_;
    std::int64_t toDeliver_;
    std::int64_t end_;
    Cancel cancel_;
    LocalBatches own_;
    std::vector<bool> hasEnded_;
};

bool isStopped()
{
    int hasArrived = 0;
    MPI_Iprobe(0, tagStop, MPI_COMM_WORLD, &hasArrived, MPI_STATUS_IGNORE);
    return hasArrived != 0;
}

/// Of the pieces of work those that fall to a rank.
std::vector<std::size_t> partOf(const std::vector<std::size_t>& which, int rank, int count)
{
    std::vector<std::size_t> part;
    for (auto k = static_cast<std::size_t>(rank); k < which.size();
         k += static_cast<std::size_t>(count)) {
        part.push_back(which[k]);
    }
    return part;
}

/// Rows by threads of this process, while this thread, the only one that speaks MPI, hands on what
/// is done: `each(k, row)` there, `meanwhile()` again and again until it is false.
void workBeside(const std::vector<std::size_t>& which, const RowOf& row, std::int64_t threads,
                const TakeRow& each, const std::function<bool()>& meanwhile)
{
    std::mutex mutex;
    std::vector<std::pair<std::size_t, std::string>> done;
    bool isOver = false;
    std::exception_ptr trouble;
    std::thread worker([&] {
        try {
            byThreads(row, threads)(which, [&](std::size_t k, const std::string& text) {
                const std::lock_guard lock(mutex);
                done.emplace_back(k, text);
            });
        } catch (...) {
            trouble = std::current_exception();
        }
        const std::lock_guard lock(mutex);
        isOver = true;
    });
    for (bool goesOn = true; goesOn;) {
        std::vector<std::pair<std::size_t, std::string>> ready;
        {
            const std::lock_guard lock(mutex);
            ready.swap(done);
            goesOn = !isOver;
        }
        for (const auto& [k, text] : ready) {
            each(k, text);
        }
        goesOn = meanwhile() || goesOn || !ready.empty();
        rest();
    }
    worker.join();
    if (trouble) {
        std::rethrow_exception(trouble);
    }
}

}  // namespace

void handOverToMpi(char**) {}

Ranks::Ranks()
{
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks()
{
    if (!wasCalled_) {
        // Wrong use, or a question to the database: rank 0 says that nothing is to be done, and
        // the others, who wait for its word in any case, hear it.
        (void)broadcast("");
    }
    MPI_Finalize();
}

std::unique_ptr<BatchSource> Ranks::share(const AtlasRange& range, std::int64_t threads,
                                          Cancel cancel, std::int64_t first)
{
    // The call comes last: workers wait for it, and nothing can fail after it.
    auto batches =
        std::make_unique<SharedBatches>(count_, range, threads, std::move(cancel), first);
    wasCalled_ = true;
    (void)broadcast(fmt::format("{}\n{}", first, textOf(range)));
    return batches;
}

bool Ranks::serve(std::int64_t threads, const Cancel& cancel)
{
    wasCalled_ = true;
    const std::string call = broadcast("");
    if (call.empty()) {
        return true;
    }
    const std::size_t mark = call.find('\n');
    const AtlasRange range = rangeOf(std::string_view(call).substr(mark + 1));
    bool isWanted = true;
    {
        LocalBatches own(range, threads, cancel, std::stoll(call.substr(0, mark)) + rank_, count_);
        std::optional<AtlasBatch> batch;
        while (isWanted && (batch = own.next())) {
            answers::Writer packed;
            pass(packed, *batch);
            const std::string& bytes = packed.bytes;
            MPI_Request request = MPI_REQUEST_NULL;
            MPI_Isend(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, tagBatch,
                      MPI_COMM_WORLD, &request);
            int isSent = 0;
            MPI_Test(&request, &isSent, MPI_STATUS_IGNORE);
            while (isSent == 0) {
                rest();
                MPI_Test(&request, &isSent, MPI_STATUS_IGNORE);
            }
            isWanted = !isStopped();
        }
    }
    MPI_Send(nullptr, 0, MPI_BYTE, 0, tagEnd, MPI_COMM_WORLD);
    while (!isStopped()) {
        rest();
    }
    MPI_Recv(nullptr, 0, MPI_BYTE, 0, tagStop, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return !isRequested(cancel);
}

DealRows Ranks::dealt(std::string question, const RowOf& row, std::int64_t threads)
{
    return [this, question = std::move(question), row, threads](
               const std::vector<std::size_t>& which, const TakeRow& take) {
        wasCalled_ = true;
        (void)broadcast(fmt::format("{}\n{}", fmt::join(which, " "), question));
        int working = count_ - 1;
        workBeside(partOf(which, 0, count_), row, threads, take, [&] {
            while (const std::optional<Arrived> message = arrived(MPI_ANY_SOURCE)) {
                const std::string& text = message->bytes;
                const std::size_t mark = text.find(' ');
                if (mark == std::string::npos) {
                    --working;  // an empty one: it has ended
                } else {
                    take(std::stoull(text.substr(0, mark)), text.substr(mark + 1));
                }
            }
            return working > 0;
        });
    };
}

bool Ranks::serveRows(const std::function<RowOf(const std::string&)>& rows, std::int64_t threads)
{
    wasCalled_ = true;
    const std::string call = broadcast("");
    if (call.empty()) {
        return true;
    }
    const std::size_t mark = call.find('\n');
    std::vector<std::size_t> which;
    std::istringstream words(call.substr(0, mark));
    for (std::size_t k = 0; words >> k;) {
        which.push_back(k);
    }
    const std::vector<std::size_t> part = partOf(which, rank_, count_);
    std::size_t sent = 0;
    const auto send = [](const std::string& text) {
        MPI_Send(text.data(), static_cast<int>(text.size()), MPI_BYTE, 0, tagBatch, MPI_COMM_WORLD);
    };
    workBeside(
        part, rows(call.substr(mark + 1)), threads,
        [&](std::size_t k, const std::string& text) {
            send(fmt::format("{} {}", k, text));
            ++sent;
        },
        [] { return false; });
    send("");
    return sent == part.size();
}

}  // namespace signorini::cli
