#pragma once
/// \file
/// A list of families in words, as JSON and as a table.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "json.hpp"
#include "signorini/bar.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

/// The outcome of one call of signorini families.
struct FamilyList {
    std::int64_t maxOrder = 0;
    double maxEnergyRatio = 0.0;
    Bar bar;
    std::vector<Family> families;
    std::string ended;                      ///< why it is not complete; empty: it is
    std::optional<double> secondStop = {};  ///< [m]; families are those of the wall that it leaves

    [[nodiscard]] bool isComplete() const { return ended.empty(); }
};

/// Where text goes, piece by piece.
using Write = std::function<void(std::string_view)>;

/// In pieces: a list may be long.
void writeText(const FamilyList& list, const Write& write);
void writeJson(const FamilyList& list, const Write& write);

/// One row a family, numbers in the shortest form that reads back exactly. \throws FileError.
void writeFamiliesCsv(const std::string& path, const FamilyList& list);

/// What names a family: order, nu, contact_blocks; its period and longest contact in L/c as
/// fractions, and its least energy.
[[nodiscard]] Json familyAsJson(const Family& family);

}  // namespace signorini::cli
