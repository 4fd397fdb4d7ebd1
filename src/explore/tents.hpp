#pragma once
/// \file
/// What exists at one period of a range: tents, docs/theory.md, section 14.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>

#include "family_chains.hpp"
#include "signorini/atlas.hpp"

namespace signorini {

/// The schedules of one n that have faces of one set, |n_c - kG| < G, cut down to a range. Grazing
/// sets are a tent too, of which one side exists: k = 0.
struct Tent {
    std::optional<Family> family;  ///< none: grazing
    Verdict verdict;               ///< of the schedule `at` was asked for last
    std::int64_t steps = 0;        ///< [steps], n
    std::int64_t summit = 0;       ///< [steps], kG
    std::int64_t first = 1;        ///< [steps], least n_c in the range
    std::int64_t last = 0;         ///< [steps], greatest n_c in the range
    std::int64_t firstKept = 1;    ///< [steps], least n_c in the range of an energy to keep
    std::int64_t lastKept = 0;     ///< [steps], greatest

    /// The verdict on one of its schedules. O(1).
    [[nodiscard]] const Verdict& at(std::int64_t contact);

    [[nodiscard]] std::int64_t count() const { return std::max<std::int64_t>(0, last - first + 1); }
    [[nodiscard]] bool keepsAny() const { return firstKept <= lastKept; }
    /// Is it the one tent, of those with its orbits, whose schedules have their period?
    [[nodiscard]] bool isOwn() const
    {
        return !family           ? steps == 2 * verdict.classes
               : isHeld(*family) ? steps == verdict.classes
                                 : true;
    }
    /// The schedule whose set is the whole.
    [[nodiscard]] Phase top() const;
};

/// All tents of a range.
class Tents {
public:
    /// \pre `validate(range)` holds.
    explicit Tents(const AtlasRange& range);

    /// The least n that is not less than this and may have a tent.
    [[nodiscard]] std::int64_t candidate(std::int64_t n) const;

    /// Visits the tents of one n by ascending n_c, those without schedules in the range, too.
    /// O(log n). \returns false if `visit` did.
    [[nodiscard]] bool forEach(std::int64_t n, auto visit) const
    {
        const std::int64_t classes = std::gcd(2 * range_.cells, n);
        if (range_.gapSign < 0) {
            Tent tent = held(n, classes);
            if (!pressAll(n, classes, visit)) {
                return false;
            }
            return visit(tent);
        }
        if (range_.gapSign > 0 && n % twos_ == 0 && grazingStaysClear()) {
            Tent tent = grazing(n, classes);
            if (!visit(tent)) {
                return false;
            }
        }
        return pressAll(n, classes, visit);
    }

    /// The set of orbits of a tent that is its own, with all its schedules of the range.
    [[nodiscard]] AtlasFamily familyOf(Tent& tent) const;

private:
    [[nodiscard]] bool pressAll(std::int64_t n, std::int64_t classes, auto visit) const
    {
        if (n >= 4 * range_.cells) {  // T < 4 where motions press and leave
            return true;
        }
        return forEachContact(2 * range_.cells / classes, n / classes, 1, range_.gapSign,
                              [&](const Family& family) {
                                  if (!staysClear(family, stopsOf(range_))) {
                                      return true;
                                  }
                                  Tent tent = pressing(n, classes, family);
                                  return visit(tent);
                              });
    }
    [[nodiscard]] bool grazingStaysClear() const;
    [[nodiscard]] Tent held(std::int64_t n, std::int64_t classes) const;
    [[nodiscard]] Tent pressing(std::int64_t n, std::int64_t classes, const Family& family) const;
    [[nodiscard]] Tent grazing(std::int64_t n, std::int64_t classes) const;
    void cutDown(Tent& tent) const;
    [[nodiscard]] bool isLowEnough(const Verdict& verdict) const;
    [[nodiscard]] std::int64_t countGrazing(const Tent& tent) const;
    [[nodiscard]] std::int64_t countHeld(const Tent& tent) const;

    AtlasRange range_;
    std::int64_t twos_ = 2;  ///< the power of 2 that n has when epsilon alternates: nu is even
};

}  // namespace signorini
