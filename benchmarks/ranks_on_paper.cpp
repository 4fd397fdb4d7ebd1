// The program signorini-ranks-on-paper: what an atlas would take on many processes, from the
// measured times of its batches. Rank r decides batches r, r + P, ..., at most two ahead of what
// rank 0 has taken; rank 0 writes them in their order. Messages are free: a batch is some
// kilobytes.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <random>
#include <vector>

#include "signorini/atlas_database.hpp"

namespace {

using namespace signorini;

double cpuSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// What a batch took [s] of the processor.
struct Task {
    double decide = 0.0;
    double write = 0.0;
};

/// Decides when asked, and sees how long the writer was away since it was asked last.
class TimedBatches : public BatchSource {
public:
    explicit TimedBatches(const AtlasRange& range) : range_(range) {}

    std::optional<AtlasBatch> next() override
    {
        const double begin = cpuSeconds();
        if (number_ > 0) {
            tasks.back().write = begin - left_;
        }
        if (number_ == batchesOf(range_)) {
            return std::nullopt;
        }
        std::optional<AtlasBatch> batch = decideBatch(range_, number_++, signs_);
        left_ = cpuSeconds();
        tasks.push_back({left_ - begin, 0.0});
        return batch;
    }

    std::vector<Task> tasks;

private:
    AtlasRange range_;
    std::int64_t number_ = 0;
    double left_ = 0.0;
    std::vector<std::int8_t> signs_;
};

std::vector<Task> measured(const AtlasRange& range)
{
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / "signorini-ranks-on-paper.sqlite";
    std::filesystem::remove(path);
    TimedBatches source(range);
    {
        AtlasDatabase database = AtlasDatabase::create(path.string());
        AtlasRun run = beginAtlas(database, range, {});
        fillAtlas(database, run, source, "1 thread", {});
    }
    std::filesystem::remove(path);
    return source.tasks;
}

/// [s], until the last batch is written.
double makespan(const std::vector<Task>& tasks, std::size_t ranks)
{
    std::vector<double> taken(tasks.size());  // when rank 0 has taken it
    std::vector<double> decided(tasks.size());
    double written = 0.0;
    for (std::size_t k = 0; k < tasks.size(); ++k) {
        const double free = k >= ranks ? decided[k - ranks] : 0.0;
        const double room = k >= 2 * ranks ? taken[k - 2 * ranks] : 0.0;
        decided[k] = std::max(free, room) + tasks[k].decide;
        taken[k] = std::max(written, decided[k]);
        written = taken[k] + tasks[k].write;
    }
    return written;
}

void report(const char* name, const AtlasRange& range)
{
    const std::vector<Task> tasks = measured(range);
    double decide = 0.0;
    double write = 0.0;
    double longest = 0.0;
    for (const Task& task : tasks) {
        decide += task.decide;
        write += task.write;
        longest = std::max(longest, task.decide);
    }
    const auto count = static_cast<double>(tasks.size());
    fmt::print("{}: {} batches, {:.3g} ms to decide one (at most {:.3g}), {:.3g} ms to write\n",
               name, tasks.size(), 1e3 * decide / count, 1e3 * longest, 1e3 * write / count);
    // A range of a hundred batches for each of a thousand ranks, drawn from those.
    std::mt19937_64 random(1);
    std::uniform_int_distribution<std::size_t> draw(0, tasks.size() - 1);
    std::vector<Task> many(100'000);
    double work = 0.0;
    for (Task& task : many) {
        task = tasks[draw(random)];
        work += task.decide + task.write;
    }
    for (const std::size_t ranks : {1, 2, 10, 100, 1000}) {
        const double time = makespan(many, ranks);
        fmt::print("  {:5} ranks: {:8.1f} s, speed-up {:6.1f}\n", ranks, time, work / time);
    }
}

}  // namespace

int main()
{
    report("two contacts, N = 20", {.cells = 20, .maxContact = 20, .maxFree = 60, .maxPhases = 2});
    report("two segments, 1 and 1.3, N = 20",
           {.cells = 20, .maxContact = 40, .maxFree = 120, .segments = {{10, 1.0}, {10, 1.3}}});
    report("one contact, N = 1000, all rows", {.cells = 1000, .maxContact = 2000, .maxFree = 4000});
    return 0;
}
