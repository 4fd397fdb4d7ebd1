#pragma once
/// \file
/// The processes of one `mpirun`: batches decided by all of them reach rank 0 in order.
///
/// Batch number first + k belongs to rank k mod P. Each worker decides its own on its threads and
/// sends them; rank 0 decides its own, receives the others', and alone touches files.
///
/// The program `signorini` contains no MPI and starts without its many libraries. Under a launcher
/// it hands over to `signorini-mpi` beside it, the same program with MPI.

#include <cstdint>
#include <memory>
#include <string>

#include "atlas_batches.hpp"
#include "journal.hpp"
#include "signorini/control.hpp"

namespace signorini::cli {

/// Under a launcher, `signorini-mpi` takes over this process with the same arguments, if it is
/// installed beside this program; otherwise, and in `signorini-mpi` itself, nothing happens.
void handOverToMpi(char** arguments);

/// The membership of this process. MPI ends when it is destroyed.
class Ranks {
public:
    /// Does a launcher say that there are several processes?
    [[nodiscard]] static bool areLaunched();

    /// \throws BackendUnavailable if this build has no MPI.
    Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;
    /// Without a call: rank 0 sends the workers home.
    ~Ranks();

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int count() const { return count_; }

    /// Rank 0: calls the workers to a range, and returns the batches of all. Destroying it ends
    /// their work.
    [[nodiscard]] std::unique_ptr<BatchSource> share(const AtlasRange& range, std::int64_t threads,
                                                     Cancel cancel, std::int64_t first);
    /// The others: decide what rank 0 asks for, until it is done. Returns false if cancelled.
    bool serve(std::int64_t threads, const Cancel& cancel);

    /// Rank 0: rows of a table, dealt to all in turn; the workers hear `question`.
    [[nodiscard]] DealRows dealt(std::string question, const RowOf& row, std::int64_t threads);
    /// The others: rows of the question that they hear, likewise.
    bool serveRows(const std::function<RowOf(const std::string& question)>& rows,
                   std::int64_t threads);

private:
    int rank_ = 0;
    int count_ = 1;
    bool wasCalled_ = false;
};

}  // namespace signorini::cli
