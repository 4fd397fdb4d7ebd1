#pragma once
/// \file
/// Numbers of 50 digits, for the few systems that doubles do not decide.
///
/// The arithmetic is Boost's cpp_bin_float<50>, compiled in one place: with operators in a header
/// each loop of Eigen's factorizations holds a copy of them. The relative error of an operation is
/// 2^-168, the range is beyond that of doubles.

#include <Eigen/Core>
#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <limits>

namespace signorini {

/// A number of 50 digits.
class FineNumber {
public:
    FineNumber();
    FineNumber(const FineNumber& other);
    FineNumber& operator=(const FineNumber& other);
    ~FineNumber() = default;
    FineNumber(std::floating_point auto value) { set(static_cast<double>(value)); }
    FineNumber(std::integral auto value) { set(static_cast<long long>(value)); }
    [[nodiscard]] explicit operator double() const;

    FineNumber& operator+=(const FineNumber& other);
    FineNumber& operator-=(const FineNumber& other);
    FineNumber& operator*=(const FineNumber& other);
    FineNumber& operator/=(const FineNumber& other);
    [[nodiscard]] FineNumber operator-() const;
    /// What is no number is neither less, equal nor greater.
    [[nodiscard]] std::partial_ordering operator<=>(const FineNumber& other) const;
    [[nodiscard]] bool operator==(const FineNumber& other) const;
    [[nodiscard]] FineNumber root() const;

    friend FineNumber operator+(FineNumber a, const FineNumber& b) { return a += b; }
    friend FineNumber operator-(FineNumber a, const FineNumber& b) { return a -= b; }
    friend FineNumber operator*(FineNumber a, const FineNumber& b) { return a *= b; }
    friend FineNumber operator/(FineNumber a, const FineNumber& b) { return a /= b; }
    friend FineNumber abs(const FineNumber& a) { return a < 0 ? -a : a; }
    friend FineNumber sqrt(const FineNumber& a) { return a.root(); }

private:
    void set(double value);
    void set(long long value);

    struct Inside;
    /// Boost's number: its headers take longer to read than most files that hold one.
    alignas(16) std::array<std::byte, 64> number_;
};

}  // namespace signorini

/// What Eigen asks of a number.
template <>
struct std::numeric_limits<signorini::FineNumber> : std::numeric_limits<double> {
    static constexpr int digits = 168;
    static constexpr int digits10 = 50;
    static signorini::FineNumber epsilon() { return 0x1p-167; }
    static signorini::FineNumber min() { return std::numeric_limits<double>::min(); }
    static signorini::FineNumber max() { return std::numeric_limits<double>::max(); }
    static signorini::FineNumber lowest() { return std::numeric_limits<double>::lowest(); }
    static signorini::FineNumber infinity() { return std::numeric_limits<double>::infinity(); }
};

template <>
struct Eigen::NumTraits<signorini::FineNumber> : Eigen::GenericNumTraits<signorini::FineNumber> {
    using Real = signorini::FineNumber;
    using NonInteger = signorini::FineNumber;
    using Nested = signorini::FineNumber;
    enum {  // NOLINTBEGIN(readability-identifier-naming): names of Eigen
        IsInteger = 0,
        IsSigned = 1,
        IsComplex = 0,
        RequireInitialization = 1,
        ReadCost = 4,
        AddCost = 30,
        MulCost = 60
    };  // NOLINTEND(readability-identifier-naming)
    static Real dummy_precision() { return 1e-46; }
};
