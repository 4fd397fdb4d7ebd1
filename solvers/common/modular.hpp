#pragma once
/// \file
/// Arithmetic modulo the prime p = 2^61 - 1: exact, never overflows, and cheap.
///
/// Every finite double is m 2^e with whole m and e, so it has an exact image here: 2^61 = 1 turns
/// the exponent into a rotation by e mod 61 bits.

#include <cmath>
#include <cstdint>

namespace signorini {

class Modular {
public:
    Modular() = default;

    /// The image of a finite double.
    explicit Modular(double number)
    {
        int exponent = 0;
        const double mantissa = std::ldexp(std::frexp(std::abs(number), &exponent), mantissaBits);
        const int shift = ((exponent - mantissaBits) % bits + bits) % bits;
        value_ = reduced(Wide{static_cast<std::uint64_t>(mantissa)} << shift);
        if (number < 0.0) {
            *this = Modular() - *this;
        }
    }

    [[nodiscard]] bool isZero() const { return value_ == 0; }

    friend Modular operator-(Modular a, Modular b)
    {
        return fromWide(Wide{a.value_} + prime - b.value_);
    }

    friend Modular operator*(Modular a, Modular b) { return fromWide(Wide{a.value_} * b.value_); }

    /// 1/a = a^(p - 2), for a that is not zero.
    [[nodiscard]] Modular inverse() const
    {
        Modular result(1.0);
        Modular square = *this;
        for (std::uint64_t power = prime - 2; power > 0; power >>= 1U) {
            if ((power & 1U) != 0) {
                result = result * square;
            }
            square = square * square;
        }
        return result;
    }

private:
    __extension__ using Wide = unsigned __int128;

    static constexpr int bits = 61;
    static constexpr int mantissaBits = 53;
    static constexpr std::uint64_t prime = (std::uint64_t{1} << bits) - 1;

    static std::uint64_t reduced(Wide number)
    {
        number = (number & prime) + (number >> bits);
        number = (number & prime) + (number >> bits);
        const auto value = static_cast<std::uint64_t>(number);
        return value >= prime ? value - prime : value;
    }

    static Modular fromWide(Wide number)
    {
        Modular result;
        result.value_ = reduced(number);
        return result;
    }

    std::uint64_t value_ = 0;
};

}  // namespace signorini
