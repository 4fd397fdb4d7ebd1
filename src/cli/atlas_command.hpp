#pragma once
/// \file
/// signorini atlas --database FILE.sqlite

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "atlas_coverage.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "ranks.hpp"
#include "reports.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

/// One call.
struct AtlasCommand {
    const Given& given;
    CommonOptions common;
    std::string database;
    std::optional<ExactPeriod> period;

    explicit AtlasCommand(const Given& words);

    /// Decides the range, or answers a query; the report goes to stdout. SIGINT and SIGTERM end
    /// the work after the batch in flight. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;

private:
    [[nodiscard]] bool isQuery() const;
    [[nodiscard]] AtlasRange range() const;
    /// Of a bar that is not uniform.
    [[nodiscard]] std::vector<Segment> segments() const;
    /// Whose scales the answers have.
    [[nodiscard]] Bar bar() const;
    void checkQuery() const;
    [[nodiscard]] std::optional<answers::AtlasPoint> point() const;
    [[nodiscard]] AtlasQuestion question() const;
    [[nodiscard]] AtlasAnswer ask(const AtlasDatabase& atlas) const;
    [[nodiscard]] ExitStatus answer() const;
    [[nodiscard]] ExitStatus build(const AtlasRange& range, Ranks* ranks,
                                   std::optional<Interrupt>& interrupt) const;
    void fill(AtlasDatabase& atlas, AtlasRun& run, Ranks* ranks, const AtlasOptions& options) const;
    void draw(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
              Outputs& outputs) const;
};

}  // namespace signorini::cli
