#pragma once
/// \file
/// A sum whose rounding error does not grow with the number of terms (Neumaier 1974).

#include <cmath>

namespace signorini {

class CompensatedSum {
public:
    explicit CompensatedSum(double start = 0.0) : sum_(start) {}

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

    [[nodiscard]] double value() const { return sum_ + lost_; }

private:
    double sum_;
    double lost_ = 0.0;
};

}  // namespace signorini
