#include "exact_projection.hpp"

#include <utility>

namespace signorini {

namespace {

Integer dot(const std::vector<std::int64_t>& row, const IntegerVector& x)
{
    Integer sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] != 0) {
            sum += row[i] * x[i];
        }
    }
    return sum;
}

/// Points, directions and multipliers are integers over one denominator: a common divisor for a
/// vector and not one for each of its sums, which is where exact arithmetic spends its time.
void reduce(Homogeneous& x)
{
    Integer divisor = x.denominator;
    for (const Integer& value : x.numerators) {
        if (divisor == 1) {
            return;
        }
        divisor = gcd(divisor, value);
    }
    for (Integer& value : x.numerators) {
        value /= divisor;
    }
    x.denominator /= divisor;
}

class ActiveSet {
public:
    ActiveSet(const RowSource& source, const RationalVector& centre,
              const std::vector<std::int64_t>& d)
        : source_(source), x_(overCommonDenominator(centre)), d_(d)
    {
    }

    Projection run()
    {
        while (auto row = source_.violatedRow(x_)) {
            if (!enforce(std::move(*row))) {
                return {.isFeasible = false, .point = {}, .rows = std::move(active_)};
            }
        }
        return {.isFeasible = true, .point = asRationals(x_), .rows = std::move(active_)};
    }

private:
    /// Where x and the multipliers go while a new row is being enforced, per unit that the new
    /// multiplier moves; the slope of the new row along x, 0 only if x is 0, over its denominator.
    struct Direction {
        Homogeneous x;
        RationalVector multipliers;  ///< what the active ones lose
        Integer slope;
    };

    /// sum d_i left_i right_i
    [[nodiscard]] Rational product(const ExactRow& left, const ExactRow& right) const
    {
        Integer sum = 0;
        for (std::size_t i = 0; i < d_.size(); ++i) {
            if (left.coefficients[i] != 0 && right.coefficients[i] != 0) {
                sum += Integer(left.coefficients[i]) * right.coefficients[i] * d_[i];
            }
        }
        return sum;
    }

    [[nodiscard]] Direction directionFor(const ExactRow& row, int sign) const
    {
        std::vector<RationalVector> gram;
        RationalVector rhs;
        for (const WeightedRow& other : active_) {
            RationalVector line;
            for (const WeightedRow& another : active_) {
                line.push_back(product(other.row, another.row));
            }
            gram.push_back(std::move(line));
            rhs.push_back(product(other.row, row) * sign);
        }
        Direction direction;
        direction.multipliers = solveRegular(std::move(gram), std::move(rhs));
        const Homogeneous loss = overCommonDenominator(direction.multipliers);
        direction.x.denominator = loss.denominator;
        for (std::size_t i = 0; i < d_.size(); ++i) {
            Integer value = loss.denominator * (row.coefficients[i] * sign);
            for (std::size_t k = 0; k < active_.size(); ++k) {
                value -= loss.numerators[k] * active_[k].row.coefficients[i];
            }
            direction.x.numerators.emplace_back(value * d_[i]);
        }
        direction.slope = dot(row.coefficients, direction.x.numerators);
        return direction;
    }

    /// x += length * direction
    void move(const Rational& length, const Homogeneous& direction)
    {
        const Integer before = denominator(length) * direction.denominator;
        const Integer along = numerator(length) * x_.denominator;
        for (std::size_t i = 0; i < d_.size(); ++i) {
            x_.numerators[i] = x_.numerators[i] * before + direction.numerators[i] * along;
        }
        x_.denominator *= before;
        reduce(x_);
    }

    /// The active inequality whose multiplier reaches 0 first.
    [[nodiscard]] std::optional<std::size_t> firstToLeave(const Direction& direction) const
    {
        std::optional<std::size_t> first;
        Rational least = 0;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            if (active_[k].row.isEquality || direction.multipliers[k] <= 0) {
                continue;
            }
            Rational length = active_[k].weight / direction.multipliers[k];
            if (!first || length < least) {
                first = k;
                least = std::move(length);
            }
        }
        return first;
    }

    /// Moves to the nearest point that meets the active rows and this one; false if there is none,
    /// with the contradiction left in the active rows.
    bool enforce(ExactRow row)
    {
        // An equality that is missed from above has a falling multiplier.
        const int sign = dot(row.coefficients, x_.numerators) > x_.denominator * row.rhs ? -1 : 1;
        Rational weight = 0;
        while (true) {
            const Direction direction = directionFor(row, sign);
            const auto leaving = firstToLeave(direction);
            const bool reaches = !direction.slope.is_zero();
            if (!reaches && !leaving) {
                for (std::size_t k = 0; k < active_.size(); ++k) {
                    active_[k].weight = -direction.multipliers[k];
                }
                active_.push_back({std::move(row), sign});
                return false;
            }
            Rational length;
            bool drops = leaving.has_value();
            if (drops) {
                length = active_[*leaving].weight / direction.multipliers[*leaving];
            }
            if (reaches) {
                const Integer missing =
                    x_.denominator * row.rhs - dot(row.coefficients, x_.numerators);
                Rational full = Rational(missing * direction.x.denominator) /
                                Integer(direction.slope * x_.denominator);
                if (!drops || full <= length) {
                    drops = false;
                    length = std::move(full);
                }
                move(length, direction.x);
            }
            for (std::size_t k = 0; k < active_.size(); ++k) {
                active_[k].weight -= length * direction.multipliers[k];
            }
            weight += sign * length;
            if (!drops) {
                active_.push_back({std::move(row), std::move(weight)});
                return true;
            }
            active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(*leaving));
        }
    }

    const RowSource& source_;
    Homogeneous x_;
    const std::vector<std::int64_t>& d_;
    std::vector<WeightedRow> active_;
};

}  // namespace

Projection project(const RowSource& source, const RationalVector& centre,
                   const std::vector<std::int64_t>& d)
{
    return ActiveSet(source, centre, d).run();
}

}  // namespace signorini
