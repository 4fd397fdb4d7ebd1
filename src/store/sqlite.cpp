#include "sqlite.hpp"

#include <sqlite3.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "signorini/control.hpp"

namespace signorini {

namespace {

/// How long to wait for other processes: a reader for one that writes a batch, a writer for people
/// who look at the database with their own tools.
constexpr std::chrono::seconds patienceOfReader{5};
constexpr std::chrono::seconds patienceOfWriter{60};
/// Between two looks at a locked database, and at whether to stop.
constexpr std::chrono::milliseconds pause{10};

}  // namespace

/// How long to wait, and what ends it.
struct Connection::Patience {
    using Clock = std::chrono::steady_clock;

    std::chrono::seconds most;
    Cancel cancel;
    Clock::time_point start = {};

    /// SQLite's question before it looks again, for the `looks`-th time: 0 gives up.
    static int goOn(void* data, int looks)
    {
        Patience& patience = *static_cast<Patience*>(data);
        if (looks == 0) {
            patience.start = Clock::now();
        }
        if (isRequested(patience.cancel) || Clock::now() - patience.start > patience.most) {
            return 0;
        }
        std::this_thread::sleep_for(pause);
        return 1;
    }
};

Connection::Connection(const std::string& path, DatabaseMode mode, Cancel cancel) : path_(path)
{
    // A killed writer leaves a journal that only a connection that may write can roll back. Where
    // the file is read-only SQLite falls back to reading by itself.
    const bool reads = mode == DatabaseMode::read;
    const int flags = reads ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    const std::string file = path.starts_with(':') ? "./" + path : path;  // ":memory:" is a name
    sqlite3* raw = nullptr;
    const int code = sqlite3_open_v2(file.c_str(), &raw, flags, nullptr);
    handle_ = std::shared_ptr<sqlite3>(raw, sqlite3_close_v2);
    if (code != SQLITE_OK) {
        fail("cannot open");
    }
    sqlite3_extended_result_codes(raw, 1);
    patience_ = std::make_shared<Patience>(
        Patience{reads ? patienceOfReader : patienceOfWriter, std::move(cancel)});
    sqlite3_busy_handler(raw, Patience::goOn, patience_.get());
    if (reads) {
        run("PRAGMA query_only = 1");
    }
}

void Connection::run(const char* sql) const
{
    if (sqlite3_exec(handle(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
        fail("cannot use");
    }
}

std::int64_t Connection::number(const char* sql) const
{
    Statement statement(*this, sql);
    return statement.step() ? statement.whole(0) : 0;
}

std::int64_t Connection::changes() const
{
    return sqlite3_changes(handle());
}

std::int64_t Connection::lastId() const
{
    return sqlite3_last_insert_rowid(handle());
}

void Connection::fail(const char* action) const
{
    throw FileError(path_, std::string(action) + ": " + sqlite3_errmsg(handle()));
}

Statement::Statement(Connection connection, std::string_view sql)
    : connection_(std::move(connection))
{
    sqlite3_stmt* raw = nullptr;
    check(sqlite3_prepare_v2(connection_.handle(), sql.data(), static_cast<int>(sql.size()), &raw,
                             nullptr));
    handle_ = std::shared_ptr<sqlite3_stmt>(raw, sqlite3_finalize);
}

Statement& Statement::bind(int index, std::int64_t value)
{
    check(sqlite3_bind_int64(handle_.get(), index + 1, value));
    return *this;
}

Statement& Statement::bind(int index, double value)
{
    if (!std::isfinite(value)) {
        return bindNull(index);
    }
    check(sqlite3_bind_double(handle_.get(), index + 1, value));
    return *this;
}

Statement& Statement::bind(int index, std::string_view value)
{
    check(sqlite3_bind_text(handle_.get(), index + 1, value.data(), static_cast<int>(value.size()),
                            SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bindNull(int index)
{
    check(sqlite3_bind_null(handle_.get(), index + 1));
    return *this;
}

bool Statement::step()
{
    const int code = sqlite3_step(handle_.get());
    if (code == SQLITE_ROW) {
        return true;
    }
    if (code != SQLITE_DONE) {
        sqlite3_reset(handle_.get());
        connection_.fail("cannot use");
    }
    return false;
}

void Statement::execute()
{
    while (step()) {
    }
    check(sqlite3_reset(handle_.get()));
}

bool Statement::isNull(int column) const
{
    return sqlite3_column_type(handle_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::whole(int column) const
{
    if (sqlite3_column_type(handle_.get(), column) != SQLITE_INTEGER) {
        refuse(column, "whole numbers");
    }
    return sqlite3_column_int64(handle_.get(), column);
}

double Statement::real(int column) const
{
    const int type = sqlite3_column_type(handle_.get(), column);
    const double value = sqlite3_column_double(handle_.get(), column);
    if ((type != SQLITE_FLOAT && type != SQLITE_INTEGER) || !std::isfinite(value)) {
        refuse(column, "finite numbers");
    }
    return value;
}

std::string Statement::text(int column) const
{
    const unsigned char* text = sqlite3_column_text(handle_.get(), column);
    return text == nullptr ? std::string() : reinterpret_cast<const char*>(text);
}

void Statement::refuse(int column, std::string_view allowed) const
{
    constexpr std::size_t shown = 60;
    throw FileError(connection_.path(),
                    fmt::format("cannot use: a row has {} = {}: allowed {}",
                                sqlite3_column_name(handle_.get(), column),
                                isNull(column) ? "NULL" : text(column).substr(0, shown), allowed));
}

void Statement::check(int code) const
{
    if (code != SQLITE_OK) {
        connection_.fail("cannot use");
    }
}

Transaction::Transaction(Connection connection) : connection_(std::move(connection))
{
    connection_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction()
{
    if (isOpen_) {
        // SQLite may have rolled back by itself already; then this fails, and rightly so.
        sqlite3_exec(connection_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
}

void Transaction::commit()
{
    connection_.run("COMMIT");
    isOpen_ = false;
}

}  // namespace signorini
