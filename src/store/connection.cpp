#include "connection.hpp"

#include <sqlite3.h>

#include <thread>
#include <utility>

namespace signorini {

namespace {

/// How long to wait for other processes: a reader for one that writes a batch, a writer for people
/// who look at the database with their own tools.
constexpr std::chrono::seconds patienceOfReader{5};
constexpr std::chrono::seconds patienceOfWriter{60};
/// Between two looks at a locked database, and at whether to stop.
constexpr std::chrono::milliseconds pauseWhileLocked{10};

/// A killed writer leaves a journal that only a connection that may write can roll back. Where the
/// file is read-only SQLite falls back to reading by itself.
SQLite::Database opened(const std::string& path, DatabaseMode mode)
{
    const int flags =
        SQLite::OPEN_READWRITE | (mode == DatabaseMode::write ? SQLite::OPEN_CREATE : 0);
    try {
        return {path.starts_with(':') ? "./" + path : path, flags};  // ":memory:" is a name
    } catch (const SQLite::Exception& error) {
        throw FileError(path, std::string("cannot open: ") + error.what());
    }
}

}  // namespace

Connection::Connection(const std::string& path, DatabaseMode mode, Cancel cancel)
    : path_(path),
      patience_(mode == DatabaseMode::read ? patienceOfReader : patienceOfWriter),
      cancel_(std::move(cancel)),
      database_(opened(path, mode))
{
    sqlite3_busy_handler(database_.getHandle(), goOn, this);
    if (mode == DatabaseMode::read) {
        use([](SQLite::Database& database) { database.exec("PRAGMA query_only = 1"); });
    }
}

int Connection::goOn(void* connection, int looks)
{
    Connection& self = *static_cast<Connection*>(connection);
    if (looks == 0) {
        self.start_ = Clock::now();
    }
    if (isRequested(self.cancel_) || Clock::now() - self.start_ > self.patience_) {
        return 0;
    }
    std::this_thread::sleep_for(pauseWhileLocked);
    return 1;
}

}  // namespace signorini
