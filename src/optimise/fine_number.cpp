#include "fine_number.hpp"

namespace signorini {

FineNumber::FineNumber() = default;
FineNumber::FineNumber(const FineNumber& other) = default;
FineNumber& FineNumber::operator=(const FineNumber& other) = default;

FineNumber::operator double() const
{
    return static_cast<double>(value_);
}

void FineNumber::set(double value)
{
    value_ = value;
}

void FineNumber::set(long long value)
{
    value_ = value;
}

FineNumber& FineNumber::operator+=(const FineNumber& other)
{
    value_ += other.value_;
    return *this;
}

FineNumber& FineNumber::operator-=(const FineNumber& other)
{
    value_ -= other.value_;
    return *this;
}

FineNumber& FineNumber::operator*=(const FineNumber& other)
{
    value_ *= other.value_;
    return *this;
}

FineNumber& FineNumber::operator/=(const FineNumber& other)
{
    value_ /= other.value_;
    return *this;
}

FineNumber FineNumber::operator-() const
{
    FineNumber negated;
    negated.value_ = -value_;
    return negated;
}

std::partial_ordering FineNumber::operator<=>(const FineNumber& other) const
{
    if (isnan(value_) || isnan(other.value_)) {
        return std::partial_ordering::unordered;
    }
    return value_.compare(other.value_) <=> 0;
}

bool FineNumber::operator==(const FineNumber& other) const
{
    return (*this <=> other) == 0;
}

FineNumber FineNumber::root() const
{
    FineNumber root;
    root.value_ = sqrt(value_);
    return root;
}

}  // namespace signorini
