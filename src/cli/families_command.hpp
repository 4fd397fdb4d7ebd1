#pragma once
/// \file
/// signorini families

#include <string>

#include "arguments.hpp"
#include "signorini/families.hpp"

namespace signorini::cli {

/// Largest order that is listed: there are 0.46 of its square, 32 bytes each.
inline constexpr std::int64_t maxListedOrder = 5'000;

/// One call.
struct FamiliesCommand {
    CommonOptions common;
    std::int64_t maxOrder = 12;  ///< [-], w
    FamilyBounds bounds;
    std::string figureFile;
    std::string tableFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end the search, and what was
    /// found is reported, in no file. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
