#pragma once
/// \file
/// Long work that may be killed at any moment and goes on from where it was: what is done stands,
/// a line each, in the file `path`.part beside the table that will hold it, below a line that says
/// the question.

#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "network_sweep.hpp"
#include "signorini/control.hpp"
#include "signorini/sweep.hpp"

namespace signorini {

/// The file. Lines are whole, or were cut short at the end and do not count.
class Journal {
public:
    /// Begins anew, or `resumes` what is there. \throws FileError; std::invalid_argument where
    /// another question stands there.
    Journal(const std::string& path, const std::string& question, bool resumes);
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;
    ~Journal();

    /// What an earlier call left.
    [[nodiscard]] const std::vector<std::string>& known() const { return known_; }
    /// Writes a line through to the file. \throws FileError.
    void add(const std::string& line);
    /// The table is in place: the journal has served.
    void remove();

    [[nodiscard]] static std::string nameFor(const std::string& path) { return path + ".part"; }

private:
    std::string name_;
    std::vector<std::string> known_;
    std::FILE* file_ = nullptr;
};

/// The k-th of many pieces of work as a row without a newline; nothing if it was cancelled.
using RowOf = std::function<std::optional<std::string>(std::size_t k)>;
/// Hears of a row that is done, one at a time.
using TakeRow = std::function<void(std::size_t k, const std::string& row)>;
/// Does these pieces of work, perhaps side by side, or fewer if they are cancelled.
using DealRows = std::function<void(const std::vector<std::size_t>& which, const TakeRow& take)>;

/// The same by so many threads of this process, the first of them first.
[[nodiscard]] DealRows byThreads(const RowOf& row, std::int64_t threads);

/// A table whose rows are done each on its own.
struct RowTable {
    std::string file;      ///< empty: none is written
    std::string question;  ///< on one line; its first, after "# "
    std::string header;
    std::vector<std::string> keys;  ///< with which the rows begin, each once
    bool resumes = false;           ///< goes on from what is in the file, or in its journal
    DealRows deal;
    std::function<void(double done, double total)> show = {};
};

/// All rows in order; rows that are known keep their place in the file, also those that nobody asks
/// for now. Where it was cancelled those that are not done are empty, and the journal
/// stays. \throws as Journal and `deal`.
[[nodiscard]] std::vector<std::string> tabulated(const RowTable& table);

/// `sweep` with what a journal knows, of the bar of the range, or of several, whose numbers are in
/// units of `bar`; `control.known` and `control.keep` are not read. Without a file null.
[[nodiscard]] std::vector<SweepPoint> sweepThrough(const SweepRange& range, const Network* several,
                                                   const Bar& bar,
                                                   const std::vector<SweepDirection>& directions,
                                                   Journal* journal, std::int64_t threads,
                                                   SweepControl control);

}  // namespace signorini
