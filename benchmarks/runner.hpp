#pragma once
/// \file
/// Runs each case in a process of its own, so that whatever a back end does to it - abort, crash,
/// search for ever, eat all memory - is one failed row of the table and not the end of the run.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "record.hpp"

namespace signorini::bench {

/// The same for every case and back end.
struct Limits {
    double seconds = 0.0;    ///< [s], wall time of a case, repeats included
    double megabytes = 0.0;  ///< [MB], address space of its process
};

/// One measurement to make.
struct Case {
    Record record;  ///< filled in as far as it identifies the case
    /// Cases of one series get harder from one to the next: once one is ended by a limit, the
    /// others are skipped. Empty: none.
    std::string series;
    std::function<void(Record&)> body;  ///< measures and judges
};

/// Runs one case; nothing if the user interrupted it.
[[nodiscard]] std::optional<Record> execute(const Case& work, const Limits& limits);

/// Turns SIGINT and SIGTERM into `isInterrupted`.
void catchInterrupts();
[[nodiscard]] bool isInterrupted();

/// How a run ended.
struct RunSummary {
    std::size_t done = 0;         ///< cases measured now
    std::size_t kept = 0;         ///< cases found in the table
    bool wasInterrupted = false;  ///< before the last case
};

/// Runs the cases in order and appends each row to the table at `path` as soon as it is known.
/// Cases that the table holds already, with the same provenance, are not run again. Progress goes
/// to stderr if that is a terminal. \throws FileError.
RunSummary run(const std::vector<Case>& cases, const Limits& limits, const std::string& provenance,
               const std::string& path);

}  // namespace signorini::bench
