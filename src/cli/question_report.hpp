#pragma once
/// \file
/// The answer to a question in physics, in words and in JSON. States are not kept: there may be
/// many sets, and a state is as long as the grid is fine.

#include <optional>
#include <string>

#include "json.hpp"
#include "question.hpp"
#include "report.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::cli {

/// Collects what `findPeriodic` says of each set of a period.
class QuestionReport {
public:
    QuestionReport(AskedPeriod asked, std::int64_t cells, const FindOptions& options,
                   std::optional<TargetReport> target);

    /// The answer for the next set.
    void add(const PeriodicResult& result);

    /// Found: at least one motion; undecided: none, and something stood in the way; none: proved of
    /// every set.
    [[nodiscard]] Status status() const;

    [[nodiscard]] std::string text() const;
    [[nodiscard]] Json json() const;

private:
    [[nodiscard]] std::string question() const;
    [[nodiscard]] std::string reason() const;

    AskedPeriod asked_;
    Schedule period_;  ///< any schedule with this period
    Bar bar_;
    std::optional<double> energyRatio_;
    std::optional<TargetReport> target_;
    std::int64_t found_ = 0;
    bool isUndecided_ = false;
    std::string motionsAsText_;
    std::string othersAsText_;
    Json sets_ = Json::array();
    Json motions_ = Json::array();
};

}  // namespace signorini::cli
