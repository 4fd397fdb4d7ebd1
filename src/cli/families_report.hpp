#pragma once
/// \file
/// A list of families in words, as JSON and as a table.

#include <functional>
#include <string>
#include <string_view>

#include "modes_answer.hpp"

namespace signorini::cli {

/// Where text goes, piece by piece.
using Write = std::function<void(std::string_view)>;

/// In pieces: a list may be long.
void writeText(const answers::FamilyList& list, const Write& write);
void writeJson(const answers::FamilyList& list, const Write& write);

/// One row a family, numbers in the shortest form that reads back exactly. \throws FileError.
void writeFamiliesCsv(const std::string& path, const answers::FamilyList& list);

}  // namespace signorini::cli
