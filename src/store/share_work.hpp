#pragma once
/// \file
/// A list of independent pieces of work, shared among threads.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
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

/// The items of a list, of which those that are missing are made by `make(k)`; a call that gives
/// none ends the work, and what is missing then is left out. As shareWork.
template <typename Item, typename Make>
[[nodiscard]] std::vector<Item> shareOut(std::vector<std::optional<Item>> items,
                                         std::int64_t threads, const Make& make,
                                         const std::function<void(double, double)>& show)
{
    shareWork(
        items.size(), threads,
        [&](std::size_t k) {
            if (!items[k]) {
                items[k] = make(k);
            }
            return items[k].has_value();
        },
        show);
    std::vector<Item> all;
    for (std::optional<Item>& item : items) {
        if (item) {
            all.push_back(std::move(*item));
        }
    }
    return all;
}

/// What `make` gives of each number of a list; as above.
template <typename Make>
[[nodiscard]] auto shareOut(const std::vector<std::int64_t>& list, std::int64_t threads,
                            const Make& make, const std::function<void(double, double)>& show)
{
    return shareOut(
        std::vector<decltype(make(0))>(list.size()), threads,
        [&](std::size_t k) { return make(list[k]); }, show);
}

}  // namespace signorini
