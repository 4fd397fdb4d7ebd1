#pragma once
/// \file
/// Wall time of an action: a warm-up, then repeats; short actions are timed in batches.

#include <algorithm>
#include <chrono>
#include <vector>

#include "record.hpp"

namespace signorini::bench {

[[nodiscard]] inline double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// What repeats gave.
struct Timing {
    double median = 0.0;  ///< [s]
    double best = 0.0;    ///< [s]
    int repeats = 0;      ///< 0: the first run took too long to be repeated, and is what counts
};

/// [s], how long the samples of one action may take together; less in a quick run.
inline double timingBudget = 0.05;

/// Runs `action` once to warm up; if that took less than five budgets, again: 3 to 9 samples, as
/// many as fit into the budget, each of as many runs as fill a thousandth of it.
template <typename Action>
[[nodiscard]] Timing timeOf(Action&& action)
{
    using Clock = std::chrono::steady_clock;
    const auto sample = [&action](int runs) {
        const auto start = Clock::now();
        for (int run = 0; run < runs; ++run) {
            action();
        }
        return std::chrono::duration<double>(Clock::now() - start).count() / runs;
    };
    const double first = sample(1);
    if (first > 5.0 * timingBudget) {
        return {first, first, 0};
    }
    const double guess = std::max(std::min(first, sample(1)), 1e-9);
    const int batch = static_cast<int>(std::clamp(1e-3 * timingBudget / guess, 1.0, 1e5));
    const int repeats = static_cast<int>(std::clamp(timingBudget / (guess * batch), 3.0, 9.0));
    std::vector<double> samples;
    for (int k = 0; k < repeats; ++k) {
        samples.push_back(sample(batch));
    }
    return {medianOf(samples), *std::min_element(samples.begin(), samples.end()), repeats};
}

/// Keeps the compiler from leaving out work whose result nobody reads.
inline void keep(const void* result)
{
    asm volatile("" : : "g"(result) : "memory");
}

inline void record(const Timing& timing, Record& record)
{
    record.figures["seconds_median"] = timing.median;
    record.figures["seconds_best"] = timing.best;
    record.figures["repeats"] = timing.repeats;
}

}  // namespace signorini::bench
