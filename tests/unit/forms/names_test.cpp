#include "names.hpp"

#include <span>

#include "catch.hpp"
#include "demand_names.hpp"
#include "set_kind_names.hpp"
#include "verdict_names.hpp"

using namespace signorini;

namespace {

/// \pre The enumerators are numbered from 0.
template <typename Table>
void checkBothWays(const Table& table)
{
    using Enum = decltype(std::begin(table)->value);
    int number = 0;
    for (const auto& row : table) {
        INFO(row.name);
        CHECK(row.value == static_cast<Enum>(number));
        CHECK(name(row.value) == row.name);
        CHECK(valueIn(table, row.name) == row.value);
        ++number;
    }
    CHECK_THROWS_AS(name(static_cast<Enum>(number)), std::logic_error);
    CHECK_FALSE(valueIn(table, ""));
    CHECK_FALSE(valueIn(table, "no such name"));
}

}  // namespace

TEST_CASE("names: each enumerator in turn has a name of its own, which leads back to it")
{
    checkBothWays(statusNames);
    checkBothWays(reasonNames);
    checkBothWays(contactNames);
    checkBothWays(setKindNames);
    checkBothWays(formulationNames);
    checkBothWays(objectiveNames);
}

TEST_CASE("names: a message lists all of a table, or of a part of it")
{
    CHECK(namesIn(statusNames) == "found|none|undecided");
    CHECK(namesIn(std::span(setKindNames).subspan(1)) == "point|simplex|box|polytope|cone");
}
