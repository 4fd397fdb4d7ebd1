#pragma once
/// \file
/// Looks into databases as any program can.

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <string>
#include <vector>

#include "catch.hpp"
#include "signorini/atlas.hpp"

namespace signorini::test {

/// May write, so that what a killed writer left behind is put right.
inline SQLite::Database opened(const std::string& path, int more = 0)
{
    return {path, SQLite::OPEN_READWRITE | more};
}

/// The first column of the first row of a query.
inline std::int64_t number(const std::string& path, const char* sql)
{
    return opened(path).execAndGet(sql).getInt64();
}

/// Equal but for the place in a database.
inline bool isSame(const AtlasFamily& a, const AtlasFamily& b)
{
    return a.cells == b.cells && a.family == b.family && a.top == b.top && a.steps == b.steps &&
           a.kind == b.kind && a.dimension == b.dimension && a.energy.least == b.energy.least &&
           a.energy.most == b.energy.most && a.schedules == b.schedules;
}

/// Every row of a table, with its rowid, after a check of the whole file.
inline std::vector<std::string> dump(const std::string& path,
                                     const std::string& table = "schedules")
{
    const SQLite::Database database = opened(path);
    SQLite::Statement check(database, "PRAGMA integrity_check");
    REQUIRE(check.executeStep());
    REQUIRE(check.getColumn(0).getString() == "ok");
    SQLite::Statement statement(database, "SELECT rowid, * FROM " + table + " ORDER BY rowid");
    std::vector<std::string> rows;
    while (statement.executeStep()) {
        std::string row;
        for (int column = 0; column < statement.getColumnCount(); ++column) {
            row += statement.getColumn(column).getString() + "|";
        }
        rows.push_back(row);
    }
    return rows;
}

}  // namespace signorini::test
