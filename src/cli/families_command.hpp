#pragma once
/// \file
/// signorini families

#include <string>

#include "arguments.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

/// Largest order that is listed.
inline constexpr std::int64_t maxListedOrder = 20'000;

/// Most families in a list, 32 bytes each.
inline constexpr std::size_t maxListedFamilies = 20'000'000;

/// One call.
struct FamiliesCommand {
    CommonOptions common;
    std::int64_t maxOrder = 12;  ///< [-], w
    FamilyBounds bounds;
    std::string figureFile;
    std::string tableFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end the search, as does
    /// a full list, and what was found is reported, in no file. Exceptions are for `main` to
    /// translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
