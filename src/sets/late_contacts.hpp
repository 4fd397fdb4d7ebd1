#pragma once
/// \file
/// How late beginnings of contact go on from period to period.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace signorini {

/// How a front goes on where it meets an event.
struct FrontOrders {
    bool isLateAtRelease;  ///< do old fronts come after the newest?
    bool isLateAtContact;  ///< or after the beginning of contact?
};

/// What fronts that go on in such an order say.
struct OrderedGrowth {
    std::optional<double> growth;
    bool dependsOnContact = true;  ///< did a front come just as contact begins?
};

/// What is left of a front where it is none any more.
inline constexpr double faded = 1e-12;
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

/// Takes off what late beginnings leave for good of the place of a body that drifts, by which
/// weights of contact k grow by[k]: from those of later contacts what the first one of that body
/// has, of which differences count from then on. Growth stays the same, and all weights fade.
void takeOffPlace(std::vector<double>& weights, std::span<const double> by);

/// The largest growth of all orders, those of releases only where some are pinned; none if that of
/// one is not known, or they differ.
[[nodiscard]] std::optional<double> growthOfOrders(
    bool arePinned, const std::function<OrderedGrowth(const FrontOrders&)>& growth);

}  // namespace signorini
