#pragma once
/// \file
/// A list of families in words, as JSON and as a table.

#include <string>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

/// The outcome of one call of signorini families.
struct FamilyList {
    std::int64_t maxOrder = 0;
    double maxEnergyRatio = 0.0;
    Bar bar;
    std::vector<Family> families;
    std::string ended;  ///< why it is not complete; empty: it is

    [[nodiscard]] bool isComplete() const { return ended.empty(); }
};

/// To standard output, piece by piece: a list may be long. \throws FileError.
void writeText(const FamilyList& list);
void writeJson(const FamilyList& list);

/// One row a family, numbers in the shortest form that reads back exactly. \throws FileError.
void writeFamiliesCsv(const std::string& path, const FamilyList& list);

}  // namespace signorini::cli
