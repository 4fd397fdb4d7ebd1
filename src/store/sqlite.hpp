#pragma once
/// \file
/// A thin, owning layer over SQLite: connections and statements, errors as FileError.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "signorini/control.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace signorini {

/// What may be done with a database.
enum class DatabaseMode {
    read,   ///< it must exist; only what an interrupted writer left behind is put right
    write,  ///< it is created if it does not exist
};

/// An open database; copies share it, and the last one closes it.
class Connection {
public:
    /// `cancel` ends any wait for another process, which then counts as too long.
    /// \throws FileError if it cannot be opened.
    Connection(const std::string& path, DatabaseMode mode, Cancel cancel = {});

    /// Runs statements that return nothing. \throws FileError.
    void run(const char* sql) const;
    /// The first column of the first row of a query. \throws FileError.
    [[nodiscard]] std::int64_t number(const char* sql) const;
    /// Rows that the last statement changed.
    [[nodiscard]] std::int64_t changes() const;
    /// Id of the row that the last INSERT made.
    [[nodiscard]] std::int64_t lastId() const;

    [[nodiscard]] sqlite3* handle() const { return handle_.get(); }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[noreturn]] void fail(const char* action) const;

private:
    struct Patience;

    std::string path_;
    std::shared_ptr<Patience> patience_;  ///< before the handle, which uses it to the end
    std::shared_ptr<sqlite3> handle_;
};

/// A prepared statement. Parameters and columns count from 0.
class Statement {
public:
    /// \throws FileError.
    Statement(Connection connection, std::string_view sql);

    Statement& bind(int index, std::int64_t value);
    Statement& bind(int index, double value);  ///< not finite: NULL
    Statement& bind(int index, std::string_view value);
    Statement& bindNull(int index);

    /// The next row, if there is one. \throws FileError.
    bool step();
    /// Runs to the end and makes it ready to run again. \throws FileError.
    void execute();

    [[nodiscard]] bool isNull(int column) const;
    /// A whole number. \throws FileError if the column holds anything else.
    [[nodiscard]] std::int64_t whole(int column) const;
    /// A finite number. \throws FileError if the column holds anything else.
    [[nodiscard]] double real(int column) const;
    /// Any value as text; NULL is empty.
    [[nodiscard]] std::string text(int column) const;
    /// Says that the value of a column cannot be. \throws FileError.
    [[noreturn]] void refuse(int column, std::string_view allowed) const;

private:
    void check(int code) const;

    Connection connection_;
    std::shared_ptr<sqlite3_stmt> handle_;
};

/// BEGIN … COMMIT; rolled back if it ends without `commit`.
class Transaction {
public:
    explicit Transaction(Connection connection);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();

    void commit();

private:
    Connection connection_;
    bool isOpen_ = true;
};

}  // namespace signorini
