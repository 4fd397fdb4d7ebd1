// The program signorini-ranks-on-paper: what an atlas would take on many processes, from the
// measured times of its batches. Rank r decides batches r, r + P, ..., at most two ahead of what
// rank 0 has taken; rank 0 writes all that are decided, in their order, in one transaction.
// Messages are free: a batch is some kilobytes.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <random>
#include <vector>

#include "signorini/atlas_database.hpp"

namespace {

using namespace signorini;

double cpuSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

constexpr std::int64_t mostAtOnce = 256;  ///< as fillAtlas has it

/// What batches took [s] of the processor.
struct Measured {
    std::vector<double> decide;
    double write = 0.0;  ///< of all
};

/// Decides when asked, and sees how long the writer was away; `atOnce` are ready together.
class TimedBatches : public BatchSource {
public:
    TimedBatches(const AtlasRange& range, std::int64_t atOnce) : range_(range), atOnce_(atOnce) {}

    std::optional<AtlasBatch> next() override
    {
        const double begin = cpuSeconds();
        times.write += number_ > 0 ? begin - left_ : 0.0;
        if (number_ == batchesOf(range_)) {
            return std::nullopt;
        }
        std::optional<AtlasBatch> batch = decideBatch(range_, number_++, signs_);
        left_ = cpuSeconds();
        times.decide.push_back(left_ - begin);
        return batch;
    }

    std::optional<AtlasBatch> ready() override
    {
        return number_ % atOnce_ == 0 || number_ == batchesOf(range_) ? std::nullopt : next();
    }

    Measured times;

private:
    AtlasRange range_;
    std::int64_t atOnce_;
    std::int64_t number_ = 0;
    double left_ = 0.0;
    std::vector<std::int8_t> signs_;
};

Measured measured(const AtlasRange& range, std::int64_t atOnce)
{
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / "signorini-ranks-on-paper.sqlite";
    std::filesystem::remove(path);
    TimedBatches source(range, atOnce);
    {
        AtlasDatabase database = AtlasDatabase::create(path.string());
        AtlasRun run = beginAtlas(database, range, {});
        fillAtlas(database, run, source, "1 thread", {});
    }
    std::filesystem::remove(path);
    return source.times;
}

/// [s], until the last batch is written: `row` for each, `end` for each transaction.
double makespan(const std::vector<double>& decide, double row, double end, std::size_t ranks)
{
    std::vector<double> taken(decide.size());  // when rank 0 has taken it
    std::vector<double> decided(decide.size());
    double written = 0.0;
    for (std::size_t k = 0, first = 0; k < decide.size(); ++k) {
        const double free = k >= ranks ? decided[k - ranks] : 0.0;
        const double room = k >= 2 * ranks ? taken[k - 2 * ranks] : 0.0;
        decided[k] = std::max(free, room) + decide[k];
        // With those before it, if it is there when they are taken.
        const bool joins =
            k > 0 && decided[k] <= taken[k - 1] && k - first < static_cast<std::size_t>(mostAtOnce);
        first = joins ? first : k;
        taken[k] = joins ? taken[k - 1] : std::max(written, decided[k]);
        written = (joins ? written : taken[k] + end) + row;
    }
    return written;
}

void report(const char* name, const AtlasRange& range)
{
    const Measured alone = measured(range, 1);
    const Measured together = measured(range, mostAtOnce);
    const auto count = static_cast<double>(alone.decide.size());
    const double all = std::accumulate(alone.decide.begin(), alone.decide.end(), 0.0);
    // count (row + end) and count row + end count/mostAtOnce.
    const double end = (alone.write - together.write) / (count - std::ceil(count / mostAtOnce));
    const double row = alone.write / count - end;
    fmt::print(
        "{}: {} batches, {:.3g} ms to decide one (at most {:.3g}), {:.3g} ms to write it "
        "and {:.3g} ms to end a transaction\n",
        name, alone.decide.size(), 1e3 * all / count,
        1e3 * *std::max_element(alone.decide.begin(), alone.decide.end()), 1e3 * row, 1e3 * end);
    // A range of a hundred batches for each of a thousand ranks, drawn from those.
    std::mt19937_64 random(1);
    std::uniform_int_distribution<std::size_t> draw(0, alone.decide.size() - 1);
    std::vector<double> many(100'000);
    for (double& task : many) {
        task = alone.decide[draw(random)];
    }
    const double one = makespan(many, row, end, 1);
    for (const std::size_t ranks : {1, 2, 10, 100, 1000}) {
        const double time = makespan(many, row, end, ranks);
        fmt::print("  {:5} ranks: {:8.1f} s, speed-up {:6.1f}\n", ranks, time, one / time);
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
