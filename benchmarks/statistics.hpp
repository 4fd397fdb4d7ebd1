#pragma once
/// \file
/// What can be read off a table of records.

#include <functional>
#include <string>
#include <vector>

#include "record.hpp"

namespace signorini::bench {

using Table = std::vector<Record>;

/// The records for which `condition` holds.
[[nodiscard]] Table where(const Table& table, const std::function<bool(const Record&)>& condition);

/// The values of one text column, each once, in the order of their first appearance.
[[nodiscard]] std::vector<std::string> distinct(const Table& table, std::string Record::*column);

/// Was it tried at all? Not if the back end is absent or refuses such programs.
[[nodiscard]] bool wasTried(const Record& record);

/// Does the row measure the library, and not a back end?
[[nodiscard]] bool isOurs(const Record& record);

/// Did it claim something?
[[nodiscard]] bool isClaim(const Record& record);

/// Is the verdict right, and the error, if there is one to measure, at most this?
[[nodiscard]] bool isRightWithin(const Record& record, double error);

/// A straight line through logarithms.
struct PowerLaw {
    double exponent = 0.0;
    double factor = 0.0;  ///< y = factor x^exponent
    std::size_t points = 0;
};

/// Least squares in log-log over points with both values > 0; exponent NaN below two points.
[[nodiscard]] PowerLaw fitPowerLaw(const std::vector<std::pair<double, double>>& points);

/// The share of problems that a solver does within `factor` times the best time of any.
struct ProfilePoint {
    double factor;
    double share;
};

/// Performance profile (Dolan and More 2002) of seconds_median over the problems in `table`; what
/// is not right took for ever. One curve for each value of `label`.
[[nodiscard]] std::vector<std::pair<std::string, std::vector<ProfilePoint>>> performanceProfiles(
    const Table& table, const std::function<std::string(const Record&)>& label);

}  // namespace signorini::bench
