#pragma once
/// \file
/// The suites: each is a list of cases, in the order in which they run.

#include "runner.hpp"

namespace signorini::bench {

/// How much of each suite.
enum class Extent { quick, full };

/// Of the requests that do not say another, relative.
inline constexpr double usualTolerance = 1e-6;

/// Error against run time: families A, B, C and random schedules, every back end, form, tolerance.
[[nodiscard]] std::vector<Case> accuracySuite(Extent extent);
/// Named stiff and extreme cases.
[[nodiscard]] std::vector<Case> extremesSuite(Extent extent);
/// One request with the simplifications of the library taken back one after the other.
[[nodiscard]] std::vector<Case> leavingOutSuite(Extent extent);
/// Run time against N.
[[nodiscard]] std::vector<Case> scalingSuite(Extent extent);
/// Family F, stepped bars: error against run time of each form and back end.
[[nodiscard]] std::vector<Case> steppedSuite(Extent extent);
/// What a user would otherwise run.
[[nodiscard]] std::vector<Case> rivalsSuite(Extent extent);
/// The same for forced, damped bars; part of the suite "rivals".
[[nodiscard]] std::vector<Case> forcedSuite(Extent extent);
/// One motion under an exact harmonic by all methods; part of it, too.
[[nodiscard]] std::vector<Case> harmonicSuite(Extent extent);

}  // namespace signorini::bench
