#pragma once
/// \file
/// A list of independent pieces of work, shared among threads.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace signorini {

/// Most threads that can be asked for.
inline constexpr std::int64_t maxThreads = 1024;

/// Serves count - 1, ..., 0 by `threads` threads, this one among them, until all are done or one
/// call returns false. `show(done, count)`, if there is one, is called after each by one thread at
/// a time.
/// \throws what `serve` or `show` throws, after all threads have ended.
void shareWork(std::size_t count, std::int64_t threads,
               const std::function<bool(std::size_t)>& serve,
               const std::function<void(double done, double total)>& show);

/// What `make(n)` gives of each n of a list, in its order; a call that gives none ends the work,
/// and what is missing then is left out. As shareWork.
template <typename Make>
[[nodiscard]] auto shareOut(const std::vector<std::int64_t>& list, std::int64_t threads,
                            const Make& make, const std::function<void(double, double)>& show)
{
    std::vector<decltype(make(0))> items(list.size());
    shareWork(
        list.size(), threads,
        [&](std::size_t k) {
            items[k] = make(list[k]);
            return items[k].has_value();
        },
        show);
    std::vector<typename decltype(make(0))::value_type> all;
    for (auto& item : items) {
        if (item) {
            all.push_back(std::move(*item));
        }
    }
    return all;
}

}  // namespace signorini
