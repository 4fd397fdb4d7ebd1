#pragma once
/// \file
/// How late beginnings of contact go on from period to period.

#include <cstddef>
#include <optional>
#include <vector>

namespace signorini {

/// Growths of two orders of fronts that differ by less are one.
inline constexpr double sameGrowth = 2e-3;
/// Periods in which a front is there, at most.
inline constexpr std::size_t mostTerms = 2000;

/// Late beginnings a_k of `count` contacts in a period obey
///
///     sum over j and s >= 0 of w_s,k,j a_j(s periods ago) = 0,   w_0,k,k = 1, w_0,k,j = 0 for j >
///     k.
///
/// `weights` holds w_s,k,j at (s count + k) count + j for s < terms. \return by how much the a_k
/// grow in a period in the long run; none if that is not settled after 6000 of them. O(terms
/// count^2) for each.
[[nodiscard]] std::optional<double> growthOfLate(const std::vector<double>& weights,
                                                 std::size_t terms, std::size_t count);

/// The one growth of all orders, those that were found; none if one was not, or they differ.
[[nodiscard]] std::optional<double> oneGrowth(const std::vector<std::optional<double>>& ofOrders);

}  // namespace signorini
