#include "fine_number.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <new>
#include <type_traits>

namespace signorini {

/// The number within.
struct FineNumber::Inside {
    using Value = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                                boost::multiprecision::et_off>;
    static_assert(sizeof(Value) <= sizeof(FineNumber));
    static_assert(alignof(Value) <= alignof(FineNumber));
    static_assert(std::is_trivially_destructible_v<Value>);

    static Value& of(FineNumber& number)
    {
        return *std::launder(reinterpret_cast<Value*>(number.number_.data()));
    }
    static const Value& of(const FineNumber& number)
    {
        return *std::launder(reinterpret_cast<const Value*>(number.number_.data()));
    }
};

FineNumber::FineNumber()
{
    new (number_.data()) Inside::Value();
}

FineNumber::FineNumber(const FineNumber& other)
{
    new (number_.data()) Inside::Value(Inside::of(other));
}

FineNumber& FineNumber::operator=(const FineNumber& other)
{
    Inside::of(*this) = Inside::of(other);
    return *this;
}

FineNumber::operator double() const
{
    return static_cast<double>(Inside::of(*this));
}

void FineNumber::set(double value)
{
    new (number_.data()) Inside::Value(value);
}

void FineNumber::set(long long value)
{
    new (number_.data()) Inside::Value(value);
}

FineNumber& FineNumber::operator+=(const FineNumber& other)
{
    Inside::of(*this) += Inside::of(other);
    return *this;
}

FineNumber& FineNumber::operator-=(const FineNumber& other)
{
    Inside::of(*this) -= Inside::of(other);
    return *this;
}

FineNumber& FineNumber::operator*=(const FineNumber& other)
{
    Inside::of(*this) *= Inside::of(other);
    return *this;
}

FineNumber& FineNumber::operator/=(const FineNumber& other)
{
    Inside::of(*this) /= Inside::of(other);
    return *this;
}

FineNumber FineNumber::operator-() const
{
    FineNumber negated;
    Inside::of(negated) = -Inside::of(*this);
    return negated;
}

std::partial_ordering FineNumber::operator<=>(const FineNumber& other) const
{
    const Inside::Value& value = Inside::of(*this);
    if (isnan(value) || isnan(Inside::of(other))) {
        return std::partial_ordering::unordered;
    }
    return value.compare(Inside::of(other)) <=> 0;
}

bool FineNumber::operator==(const FineNumber& other) const
{
    return (*this <=> other) == 0;
}

FineNumber FineNumber::root() const
{
    FineNumber root;
    Inside::of(root) = sqrt(Inside::of(*this));
    return root;
}

}  // namespace signorini
