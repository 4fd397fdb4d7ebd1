#include <algorithm>
#include <numeric>

#include "forced_check.hpp"
#include "interval.hpp"

namespace signorini {

namespace {

/// A row of the two unknowns C and S.
struct Row {
    Interval c;
    Interval s;

    friend Row operator+(const Row& x, const Row& y) { return {x.c + y.c, x.s + y.s}; }
    friend Row operator-(const Row& x, const Row& y) { return {x.c - y.c, x.s - y.s}; }
    friend Row operator*(const Interval& factor, const Row& x)
    {
        return {factor * x.c, factor * x.s};
    }
};

Interval cross(const Row& x, const Row& y)
{
    return x.c * y.s - x.s * y.c;
}

/// The arrivals p_m of both shapes, enclosed.
class Enclosure {
public:
    Enclosure(std::int64_t cells, std::int64_t contact, double rho,
              std::span<const Excitation> shapes)
        : cells_(cells),
          contact_(contact),
          steps_(shapes.front().steps()),
          rho_(rho),
          shapes_(shapes),
          p_(static_cast<std::size_t>(steps_)),
          flies_(static_cast<std::size_t>(std::gcd(2 * cells, steps_)))
    {
        for (std::int64_t m = 0; m < std::gcd(2 * cells, steps_); ++m) {
            enclose(m);
        }
    }

    [[nodiscard]] Row push(std::int64_t m) const
    {
        return force(m) + Interval(2.0) * p_[static_cast<std::size_t>(m)];
    }

    /// u(L, 0).
    [[nodiscard]] Row tip() const
    {
        Row sum;
        for (std::int64_t m = 0; m < 2 * cells_; ++m) {
            sum = sum + p_[static_cast<std::size_t>(m % steps_)];
        }
        return each([this](const Excitation& e) { return Interval(e.baseDisplacement(cells_)); }) -
               (Interval(1.0) / Interval(static_cast<double>(cells_))) * sum;
    }

    /// Is it a row of the schedule, and one of C and S alone? Where a class never flies it is not.
    [[nodiscard]] bool isRow(const ForcedRow& row) const
    {
        return row.isContact ? row.step >= 0 && row.step < contact_ && flies_[classOf(row.step)]
                             : row.step >= contact_ && row.step < steps_;
    }

    /// Written so that it is >= 0.
    [[nodiscard]] Row row(const ForcedRow& which) const
    {
        if (which.isContact) {
            return push(which.step);
        }
        Row sum;
        for (std::int64_t m = contact_; m <= which.step; ++m) {
            sum = sum - push(m);
        }
        return sum;
    }

private:
    [[nodiscard]] std::size_t classOf(std::int64_t m) const
    {
        return static_cast<std::size_t>(m) % flies_.size();
    }

    template <typename Value>
    [[nodiscard]] Row each(Value value) const
    {
        return {value(shapes_.front()), shapes_.size() > 1 ? value(shapes_.back()) : Interval()};
    }

    [[nodiscard]] Row force(std::int64_t m) const
    {
        return each([m](const Excitation& e) { return Interval(e.force(m)); });
    }

    /// What leaves the tip in step m and comes back with the motion of the base.
    [[nodiscard]] Row echo(std::int64_t m, const Row& p) const
    {
        const Row base = each([m, this](const Excitation& e) {
            return (Interval(e.baseDisplacement(m + cells_ + 1)) -
                    Interval(e.baseDisplacement(m + cells_))) *
                   Interval(e.stepsPerCrossing);
        });
        const Interval admittance = Interval(0.5) * (Interval(1.0) + Interval(rho_));
        return m < contact_ ? base + p : base - (admittance * force(m) + Interval(rho_) * p);
    }

    /// Once around from 0 tells where the fixed point is. A class that is always in contact has an
    /// amplitude of its own: the least for which R, summed over it, is not negative. More of it
    /// only lowers u(L, 0), so that a conflict found with the least is one with any.
    void enclose(std::int64_t first)
    {
        Row p;
        Row push;
        Interval factor(1.0);
        Interval members(0.0);
        bool isHeld = true;
        std::int64_t m = first;
        do {
            push = push + force(m) + Interval(2.0) * p;
            members = members + Interval(1.0);
            p = echo(m, p);
            isHeld = isHeld && m < contact_;
            factor = m < contact_ ? factor : Interval(-rho_) * factor;
            m = (m + 2 * cells_) % steps_;
        } while (m != first);
        const Interval grip = isHeld ? Interval(-2.0) * members : Interval(1.0) - factor;
        p = isHeld ? push : p;
        p = {p.c / grip, p.s / grip};
        flies_[classOf(first)] = !isHeld;
        do {
            p_[static_cast<std::size_t>(m)] = p;
            p = echo(m, p);
            m = (m + 2 * cells_) % steps_;
        } while (m != first);
    }

    std::int64_t cells_;
    std::int64_t contact_;
    std::int64_t steps_;
    double rho_;
    std::span<const Excitation> shapes_;
    std::vector<Row> p_;
    std::vector<bool> flies_;  ///< for each class
};

bool haveOppositeSigns(const Interval& x, const Interval& y)
{
    return (x.isPositive() && y.isNegative()) || (x.isNegative() && y.isPositive());
}

}  // namespace

bool forbidsContact(std::int64_t cells, std::int64_t contact, double rho,
                    std::span<const Excitation> shapes, std::span<const ForcedRow> rows)
{
    const Enclosure waves(cells, contact, rho, shapes);
    if (!std::all_of(rows.begin(), rows.end(),
                     [&waves](const ForcedRow& row) { return waves.isRow(row); })) {
        return false;
    }
    const Row gap = waves.tip();
    if (shapes.size() == 1 && rows.size() == 1) {
        return haveOppositeSigns(gap.c, waves.row(rows.front()).c);
    }
    if (shapes.size() != 2 || rows.size() != 2) {
        return false;
    }
    // -gap = x first + y second; Cramer's rule.
    const Row first = waves.row(rows.front());
    const Row second = waves.row(rows.back());
    const Interval volume = cross(first, second);
    return haveOppositeSigns(cross(gap, second), volume) &&
           haveOppositeSigns(cross(first, gap), volume);
}

}  // namespace signorini
