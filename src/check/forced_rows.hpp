#pragma once
/// \file
/// The conditions of a forced motion as rows whose numbers are enclosed.

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "forced_check.hpp"
#include "interval.hpp"

namespace signorini {

/// A vector of the plane (C, S), enclosed.
struct EnclosedPlane {
    Interval c;
    Interval s;

    friend EnclosedPlane operator+(const EnclosedPlane& x, const EnclosedPlane& y)
    {
        return {x.c + y.c, x.s + y.s};
    }
    friend EnclosedPlane operator-(const EnclosedPlane& x, const EnclosedPlane& y)
    {
        return {x.c - y.c, x.s - y.s};
    }
    friend EnclosedPlane operator*(const Interval& factor, const EnclosedPlane& x)
    {
        return {factor * x.c, factor * x.s};
    }
    [[nodiscard]] Interval dot(const EnclosedPlane& y) const { return c * y.c + s * y.s; }
    [[nodiscard]] Interval cross(const EnclosedPlane& y) const { return c * y.s - s * y.c; }
};

/// plane . (C, S) + free . z >= limit, or = limit.
struct EnclosedRow {
    bool isEquality = false;
    EnclosedPlane plane;
    std::map<std::int64_t, std::int64_t> free;  ///< class -> factor, exact
    Interval limit;
};

/// The arrivals p_m of both shapes, enclosed, and the rows made of them. Waves of a class that
/// nothing damps (no flight, or an even number of them and rho = 1) begin with 0 and have an
/// amplitude z of their own.
class EnclosedWaves {
public:
    /// O(n).
    explicit EnclosedWaves(const ForcedQuestion& question);

    /// The row of a condition; none if the schedule has no such condition. O(n).
    [[nodiscard]] std::optional<EnclosedRow> row(const ForcedCondition& condition) const;

private:
    struct Class {
        bool isFree = false;
        EnclosedPlane work;  ///< of a free one: what its waves gain once around
    };

    template <typename Value>
    [[nodiscard]] EnclosedPlane each(Value value) const;
    [[nodiscard]] EnclosedPlane force(std::int64_t m) const;
    [[nodiscard]] EnclosedPlane echo(std::int64_t m, const EnclosedPlane& p) const;
    void enclose(std::int64_t first);
    void addWave(EnclosedRow& row, std::int64_t m, std::int64_t factor) const;
    void addPush(EnclosedRow& row, std::int64_t m, std::int64_t factor) const;
    [[nodiscard]] EnclosedRow gapRow() const;
    struct Part;
    /// Where step m stands in the schedule.
    [[nodiscard]] Part partOf(std::int64_t m) const;
    [[nodiscard]] std::optional<EnclosedRow> flightRow(const ForcedCondition& condition) const;
    [[nodiscard]] std::int64_t classes() const
    {
        return static_cast<std::int64_t>(classes_.size());
    }
    [[nodiscard]] const Class& classOf(std::int64_t m) const
    {
        return classes_[static_cast<std::size_t>(m) % classes_.size()];
    }

    const ForcedQuestion& question_;
    std::int64_t cells_;
    std::int64_t steps_;
    std::vector<bool> isContact_;
    std::vector<EnclosedPlane> p_;
    std::vector<int> signs_;  ///< of z in p_m
    std::vector<Class> classes_;
};

}  // namespace signorini
