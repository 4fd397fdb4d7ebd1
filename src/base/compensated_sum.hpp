#pragma once
/// \file
/// A sum whose rounding error does not grow with the number of terms (Neumaier 1974).

#include <cmath>

namespace signorini {

/// sum + lost + term: what rounding takes from the addition is kept beside the sum.
inline void addCompensated(double& sum, double& lost, double term)
{
    const double next = sum + term;
    lost += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
}

class CompensatedSum {
public:
    explicit CompensatedSum(double start = 0.0) : sum_(start) {}

    void add(double term) { addCompensated(sum_, lost_, term); }

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
