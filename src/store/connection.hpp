#pragma once
/// \file
/// An open SQLite database: how it is opened, how it waits for others, its errors as FileError.
/// Statements and transactions are those of SQLiteCpp.

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <chrono>
#include <string>

#include "signorini/control.hpp"

namespace signorini {

/// What may be done with a database.
enum class DatabaseMode {
    read,   ///< it must exist; only what an interrupted writer left behind is put right
    write,  ///< it is created if it does not exist
};

/// Stays where it is: SQLite keeps the address of its patience.
class Connection {
public:
    /// `cancel` ends any wait for another process, which then counts as too long.
    /// \throws FileError if it cannot be opened.
    Connection(const std::string& path, DatabaseMode mode, Cancel cancel = {});
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection() = default;

    [[nodiscard]] const std::string& path() const { return path_; }

    /// Hands the database to `action`. \throws FileError where SQLite reports trouble.
    template <typename Action>
    decltype(auto) use(Action action)
    {
        try {
            return action(database_);
        } catch (const SQLite::Exception& error) {
            throw FileError(path_, std::string("cannot use: ") + error.what());
        }
    }

private:
    using Clock = std::chrono::steady_clock;

    /// SQLite's question before it looks again, for the `looks`-th time: 0 gives up. Its own
    /// timeout would not listen to `cancel`.
    static int goOn(void* connection, int looks);

    std::string path_;
    std::chrono::seconds patience_;
    Cancel cancel_;
    Clock::time_point start_ = {};  ///< of a wait
    SQLite::Database database_;
};

}  // namespace signorini
