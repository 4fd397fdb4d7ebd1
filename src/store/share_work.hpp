#pragma once
/// \file
/// A list of independent pieces of work, shared among threads.

#include <cstddef>
#include <cstdint>
#include <functional>

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

}  // namespace signorini
