#pragma once
/// \file
/// A sum whose rounding error does not grow with the number of terms (Neumaier 1974).

#include <cmath>

namespace signorini {

/// What rounding takes from each addition is kept beside the sum. Two words, a few additions.
class CompensatedSum {
public:
    explicit CompensatedSum(double start = 0.0) : sum_(start) {}

    /// O(1).
    void add(double term)
    {
        const double next = sum_ + term;
        lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
        sum_ = next;
    }

    /// Adds another sum, times +-1.
    void add(const CompensatedSum& other, double sign)
    {
        add(sign * other.sum_);
        lost_ += sign * other.lost_;
    }

    /// The sum, rounded once.
    [[nodiscard]] double value() const { return sum_ + lost_; }
    /// What was added since it was as `earlier`.
    [[nodiscard]] double since(const CompensatedSum& earlier) const
    {
        return (sum_ - earlier.sum_) + (lost_ - earlier.lost_);
    }

private:
    double sum_;
    double lost_ = 0.0;
};

}  // namespace signorini
